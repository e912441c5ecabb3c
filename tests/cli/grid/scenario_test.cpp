// taut grid scen: what a scenario file says, and what is found.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/paths.h"
#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class GridScenarios : public ProgramTest {
 protected:
  static json envelope(const std::string& arguments) {
    return json::parse(run_taut("grid " + arguments + " --json -").out);
  }
};

TEST_F(GridScenarios, MayCountDiagonalsInSinglePrecision) {
  std::string bytes = "type octile\nheight 97\nwidth 97\nmap\n";
  for (int row = 0; row < 97; ++row) bytes += std::string(97, '.') + "\n";
  const std::string map = folder.file("open.map", bytes);
  const auto run = [&](const std::string& length) {
    return run_taut("grid scen " + map + " - --json -", "0\topen.map\t97\t97\t0\t0\t96\t96\t" + length + "\n");
  };
  for (const char* length : {"135.764", "135.7645", "135.76449966", "135.76450199"}) {
    EXPECT_EQ(run(length).code, 0) << length;
    EXPECT_EQ(json::parse(run(length).out)["result"]["matched"], 1) << length;
  }
  EXPECT_EQ(json::parse(run("135.76449966").out)["result"]["single_precision"], 1);
  EXPECT_THAT(run("135.764").err, HasSubstr("1 length as the file says only where the root of two is of single"));
  EXPECT_EQ(run("135.76449000").code, 1);
  EXPECT_EQ(run("135.763").code, 1);
  EXPECT_EQ(run("135.76449000").err.find("taut batch"), std::string::npos) << "no any-angle length is that near";
}

TEST_F(GridScenarios, SayZeroWhereThereIsNoWay) {
  const std::string map = folder.file("a.map", "type octile\nheight 1\nwidth 3\nmap\n.@.\n");
  const std::string none = folder.file("a.scen", "version 1\n0\ta.map\t3\t1\t0\t0\t2\t0\t0\n");
  EXPECT_THAT(run_taut("grid scen " + map + " " + none).out, HasSubstr("1 scenario, 1 as the file says"));
  const std::string some = folder.file("b.scen", "version 1\n0\ta.map\t3\t1\t0\t0\t2\t0\t2\n");
  EXPECT_THAT(run_taut("grid scen " + map + " " + some).err, HasSubstr("says 2, found no path"));
  const std::string open = folder.file("b.map", "type octile\nheight 1\nwidth 3\nmap\n...\n");
  EXPECT_THAT(run_taut("grid scen " + open + " " + none).err, HasSubstr("says 0, found 2"));
}

TEST_F(GridScenarios, ScaleTheirMap) {
  const std::string map = folder.file("a.map", "type octile\nheight 3\nwidth 4\nmap\n..@.\n..@.\n....\n");
  const std::string twice = folder.file("a.scen", "version 1\n0\ta.map\t8\t6\t0\t0\t7\t0\t12.65685425\n");
  const Outcome run = run_taut("grid scen " + map + " " + twice);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("a.scen:2: for a map of 8 x 6 cells: " + map + " is scaled to that"));
  const std::string other = folder.file("b.scen", "version 1\n0\ta.map\t8\t7\t0\t0\t7\t0\t12.65685425\n");
  EXPECT_EQ(run_taut("grid scen " + map + " " + other).code, 3);
}

TEST_F(GridScenarios, AgreeWithTheirFileToItsDigits) {
  const std::string map = folder.file("a.map", "type octile\nheight 3\nwidth 4\nmap\n..@.\n..@.\n....\n");
  const std::string right = folder.file("a.scen", "version 1\n0\ta.map\t4\t3\t0\t0\t3\t0\t6.41421\n");
  const Outcome run = run_taut("grid scen " + map + " " + right);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("1 scenario, 1 as the file says, 0 mismatches"));
  const std::string wrong = folder.file("b.scen", "version 1\n0\ta.map\t4\t3\t0\t0\t3\t0\t6.41420\n");
  const Outcome other = run_taut("grid scen " + map + " " + wrong);
  EXPECT_EQ(other.code, 1);
  EXPECT_EQ(envelope("scen " + map + " " + wrong)["status"], "differs");
  EXPECT_EQ(envelope("scen " + map + " " + right)["result"]["matched"], 1);
  EXPECT_EQ(run_taut("grid scen -q " + map + " " + right).out, "");
  EXPECT_THAT(other.err, HasSubstr("b.scen:2: says 6.41420, found 6.41421356"));
  const std::string foreign = folder.file("c.scen", "version 1\n0\ta.map\t5\t3\t0\t0\t3\t0\t6.41421\n");
  EXPECT_EQ(run_taut("grid scen " + map + " " + foreign).code, 3);
  const std::string bare = folder.file("e.scen", "0\ta.map\t4\t3\t0\t0\t3\t0\t6.41421\n");
  EXPECT_THAT(run_taut("grid scen " + map + " " + bare).out, HasSubstr("1 scenario, 1 as the file says"));
  EXPECT_THAT(run_taut("grid solve " + bare).err, HasSubstr("is a scenario file"));
  const std::string walled = folder.file("d.scen", "version 1\n0\ta.map\t4\t3\t2\t0\t3\t0\t6.41421\n");
  EXPECT_EQ(run_taut("grid scen " + map + " " + walled).code, 3);
  EXPECT_EQ(run_taut("grid scen " + map + " " + right + " --algorithm bfs").code, 2);
}

void expect_every_exact_search_to_match(const std::string& files, const char* verdict) {
  for (const char* algorithm : {"jps", "astar", "dijkstra", "bidirectional-astar", "idastar"}) {
    const Outcome run = run_taut("grid scen " + files + " --algorithm " + algorithm);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr(verdict));
  }
}

TEST_F(GridScenarios, AreMatchedByEveryExactSearch) {
  expect_every_exact_search_to_match(data_file("rooms_64x48.map") + " " + data_file("rooms_64x48.scen"),
                                     "40 scenarios, 40 as the file says, 0 mismatches");
  if (const auto shared = shared_data_dir())
    expect_every_exact_search_to_match(
        (*shared / "movingai/arena.map.gz").string() + " " + (*shared / "movingai/arena.map.scen.gz").string(),
        "160 scenarios, 160 as the file says, 0 mismatches");
}

}  // namespace
}  // namespace taut::test
