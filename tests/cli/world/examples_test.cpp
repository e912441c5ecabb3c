// data/README.md says what commands on its examples of others' formats find; here they are run.
#include <gmock/gmock.h>

#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "support/program_test.h"

namespace taut::test {
namespace {

using testing::HasSubstr;

class Examples : public ProgramTest {
 protected:
  /// The command without `taut`, with data/ where it lies.
  static std::string placed(const std::string& words) {
    return std::regex_replace(words, std::regex("data/"), data_dir().string() + "/");
  }
  static std::string file(const std::string& name) { return (data_dir() / name).string(); }
};

TEST_F(Examples, FindWhatTheirReadmeSays) {
  std::ifstream readme(data_dir() / "README.md");
  const std::regex row(R"(\| `([^`]+)` \|.*\| `taut (solve [^`]+)`: (length [0-9.]+, [0-9]+ corners?) \|)");
  int rows = 0;
  for (std::string line; std::getline(readme, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, row)) continue;
    ++rows;
    const std::string command = placed(match[2].str());
    EXPECT_THAT(command, HasSubstr(file(match[1].str()))) << "its own file";
    const Outcome run = run_taut(command);
    EXPECT_EQ(run.code, 0) << command << run.err;
    EXPECT_THAT(run.out, HasSubstr(match[3].str() + ",")) << command;
  }
  EXPECT_EQ(rows, 8);
}

TEST_F(Examples, ShowWhatTheyAreFor) {
  EXPECT_THAT(run_taut("check " + file("office.geojson")).err, HasSubstr("2 points without a role left out"));
  EXPECT_THAT(run_taut("check " + file("traced.wkt")).err, HasSubstr("crosses itself"));
  EXPECT_THAT(run_taut("check " + file("courtyard.wkt")).err, HasSubstr("--polygons nested"));
  EXPECT_THAT(run_taut("solve " + file("cracked.wkt") + " --from 1,1 --to 7,2").out, HasSubstr("length 6.710440"))
      << "through the crack";
  const std::string unknown = " --from -1,0.65 --to 1,0.65", hall = file("hall.yaml");
  EXPECT_EQ(run_taut("solve " + hall + unknown).code, 3);
  EXPECT_EQ(run_taut("solve " + hall + unknown + " --unknown-free").code, 0);
  EXPECT_EQ(run_taut("check " + file("hall.pgm")).code, 3) << "without a resolution";
}

TEST_F(Examples, KeepTheirWorldInEachFormatThatHoldsIt) {
  int copies = 0;
  for (const char* name : {"office.geojson", "hall.yaml", "yard.svg", "parcels.csv", "courtyard.wkt", "cracked.wkt"}) {
    const auto area = [](const Outcome& run) {
      EXPECT_EQ(run.code, 0) << run.err;
      const std::size_t at = run.out.find("free space");
      return at == std::string::npos ? "" : run.out.substr(at, run.out.find('\n', at) - at);
    };
    const std::string right = area(run_taut("check " + file(name)));
    for (const char* format : {"geojson", "wkt", "segments"}) {
      const std::string copy = in_folder(std::string("copy.") + format);
      const Outcome made = run_taut("convert " + file(name) + " " + copy + " --as " + format);
      if (made.code == 3) continue;  // says what would be lost
      ++copies;
      const bool solid = made.err.find("read it with --polygons obstacles") != std::string::npos;
      EXPECT_EQ(area(run_taut("check " + copy + (solid ? " --polygons obstacles" : ""))), right)
          << name << " as " << format;
    }
  }
  EXPECT_EQ(copies, 12);
}

}  // namespace
}  // namespace taut::test
