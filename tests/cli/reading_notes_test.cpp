// What reading noted, in the result of every subcommand that reads a world.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

// A door that lies on no wall is left out; one end is joined, and another nearly touches.
constexpr const char* kPlan =
    R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[[0,0],[9,0],[9,4],[0,4],[0,0]]]}},
{"type":"Feature","properties":{},"geometry":{"type":"LineString","coordinates":[[2,0.001],[2,3]]}},
{"type":"Feature","properties":{"role":"door"},"geometry":{"type":"LineString","coordinates":[[5,1],[5,2]]}},
{"type":"Feature","properties":{"role":"start"},"geometry":{"type":"Point","coordinates":[1,1]}},
{"type":"Feature","properties":{"role":"goal"},"geometry":{"type":"Point","coordinates":[3,1]}}]})";

class ReadingNotes : public ProgramTest {};

TEST_F(ReadingNotes, StandInTheResultOfEverySubcommand) {
  std::ofstream(in_folder("queries")) << "1 1 3 1\n";
  for (const std::string& words :
       {std::string("solve -"), std::string("solve - --robot disc:0.1 --arcs"), std::string("solve - --clearance 0.1"),
        std::string("solve - --widest"), std::string("solve - --tradeoff"), std::string("solve - --anytime"),
        std::string("check -"), std::string("compare - --planners polyanya"), std::string("passage -"),
        std::string("roadmap -"), std::string("bug -"), "batch - " + in_folder("queries"),
        "space - --as wkt -o " + in_folder("space"), "convert - " + in_folder("world") + " --as geojson",
        std::string("drive - --car length=0.4,width=0.2,radius=0.3")}) {
    const Outcome outcome = run_taut(words + " --snap 0.001 -q --json " + in_folder("a.json"), kPlan);
    EXPECT_EQ(outcome.code, 0) << words << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("lies on no wall")) << words;
    const json result = json::parse(contents(folder / "a.json"))["result"];
    EXPECT_EQ(result["remarks"].size(), 2U) << words << result["remarks"];
    EXPECT_EQ(result["snap"]["joined"], 1) << words;
    EXPECT_TRUE(result["near"].is_array()) << words;
  }
}

}  // namespace
}  // namespace taut::test
