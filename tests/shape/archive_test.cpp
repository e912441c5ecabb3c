// What the library's object code refers to: it never prints, logs or exits, and nothing that it stands on does so for
// it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "support/run_program.h"

namespace taut::test {
namespace {

using testing::IsEmpty;

std::vector<std::string> lines_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  if (!pipe) throw std::runtime_error("cannot run " + command);
  std::vector<std::string> lines(1);
  for (int c; (c = std::fgetc(pipe.get())) != EOF;)
    if (c == '\n')
      lines.emplace_back();
    else
      lines.back() += static_cast<char>(c);
  lines.pop_back();
  return lines;
}

const std::string kLibrary = std::string("'") + TAUT_LIBRARY + "'";
const std::set<std::string_view> kForbidden{"exit",      "_exit",  "quick_exit", "abort",  "std::cout", "std::cerr",
                                            "std::clog", "stdout", "stderr",     "printf", "fprintf",   "vprintf",
                                            "vfprintf",  "puts",   "fputs",      "perror"};

/// The symbol without its version or offset: abort of abort@GLIBC_2.2.5 and of abort-0x4.
std::string_view bare(std::string_view symbol) { return symbol.substr(0, symbol.find_first_of("@-+")); }

/// The object files of the archive that refer to something forbidden.
std::set<std::string> suspects() {
  std::set<std::string> objects;
  for (const std::string& line : lines_of("nm -C -A " + kLibrary)) {
    const std::size_t end = line.find(".o:"), undefined = line.find(" U ");
    if (end == std::string::npos || undefined == std::string::npos) continue;
    if (!kForbidden.contains(bare(std::string_view(line).substr(undefined + 3)))) continue;
    const std::size_t begin = line.rfind(':', end) + 1;
    objects.insert(line.substr(begin, end + 2 - begin));
  }
  return objects;
}

/// Functions of an object file that refer to something forbidden, and what that is. No regular expressions: a name in a
/// line may have tens of thousands of letters.
std::vector<std::string> references(const std::string& object) {
  const Folder folder;
  const std::string copy = "'" + (folder / "object.o").string() + "'";
  std::vector<std::string> found;
  std::string current;
  for (const std::string& line :
       lines_of("ar p " + kLibrary + " " + object + " >" + copy + " && objdump -dr -C " + copy)) {
    const std::size_t name = line.find(" <"), symbol = line.rfind('\t') + 1;
    if (line.ends_with(">:") && name != std::string::npos) current = line.substr(name + 2, line.size() - name - 4);
    if (line.find(": R_") != std::string::npos && kForbidden.contains(bare(std::string_view(line).substr(symbol))))
      found.push_back(current + " refers to " + line.substr(symbol));
  }
  return found;
}

/// CGAL's failed assertions print and end the program only where they were told to; by default they throw.
bool is_assertion_code(const std::string& reference) {
  static constexpr const char* kHandlers[]{"CGAL::assertion_fail(", "CGAL::precondition_fail(",
                                           "CGAL::postcondition_fail(",
                                           "CGAL::(anonymous namespace)::_standard_error_handler("};
  return std::any_of(std::begin(kHandlers), std::end(kHandlers),
                     [&](const char* handler) { return reference.starts_with(handler); });
}

TEST(Archive, HoldsTheDiagram) {
  EXPECT_THAT(lines_of("nm -C " + kLibrary + " | grep ' T taut::detail::voronoi_diagram'"), testing::SizeIs(1));
}

TEST(Archive, HasNoSymbolOfCore) { EXPECT_THAT(lines_of("nm -C " + kLibrary + " | grep 'CORE::'"), IsEmpty()); }

TEST(Archive, NeitherPrintsNorExitsButForAssertionsThatThrow) {
  const std::set<std::string> objects = suspects();
  EXPECT_TRUE(objects.contains("voronoi_diagram.cpp.o"));  // by its assertions: so the search finds something
  std::vector<std::string> others;
  for (const std::string& object : objects) {
    const auto found = references(object);
    EXPECT_THAT(found, testing::Not(IsEmpty())) << object;
    for (const std::string& reference : found)
      if (!is_assertion_code(reference)) others.push_back(object + ": " + reference);
  }
  EXPECT_THAT(others, IsEmpty());
}

}  // namespace
}  // namespace taut::test
