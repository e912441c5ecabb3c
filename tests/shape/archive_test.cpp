// What the library's object code refers to: it never prints, logs or exits, and nothing that it stands on does so for
// it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
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
const std::string kForbidden =
    R"((_?exit|quick_exit|abort|std::cout|std::cerr|std::clog|stdout|stderr|v?f?printf|f?puts|perror))";

/// The object files of the archive that refer to something forbidden.
std::set<std::string> suspects() {
  const std::regex undefined(R"re(:([^:/]+\.o):\s+U )re" + kForbidden + R"re((@.*)?$)re");
  std::set<std::string> objects;
  for (const std::string& line : lines_of("nm -C -A " + kLibrary))
    if (std::smatch match; std::regex_search(line, match, undefined)) objects.insert(match[1]);
  return objects;
}

/// Functions of an object file that refer to something forbidden, and what that is.
std::vector<std::string> references(const std::string& object) {
  const Folder folder;
  const std::regex function(R"re(^[0-9a-f]+ <(.*)>:$)re");
  const std::regex reference(R"re(\sR_\S+\s+)re" + kForbidden + R"re(([-+@].*)?$)re");
  const std::string copy = "'" + (folder / "object.o").string() + "'";
  std::vector<std::string> found;
  std::string current;
  for (const std::string& line :
       lines_of("ar p " + kLibrary + " " + object + " >" + copy + " && objdump -dr -C " + copy)) {
    std::smatch match;
    if (std::regex_match(line, match, function)) current = match[1];
    if (std::regex_search(line, match, reference)) found.push_back(current + " refers to " + match[1].str());
  }
  return found;
}

/// CGAL's failed assertions print and end the program only where they were told to; by default they throw.
bool is_assertion_code(const std::string& reference) {
  static const std::regex handlers(
      R"re(^CGAL::((assertion|precondition|postcondition)_fail|\(anonymous namespace\)::_standard_error_handler)\()re");
  return std::regex_search(reference, handlers);
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
