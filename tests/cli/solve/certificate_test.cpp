// taut solve --certificate, taut verify.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr const char* kRoom = "boundary 0 0 4 4\nstart 0.5 1\ngoal 3.5 1\n2 0 2 3\n";
constexpr const char* kOpen = "boundary 0 0 4 4\nstart 0.5 1\ngoal 3.5 1\n2 0 2 2\n";
constexpr const char* kSealed = "boundary 0 0 4 4\nstart 0.5 1\ngoal 3.5 1\n2 0 2 4\n";

constexpr const char* kSlit = "boundary 0 0 4 4\nstart 1 1\ngoal 3 3\n2 0 2 1.8\n2 2.2 2 4\n";

class CertificateProgram : public ProgramTest {
 protected:
  std::string proof_of(const std::string& world, int code) const {
    EXPECT_EQ(run_taut("solve - --certificate " + in_folder("proof"), world).code, code);
    return in_folder("proof");
  }
  static Outcome verify(const std::string& proof, const std::string& world) {
    return run_taut("verify - " + proof, world);
  }
};

TEST_F(CertificateProgram, ProvesThatNoPathIsShorter) {
  const Outcome run = verify(proof_of(kRoom, 0), kRoom);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("proven: no path is shorter than 5.000000000 - "));
  EXPECT_THAT(run.out, HasSubstr("yours is 5.000000000 long"));
}

TEST_F(CertificateProgram, ProvesThatThereIsNoPath) {
  const Outcome run = verify(proof_of(kSealed, 1), kSealed);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("proven: there is no path"));
}

TEST_F(CertificateProgram, ProvesItOfARoomThatIsTheGoal) {
  const std::string open = "boundary 0 0 4 4\nstart 0.5 1\ngoal 3 0 4 2\n2 0 2 3\n", shut = open + "3 0 3 2\n3 2 4 2\n";
  EXPECT_THAT(verify(proof_of(open, 0), open).out, HasSubstr("yours is 3.914213562 long"));
  EXPECT_THAT(verify(proof_of(shut, 1), shut).out, HasSubstr("proven: there is no path"));
}

TEST_F(CertificateProgram, ProvesNothingAboutAnotherWorld) {
  const Outcome run = verify(proof_of(kSealed, 1), kRoom);
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, HasSubstr("not proven: the certificate is of another world"));
}

TEST_F(CertificateProgram, NamesTheLegThatRefutesIt) {
  json proof = json::parse(contents(proof_of(kRoom, 0)));
  proof["world"] = json::parse(contents(proof_of(kOpen, 0)))["world"];
  const Outcome run = verify(folder.file("other", proof.dump()), kOpen);
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, HasSubstr("not proven: nothing stops the leg (0.5, 1)-(2, 2)"));
}

TEST_F(CertificateProgram, SaysThatItCannotReadAFile) {
  const Outcome run = verify(folder.file("text", "start 1 1\n"), kRoom);
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("the certificate cannot be read: parse error at line 1, column 1"));
}

TEST_F(CertificateProgram, RefusesToProveWhatItCannot) {
  const auto refusal = [&](const std::string& options, const std::string& world) {
    const Outcome run = run_taut("solve - --certificate " + in_folder("none") + " " + options, world);
    EXPECT_FALSE(std::filesystem::exists(in_folder("none")));
    return std::to_string(run.code) + " " + run.err;
  };
  EXPECT_THAT(refusal("--robot disc:0.1", kRoom), testing::StartsWith("4 "));
  EXPECT_THAT(refusal("--clearance 0.1", kRoom), testing::StartsWith("2 "));
  EXPECT_THAT(refusal("--robot disc:1e-9 --arcs", kRoom), testing::StartsWith("4 "));
  EXPECT_THAT(refusal("--widest", kSealed), testing::StartsWith("4 "));
  EXPECT_THAT(refusal("", "boundary 0 0 4 4\nstart 1 1\ngoal 3 3\n0 1.0000000000000002 1 0.1\n"),
              HasSubstr("no multiples of one unit"));
}

TEST_F(CertificateProgram, ProvesWhatDiscsCanDo) {
  const std::string proof = in_folder("proof");
  EXPECT_EQ(run_taut("solve - --widest --certificate " + proof, kRoom).code, 0);
  EXPECT_THAT(verify(proof, kRoom).out,
              HasSubstr("no disc of a radius above 0.5 gets through; the path keeps 0.4999999"));
  EXPECT_THAT(verify(proof, kOpen).out, HasSubstr("of another world"));
  EXPECT_EQ(run_taut("solve - --robot disc:0.25 --certificate " + proof, kSlit).code, 1);
  const Outcome narrow = run_taut("verify - " + proof + " --json -", kSlit);
  EXPECT_EQ(narrow.code, 0) << narrow.err;
  EXPECT_EQ(json::parse(narrow.out)["result"]["bound"], 0.25);
}

TEST_F(CertificateProgram, ProvesHowLongADiscsArcsAre) {
  const std::string proof = in_folder("proof"), arcs = "--robot disc:0.25 --arcs --certificate " + proof;
  EXPECT_EQ(run_taut("solve - " + arcs, kRoom).code, 0);
  EXPECT_THAT(verify(proof, kRoom).out, HasSubstr("no path of a disc of radius 0.25 is shorter than 5.488"));
  EXPECT_THAT(verify(proof, kRoom).out, HasSubstr("one that keeps 0.25 is 5.488"));
  EXPECT_EQ(verify(proof, kOpen).code, 1);
  EXPECT_THAT(verify(proof, kOpen).out, HasSubstr("of another world"));
  const Outcome unread = verify(folder.file("other", "{\"kind\": \"arcs\", \"radius\": -1}"), kRoom);
  EXPECT_EQ(unread.code, 3);
  EXPECT_THAT(unread.err, HasSubstr("other: a certificate of arcs has a radius"));
  EXPECT_EQ(run_taut("solve - " + arcs, kSlit).code, 1);
  EXPECT_THAT(verify(proof, kSlit).out, HasSubstr("no disc of radius 0.25 gets through"));
}

TEST_F(CertificateProgram, ProvesTheArcsOfABatchOfRadii) {
  const std::string proof = in_folder("proof"),
                    queries = folder.file("radii", "1 1 3 3 0.1\n1 1 3 3 0.2\n1 1 3 3 0.3\n");
  EXPECT_EQ(run_taut("batch - " + queries + " --arcs --certificate " + proof, kSlit).code, 1);
  EXPECT_THAT(verify(proof, kSlit).out, HasSubstr("3 of 3 proven"));
  json proofs = json::parse(contents(proof));
  EXPECT_EQ(proofs[1]["radius"], 0.2);
  EXPECT_EQ(proofs[2]["kind"], "none");
  proofs[1]["radius"] = 0.1;
  const Outcome wrong = verify(folder.file("other", proofs.dump()), kSlit);
  EXPECT_EQ(wrong.code, 1);
  EXPECT_THAT(wrong.out, HasSubstr("2 of 3 proven; certificate 2: "));
}

TEST_F(CertificateProgram, ProvesArcsAmongThickWallsAndOfData) {
  const std::string proof = in_folder("proof"), arcs = " --robot disc:0.2 --arcs --certificate " + proof;
  EXPECT_EQ(run_taut("solve - --wall-thickness 0.1" + arcs, kRoom).code, 0);
  EXPECT_EQ(run_taut("verify - --wall-thickness 0.1 " + proof, kRoom).code, 0);
  for (const char* name : {"maze_5x7.txt", "islands.wkt", "floor_plan.geojson"}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(run_taut("solve " + data_file(name) + arcs).code, 0);
    const Outcome run = run_taut("verify " + data_file(name) + " " + proof + " --json -");
    EXPECT_EQ(run.code, 0) << run.err;
    const json result = json::parse(run.out)["result"];
    EXPECT_NEAR(result["length"], result["bound"], 1e-4 * result["length"].get<double>());
    EXPECT_EQ(result["kind"], "arcs");
  }
}

// Start and goal stand on openings.
TEST_F(CertificateProgram, ProvesTheWidestDiscsOfData) {
  for (const char* name : {"maze_5x7.txt", "maze_25x25.txt", "islands.wkt"}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(run_taut("solve " + data_file(name) + " --widest --certificate " + in_folder("proof")).code, 0);
    const Outcome run = run_taut("verify " + data_file(name) + " " + in_folder("proof") + " --json -");
    EXPECT_EQ(run.code, 0) << run.err;
    const json result = json::parse(run.out)["result"];
    EXPECT_NEAR(result["keeps"], result["bound"], 1e-6);
  }
}

TEST_F(CertificateProgram, ProvesHowFarOtherPlannersAreFromTheShortest) {
  for (const std::string options : {"--roadmap prm", "--roadmap voronoi", "--roadmap cells", "--algorithm bfs"}) {
    SCOPED_TRACE(options);
    const std::string proof = in_folder("proof");
    EXPECT_EQ(run_taut("solve - --certificate " + proof + " " + options, kRoom).code, 0);
    const Outcome run = run_taut("verify - " + proof + " --json -", kRoom);
    EXPECT_EQ(run.code, 0) << run.err;
    const json result = json::parse(run.out)["result"];
    EXPECT_NEAR(result["bound"], 5, 1e-9);
    EXPECT_GE(result["length"], 5);
  }
}

TEST_F(CertificateProgram, ProvesEveryAnswerOfABatchInOneFile) {
  const std::string proof = in_folder("proof"), queries = folder.file("queries", "0.5 1 3.5 1\n1 1 1 3\n0.5 1 9 9\n");
  run_taut("batch - " + queries + " --certificate " + proof, kRoom);
  EXPECT_THAT(verify(proof, kRoom).out, HasSubstr("2 of 2 proven"));
  EXPECT_EQ(verify(proof, kRoom).code, 0);
  json proofs = json::parse(contents(proof));
  EXPECT_EQ(proofs[1]["line"], 2);
  proofs[0]["reach"] = proofs[0]["reach"].get<std::int64_t>() + 1;
  const Outcome wrong = verify(folder.file("other", proofs.dump()), kRoom);
  EXPECT_EQ(wrong.code, 1);
  EXPECT_THAT(wrong.out, HasSubstr("1 of 2 proven; certificate 1: "));
}

TEST_F(CertificateProgram, ProvesItOfThickWallsSquaresAndSeveralAreas) {
  const std::string proof = in_folder("proof");
  for (const std::string options : {"--wall-thickness 0.1", "--robot square:0.2"}) {
    SCOPED_TRACE(options);
    EXPECT_EQ(run_taut("solve - --certificate " + proof + " " + options, kRoom).code, 0);
    EXPECT_EQ(run_taut("verify - " + proof + " " + options, kRoom).code, 0);
    EXPECT_EQ(run_taut("verify - " + proof, kRoom).code, 1);
  }
  EXPECT_EQ(run_taut("solve " + data_file("floor_plan.geojson") + " --certificate " + proof).code, 0);
  EXPECT_EQ(run_taut("verify " + data_file("floor_plan.geojson") + " " + proof).code, 0);
}

// Mazes and islands between two points.
TEST_F(CertificateProgram, ProvesTheAnswersOfData) {
  for (const char* name : {"maze_5x7.txt", "maze_25x25.txt", "maze_45x45.txt", "maze_61x61_loops.txt", "islands.wkt"}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(run_taut("solve " + data_file(name) + " --certificate " + in_folder("proof")).code, 0);
    const Outcome run = run_taut("verify " + data_file(name) + " " + in_folder("proof") + " --json -");
    EXPECT_EQ(run.code, 0) << run.err;
    const json result = json::parse(run.out)["result"];
    EXPECT_NEAR(result["length"], result["bound"], 1e-9);
  }
}

// Mazes of others, from the corner to a place in the middle; those that are smaller have none there.
TEST_F(CertificateProgram, ProvesTheAnswersOfOthersMazes) {
  const char* const shared = std::getenv("TAUT_SHARED_DATA");
  if (shared == nullptr) GTEST_SKIP() << "TAUT_SHARED_DATA is not set";
  int proven = 0;
  for (const char* kind : {"micromouse", "prm"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(std::filesystem::path(shared) / kind)) {
      if (!entry.is_regular_file()) continue;
      SCOPED_TRACE(entry.path());
      const std::string maze = entry.path().string(), proof = in_folder(entry.path().filename().string() + ".proof");
      const std::string to = std::string(kind) == "prm" ? "" : " --to 8,8";
      if (run_taut("solve " + maze + " --no-verify --certificate " + proof + to).code > 1) continue;
      EXPECT_EQ(run_taut("verify " + maze + " " + proof).code, 0);
      ++proven;
    }
  EXPECT_GE(proven, 50);
}

}  // namespace
}  // namespace taut::test
