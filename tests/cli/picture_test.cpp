// Every kind of picture the program draws: one look, and XML.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "support/program_test.h"

namespace taut::test {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

/// What is wrong with the nesting of the tags or with a text; empty when nothing is.
std::string fault_of(std::string_view xml) {
  std::vector<std::string_view> open;
  while (!xml.empty()) {
    const std::size_t from = xml.find('<');
    const std::string_view text = xml.substr(0, from);
    if (text.find("&") != std::string_view::npos && text.find(';') == std::string_view::npos) return "a bare &";
    if (from == std::string_view::npos) break;
    const std::size_t to = xml.find('>', from);
    if (to == std::string_view::npos) return "a tag without an end";
    std::string_view tag = xml.substr(from + 1, to - from - 1);
    xml.remove_prefix(to + 1);
    if (tag.find('<') != std::string_view::npos) return "a < within a tag";
    if (open.empty() && tag != "svg" && !tag.starts_with("svg ")) return "something beside the root";
    if (tag.ends_with('/')) continue;
    if (tag.starts_with('/')) {
      if (open.back() != tag.substr(1))
        return "</" + std::string(open.back()) + "> expected, not <" + std::string(tag) + ">";
      open.pop_back();
      if (open.empty() && xml.find('<') != std::string_view::npos) return "more than one root";
    } else {
      open.push_back(tag.substr(0, tag.find(' ')));
    }
  }
  return open.empty() ? "" : "<" + std::string(open.back()) + "> is not closed";
}

/// The first rule of a style that would colour more than these pictures; empty when none does.
std::string far_rule(const std::string& picture) {
  std::size_t from = picture.find("<style>");
  std::stringstream style(picture.substr(from + 7, picture.find("</style>") - from - 7));
  for (std::string line; std::getline(style, line);)
    if (!line.empty() && !line.starts_with(".taut") && !line.starts_with("@media") && line != "}") return line;
  return "";
}

struct Kind {
  const char* name;
  const char* command;  // data/ stands for the project's
};

void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.command; }

class Picture : public ProgramTest, public testing::WithParamInterface<Kind> {};

TEST_P(Picture, IsXmlWithTheSharedPageAndLegend) {
  std::string command = GetParam().command;
  for (std::size_t at = 0; (at = command.find(" data/", at)) != std::string::npos; at += 6)
    command.replace(at, 6, " " + data_dir().string() + "/");
  const Outcome outcome = run_taut(command + " --svg -");
  ASSERT_LE(outcome.code, 1) << outcome.err;
  EXPECT_EQ(fault_of(outcome.out), "");
  EXPECT_THAT(outcome.out, ContainsRegex("<svg [^>]*class=\"taut( [a-z-]+)?\" role=\"img\""));
  EXPECT_EQ(far_rule(outcome.out), "");
  EXPECT_THAT(outcome.out, HasSubstr("<rect class=\"page\""));
  EXPECT_THAT(outcome.out, HasSubstr("prefers-color-scheme:dark"));
  EXPECT_THAT(outcome.out, HasSubstr("<g class=\"legend\">"));
  EXPECT_THAT(outcome.out, HasSubstr("<text class=\"title\""));
  EXPECT_THAT(outcome.out, Not(HasSubstr("nan")));
  EXPECT_THAT(outcome.out, Not(HasSubstr("\"inf")));
}

INSTANTIATE_TEST_SUITE_P(
    Program, Picture,
    testing::Values(
        Kind{"Path", "solve data/maze_25x25.txt"},
        Kind{"Barrier", "solve data/islands.wkt --robot disc:1.05 --from 5,8 --to 9,4"},
        Kind{"Arcs", "solve data/floor_plan.geojson --robot disc:0.2 --arcs"},
        Kind{"Comparison", "compare data/maze_5x7.txt"}, Kind{"Milestones", "roadmap data/maze_5x7.txt --kind prm"},
        Kind{"Tradeoff", "solve data/islands.wkt --tradeoff"},
        Kind{"TradeoffFilm", "solve data/three_ways.txt --tradeoff --animate"},
        Kind{"Passage", "passage data/islands.wkt"}, Kind{"Diagram", "roadmap data/islands.wkt --kind voronoi"},
        Kind{"Tangent", "bug data/islands.wkt --algorithm tangent --range 5"},
        Kind{"TangentFilm", "bug data/islands.wkt --algorithm tangent --range 5 --animate"},
        Kind{"Mouse", "mouse run data/mouse_16.maz --flood"},
        Kind{"MouseFilm", "mouse run data/mouse_16.maz --animate"}, Kind{"SpeedRun", "mouse speed data/mouse_16.maz"},
        Kind{"Chase", "chase data/town_60x40.chase"}, Kind{"ChaseFilm", "chase data/town_60x40.chase --animate"},
        Kind{"Plane", "chase plane data/islands.wkt --target data/islands_way.csv"},
        Kind{"PlaneFilm", "chase plane data/islands.wkt --target data/islands_way.csv --animate"},
        Kind{"Tree", "drive data/car/lane.txt --planner rrt"}, Kind{"Drive", "drive data/car/lane.txt"},
        Kind{"DriveFilm", "drive data/car/lane.txt --sample 2 --animate"},
        Kind{"Values", "drive data/car/lane.txt --planner value-iteration"},
        Kind{"CarInWorld", "drive data/islands.wkt --car length=0.4,width=0.2,radius=0.3"},
        Kind{"Grid", "grid solve data/pocket.csv"}, Kind{"GridFilm", "grid solve data/pocket.csv --animate"}),
    [](const auto& instance) { return instance.param.name; });

class PicturePage : public ProgramTest {};

TEST_F(PicturePage, HoldsTheFilmWhereTheNameEndsInHtml) {
  const std::string file = in_folder("play.html");
  ASSERT_EQ(run_taut("grid solve " + (data_dir() / "pocket.csv").string() + " --animate " + file).code, 0);
  const std::string page = contents(file);
  EXPECT_THAT(page, testing::StartsWith("<!DOCTYPE html>"));
  EXPECT_THAT(page, HasSubstr("\"film\": \"\\u003csvg "));
  EXPECT_THAT(page, HasSubstr("\"name\": \"play.html\""));
}

TEST(PictureFault, IsFoundWhereTagsDoNotNest) {
  EXPECT_EQ(fault_of("<svg a=\"1\"><g><path/></g>&amp;</svg>\n"), "");
  EXPECT_NE(fault_of("<svg><g></svg></g>"), "");
  EXPECT_NE(fault_of("<svg></style></svg>"), "");
  EXPECT_NE(fault_of("<svg/><svg>"), "");
  EXPECT_NE(fault_of("<svg>a & b</svg>"), "");
  EXPECT_NE(fault_of("<svg><g></g>"), "");
}

}  // namespace
}  // namespace taut::test
