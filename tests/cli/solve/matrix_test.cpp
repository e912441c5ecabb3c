// taut matrix: all pairs of points.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/program_test.h"
#include "support/text.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kRoom = "boundary 0 0 10 10\n5 0 5 6\n";

class MatrixCommand : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    room = folder.file("room.txt", kRoom);
  }
  Outcome run(const std::string& points, const std::string& options = "") {
    return run_taut("matrix " + room + " - " + options, points);
  }
  std::string room;
};

TEST_F(MatrixCommand, PrintsARowAPoint) {
  const Outcome outcome = run("2 2 # left\n8,2\n\n2 6\n");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "0,10,4\n10,0,8\n4,8,0\n");
  EXPECT_THAT(outcome.err, HasSubstr("3 points, longest 10"));
}

TEST_F(MatrixCommand, AgreesWithBatchToTheLastDigit) {
  const std::vector<std::string> points{"0.1 0.7", "9.3 1.2", "5 6", "5 2.5", "7.7 9.9", "0 0", "4.9 5.9"};
  std::string lines, queries;
  for (const std::string& p : points) {
    lines += p + "\n";
    for (const std::string& q : points) queries += p + " " + q + "\n";
  }
  const Outcome batch = run_taut("batch " + room + " -", queries);
  std::string expected;
  std::size_t number = 0, at = 0;
  for (std::size_t end; (end = batch.out.find('\n', at)) != std::string::npos; at = end + 1) {
    const std::size_t blank = batch.out.find(' ', at);
    expected += batch.out.substr(blank + 1, end - blank - 1) + (++number % points.size() == 0 ? "\n" : ",");
  }
  EXPECT_EQ(run(lines).out, expected);
}

TEST_F(MatrixCommand, TellsPairsWithoutAPath) {
  room = folder.file("sealed.txt", "boundary 0 0 10 10\n5 0 5 10\n");
  const Outcome outcome = run("2 2\n8 2\n", "--json " + in_folder("a.json"));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.out, "0,inf\ninf,0\n");
  EXPECT_THAT(outcome.err, HasSubstr("1 pair without a path"));
  const json result = json::parse(contents(in_folder("a.json")));
  EXPECT_EQ(result["status"], "none");
  EXPECT_EQ(result["result"]["none"], 1);
  EXPECT_TRUE(result["result"]["lengths"][0][1].is_null());
}

TEST_F(MatrixCommand, IsNoNumberWhereNothingProvesThatThereIsNoPath) {
  const std::string world = folder.file("gap.txt", "boundary 0 0 10 10\n5 0 5 4\n5 6 5 10\n");
  const Outcome outcome = run_taut("matrix --robot disc:1 " + world + " -", "2 5\n8 5\n");
  EXPECT_EQ(outcome.out, "0,nan\nnan,0\n");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_EQ(run_taut("matrix --robot disc:1.01 " + world + " -", "2 5\n8 5\n").out, "0,inf\ninf,0\n");
}

TEST_F(MatrixCommand, WritesNumPyAndBareNumbers) {
  const std::string npy = in_folder("a.npy"), raw = in_folder("a.f64");
  EXPECT_THAT(run("2 2\n8 2\n2 6\n", "-o " + npy).out, StartsWith(room + ": 3 points, longest 10, "));
  run("2 2\n8 2\n2 6\n", "-o " + raw);
  const std::string numbers = contents(raw), array = contents(npy);
  ASSERT_EQ(numbers.size(), 72u);
  double second = 0;
  std::memcpy(&second, numbers.data() + 8, 8);
  EXPECT_EQ(second, 10);
  EXPECT_THAT(array, StartsWith(std::string("\x93NUMPY\x01\x00", 8)));
  EXPECT_THAT(array, HasSubstr("{'descr': '<f8', 'fortran_order': False, 'shape': (3, 3), }"));
  EXPECT_EQ((array.size() - 72) % 64, 0u);
  EXPECT_EQ(array.substr(array.size() - 72), numbers);
  EXPECT_EQ(array[array.size() - 73], '\n');
}

TEST_F(MatrixCommand, NamesTheLineOfAPointThatIsNoPlace) {
  const std::string world = folder.file("block.wkt", "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 6 3, 6 6, 3 6, 3 3))");
  const Outcome outcome = run_taut("matrix " + world + " -", "1 1\n# block\n4 3.5\n");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("<stdin>:3: point (4, 3.5) lies 0.5"));
  EXPECT_THAT(outcome.err, HasSubstr("nearest free point (4, 3)"));
  const Outcome moved = run_taut("matrix " + world + " - --snap-ends 1", "1 3\n4 3.5\n");
  EXPECT_EQ(moved.out, "0,3\n3,0\n");
  EXPECT_THAT(moved.err, HasSubstr("moved there"));
}

TEST_F(MatrixCommand, RefusesWhatItCannotWriteOrRead) {
  EXPECT_EQ(run("1 1\n", "-o " + in_folder("a.xls")).code, 2);
  EXPECT_EQ(run("1 1\n", "--as npy").code, 2);
  EXPECT_EQ(run("1 1\n", "-o - --as png").code, 2);
  EXPECT_EQ(run("").code, 3);
  EXPECT_THAT(run("# none\n").err, HasSubstr("<stdin>: holds no points"));
  EXPECT_EQ(run_taut("matrix - -", "").code, 2);
}

TEST_F(MatrixCommand, HasPointsOnSlopedWallsWhereTheyAreWritten) {
  // The crossing of the walls is no pair of decimals, so both bend there.
  const std::string world = folder.file("cross.txt", "boundary 0 0 7 7\n4 7 6 3\n1 2 7 5\n");
  const Outcome outcome = run_taut("matrix " + world + " -", "5 5\n5 6\n4.5 6\n");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const Outcome batch = run_taut("batch " + world + " -", "5 5 5 6\n5 5 4.5 6\n5 6 4.5 6\n");
  EXPECT_EQ(batch.out, "1 1\n2 1.118033988749895\n3 0.5\n");
  EXPECT_EQ(outcome.out, "0,1,1.118033988749895\n1,0,0.5\n1.118033988749895,0.5,0\n");
}

TEST_F(MatrixCommand, StoppedByALimitPrintsTheRowsThatAreFinal) {
  const std::string maze = in_folder("maze.txt");
  ASSERT_EQ(run_taut("generate --size 120x120 --loops 0.3 -o " + maze).code, 0);
  std::string points;
  for (int n = 0; n < 4000; ++n) points += std::to_string(n % 119) + ".5 " + std::to_string(n / 119) + ".5\n";
  const Outcome outcome = run_taut("matrix " + maze + " - --max-seconds 1.5 --json " + in_folder("a.json"), points);
  EXPECT_EQ(outcome.code, 4);
  const json envelope = json::parse(contents(in_folder("a.json")));
  EXPECT_EQ(envelope["status"], "stopped");
  const json result = envelope["result"].is_object() ? envelope["result"] : json::object();
  const std::vector<std::string> rows = lines_of(outcome.out);
  EXPECT_EQ(result.value("rows", std::size_t{0}), rows.size());
  for (const std::string& row : rows) EXPECT_EQ(count(row, ","), 3999u);
}

}  // namespace
}  // namespace taut::test
