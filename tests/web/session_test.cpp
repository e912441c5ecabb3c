#include <taut/web/session.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>
#include <string>

#include <taut/io/worlds/read_world.h>
#include <taut/search/shortest_path.h>

namespace taut::web {
namespace {

using nlohmann::json;

json ask(Session& session, const json& request) { return json::parse(session.answer(request.dump())); }

// A room of 4 x 2 with a wall between its halves that is open at the top.
constexpr const char* kTwoRooms =
    "boundary 0 0 4 2\nstart 1 0.5\ngoal 3 0.5\n0 0 4 0\n4 0 4 2\n4 2 0 2\n0 2 0 0\n2 0 2 1.5\n";

Session with_two_rooms() {
  Session session;
  EXPECT_FALSE(ask(session, {{"do", "load"}, {"name", "rooms"}, {"bytes", kTwoRooms}}).contains("error"));
  return session;
}

json walls_of(Session& session) { return ask(session, {{"do", "world"}}).at("walls"); }

std::string data(const std::string& name) {
  std::ifstream file(std::string(TAUT_DATA_DIR) + "/" + name, std::ios::binary);
  std::stringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

TEST(Session, TellsTheWorldThatItLoaded) {
  Session session;
  const json world = ask(session, {{"do", "load"}, {"name", "rooms"}, {"bytes", kTwoRooms}});
  EXPECT_EQ(world["format"], "segments");
  EXPECT_EQ(world["walls"].size(), 25U);
  EXPECT_EQ(world["box"], json({0, 0, 4, 2}));
  EXPECT_EQ(world["start"], json({1, 0.5}));
  EXPECT_EQ(world["goal"], json({3, 0.5}));
}

TEST(Session, FindsTheShortestPathAndAsManyDigitsAsAreAskedFor) {
  Session session = with_two_rooms();
  const json path = ask(session, {{"do", "path"}, {"digits", 30}});
  EXPECT_EQ(path["status"], "found");
  EXPECT_EQ(path["points"], json({1, 0.5, 2, 1.5, 3, 0.5}));
  EXPECT_EQ(path["digits"], "2.828427124746190097603377448419");
}

TEST(Session, GoesFromWhereItIsToldNotFromWhereTheWorldSays) {
  Session session = with_two_rooms();
  const json path = ask(session, {{"do", "path"}, {"start", {1, 1.5}}, {"goal", {3, 1.5}}});
  EXPECT_EQ(path["length"], 2.0);
}

TEST(Session, BendsADiscAroundTheCorner) {
  Session session = with_two_rooms();
  const json path = ask(session, {{"do", "path"}, {"radius", 0.25}});
  ASSERT_EQ(path["status"], "found");
  EXPECT_EQ(path["pieces"].size(), 3 * 7U);
  EXPECT_GT(path["length"], 2.8284271247461903);
}

TEST(Session, NamesTheGateThatADiscIsTooLargeFor) {
  Session session = with_two_rooms();
  const json path = ask(session, {{"do", "path"}, {"radius", 0.3}});
  EXPECT_EQ(path["status"], "none");
  EXPECT_EQ(path["gates"], json({2, 1.5, 2, 2}));
  EXPECT_THAT(path["reason"].get<std::string>(), testing::HasSubstr("this gate is narrower than 0.6"));
  const json widest = ask(session, {{"do", "widest"}});
  EXPECT_EQ(widest["radius"], 0.25);
  EXPECT_EQ(widest["limit"], "gate");
}

TEST(Session, NamesTheWallsOnceADrawnOneClosesTheWay) {
  Session session = with_two_rooms();
  json walls = walls_of(session);
  for (const double number : {2.0, 1.5, 2.0, 2.0, 0.0}) walls.push_back(number);
  EXPECT_EQ(ask(session, {{"do", "edit"}, {"walls", walls}})["walls"].size(), 30U);
  const json path = ask(session, {{"do", "path"}});
  EXPECT_EQ(path["status"], "none");
  EXPECT_FALSE(path["walls"].empty());
  EXPECT_THAT(path["reason"].get<std::string>(), testing::HasSubstr("separate"));
}

TEST(Session, KeepsItsWorldWhenAnEditIsRefused) {
  Session session = with_two_rooms();
  EXPECT_TRUE(ask(session, {{"do", "edit"}, {"walls", {0, 0, 1}}}).contains("error"));
  EXPECT_TRUE(ask(session, {{"do", "edit"}, {"walls", {0, 0, 1e80, 0, 0}}}).contains("error"));
  EXPECT_TRUE(ask(session, {{"do", "load"}, {"bytes", "no world at all"}}).contains("error"));
  EXPECT_EQ(walls_of(session).size(), 25U);
}

TEST(Session, SaysWhereTheNearestPlaceIsWhenAnEndIsNone) {
  Session session = with_two_rooms();
  const json outside = ask(session, {{"do", "path"}, {"goal", {3, 3}}});
  EXPECT_EQ(outside["status"], "blocked");
  EXPECT_EQ(outside["end"], "goal");
  EXPECT_EQ(outside["nearest"], json({3, 2}));
  EXPECT_EQ(ask(session, {{"do", "path"}, {"start", {0.1, 1}}, {"radius", 0.2}})["nearest"], json({0.2, 1}));
}

TEST(Session, HasEveryLayer) {
  Session session = with_two_rooms();
  const auto layer = [&](const char* name) { return ask(session, {{"do", "layer"}, {"name", name}}); };
  EXPECT_EQ(layer("triangulation")["segments"].size() % 4, 0U);
  EXPECT_FALSE(layer("mesh")["segments"].empty());
  EXPECT_FALSE(layer("voronoi")["curves"].empty());
  EXPECT_EQ(layer("gates")["widths"].size() * 4, layer("gates")["segments"].size());
  EXPECT_GE(layer("region")["ring"].size(), 6U);
  EXPECT_FALSE(layer("visibility").contains("error"));
  EXPECT_TRUE(layer("wallpaper").contains("error"));
}

TEST(Session, SavesInWhateverFormatCanHoldTheWorld) {
  Session session = with_two_rooms();
  const json formats = ask(session, {{"do", "formats"}})["formats"];
  EXPECT_THAT(formats, testing::Contains("geojson"));
  EXPECT_THAT(formats, testing::Not(testing::Contains("maz")));
  const json saved = ask(session, {{"do", "save"}, {"as", "segments"}, {"goal", {3, 1}}});
  Session again;
  EXPECT_EQ(ask(again, {{"do", "load"}, {"bytes", saved["text"]}})["goal"], json({3, 1}));
}

TEST(Session, ReadsAndWritesBytesThatAreNoText) {
  Session session, again;
  ask(session, {{"do", "load"}, {"bytes", data("mouse_16.num")}});
  const json saved = ask(session, {{"do", "save"}, {"as", "maz"}});
  EXPECT_EQ(saved["base64"].get<std::string>().size(), 344U);  // of 256 bytes
  EXPECT_EQ(ask(again, {{"do", "load"}, {"base64", saved["base64"]}})["format"], "maz");
  EXPECT_EQ(walls_of(again), walls_of(session));
  EXPECT_EQ(ask(session, {{"do", "load"}, {"base64", "MCAwIDEgMA=="}})["walls"], json({0, 0, 1, 0, 0}));
  EXPECT_TRUE(ask(session, {{"do", "load"}, {"base64", "MCAw*"}}).contains("error"));
}

TEST(Session, GivesPlacesToBeginWithWhereTheWorldHasNone) {
  Session session;
  const json world = ask(session, {{"do", "load"}, {"bytes", "0 0 1 0\n0.5 -1 0.5 1\n"}});
  EXPECT_TRUE(world["start"].is_null());
  const json path = ask(session, {{"do", "path"}, {"start", world["ends"]["start"]}, {"goal", world["ends"]["goal"]}});
  EXPECT_EQ(path["status"], "found");
}

TEST(Session, AnswersWhateverItIsAskedWithAnObject) {
  Session session;
  for (const char* request : {"", "null", "[1]", "{", R"({"do":"path"})", R"({"do":"dance"})", R"({"do":7})"})
    EXPECT_TRUE(json::parse(session.answer(request)).contains("error")) << request;
  session = with_two_rooms();
  for (const char* request :
       {R"({"do":"path","start":[1]})", R"({"do":"path","start":["a",2]})", R"({"do":"path","radius":-1})",
        R"({"do":"path","start":[1e200,0]})", R"({"do":"path","digits":1001})", R"({"do":"path","digits":1.5})",
        R"({"do":"path","radius":"wide"})", R"({"do":"save","as":"parchment"})"})
    EXPECT_TRUE(json::parse(session.answer(request)).contains("error")) << request;
}

TEST(Session, PassesItsSelfTest) {
  Session session;
  const json answer = ask(session, {{"do", "self-test"}});
  EXPECT_EQ(answer["passed"], true) << answer.dump(1);
  EXPECT_GE(answer["checks"].size(), 5U);
}

// Two roads to one answer: what is kept from one question to the next changes nothing.
TEST(Session, AnswersOneHundredDragsAsOneOffQueriesDo) {
  Session session;
  ask(session, {{"do", "load"}, {"bytes", data("maze_25x25.txt")}});
  const FreeSpace space(read_world(data("maze_25x25.txt")));
  for (int i = 0; i < 100; ++i) {
    const Point from{1.25 + i * 7 % 25, 1.25 + i * 11 % 25}, to{0.75 + i * 13 % 25, 1.0 + i * 3 % 25};
    const json path =
        ask(session, {{"do", "path"}, {"start", {from.x, from.y}}, {"goal", {to.x, to.y}}, {"digits", 20}});
    const auto expected = shortest_path(space, from, to);
    ASSERT_EQ(path["status"], expected ? "found" : "none");
    if (expected) EXPECT_EQ(path["digits"], expected->length.decimals(20));
  }
}

}  // namespace
}  // namespace taut::web
