// taut chase
#include <sys/stat.h>

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
using testing::StartsWith;

class ChaseProgram : public ProgramTest {};

std::string town() { return (data_dir() / "town_60x40.chase").string(); }

TEST_F(ChaseProgram, PrintsWhatIsProvenAndFourColumns) {
  const Outcome run = run_taut("chase " + town());
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out,
            "town_60x40.chase: caught at (19, 21); nobody does for less (proven)\n"
            "caught    time   moves    cost\n"
            "   yes      40      40      71\n");
  EXPECT_THAT(run_taut("chase --clock one " + town()).out, HasSubstr("   yes      41      40      72\n"));
}

void expect_optima(const std::string& map, int zero, int one) {
  EXPECT_EQ(json::parse(run_taut("chase --json - --clock zero " + map).out)["result"]["cost"], zero);
  EXPECT_EQ(json::parse(run_taut("chase --json - --clock one " + map).out)["result"]["cost"], one);
}

TEST_F(ChaseProgram, ReproducesTheOptimumByBothClocks) {
  expect_optima(town(), 71, 72);
  if (const auto shared = shared_data_dir()) expect_optima((*shared / "pursuit" / "map3.txt.gz").string(), 241, 240);
}

TEST_F(ChaseProgram, WritesJsonPathAndPictures) {
  const json envelope = json::parse(run_taut("chase --json - " + town()).out), answer = envelope["result"];
  EXPECT_EQ(envelope["command"], "chase");
  EXPECT_EQ(envelope["status"], "found");
  EXPECT_EQ(answer["caught"], true);
  EXPECT_EQ(answer["time"], 40);
  EXPECT_EQ(answer["moves"], 40);
  EXPECT_EQ(answer["cost"], 71);
  EXPECT_EQ(answer["proven"], true);
  EXPECT_EQ(answer["lower_bound"], 71);
  EXPECT_GT(answer["peak_memory_bytes"], 0);
  EXPECT_GE(answer["planning"]["slowest_seconds"], answer["planning"]["first_seconds"]);
  EXPECT_EQ(answer["path"].size(), 41U);
  const Outcome path = run_taut("chase -q --path " + town());
  EXPECT_EQ(std::count(path.out.begin(), path.out.end(), '\n'), 41);
  EXPECT_THAT(path.out, ContainsRegex("40 19,21\n$"));
  const std::string still = run_taut("chase --svg - " + town()).out,
                    moving = run_taut("chase --animate - " + town()).out;
  EXPECT_THAT(still, StartsWith("<svg xmlns="));
  EXPECT_THAT(still, HasSubstr("data:image/png;base64,iVBORw0KGgo"));
  EXPECT_THAT(still, HasSubstr("caught at 40"));
  EXPECT_THAT(still, HasSubstr("<title>town_60x40.chase</title>"));
  for (const char* key : {">robot<", ">target<", ">target later<", ">obstacle<", ">cost 1 to 101<"})
    EXPECT_THAT(still, HasSubstr(key));
  EXPECT_THAT(still, testing::ContainsRegex(">[0-9]+ cells<"));
  EXPECT_EQ(still, run_taut("chase --svg - " + town()).out);
  EXPECT_THAT(moving, HasSubstr("<animate attributeName=\"cx\""));
}

TEST_F(ChaseProgram, LetsEachPlannerChase) {
  const Outcome run = run_taut("chase compare " + town());
  EXPECT_EQ(run.code, 0) << run.err;
  for (const char* line : {"exact +yes +40 +40 +71 +yes", "entry +yes +83 +78 +83 +no", "weighted +yes", "first +yes"})
    EXPECT_THAT(run.out, ContainsRegex(line));
  EXPECT_EQ(json::parse(run_taut("chase compare --json - " + town()).out)["result"]["chases"].size(), 6U);
  EXPECT_EQ(run_taut("chase compare -q " + town()).out, "");
  EXPECT_THAT(run_taut("chase --planner entry " + town()).out, HasSubstr("not proven optimal"));
  const Outcome old = run_taut("chase --planner report " + town());
  EXPECT_EQ(old.code, 2);
  EXPECT_THAT(old.err, HasSubstr("did you mean `--planner entry`?"));
}

// A building so large that the least cost is not proven for a while; its first plan comes soon.
TEST_F(ChaseProgram, HeadsForWhereTheTargetWillBe) {
  const std::string map = "N 1,9 C 9 R 1,1 T 1,9 1,8 1,7 1,6 1,5 1,4 1,3 1,2 1,1 M 1,1,1,1,1,1,1,1,1";
  const json ahead = json::parse(run_taut("chase - --planner ahead --ahead 0 --json -", map).out)["result"];
  EXPECT_EQ(ahead["planner"], "ahead");
  EXPECT_EQ(ahead["caught"], true);
  EXPECT_EQ(ahead["time"], 4);
  EXPECT_EQ(ahead["proven"], false);
  EXPECT_EQ(run_taut("chase - --planner fixed", map).code, 0);
  // Straight on it is dear and in time, around the obstacles cheap and two seconds late.
  const char* kTwoLanes = "N 3,4 C 9 R 1,1 T 1,4 1,4 1,4 1,4 M 1,8,8,1 1,9,9,1 1,1,1,1";
  const Outcome late = run_taut("chase - --planner fixed", kTwoLanes);
  EXPECT_EQ(late.code, 4);
  EXPECT_THAT(late.out, HasSubstr("the target got away"));
  EXPECT_EQ(run_taut("chase - --planner exact", kTwoLanes).code, 0);
}

TEST_F(ChaseProgram, TakesAnyWeightAndWritesTheTableAsCsv) {
  const auto cost = [&](const std::string& weight) {
    return json::parse(
               run_taut("chase --planner weighted --json - --weight " + weight + " " + town()).out)["result"]["cost"]
        .get<double>();
  };
  EXPECT_EQ(cost("1"), 83);
  EXPECT_GE(cost("50"), 71);
  const std::string file = (folder / "chases.csv").string();
  EXPECT_EQ(run_taut("chase compare --free-planning --csv " + file + " " + town()).code, 0);
  const std::string table = contents(file);
  EXPECT_THAT(table, StartsWith("map,planner,caught,time,moves,cost,proven,cpu_seconds\n"));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 7);
  EXPECT_THAT(table, HasSubstr("town_60x40.chase,exact,1,40,40,71,1,"));
  EXPECT_EQ(run_taut("chase --weight 0 " + town()).code, 2);
}

TEST_F(ChaseProgram, WritesTheBestPlanSoFarWhenStopped) {
  const std::string map = (folder / "large.chase").string(), file = (folder / "a.json").string();
  ASSERT_EQ(run_taut("chase generate --building --costly --size 700 --duration 3000 --seed 2 -o " + map).code, 0);
  for (const double seconds : {0.5, 1.0, 2.0, 4.0}) {
    const Outcome run = run_taut("chase --free-planning --json " + file + " " + map, "", seconds);
    if (run.code == 0) continue;  // a fast machine
    EXPECT_EQ(run.code, 4);
    const json envelope = json::parse(contents(file));
    EXPECT_EQ(envelope["status"], "stopped");
    EXPECT_THAT(envelope["reason"].get<std::string>(), StartsWith("interrupted"));
    const json& answer = envelope["result"];
    if (answer.is_null() || answer["plan_cost"].is_null()) continue;  // before the first plan
    EXPECT_LE(answer["lower_bound"], answer["plan_cost"]);
    EXPECT_GT(answer["path"].size(), 1U);
    EXPECT_THAT(run.out, HasSubstr("the best plan so far costs "));
  }
}

TEST_F(ChaseProgram, KeepsFinishedRowsWhenTheComparisonIsStopped) {
  const std::string endless = (folder / "endless").string(), file = (folder / "a.json").string();
  ASSERT_EQ(mkfifo(endless.c_str(), 0600), 0);
  const Outcome run = run_taut("chase compare " + town() + " - --max-seconds 5 --json " + file + " <>" + endless);
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.out, ContainsRegex("first +yes"));
  const json envelope = json::parse(contents(file));
  EXPECT_EQ(envelope["status"], "stopped");
  EXPECT_EQ(envelope["result"]["chases"].size(), 6U);
}

TEST_F(ChaseProgram, SaysWhyATargetCannotBeCaught) {
  const auto expect_reason = [](const char* map, const char* reason) {
    for (const char* planner : {"exact", "entry", "weighted", "first"}) {
      const Outcome run = run_taut(std::string("chase - --planner ") + planner, map);
      EXPECT_EQ(run.code, 1) << planner;
      EXPECT_EQ(run.out, std::string("<stdin>: the target cannot be caught: ") + reason + "\n") << planner;
    }
  };
  expect_reason("N 1,3 C 5 R 1,1 T 1,3 1,3 1,3 M 1,1,9", "the target is inside obstacles all the time");
  expect_reason("N 1,3 C 5 R 1,1 T 1,3 1,3 1,3 M 1,9,1",
                "obstacles separate the target's whole trajectory from the robot");
  expect_reason("N 1,4 C 5 R 1,1 T 1,4 1,4 1,4 M 1,1,1,1",
                "the trajectory is too short: the robot comes at least 1 second late to each of its cells");
  expect_reason("N 1,4 C 5 R 1,1 T 1,1 M 1,1,1,1",
                "the trajectory is too short: its only entry is where the target begins");
}

TEST_F(ChaseProgram, ChasesATargetThatItSeesSecondBySecond) {
  const Outcome all = run_taut("chase --online --horizon 1000 " + town());
  EXPECT_EQ(all.code, 0) << all.err;
  EXPECT_THAT(all.out, HasSubstr("costs 1.000 times the optimum of one who knows all"));
  EXPECT_THAT(all.out, HasSubstr("   yes      40      40      71\n"));
  const json answer = json::parse(run_taut("chase --online --json - " + town()).out)["result"];
  EXPECT_EQ(answer["planner"], "online");
  EXPECT_EQ(answer["caught"], true);
  EXPECT_EQ(answer["online"]["horizon"], 0);
  EXPECT_EQ(answer["online"]["clairvoyant_cost"], 71);
  EXPECT_GE(answer["online"]["ratio"], 1);
  const Outcome away = run_taut("chase - --online", "N 1,5 C 5 R 1,1 T 1,3 1,4 1,5 M 1,1,1,1,1");
  EXPECT_EQ(away.code, 1) << "nobody could: " << away.out;
}

TEST_F(ChaseProgram, GeneratesBuildings) {
  const Outcome map = run_taut("chase generate --building --costly --inflation 3 --size 80x50 --duration 150 --seed 4");
  EXPECT_EQ(map.out,
            run_taut("chase generate --building --costly --inflation 3 --size 80x50 --duration 150 --seed 4").out);
  EXPECT_EQ(json::parse(run_taut("chase - --json -", map.out).out)["result"]["proven"], true);
}

TEST_F(ChaseProgram, GeneratesTheTownOfTheData) {
  const Outcome run = run_taut("chase generate --size 60x40 --duration 120 --costly --buildings 0.25 --seed 2");
  EXPECT_EQ(run.out, contents(town()));
}

TEST_F(ChaseProgram, RefusesWrongUsage) {
  for (const char* words :
       {"chase", "chase --planner magic x", "chase --clock two x", "chase compare", "chase generate --size 2",
        "chase --svg - --animate - x", "chase --plan-seconds -1 x", "chase --horizon 3 x",
        "chase --online --planner exact x", "chase generate --inflation 0", "chase generate --inflation 3",
        "chase generate --building --buildings 0.3", "chase --robot disc:1 x", "chase generate --json -"}) {
    const Outcome run = run_taut(words);
    EXPECT_EQ(run.code, 2) << words;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
}

struct Wrong {
  const char* map;
  const char* says;
};

TEST_F(ChaseProgram, NamesLineAndCulpritOfAWrongMap) {
  for (const Wrong& w :
       {Wrong{"", "<stdin>: file is empty"}, Wrong{"hello", "'hello' is no section; they are N, C, R, T and M"},
        Wrong{"N\n1,3\nC\n5\nR\n1,4\nT\n1,3\nM\n1,1,1", ":6: "}, Wrong{"N 1,3 C 5 R 1,1 T 1,3 M 1,1", "ends too soon"},
        Wrong{"N 1,3 C 5 R 1,1 T 1,3 M 1,1,1,1", "is left over"}, Wrong{"N 1,3 C 5 R 1,1 T 1,3 M 1,-1,1", "negative"},
        Wrong{"N 1,3 C 5 R 1,1 M 1,1,1", "T"}, Wrong{"N 1,3 C 5 R 1,1 T 1,3 M 9,1,1", "start"},
        Wrong{"N 1,3 C 5 C 5 R 1,1 T 1,3 M 1,1,1", "a second section C"}, Wrong{"N 0,3 C 5 R 1,1 T 1,3 M", "no cells"},
        Wrong{"N 1,3 C 5 Q 1,1 T 1,3 M 1,1,1", "is no section"}}) {
    const Outcome run = run_taut("chase -", w.map);
    EXPECT_EQ(run.code, 3) << w.map;
    EXPECT_EQ(run.out, "");
    EXPECT_THAT(run.err, HasSubstr(w.says));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
  EXPECT_EQ(run_taut("chase /nowhere/at/all").code, 3);
}

}  // namespace
}  // namespace taut::test
