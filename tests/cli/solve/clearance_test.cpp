// taut solve --clearance, --widest, --tradeoff; taut passage; taut roadmap --kind voronoi.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// Two rooms; from the left to the right one a door of width 1 at the bottom and, further away, one of width 3 at the
// top.
constexpr const char* kTwoDoors =
    "0 0 20 0\n20 0 20 20\n20 20 0 20\n0 20 0 0\n10 0 10 2\n10 3 10 16\n10 19 10 20\nstart 5 5\ngoal 15 5\n";
// Entrance and exit are openings of width 1; within, a door of width 1/2.
constexpr const char* kOpenings =
    "0 0 4 0\n4 0 4 1\n4 2 4 3\n4 3 0 3\n0 3 0 2\n0 1 0 0\n2 0 2 1.25\n2 1.75 2 3\nstart 0 1.5\ngoal 4 1.5\n";

class SolveClearance : public ProgramTest {};
class Passage : public ProgramTest {};
class VoronoiKind : public ProgramTest {};

TEST_F(SolveClearance, TakesTheShortWayForASmallDiscAndTheLongOneForALargeOne) {
  const json narrow = json::parse(run_taut("solve - --clearance 0.5 --json -", kTwoDoors).out)["result"];
  const json wide = json::parse(run_taut("solve - --clearance 0.51 --json -", kTwoDoors).out)["result"];
  EXPECT_EQ(narrow["query"], "clearance");
  EXPECT_EQ(narrow["asked"], 0.5);
  EXPECT_EQ(narrow["radius"], 0.5);
  EXPECT_EQ(narrow["verified"], true);
  EXPECT_EQ(narrow["shortest_in"], "diagram");
  EXPECT_EQ(wide["radius"], 1.5);
  EXPECT_EQ(wide["verified"], true);
  EXPECT_LT(narrow["length"], wide["length"]);
  EXPECT_EQ(narrow["curves"][0].size(), 3U);
}

TEST_F(SolveClearance, SaysThatItIsTheShortestAlongTheDiagramOnly) {
  const Outcome run = run_taut("solve - --clearance 0.25", kTwoDoors);
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out, HasSubstr("along the Voronoi diagram (the shortest there, not in the plane)"));
  EXPECT_THAT(run.out,
              HasSubstr("narrowest 1 between (10, 2) and (10, 3), of the walls (10, 0)-(10, 2) and (10, 3)-(10, 16)"));
}

TEST_F(SolveClearance, NamesTheGatesThatAreTooNarrow) {
  const Outcome run =
      run_taut("solve - --clearance 1.6 --svg " + in_folder("a.svg") + " --json " + in_folder("a.json"), kTwoDoors);
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, HasSubstr("no path with clearance 1.6: these 2 gates are narrower than 3.2: "
                                 "3 between (10, 16) and (10, 19); 1 between (10, 2) and (10, 3)"));
  const json envelope = json::parse(contents(in_folder("a.json"))), answer = envelope["result"];
  EXPECT_EQ(envelope["status"], "none");
  EXPECT_EQ(answer["barrier"]["gates"].size(), 2U);
  EXPECT_EQ(answer["barrier"]["gates"][0]["width_text"], "3");
  EXPECT_THAT(contents(in_folder("a.svg")), HasSubstr("<g class=\"gates\">"));
  EXPECT_THAT(contents(in_folder("a.svg")), HasSubstr("<g class=\"separation\">"));
}

TEST_F(SolveClearance, NamesTheWallThatIsTooNearToAnEnd) {
  const Outcome run = run_taut("solve - --clearance 6", kTwoDoors);
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, HasSubstr("the start (5, 5) is only 5 from the wall"));
}

TEST_F(SolveClearance, NamesWallsWhereNotEvenAPointGetsThrough) {
  const char* sealed = "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 4\nstart 1 2\ngoal 3 2\n";
  for (const char* query : {"solve - --widest", "solve - --tradeoff", "solve - --clearance 0", "passage -"}) {
    SCOPED_TRACE(query);
    const Outcome run = run_taut(query, sealed);
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.out, HasSubstr("this wall separates start and goal: (2, 0)-(2, 4)"));
  }
}

TEST_F(SolveClearance, NamesTheTwoWallsThatPinchTheLargestDisc) {
  const Outcome run = run_taut("solve - --widest --stats", kTwoDoors);
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out,
              HasSubstr("the largest disc that gets through has radius 1.5; narrowest 3 between (10, 16) and (10, 19), "
                        "of the walls (10, 3)-(10, 16) and (10, 19)-(10, 20)"));
  EXPECT_THAT(run.err, HasSubstr("walls and gates agree"));
  const json answer = json::parse(run_taut("solve - --widest --json -", kTwoDoors).out)["result"];
  EXPECT_EQ(answer["pinch"]["at"], "gate");
  EXPECT_EQ(answer["pinch"]["walls"].size(), 2U);
  EXPECT_EQ(answer["width"], "3");
  EXPECT_EQ(answer["radius_below"], 1.5);
  EXPECT_EQ(answer["barrier"]["gates"].size(), 2U);  // why no larger one
}

TEST_F(SolveClearance, GoesThroughOpeningsWhereItStartsAndEnds) {
  const json answer = json::parse(run_taut("solve - --widest --json -", kOpenings).out)["result"];
  EXPECT_EQ(answer["radius"], 0.25);
  EXPECT_EQ(answer["pinch"]["posts"], json::parse("[[2, 1.25], [2, 1.75]]"));
  EXPECT_EQ(answer["verified"], true);
}

TEST_F(SolveClearance, DrawsArcsAsBezierCurves) {
  EXPECT_THAT(run_taut("solve - --widest --svg -", kTwoDoors).out,
              ContainsRegex("<g class=\"path\"><path class=\"casing\" d=\"[^\"]*q"));
}

TEST_F(SolveClearance, PrintsThePointsOfTheWayForCheck) {
  const std::string points = run_taut("solve - --widest --path -q", kTwoDoors).out;
  EXPECT_THAT(points, StartsWith("# legs between points of a curve, no farther than "));
  EXPECT_THAT(points, ContainsRegex("it\n5 5\n"));
  const std::string file = folder.file("world.txt", kTwoDoors);
  EXPECT_EQ(run_taut("check " + file + " --path -", points).code, 0);
}

TEST_F(SolveClearance, EndsInARoom) {
  const json answer = json::parse(run_taut("solve --widest --json - " + data_file("mouse_16.maz")).out)["result"];
  EXPECT_EQ(answer["radius"], 0.5);
  EXPECT_EQ(answer["verified"], true);
}

TEST_F(SolveClearance, RefusesWhatDoesNotGoTogether) {
  for (const char* options : {"--widest --tradeoff", "--widest --clearance 1", "--clearance -1", "--clearance wide",
                              "--widest --robot disc:1", "--widest --roadmap cells", "--widest --save x",
                              "--widest --load x", "--widest --svg - --json -"}) {
    SCOPED_TRACE(options);
    const Outcome run = run_taut(std::string("solve - ") + options, kTwoDoors);
    EXPECT_EQ(run.code, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
  }
  EXPECT_EQ(run_taut("solve - --widest --from 10,1.5,2", kTwoDoors).code, 2);
  EXPECT_EQ(run_taut("solve - --widest --from 30,30", "boundary 0 0 20 20\n" + std::string(kTwoDoors)).code, 3);
  EXPECT_EQ(run_taut("passage - --from 30,30", "boundary 0 0 20 20\n" + std::string(kTwoDoors)).code, 3);
}

TEST_F(Passage, IsWhatSolveNamesWhenADiscHasNoPath) {
  const Outcome none = run_taut("solve - --robot disc:1.6", kTwoDoors);
  EXPECT_EQ(none.code, 1);
  EXPECT_THAT(none.out, HasSubstr("no path: these 2 gates are narrower than 3.2: "));
  EXPECT_THAT(none.out, HasSubstr("3 between (10, 16) and (10, 19)"));
  const json result = json::parse(run_taut("solve - --robot disc:1.6 --json -", kTwoDoors).out);
  EXPECT_EQ(result["status"], "none");
  EXPECT_THAT(result["reason"].get<std::string>(), HasSubstr("these 2 gates"));
  EXPECT_FALSE(result["result"]["separation"].empty());
  EXPECT_THAT(run_taut("solve - --robot square:1.6", kTwoDoors).out, HasSubstr("walls separate start and goal"));
}

TEST_F(Passage, SaysHowLargeADiscMayBe) {
  const Outcome run = run_taut("passage -", kTwoDoors);
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out,
              HasSubstr("the largest disc that gets through has radius 1.5, diameter 3 between (10, 16) and (10, 19)"));
  const json answer = json::parse(run_taut("passage - --json -", kTwoDoors).out)["result"];
  EXPECT_EQ(answer["largest"]["radius"], 1.5);
  EXPECT_EQ(answer["largest"]["limit"], "gate");
  EXPECT_EQ(answer["barrier"]["gates"].size(), 2U);
}

TEST_F(Passage, SaysWhetherADiscGetsThrough) {
  EXPECT_EQ(run_taut("passage - --robot disc:1.5", kTwoDoors).code, 0);
  const Outcome none = run_taut("passage - --robot disc:1.6 --svg " + in_folder("a.svg"), kTwoDoors);
  EXPECT_EQ(none.code, 1);
  EXPECT_THAT(none.out, HasSubstr("no disc of radius 1.6 gets through: these 2 gates are narrower than 3.2: "));
  EXPECT_THAT(contents(in_folder("a.svg")), HasSubstr("<g class=\"gates\">"));
  EXPECT_EQ(run_taut("passage - --robot square:1", kTwoDoors).code, 2);
  EXPECT_THAT(run_taut("passage --help").out, HasSubstr("Usage: taut passage"));
}

TEST_F(Passage, AgreesWithTheWidestPath) {
  for (const char* name :
       {"maze_25x25.txt", "floor_plan.geojson", "islands.wkt", "mouse_32.maze", "corridors_30x20.txt"}) {
    SCOPED_TRACE(name);
    const json widest = json::parse(run_taut("solve --widest --json - " + data_file(name)).out)["result"];
    const json passage = json::parse(run_taut("passage --json - " + data_file(name)).out)["result"];
    EXPECT_EQ(widest["radius_below"], passage["largest"]["radius"]);
    EXPECT_EQ(widest["verified"], true);
  }
}

TEST_F(VoronoiKind, IsDrawnAndExported) {
  const std::string query = "roadmap --kind voronoi - ";
  const Outcome line = run_taut(query, kTwoDoors);
  EXPECT_EQ(line.code, 0);
  EXPECT_THAT(line.out, ContainsRegex("segment Voronoi diagram, [0-9]+ vertices, [0-9]+ edges, [0-9]+ arcs"));
  EXPECT_THAT(run_taut(query + "--svg -", kTwoDoors).out, ContainsRegex("<g class=\"roadmap\"><path d=\"[^\"]*q"));
  const json all = json::parse(run_taut(query + "--json -", kTwoDoors).out)["result"];
  EXPECT_EQ(all["edges"].size(), all["arcs"].size());
  EXPECT_EQ(all["vertices"].size(), all["clearances"].size());
  const json map = json::parse(run_taut(query + "--geojson -", kTwoDoors).out);
  EXPECT_EQ(map["features"].size(), all["vertices"].size() + all["edges"].size());
  const auto arc = std::find_if(map["features"].begin(), map["features"].end(),
                                [](const json& f) { return f["properties"].value("kind", "") == "parabola"; });
  ASSERT_NE(arc, map["features"].end());
  EXPECT_GT((*arc)["properties"]["tolerance"], 0);
  const std::string graphml = run_taut(query + "--graphml -", kTwoDoors).out;
  EXPECT_THAT(graphml, HasSubstr("for=\"edge\" attr.name=\"clearance\" attr.type=\"double\""));
  EXPECT_THAT(graphml, HasSubstr("for=\"edge\" attr.name=\"length\" attr.type=\"double\""));
}

TEST_F(VoronoiKind, IsNotKeptInFiles) {
  for (const char* query : {"roadmap - --kind voronoi --save ", "solve - --roadmap voronoi --save "}) {
    const Outcome run = run_taut(query + in_folder("x"), kTwoDoors);
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err, HasSubstr("'voronoi' cannot be kept in a file"));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
  }
}

TEST_F(VoronoiKind, SolvesAndIsCompared) {
  const json path = json::parse(run_taut("solve - --roadmap voronoi --json -", kTwoDoors).out)["result"];
  EXPECT_EQ(path["optimal"], false);
  EXPECT_EQ(path["verified"], true);
  EXPECT_NEAR(path["clearance"], 0.5, 1e-2);
  const json all =
      json::parse(run_taut("compare - --planners voronoi,visibility-astar --json -", kTwoDoors).out)["result"];
  EXPECT_GT(all["planners"][0]["ratio"], 1.0);
  EXPECT_EQ(all["planners"][0]["verified"], true);
  EXPECT_GT(all["planners"][0]["expanded"], 0);
}

}  // namespace
}  // namespace taut::test
