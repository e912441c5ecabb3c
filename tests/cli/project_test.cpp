#include <gmock/gmock.h>

#include <fstream>

#include "support/program_test.h"

namespace taut::test {
namespace {

using testing::HasSubstr;
using testing::Not;

// A room of Berlin, a sloped wall across it, and one that ends on that: in (13.4075, 52.5023), which no doubles hold.
const std::string kRoom =
    "boundary 13.4 52.5 13.42 52.51\n"
    "13.4 52.5011 13.42 52.5043\n"
    "13.4075 52.5023 13.4075 52.51\n";
const std::string kOpen =
    "boundary 13.4 52.5 13.42 52.51\n"
    "13.4 52.5011 13.42 52.5043\n"
    "13.4075 52.5023 13.4075 52.509\n";

class Project : public ProgramTest {};

TEST_F(Project, DoesNotLeakWhereAWallEndsOnASlopedOne) {
  const Outcome outcome = run_taut("solve - --project --from 13.402,52.507 --to 13.418,52.507 --json -", kRoom);
  EXPECT_EQ(outcome.code, 1) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("[[13.4075, 52.5023], [13.4075, 52.51]]"));
}

TEST_F(Project, AnswersInLongitudeAndLatitudeAndMetres) {
  const Outcome outcome = run_taut("solve - --project --from 13.402,52.507 --to 13.418,52.507 --json -", kOpen);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("planned in metres about (13.41, 52.505)"));
  // 435.08 m to the wall's end and 746.98 m from there, by Vincenty's formula.
  EXPECT_THAT(outcome.out, HasSubstr("\"points\": [[13.402, 52.507], [13.4075, 52.509], [13.418, 52.507]]"));
  EXPECT_THAT(outcome.out, HasSubstr("\"corners\": 1"));
  EXPECT_THAT(outcome.out, HasSubstr("\"relative_error\": 0.000113"));
  EXPECT_THAT(outcome.out, HasSubstr("\"error\": 0."));
}

TEST_F(Project, ChecksWhatItWrote) {
  std::ofstream(in_folder("room.txt")) << kOpen;
  const std::string room = in_folder("room.txt");
  for (const char* form : {"--json", "--geojson", "--wkt", "--csv"}) {
    // The start lies on the sloped wall.
    const Outcome solved = run_taut("solve " + room + " --project --from 13.405,52.5019 --to 13.4183,52.50711 -q " +
                                    form + " " + in_folder("path"));
    EXPECT_EQ(solved.code, 0) << solved.err;
    const Outcome checked = run_taut("check " + room + " --project --path " + in_folder("path"));
    EXPECT_EQ(checked.code, 0) << form << checked.out << checked.err;
    EXPECT_THAT(checked.out, HasSubstr("valid, length ")) << form;
  }
  std::ofstream(in_folder("wrong")) << "13.405 52.507\n13.41 52.507\n";
  EXPECT_EQ(run_taut("check " + room + " --project --path " + in_folder("wrong")).code, 1);
}

TEST_F(Project, AnswersQueries) {
  std::ofstream(in_folder("room.txt")) << kRoom;
  const Outcome outcome = run_taut("batch " + in_folder("room.txt") + " - --project --path",
                                   "13.402 52.507 13.41 52.509\n"
                                   "13.405 52.5019 13.4065 52.509\n");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("1 none\n2 796.60"));
  EXPECT_THAT(outcome.out, HasSubstr(" 13.405 52.5019 13.4065 52.509\n"));
}

TEST_F(Project, MeasuresAllPairs) {
  std::ofstream(in_folder("room.txt")) << kRoom;
  // The first lies on the sloped wall, the last in the other room.
  const Outcome outcome = run_taut("matrix " + in_folder("room.txt") + " - --project",
                                   "lat,lon\n52.5019,13.405\n52.509,13.4065\n52.509,13.41\n");
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("0,796.60"));
  EXPECT_THAT(outcome.out, HasSubstr("inf,inf,0\n"));
}

TEST_F(Project, TakesRobotsAndWallsInMetres) {
  // Between the wall's end and the boundary, on which one may stand, are 0.001 degrees, 111.28 m.
  const std::string ends = "solve - --project --from 13.402,52.507 --to 13.418,52.507 ";
  EXPECT_EQ(run_taut(ends + "--robot disc:111", kOpen).code, 0);
  EXPECT_EQ(run_taut(ends + "--robot disc:112", kOpen).code, 1);
  EXPECT_EQ(run_taut(ends + "--wall-thickness 222", kOpen).code, 0);
  EXPECT_EQ(run_taut(ends + "--wall-thickness 223", kOpen).code, 1);
}

TEST_F(Project, NamesPlacesInLongitudeAndLatitude) {
  const std::string ends = "solve - --project --from 13.4075,52.507 --to 13.418,52.507 --wall-thickness 2 ";
  const Outcome refused = run_taut(ends, kOpen);
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, HasSubstr("start (13.4075, 52.507) lies 1 m inside the wall from (13.4075, 52.5023) to "
                                     "(13.4075, 52.509), line 3; nearest free point (13.4"));
  const Outcome moved = run_taut(ends + "--snap-ends 1.5 --json -", kOpen);
  EXPECT_EQ(moved.code, 0) << moved.err;
  EXPECT_THAT(moved.out, HasSubstr("\"given\": [13.4075, 52.507]"));
}

TEST_F(Project, IsRefusedWhereItMeansNothing) {
  for (const char* words : {"bug - --project", "compare - --project", "convert - --as wkt --project",
                            "solve - --project --widest", "solve - --project --robot disc:1 --arcs"}) {
    const Outcome outcome = run_taut(words, kOpen);
    EXPECT_EQ(outcome.code, 2) << words;
    EXPECT_THAT(outcome.err, HasSubstr("--project")) << words;
  }
  const Outcome swapped = run_taut("solve - --project --from 52.507,13.402 --to 13.418,52.507", kOpen);
  EXPECT_EQ(swapped.code, 3);
  EXPECT_THAT(swapped.err, HasSubstr("longitude comes first"));
}

}  // namespace
}  // namespace taut::test
