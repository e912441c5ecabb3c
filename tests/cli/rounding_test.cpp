// Where crossings of walls are no decimals, answers say how far their proof goes.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

// Three walls that cross one another around a triangle, at places that no decimals hold.
const std::string kTriangle =
    "boundary 0 0 10 10\ngoal 0.5 9\n"
    "1 1 9 2\n2 0.5 6 8\n8 0.5 4 8\n";

class Rounding : public ProgramTest {
 protected:
  static std::pair<int, json> solved(const std::string& words, const std::string& world) {
    const Outcome run = run_taut("solve - --json - -q " + words, world);
    return {run.code, json::parse(run.out)};
  }
};

TEST_F(Rounding, PathsAreOptimalWhereNothingIsRounded) {
  const auto [code, answer] = solved("--from 1,1 --to 9,9", "boundary 0 0 10 10\n3 3 5 5\n3 5 5 3\n");
  EXPECT_EQ(code, 0);
  EXPECT_EQ(answer["result"]["optimal"], true);
  EXPECT_FALSE(answer["result"].contains("within"));
}

TEST_F(Rounding, PathsAreTheShortestWithinADistanceElse) {
  for (const char* words :
       {"--from 9.5,0.5", "--from 9.5,0.5 --roadmap visibility", "--from 9.5,0.5 --robot disc:0.1 --arcs"}) {
    const auto [code, answer] = solved(words, kTriangle);
    EXPECT_EQ(code, 0);
    EXPECT_FALSE(answer["result"].contains("optimal")) << words;
    EXPECT_GT(answer["result"]["within"].get<double>(), 0) << words;
    EXPECT_LT(answer["result"]["within"].get<double>(), 1e-11) << words;
  }
  const auto [code, answer] = solved("--from 9.5,0.5 --roadmap prm", kTriangle);
  EXPECT_EQ(answer["result"]["optimal"], false) << "what is not optimal anyhow says so";
}

TEST_F(Rounding, NoneMeansNoneThatStaysThatFarFromObstacles) {
  const auto [code, answer] = solved("--from 5,4", kTriangle);
  EXPECT_EQ(code, 1);
  EXPECT_EQ(answer["status"], "none");
  EXPECT_GT(answer["result"]["within"].get<double>(), 0);
}

TEST_F(Rounding, NothingIsProvenOfAnEndBesideABentWall) {
  const std::string beside = "--from 5,1.5000000000001";
  const auto [code, answer] = solved(beside, kTriangle);
  EXPECT_EQ(code, 4);
  EXPECT_EQ(answer["status"], "unproven");
  EXPECT_THAT(answer["reason"].get<std::string>(), HasSubstr("an end is so near a wall"));
  EXPECT_EQ(run_taut("compare - --planners polyanya " + beside, kTriangle).code, 4);
  EXPECT_EQ(run_taut("bug - " + beside, kTriangle).code, 4);
  const std::string queries = folder.file("queries.txt", "5 1.5000000000001 0.5 9\n5 4 0.5 9\n");
  EXPECT_EQ(run_taut("batch - " + queries, kTriangle).out, "1 unproven\n2 none\n");
}

TEST_F(Rounding, EndsOnWallsStayOnThem) {
  EXPECT_EQ(solved("--from 5,1.5", kTriangle).first, 0) << "below the wall the way is free";
  // On a wall whose line is a computed number, and which another crosses.
  const std::string world = "boundary 0 0 10 10\n0.30000000000000004 1 0.30000000000000004 9\n0 2 7 9\n";
  const auto [code, answer] = solved("--from 0.30000000000000004,5 --to 0.1,5", world);
  EXPECT_EQ(code, 0);
  EXPECT_DOUBLE_EQ(answer["result"]["length"].get<double>(), 0.2);
  const std::string queries = folder.file("queries.txt", "0.30000000000000004 5 0.1 5\n0.30000000000000004 5 1 5\n");
  EXPECT_EQ(run_taut("batch - " + queries, world).out, "1 0.20000000000000004\n2 0.7\n");
}

TEST_F(Rounding, RadiiAreRightWithinADistance) {
  for (const std::string command :
       {"passage - --from 9.5,0.5", "passage - --from 9.5,0.5 --robot disc:0.2",
        "passage - --from 9.5,0.5 --robot disc:3", "passage - --from 5,4", "solve - --widest --from 9.5,0.5",
        "solve - --clearance 0.1 --from 9.5,0.5", "solve - --clearance 3 --from 9.5,0.5",
        "solve - --tradeoff --from 9.5,0.5", "solve - --arcs --robot disc:0.1 --from 5,4"}) {
    const Outcome run = run_taut(command + " --json - -q", kTriangle);
    ASSERT_LE(run.code, 1) << command << run.err;
    const json result = json::parse(run.out)["result"];
    EXPECT_GT(result.value("within", 0.0), 0) << command;
    EXPECT_LT(result.value("within", 1.0), 1e-11) << command;
  }
  const Outcome straight =
      run_taut("passage - --from 1,1 --to 9,9 --json - -q", "boundary 0 0 10 10\n3 3 5 5\n3 5 5 3\n");
  EXPECT_FALSE(json::parse(straight.out)["result"].contains("within"));
}

TEST_F(Rounding, ComparedPlannersAreOptimalAsFarAsTheWorldIs) {
  const Outcome run = run_taut("compare - --planners polyanya,prm --from 9.5,0.5 --json - -q", kTriangle);
  const json result = json::parse(run.out)["result"];
  EXPECT_GT(result["within"].get<double>(), 0);
  EXPECT_EQ(result["planners"][0]["within"], result["within"]);
  EXPECT_FALSE(result["planners"][0].contains("optimal"));
  EXPECT_EQ(result["planners"][1]["optimal"], false);
}

TEST_F(Rounding, OfADiscAHairTooWideTheGatesProveThatThereIsNone) {
  const std::string world = "boundary 0 0 10 10\n0 5 4.65 5\n5.35 5 10 5\n";
  const auto [none, why] = solved("--from 1,1 --to 1,9 --robot disc:0.3500000001", world);
  EXPECT_EQ(none, 1);
  EXPECT_THAT(why["reason"].get<std::string>(), HasSubstr("7/10 between (4.65, 5) and (5.35, 5)"));
  const auto [fits, hint] = solved("--from 1,1 --to 1,9 --robot disc:0.35", world);
  EXPECT_EQ(fits, 4) << "the polygon around it does not fit";
  EXPECT_THAT(hint["reason"].get<std::string>(), HasSubstr("--arcs plans for the disc itself"));
  EXPECT_EQ(solved("--from 1,1 --to 1,9 --robot disc:0.35 --arcs", world).first, 0);
}

TEST_F(Rounding, OfADiscThePolygonAroundItStandsOut) {
  const std::string world = "boundary 0 0 10 10\n3 3 5 5\n";
  const auto [code, answer] = solved("--from 3,6 --to 6,3 --robot disc:0.5", world);
  EXPECT_EQ(code, 0);
  EXPECT_FALSE(answer["result"].contains("optimal"));
  const double within = answer["result"]["within"].get<double>();
  EXPECT_NEAR(within, 0.5 * 0.00121, 1e-9);
  // Of the disc itself: no longer, and no path of a disc larger by so much is shorter than the polygon's.
  const double polygon = answer["result"]["length"].get<double>();
  const auto arcs = [&](double radius) {
    return solved(fmt::format("--from 3,6 --to 6,3 --arcs --robot disc:{}", radius), world).second["result"]["length"];
  };
  EXPECT_LE(arcs(0.5).get<double>(), polygon);
  EXPECT_GE(arcs(0.5 + within).get<double>(), polygon);
  const auto [none, why] = solved("--from 1,1 --to 9,9 --robot disc:0.5", "boundary 0 0 10 10\n0 5 10 5\n");
  EXPECT_EQ(none, 1);
  EXPECT_FALSE(why["result"].contains("within")) << "proven of the disc itself";
}

}  // namespace
}  // namespace taut::test
