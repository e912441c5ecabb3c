// taut bug: what it prints, writes and returns.
#include <sys/stat.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

constexpr const char* kRoom = "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 3\nstart 1 2\ngoal 3 2\n";
constexpr const char* kSealed = "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 4\nstart 1 2\ngoal 3 2\n";

class BugCommand : public ProgramTest {};

TEST_F(BugCommand, GivesLengthBoundAndContactsAsJson) {
  const Outcome run = run_taut("bug - --algorithm 2 --turn left --json -", kRoom);
  ASSERT_EQ(run.code, 0) << run.err;
  const auto envelope = nlohmann::json::parse(run.out), json = envelope["result"];
  EXPECT_EQ(envelope["status"], "found");
  EXPECT_EQ(envelope["command"], "bug");
  EXPECT_EQ(json["length"], 4);
  EXPECT_GE(json["bound"], json["length"]);
  EXPECT_EQ(json["hits"].size(), 1U);
  EXPECT_EQ(json["leaves"].size(), 1U);
}

TEST_F(BugCommand, EndsWithOneWhenThereIsNoPathAndTwoOnNonsense) {
  EXPECT_EQ(run_taut("bug - --algorithm 1", kSealed).code, 1);
  EXPECT_EQ(run_taut("bug - --algorithm 2", kSealed).code, 1);
  EXPECT_EQ(run_taut("bug - --algorithm 3", kSealed).code, 2);
  EXPECT_EQ(run_taut("bug - --from 9,9", "boundary 0 0 4 4\n" + std::string(kSealed)).code, 3);
}

TEST_F(BugCommand, PrintsTheShortestLengthAndTheRatioBesideTangentBugs) {
  const Outcome run = run_taut("bug - --algorithm tangent --range inf --json -", kRoom);
  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out)["result"];
  EXPECT_EQ(json["algorithm"], "tangent");
  EXPECT_EQ(json["range"], "inf");
  EXPECT_EQ(json["length"], json["shortest"]);
  EXPECT_EQ(json["ratio"], 1);
  EXPECT_GE(json["bound"], json["length"]);
  const Outcome touch = run_taut("bug - --algorithm tangent --range 0", kRoom);
  EXPECT_THAT(touch.out, testing::HasSubstr("tangent bug, range 0, length 4.000000"));
  EXPECT_EQ(run_taut("bug - --algorithm tangent", kSealed).code, 1);
}

TEST_F(BugCommand, TakesARangeForTangentBugOnly) {
  EXPECT_EQ(run_taut("bug - --range 2", kRoom).code, 2);
  for (const char* range : {"-1", "nan", "far"})
    EXPECT_EQ(run_taut(std::string("bug - --algorithm tangent --range ") + range, kRoom).code, 2) << range;
}

TEST_F(BugCommand, DrawsWhatWasInSight) {
  const std::string still = run_taut("bug - --algorithm tangent --svg -", kRoom).out;
  EXPECT_THAT(still, testing::HasSubstr("<g class=\"views\">"));
  EXPECT_THAT(still, testing::Not(testing::HasSubstr("<animate ")));
  EXPECT_THAT(run_taut("bug - --algorithm tangent --animate -", kRoom).out, testing::HasSubstr("<animate "));
  EXPECT_THAT(run_taut("bug - --algorithm bug2 --svg -", kRoom).out,
              testing::Not(testing::HasSubstr("<g class=\"views\">")));
}

TEST_F(BugCommand, NamesItsContactsBesideThePathAndInTheKey) {
  const std::string picture = run_taut("bug - --svg -", kRoom).out;
  for (const char* words : {">H1 L1<", ">hit point<", ">leave point<", ">straight line<"})
    EXPECT_THAT(picture, testing::HasSubstr(words));
  EXPECT_EQ(picture, run_taut("bug - --svg -", kRoom).out);
}

TEST_F(BugCommand, ComparesAllBugsWithTheShortestPath) {
  const std::string room = folder.file("room.txt", kRoom), sealed = folder.file("sealed.txt", kSealed);
  const Outcome run = run_taut("bug compare " + room + " --range 0,1,inf");
  EXPECT_EQ(run.code, 0) << run.err;
  for (const char* robot : {"bug1", "bug2", "tangent", "shortest"}) EXPECT_THAT(run.out, testing::HasSubstr(robot));
  EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 7);
  EXPECT_EQ(run_taut("bug compare " + room + " " + sealed).code, 1);
  EXPECT_EQ(run_taut("bug compare -q " + room).out, "");
  const auto all = nlohmann::json::parse(run_taut("bug compare --json - " + room + " " + sealed).out);
  EXPECT_EQ(all["status"], "none");
  EXPECT_EQ(all["result"]["journeys"].size(), 8U);
  EXPECT_EQ(run_taut("bug compare").code, 2);
  EXPECT_EQ(run_taut("bug").code, 2);
}

TEST_F(BugCommand, WritesTheComparisonAsATable) {
  const std::string room = folder.file("room.txt", kRoom), sealed = folder.file("sealed.txt", kSealed);
  const std::string file = (folder / "bugs.csv").string();
  EXPECT_EQ(run_taut("bug compare " + room + " " + sealed + " --range 0,inf --csv " + file).code, 1);
  const std::string csv = contents(file);
  EXPECT_THAT(csv, testing::StartsWith("world,robot,range,found,length,ratio,bound,followed,cpu_seconds\n"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 5);
  EXPECT_THAT(csv, testing::HasSubstr(room + ",bug2,,1,4.0,"));
  EXPECT_THAT(csv, testing::HasSubstr(room + ",tangent,inf,1,"));
  EXPECT_THAT(csv, testing::HasSubstr(sealed + ",tangent,0,0,"));
  EXPECT_THAT(csv, testing::HasSubstr(sealed + ",shortest,,0,,,,,\n"));
}

TEST_F(BugCommand, KeepsFinishedRowsWhenTheComparisonIsStopped) {
  const std::string room = folder.file("room.txt", kRoom), endless = (folder / "endless").string();
  ASSERT_EQ(mkfifo(endless.c_str(), 0600), 0);
  const std::string file = (folder / "a.json").string();
  const Outcome run = run_taut("bug compare " + room + " - --max-seconds 2 --json " + file + " <>" + endless);
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.out, testing::HasSubstr("shortest"));
  const auto envelope = nlohmann::json::parse(contents(file));
  EXPECT_EQ(envelope["status"], "stopped");
  EXPECT_EQ(envelope["result"]["journeys"].size(), 4U);
}

}  // namespace
}  // namespace taut::test
