// What the library's geometry finds hard is answered like everything else: nothing is written or printed beside it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "support/locked_folder.h"
#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;

/// A world whose diagram has points that doubles cannot find, the query, and the right radius.
struct HardWorld {
  const char* file;
  const char* text;
  const char* query;
  double radius;
  const char* said = "";  // on stderr
};

void PrintTo(const HardWorld& world, std::ostream* out) { *out << world.file << " " << world.query; }

// Two walls half a hundredth long that turn back at a shared end, at coordinates of a million.
constexpr HardWorld kSliver{"two.wkt",
                            "LINESTRING(999999.999825306 1000000.00509603, 999999.998026552 1000000.00032481)\n"
                            "LINESTRING(999999.998351364 1000000.00229826, 999999.999825306 1000000.00509603)\n",
                            "--wall-thickness 0.00025 --from 1000000.001,1000000.001 --to 999999.996,1000000.003",
                            0.0010818729167804122};
// A wall that ends one unit in the last place from the corner of two others.
constexpr HardWorld kNearMiss{"three.txt", "5 42 6 42\n5 41 4.999999999999999 42\n5 47 5 48\n",
                              "--snap 0 --from 1,1 --to 9,60", 10.5,
                              "taut: three.txt: 1 end nearly touches another wall, at most 8.88e-16 apart: "
                              "(4.999999999999999, 42) and (5, 42)-(6, 42)\n"};

class Silence : public ProgramTest, public testing::WithParamInterface<HardWorld> {
 protected:
  void expect_answer(const Outcome& run) {
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(run.err, GetParam().said);
    const json answer = json::parse(run.out, nullptr, false);
    ASSERT_FALSE(answer.is_discarded()) << run.out;
    EXPECT_EQ(answer["status"], "found");
    const json& result = answer.contains("result") ? answer["result"] : answer;
    EXPECT_EQ(result["verified"], true);
    EXPECT_DOUBLE_EQ(result["radius"], GetParam().radius);
  }

  /// The names in the folder.
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) all.push_back(entry.path().filename());
    return all;
  }

  std::string query(const std::string& mode) const {
    return mode + " " + GetParam().file + " " + GetParam().query + " --json - -q";
  }
};

TEST_P(Silence, FindsTheWidestWayWhereNothingCanBeWritten) {
  folder.file(GetParam().file, GetParam().text);
  expect_answer(run_taut_where_nothing_can_be_written(folder, query("solve --widest")));
  EXPECT_THAT(names(), testing::ElementsAre(GetParam().file));
}

TEST_P(Silence, WritesNothingWhereItCould) {
  folder.file(GetParam().file, GetParam().text);
  expect_answer(run_script("cd '" + folder.path().string() + "' && exec \"$taut\" " + query("solve --widest")));
  EXPECT_THAT(names(), testing::ElementsAre(GetParam().file));
}

INSTANTIATE_TEST_SUITE_P(OfHardInput, Silence, testing::Values(kSliver, kNearMiss),
                         [](const auto& world) { return world.index == 0 ? "Sliver" : "NearMiss"; });

}  // namespace
}  // namespace taut::test
