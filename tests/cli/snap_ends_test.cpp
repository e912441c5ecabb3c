#include <gmock/gmock.h>

#include "support/program_test.h"

namespace taut::test {
namespace {

using testing::HasSubstr;
using testing::Not;

// A wall 0.06 thick, and a sloped one.
const std::string kRoom =
    "boundary 0 0 6 4\nstart 1.5 1.98\ngoal 3 3\n"
    "1 2 4 2 0.06\n"
    "2 0 5 1.3\n";

class SnapEnds : public ProgramTest {};

TEST_F(SnapEnds, RefusalSaysHowFarInsideWhichWallAndWhereTheNearestPlaceIs) {
  const Outcome outcome = run_taut("solve -", kRoom);
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("start (1.5, 1.98) lies 0.01 inside the wall from (1, 2) to (4, 2), line 4; "
                                     "nearest free point (1.5, 1.97)"));
}

TEST_F(SnapEnds, MoveToTheNearestPlaceAndSaySo) {
  const Outcome outcome = run_taut("solve - --snap-ends 0.05 --path", kRoom);
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("nearest free point (1.5, 1.97); moved there"));
  EXPECT_THAT(outcome.out, HasSubstr("\n1.5 1.97\n"));
  EXPECT_THAT(run_taut("solve - --snap-ends 0.05 --json - -q", kRoom).out,
              HasSubstr("{\"end\": \"start\", \"given\": [1.5, 1.98], \"moved_to\": [1.5, 1.97], \"distance\": 0.01, "
                        "\"rounding\": 0.0}"));
  const std::string picture = run_taut("solve - --snap-ends 0.05 --svg -", kRoom).out;
  EXPECT_THAT(picture, HasSubstr("<g class=\"moves\">"));
  EXPECT_THAT(picture, HasSubstr("start moved 0.01 from (1.5, 1.98)"));
}

TEST_F(SnapEnds, StayWhereThePlaceIsFartherThanAskedFor) {
  const Outcome outcome = run_taut("solve - --snap-ends 0.009", kRoom);
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("nearest free point (1.5, 1.97)"));
  EXPECT_EQ(run_taut("solve - --snap-ends -1", kRoom).code, 2);
}

TEST_F(SnapEnds, LeaveFreeEndsAlone) {
  const Outcome outcome = run_taut("solve - --from 0.5,0.5 --snap-ends 5 --json - -q", kRoom);
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, Not(HasSubstr("moved_ends")));
}

TEST_F(SnapEnds, MeanTheSameEverywhere) {
  for (const char* words : {"solve - --roadmap visibility", "solve - --robot disc:0.3",
                            "solve - --robot disc:0.3 --arcs", "solve - --robot square:0.2", "solve - --clearance 0.3",
                            "solve - --widest", "solve - --tradeoff", "compare - --planners polyanya,voronoi",
                            "passage -", "passage - --robot disc:0.3", "bug -", "bug - --robot disc:0.2", "check -"}) {
    const Outcome refused = run_taut(words, kRoom);
    EXPECT_EQ(refused.code, 3) << words;
    EXPECT_THAT(refused.err, HasSubstr("nearest free point (1.5")) << words;
    const Outcome moved = run_taut(std::string(words) + " --snap-ends 1 --json -", kRoom);
    EXPECT_EQ(moved.code, 0) << words << moved.err;
    EXPECT_THAT(moved.out, HasSubstr("\"moved_ends\"")) << words;
  }
}

TEST_F(SnapEnds, OfADiscByItsTrueDistanceWithArcs) {
  const std::string wall = "boundary 0 0 6 4\nstart 3 2.1\ngoal 5 3\n1 2 4 2\n";
  EXPECT_THAT(run_taut("solve - --robot disc:0.35 --arcs", wall).err,
              HasSubstr("start (3, 2.1) is 0.25 too near for the robot to the wall from (1, 2) to (4, 2), line 4; "
                        "nearest free point (3, 2.35)"));
}

TEST_F(SnapEnds, NameTheWallThatIsNear) {
  // Seen from (180, 100) the obstacle's first corner is farther than the wall.
  const std::string world =
      "{\"type\": \"FeatureCollection\", \"features\": ["
      "{\"type\": \"Feature\", \"properties\": {\"role\": \"obstacle\"}, \"geometry\": {\"type\": \"Polygon\", "
      "\"coordinates\": [[[200, 0], [400, 0], [400, 300], [200, 300], [200, 0]]]}},"
      "{\"type\": \"Feature\", \"properties\": {\"role\": \"wall\"}, \"geometry\": {\"type\": \"LineString\", "
      "\"coordinates\": [[0, 0], [0, 300]]}}]}";
  EXPECT_THAT(run_taut("solve - --from 100,100 --to 180,100 --robot disc:30", world).err,
              HasSubstr("goal (180, 100) is 10 too near for the robot to the obstacle with the side from (200, 300) to "
                        "(200, 0)"));
}

TEST_F(SnapEnds, OfABatchAreSaidLineByLine) {
  const std::string queries = "0.5 0.5 3 2.01\n0.5 0.5 0.5 3\n";
  const std::string world = folder.file("room.txt", kRoom), file = folder.file("queries.txt", queries);
  const std::string words = "batch " + world + " " + file;
  EXPECT_THAT(run_taut(words).out, HasSubstr("1 blocked\n"));
  const Outcome moved = run_taut(words + " --snap-ends 0.1 --json-lines");
  EXPECT_EQ(moved.code, 0);
  EXPECT_THAT(moved.out,
              HasSubstr("\"moved_ends\": [{\"end\": \"goal\", \"given\": [3.0, 2.01], \"moved_to\": [3.0, 2.03]"));
  EXPECT_THAT(moved.err, HasSubstr("1 end moved by 0.02 at most"));
}

}  // namespace
}  // namespace taut::test
