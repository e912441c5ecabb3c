// --shard, --part, --join: what one run would have given.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

std::string numbers(int lines, int a_line, unsigned seed) {
  std::mt19937 draw(seed);
  std::string text;
  for (int i = 0; i < lines; ++i) {
    for (int k = 0; k < a_line; ++k) text += std::to_string(1 + draw() % 46 / 2.0).substr(0, 4) + " ";
    text += "\n";
  }
  return text;
}

class Shards : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    maze = folder.file("maze.txt", run_taut("generate --size 24 --loops 0.3 --seed 5").out);
    queries = folder.file("queries.txt", "# head\n" + numbers(700, 4, 1) + "1 1 2 2 5\n");
    points = folder.file("points.txt", numbers(60, 2, 2));
    batch = "batch " + maze + " " + queries + " --path";
    matrix = "matrix " + maze + " " + points;
  }

  std::string part(int shard) const { return in_folder("part." + std::to_string(shard)); }
  Outcome shard(const std::string& command, int i, int n, const std::string& more = {}) const {
    return run_taut(command + " --shard " + std::to_string(i) + "/" + std::to_string(n) + " --part " + part(i) + more);
  }
  void all_shards(const std::string& command, int n) const {
    for (int i = 1; i <= n; ++i) {
      const Outcome run = shard(command, i, n);
      ASSERT_EQ(run.code, 0) << run.err;
    }
  }
  std::string parts(int n) const {
    std::string names;
    for (int i = n; i >= 1; --i) names += " " + part(i);  // in whatever order
    return names;
  }
  /// The refusal, in one line.
  std::string refusal(const std::string& command) const {
    const Outcome run = run_taut(command);
    EXPECT_EQ(run.code, 3) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(run.out, "");
    return run.err;
  }

  std::string maze, queries, points, batch, matrix;
};

TEST_F(Shards, OfBatchGiveWhatOneRunGives) {
  const Outcome whole = run_taut(batch), lines = run_taut(batch + " --json-lines");
  EXPECT_EQ(whole.code, 1) << "a length is wrong";
  for (const int n : {1, 2, 3, 5}) {  // of three items
    SCOPED_TRACE(n);
    all_shards(batch, n);
    const Outcome joined = run_taut(batch + " --join" + parts(n));
    EXPECT_EQ(joined.code, 1);
    EXPECT_EQ(joined.out, whole.out);
    EXPECT_THAT(joined.err, HasSubstr("queries.txt:702: expected 5, found 1.41421356"));
    EXPECT_EQ(run_taut(batch + " --json-lines --join" + parts(n)).out, lines.out) << "how it is printed is free";
    for (int i = 1; i <= n; ++i) std::filesystem::remove(part(i));
  }
}

TEST_F(Shards, OfMatrixGiveWhatOneRunGives) {
  for (const char* more : {"", " --robot disc:0.2 --snap-ends 0.3"}) {
    SCOPED_TRACE(more);
    const Outcome whole = run_taut(matrix + more);
    EXPECT_EQ(whole.out.size() > 1000, true) << whole.err;
    all_shards(matrix + more, 3);
    const Outcome joined = run_taut(matrix + more + " --join" + parts(3));
    EXPECT_EQ(joined.out, whole.out);
    EXPECT_EQ(joined.code, whole.code);
    run_taut(matrix + more + " -o " + in_folder("whole.npy"));
    run_taut(matrix + more + " -o " + in_folder("joined.npy") + " --join" + parts(3));
    EXPECT_EQ(contents(folder / "joined.npy"), contents(folder / "whole.npy"));
    for (int i = 1; i <= 3; ++i) std::filesystem::remove(part(i));
  }
}

json without_times(json value) {
  if (value.is_structured()) {
    for (auto it = value.begin(); it != value.end();)
      if (value.is_object() && (it.key().find("second") != std::string::npos || it.key() == "stages"))
        it = value.erase(it);
      else
        *it = without_times(*it), ++it;
  }
  return value;
}

TEST_F(Shards, OfCompareGiveWhatOneRunGives) {
  const std::string compare =
      "compare " + data_file("corridors_30x20.txt") + " --runs 3 --planners cells4,prm,prm-funnel,voronoi";
  const Outcome whole = run_taut(compare + " --json " + in_folder("whole.json"));
  all_shards(compare, 4);
  const Outcome joined = run_taut(compare + " --json " + in_folder("joined.json") + " --join" + parts(4));
  EXPECT_EQ(joined.code, whole.code);
  EXPECT_EQ(without_times(json::parse(contents(folder / "joined.json"))),
            without_times(json::parse(contents(folder / "whole.json"))));
  EXPECT_EQ(run_taut(compare + " --svg a.svg --join" + parts(4)).code, 2);
}

TEST_F(Shards, ThatWereStoppedGoOnAfterWhatIsWhole) {
  all_shards(batch, 2);
  const std::string whole = contents(part(1));
  const std::size_t second_item = whole.find("\nitem 2 ");
  ASSERT_NE(second_item, std::string::npos);
  std::string damaged = whole;
  damaged[second_item - 40] ^= 1;  // of the first item
  for (const std::string& left :
       {std::string(), whole.substr(0, 30), whole.substr(0, second_item - 100), whole.substr(0, second_item + 12),
        whole.substr(0, second_item + 100), whole.substr(0, whole.size() - 2), damaged}) {
    folder.file("part.1", left);
    EXPECT_EQ(shard(batch, 1, 2).code, 0);
    const std::string again = contents(part(1));
    EXPECT_EQ(again.size(), whole.size());  // times differ
    if (left.size() > second_item && left != damaged)
      EXPECT_EQ(again.substr(0, second_item), whole.substr(0, second_item)) << "what is whole is kept";
  }
  EXPECT_EQ(run_taut(batch + " --join" + parts(2)).out, run_taut(batch).out);
  EXPECT_THAT(shard(batch, 1, 2).out, HasSubstr("shard 1 of 2: 2 of 2 items done, 2 of them before"));
}

TEST_F(Shards, ThatAreInterruptedKeepWhatIsFinished) {
  const std::string many = folder.file("many.txt", numbers(40'000, 4, 3));
  const std::string large = folder.file("large.txt", run_taut("generate --size 120 --loops 0.2 --seed 2").out);
  const std::string command = "batch " + large + " " + many;
  const Outcome stopped = shard(command, 1, 2, " --max-seconds 0.3 --json " + in_folder("a.json"));
  EXPECT_EQ(stopped.code, 4);
  const json envelope = json::parse(contents(folder / "a.json"));
  EXPECT_EQ(envelope["status"], "stopped");
  EXPECT_THAT(refusal(command + " --join " + part(1)), HasSubstr("part.1: shard 1 of 2 is cut off at item"));
}

TEST_F(Shards, ThatAreMissingForeignOrDamagedAreNamed) {
  all_shards(batch, 3);
  const std::string join = batch + " --join ";
  EXPECT_THAT(refusal(join + part(1) + " " + part(3)), HasSubstr("--join: shard 2 of 3 is missing"));
  EXPECT_THAT(refusal(join + parts(3) + " " + part(2)), HasSubstr("part.2: is shard 2, as "));
  EXPECT_THAT(refusal(join + queries), HasSubstr("queries.txt: is no shard of taut's"));
  EXPECT_THAT(refusal(batch + " --robot disc:0.1 --join" + parts(3)), HasSubstr("part.3: is a shard of another work"));
  EXPECT_THAT(refusal(matrix + " --join" + parts(3)), HasSubstr("part.3: is a shard of taut batch, not of matrix"));
  const std::string other =
      "batch " + folder.file("other.txt", run_taut("generate --size 24 --seed 6").out) + " " + queries;
  EXPECT_THAT(refusal(other + " --path --join" + parts(3)), HasSubstr("another work"));
  EXPECT_THAT(refusal(other + " --path --shard 1/3 --part " + part(1)),
              HasSubstr("part.1: is a shard of another work"));
  EXPECT_THAT(refusal(batch + " --shard 2/3 --part " + part(1)), HasSubstr("part.1: is shard 1, not 2"));
  std::string bytes = contents(part(2));
  bytes[bytes.size() / 2] ^= 4;
  folder.file("part.2", bytes);
  EXPECT_THAT(refusal(join + parts(3)), HasSubstr("part.2: shard 2 of 3 is damaged at item 1; --shard 2/3 --part"));
  folder.file("part.2", bytes.substr(0, bytes.size() / 2));
  EXPECT_THAT(refusal(join + parts(3)), HasSubstr("part.2: shard 2 of 3 is cut off at item 1"));
}

TEST_F(Shards, AreAskedForInFull) {
  EXPECT_THAT(run_taut(batch + " --shard 3/2 --part " + part(1)).err, HasSubstr("'3/2' is not I/N"));
  EXPECT_THAT(run_taut(batch + " --shard 1 --part " + part(1)).err, HasSubstr("'1' is not I/N"));
  EXPECT_THAT(run_taut(batch + " --shard 1/2").err, HasSubstr("--shard needs --part FILE"));
  EXPECT_THAT(run_taut(batch + " --part " + part(1)).err, HasSubstr("--part needs --shard I/N"));
  EXPECT_EQ(run_taut(batch + " --shard 1/2 --part " + part(1) + " --join " + part(2)).code, 2);
}

}  // namespace
}  // namespace taut::test
