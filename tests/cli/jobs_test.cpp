// --jobs N: the same results, to the last byte, however many threads there are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "support/program_test.h"
#include "support/sanitized.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// Without what was measured: times, and how much memory there was.
json without_times(const json& value) {
  if (value.is_array()) {
    json kept = json::array();
    for (const json& item : value) kept.push_back(without_times(item));
    return kept;
  }
  if (!value.is_object()) return value;
  json kept = json::object();
  for (const auto& [key, item] : value.items())
    if (key.find("second") == std::string::npos && !key.ends_with("_ms") && key != "peak_memory_bytes")
      kept[key] = without_times(item);
  return kept;
}

std::string points(int count, int side, unsigned seed, int numbers) {
  std::mt19937 draw(seed);
  std::string lines;
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < numbers; ++k)
      lines += std::to_string(1 + draw() % static_cast<unsigned>(4 * side - 4) / 4.0).substr(0, 6) + " ";
    lines += "\n";
  }
  return lines;
}

class Jobs : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    maze = folder.file("maze.txt", run_taut("generate --size 24 --loops 0.3 --seed 5").out);
  }

  /// The same answer from 1, 2 and 5 threads: what is printed, unless it tells times, what is written, and the result.
  void expect_the_same(const std::string& command, std::string_view input, const std::string& file = {},
                       bool prints_times = false) {
    Outcome first;
    std::string bytes;
    json result;
    for (const char* jobs : {"1", "2", "5"}) {
      SCOPED_TRACE(command + " --jobs " + jobs);
      const Outcome run = run_taut(command + " --jobs " + jobs + " --json " + in_folder("result.json"), input);
      json envelope = json::parse(contents(folder / "result.json"));
      ASSERT_NE(envelope["status"], "refused") << run.err;
      if (result.is_null()) {
        first = run;
        result = without_times(envelope);
        if (!file.empty()) bytes = contents(folder / file);
        continue;
      }
      EXPECT_EQ(run.code, first.code);
      if (!prints_times) EXPECT_EQ(run.out, first.out);
      EXPECT_EQ(without_times(envelope), result);
      if (!file.empty()) EXPECT_EQ(contents(folder / file), bytes);
    }
  }

  std::string maze;
};

TEST_F(Jobs, OfBatchChangeNoByte) {
  const std::string queries = points(400, 24, 1, 4);  // enough for the graph and for landmarks
  expect_the_same("batch " + maze + " - --path", queries);
  expect_the_same("batch " + maze + " - --json-lines --snap-ends 0.1", queries);
  expect_the_same("batch " + maze + " - --robot disc:0.2", queries);
}

TEST_F(Jobs, OfBatchKeepTheAnswersBeforeALineThatIsWrong) {
  const Outcome one = run_taut("batch " + maze + " - --jobs 1", points(50, 24, 2, 4) + "1 2 3\n"),
                more = run_taut("batch " + maze + " - --jobs 3", points(50, 24, 2, 4) + "1 2 3\n");
  EXPECT_EQ(more.code, 3);
  EXPECT_EQ(std::count(more.out.begin(), more.out.end(), '\n'), 50);
  EXPECT_EQ(more.out, one.out);
  EXPECT_THAT(more.err, HasSubstr("<stdin>:51:"));
}

TEST_F(Jobs, OfMatrixChangeNoByte) {
  expect_the_same("matrix " + maze + " -", points(90, 24, 3, 2));
  expect_the_same("matrix " + maze + " - -o " + in_folder("a.npy"), points(90, 24, 3, 2), "a.npy", true);
}

TEST_F(Jobs, OfRoadmapChangeNoByte) {
  for (const char* kind : {"visibility", "full", "voronoi"})
    expect_the_same("roadmap " + maze + " --kind " + kind + " --graphml " + in_folder("a.xml"), "", "a.xml", true);
}

TEST_F(Jobs, OfCompareChangeNoByte) {
  expect_the_same("compare " + data_file("corridors_30x20.txt") +
                      " --runs 3 --planners polyanya,prm,prm-funnel,full-visibility,voronoi",
                  "", {}, true);
}

TEST_F(Jobs, OfCompareRefuseAPlannerThatCannotRun) {
  const Outcome one = run_taut("compare " + data_file("courtyard.wkt") +
                               " --from 1,1 --to 2,1 --planners prm,cells4,prm --jobs 1"),
                more = run_taut("compare " + data_file("courtyard.wkt") +
                                " --from 1,1 --to 2,1 --planners prm,cells4,prm --jobs 4");
  EXPECT_EQ(one.code, 3);
  EXPECT_EQ(more.code, 3);
  EXPECT_EQ(more.err, one.err);
}

TEST_F(Jobs, OfDriveChangeNoByte) {
  expect_the_same("drive " + data_file("car/lane.txt") + " --all --controls", "", {}, true);
  expect_the_same("drive " + data_file("car/lane.txt") + " --all --planner rrt", "", {}, true);
  EXPECT_EQ(run_taut("drive " + data_file("car/lane.txt") + " --jobs 2").code, 2) << "there is one drive";
}

TEST_F(Jobs, OfMouseCompareChangeNoByte) {
  expect_the_same(
      "mouse compare " + data_file("mouse_12.cells") + " " + data_file("mouse_16.maz") + " --explorers flood,score", "",
      {}, true);
}

TEST_F(Jobs, OfChaseChangeNoByte) {
  expect_the_same("chase " + data_file("town_60x40.chase") + " --free-planning --path", "", {}, true);
}

TEST_F(Jobs, AreANumber) {
  EXPECT_EQ(run_taut("batch " + maze + " - --jobs 0", "1 1 2 2\n").code, 0) << "a thread a core";
  EXPECT_EQ(run_taut("batch " + maze + " - --jobs 2000", "1 1 2 2\n").code, 2);
  EXPECT_THAT(run_taut("batch " + maze + " - --jobs two", "1 1 2 2\n").err,
              HasSubstr("--jobs: 'two' is not a whole number"));
}

// What was answered in order is printed; the clock and signals end it whatever the threads do.
TEST_F(Jobs, StopWithWhatIsFinished) {
  const std::string large = folder.file("large.txt", run_taut("generate --size 200 --loops 0.2 --seed 1").out);
  const std::string queries = folder.file("queries.txt", points(40'000, 200, 4, 4));
  for (const char* limit : {"--max-seconds 0.4", ""}) {
    const Outcome run = run_taut("batch " + large + " " + queries + " --jobs 3 " + limit, "", *limit ? 0 : 0.4);
    EXPECT_EQ(run.code, 4) << run.err;
    EXPECT_THAT(run.err, HasSubstr("stopped in stage"));
  }
}

TEST_F(Jobs, KeepToALimitOfMemory) {
  if (kSanitized) GTEST_SKIP() << "memory cannot be limited";
  const Outcome run = run_taut("batch " + maze + " - --jobs 4 --max-memory 400M", points(200, 24, 6, 4));
  EXPECT_EQ(run.code, 0) << run.err;
  const Outcome little = run_taut("batch " + maze + " - --jobs 64 --max-memory 60M", points(200, 24, 6, 4));
  EXPECT_TRUE(little.code == 0 || little.code == 4) << little.err;
}

}  // namespace
}  // namespace taut::test
