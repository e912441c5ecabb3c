// --mpi: under mpirun, where taut is built with it, what one process gives.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using testing::HasSubstr;

class Ranks : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    maze = folder.file("maze.txt", run_taut("generate --size 24 --loops 0.3 --seed 5").out);
    std::mt19937 draw(1);
    std::string text;
    for (int i = 0; i < 4 * 1500; ++i)
      text += std::to_string(1 + draw() % 46 / 2.0).substr(0, 4) + (i % 4 == 3 ? "\n" : " ");
    queries = folder.file("queries.txt", text);
  }

  std::string maze, queries;
};

#ifdef TAUT_MPIRUN

/// By so many processes, whatever the machine.
Outcome run_by(int ranks, const std::string& command, const std::string& before = "", const std::string& input = "") {
  return run_script(before +
                        " OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 " TAUT_MPIRUN
                        " --oversubscribe --bind-to none -n " +
                        std::to_string(ranks) + " \"$taut\" " + command + " --mpi",
                    input);
}

TEST_F(Ranks, GiveWhatOneProcessGives) {
  const std::string points = folder.file("points.txt", "1 1\n5 5\n20 3\n7 9\n1 20\n3 3\n4 4\n5 6\n9 9\n");
  for (const std::string& command : {"batch " + maze + " " + queries + " --path", "matrix " + maze + " " + points,
                                     "compare " + data_file("corridors_30x20.txt") + " --planners cells4,voronoi -q"}) {
    const Outcome one = run_taut(command);
    for (const int ranks : {1, 2, 4}) {
      SCOPED_TRACE(command + " by " + std::to_string(ranks));
      const Outcome run = run_by(ranks, command);
      EXPECT_EQ(run.code, one.code) << run.err;
      EXPECT_EQ(run.out, one.out);
    }
  }
  const std::string command = "batch " + maze + " - --path --jobs 2";
  EXPECT_EQ(run_by(3, command, "", contents(queries)).out, run_taut("batch " + maze + " " + queries + " --path").out)
      << "standard input is the first rank's";
}

TEST_F(Ranks, NameWhatIsLostAndDoItAgain) {
  const std::string command = "batch " + maze + " " + queries;
  const Outcome one = run_taut(command), failed = run_by(3, command, "TAUT_LOSE=2"),
                alone = run_by(2, command, "TAUT_LOSE=1"),
                late = run_by(3, command + " --lost-after 0.2", "TAUT_LOSE=1:2");
  for (const Outcome& run : {failed, alone, late}) {
    EXPECT_EQ(run.out, one.out);
    EXPECT_EQ(run.code, 0);
  }
  EXPECT_THAT(failed.err, HasSubstr("was lost by rank 2: lost for a test; given again"));
  EXPECT_THAT(late.err, HasSubstr("did not come back from rank 1 for 0.2 s; given again"));
}

TEST_F(Ranks, EndTogetherWhereTheInputIsWrong) {
  EXPECT_EQ(run_by(3, "batch nothing.txt " + queries).code, 3);
  EXPECT_EQ(run_by(3, "batch " + maze + " " + queries + " --max-seconds 0").code, 4);
}

#else

TEST_F(Ranks, AreRefusedByATautWithoutThem) {
  const Outcome run = run_taut("batch " + maze + " " + queries + " --mpi");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("--mpi: this taut was built without MPI"));
}

#endif

TEST_F(Ranks, GoWithNoShard) {
  EXPECT_EQ(run_taut("batch " + maze + " " + queries + " --mpi --shard 1/2 --part a").code, 2);
  EXPECT_EQ(run_taut("batch " + maze + " " + queries + " --mpi --join a").code, 2);
}

}  // namespace
}  // namespace taut::test
