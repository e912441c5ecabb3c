#include <taut/cli/version.h>

#include <fmt/format.h>
#include <CLI/Version.hpp>
#include <nlohmann/json.hpp>

#ifndef TAUT_BOOST_NUMBERS
#include <gmp.h>
#endif

namespace taut::cli {

namespace {

constexpr const char* kCompiler =
#ifdef __clang__
    "clang " __clang_version__;
#else
    "g++ " __VERSION__;
#endif

constexpr const char* kChecks =
#ifdef TAUT_CHECKS
    "preconditions checked";
#else
    "preconditions trusted";
#endif

#ifdef TAUT_BOOST_NUMBERS
constexpr const char* kGmp = "unused";
#else
const char* const kGmp = gmp_version;
#endif

}  // namespace

std::string version_text() {
  return fmt::format("taut " TAUT_VERSION
                     "\n"
                     "compiler: {}, C++{}\n"
                     "libraries: CGAL " TAUT_CGAL_VERSION ", Boost " TAUT_BOOST_VERSION
                     ", GMP {}, fmt {}.{}.{}, CLI11 {}, nlohmann-json {}.{}.{}\n"
                     "options: {}",
                     kCompiler, __cplusplus / 100 % 100, kGmp, FMT_VERSION / 10000, FMT_VERSION / 100 % 100,
                     FMT_VERSION % 100, CLI11_VERSION, NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                     NLOHMANN_JSON_VERSION_PATCH, kChecks);
}

}  // namespace taut::cli
