#include <taut/io/results/result_json.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <taut/io/results/envelope.h>
#include <taut/io/worlds/read_path.h>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "support/refusal.h"

namespace taut {
namespace {

using nlohmann::json;
using testing::HasSubstr;

PlanResult found() {
  PlanResult result;
  result.status = SearchStatus::found;
  result.path.points = {{1, 2}, {2, 3}, {3, 2}};
  result.path.length = Length(result.path.points);
  result.clearance = 0.5;
  result.verified = true;
  result.start = Point{1, 2};
  result.goal.point = Point{3, 2};
  return result;
}

json parsed(const PlanResult& result) { return json::parse(json_text(result_json(result))); }

TEST(ResultJson, SaysWhatWasFound) {
  const json answer = parsed(found());
  EXPECT_DOUBLE_EQ(answer["length"].get<double>(), std::sqrt(8));
  EXPECT_EQ(answer["length_text"], "2.828427124746190");
  EXPECT_LE(answer["length_interval"][0], answer["length"]);
  EXPECT_GE(answer["length_interval"][1], answer["length"]);
  EXPECT_EQ(answer["points"], json::parse("[[1, 2], [2, 3], [3, 2]]"));
  EXPECT_EQ(answer["corners"], 1);
  EXPECT_EQ(answer["clearance"], 0.5);
  EXPECT_EQ(answer["start"], json::parse("[1, 2]"));
  EXPECT_EQ(answer["goal"], json::parse(R"({"point": [3, 2]})"));
  EXPECT_EQ(answer["robot"], json::parse(R"({"kind": "point"})"));
  EXPECT_FALSE(answer.contains("separation"));
}

TEST(ResultJson, HasNoClearanceWhereThereIsNoObstacleOrNoCheck) {
  PlanResult result = found();
  result.clearance = std::numeric_limits<double>::infinity();
  EXPECT_EQ(parsed(result)["clearance"], nullptr);
  result.clearance.reset();
  EXPECT_EQ(parsed(result)["clearance"], nullptr);
}

TEST(ResultJson, NamesTheWallsWhenThereIsNone) {
  PlanResult result = found();
  result.status = SearchStatus::none;
  result.separation = {{{0, 0}, {1, 0}}};
  const json answer = parsed(result);
  EXPECT_EQ(answer["separation"], json::parse("[[[0, 0], [1, 0]]]"));
  EXPECT_FALSE(answer.contains("points"));
}

TEST(ResultJson, KnowsNothingOfEndsThatWereNotRead) {
  PlanResult result;
  result.status = SearchStatus::stopped;
  const json answer = parsed(result);
  EXPECT_EQ(answer["start"], nullptr);
  EXPECT_EQ(answer["goal"], nullptr);
  EXPECT_FALSE(answer.contains("points"));
}

TEST(ResultJson, KeepsTheBestPathOfASearchThatWasStopped) {
  PlanResult result = found();
  result.status = SearchStatus::stopped;
  result.bound = 1.5;
  EXPECT_EQ(parsed(result)["points"], parsed(found())["points"]);
  EXPECT_EQ(parsed(result)["bound"], 1.5);
}

TEST(ResultJson, DescribesRoomsAndRobots) {
  PlanResult result = found();
  result.goal = {{}, {{{7, 7}, {8, 8}}}};
  result.robot = Footprint::disc(0.25);
  const json answer = parsed(result);
  EXPECT_EQ(answer["goal"], json::parse(R"({"room": [[7, 7, 8, 8]]})"));
  EXPECT_EQ(answer["robot"], json::parse(R"({"kind": "disc", "radius": 0.25})"));
}

TEST(ResultJson, KeepsLinesShort) {
  PlanResult result = found();
  result.path.points.assign(1000, Point{0.1, 1.0 / 3});
  std::size_t longest = 0, line = 0;
  for (const char c : json_text(result_json(result))) longest = std::max(longest, line = c == '\n' ? 0 : line + 1);
  EXPECT_LE(longest, 120U);
}

TEST(ReadPath, ReadsWhatSolveWritesInItsEnvelopeOrWithout) {
  const Json result = result_json(found());
  Envelope envelope;
  envelope.outcome = Outcome::found;
  envelope.result = result;
  for (const std::string& text : {json_text(result), envelope_text(envelope)}) {
    const ClaimedPath path = read_path(text);
    EXPECT_EQ(path.points, found().path.points);
    EXPECT_DOUBLE_EQ(path.length.value(), std::sqrt(8));
  }
}

TEST(ReadPath, RefusesAnEnvelopeWithoutAPath) {
  Envelope envelope;
  envelope.outcome = Outcome::stopped;
  EXPECT_THAT(test::refusal_of([&] { read_path(envelope_text(envelope), "p"); }), HasSubstr("no path"));
}

TEST(ReadPath, ReadsListsAndLines) {
  const std::vector<Point> points{{0, 1}, {2.5, -3}};
  EXPECT_EQ(read_path("[[0, 1], [2.5, -3]]").points, points);
  EXPECT_EQ(read_path("# comment\n0 1\r\n\n2.5,-3 # end").points, points);
  EXPECT_EQ(read_path("{\"points\": []}").points.size(), 0U);
}

TEST(ReadPath, NamesTheLineOfWhatIsWrong) {
  const auto message = [](std::string_view bytes) { return test::refusal_of([&] { read_path(bytes, "p"); }); };
  EXPECT_EQ(message(""), "p: file is empty");
  EXPECT_THAT(message("0 1\n2\n"), HasSubstr("p:2: "));
  EXPECT_THAT(message("0 1\n2 3 4\n"), HasSubstr("p:2: "));
  EXPECT_THAT(message("0 nan\n"), HasSubstr("p:1: "));
  EXPECT_THAT(message("[[0, 1],\n [2]]"), HasSubstr("p:2: "));
  EXPECT_THAT(message("[[0, \"1\"]]"), HasSubstr("no number"));
  EXPECT_THAT(message("[[0, 1e80]]"), HasSubstr("beyond"));
  EXPECT_THAT(message("{\"status\": \"none\"}"), HasSubstr("no path"));
  EXPECT_THAT(message("[[0, 1"), HasSubstr("p:1: "));
}

}  // namespace
}  // namespace taut
