// What the fuzz targets share: a finding is an abort, with words.
#pragma once

#include <fuzzer/FuzzedDataProvider.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include <taut/geometry/errors.h>

namespace taut::fuzz {

[[noreturn]] inline void found(const std::string& words) {
  std::fprintf(stderr, "FOUND: %s\n", words.c_str());
  std::abort();
}

inline void require(bool holds, const std::string& words) {
  if (!holds) found(words);
}

/// Runs what reads; bad input is an InputError of one line that says something, and nothing else is thrown.
template <class Read>
void read(Read&& reads) {
  try {
    reads();
  } catch (const InputError& error) {
    const std::string_view words = error.what();
    require(!words.empty() && words.find('\n') == std::string_view::npos, "an error that is not one line");
  }
}

}  // namespace taut::fuzz
