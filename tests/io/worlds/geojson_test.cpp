#include <gtest/gtest.h>

#include <string>

#include <taut/io/worlds/read_world.h>

#include "support/refusal.h"

namespace taut {
namespace {

std::string feature(const std::string& properties, const std::string& type, const std::string& coordinates) {
  return R"({"type": "Feature", "properties": )" + properties + R"(, "geometry": {"type": ")" + type +
         R"(", "coordinates": )" + coordinates + "}}";
}

const std::string kSquare = "[[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]]";

TEST(GeoJson, ReadsBareGeometries) {
  EXPECT_EQ(read_world(R"({"type": "Polygon", "coordinates": )" + kSquare + "}").boundary(), Boundary::walled);
  EXPECT_EQ(read_world(R"({"coordinates": [[0, 0, 7], [1, 1, 7], [2, 0, 7]], "type": "LineString"})").walls().size(),
            2U);
}

TEST(GeoJson, ReadsRoles) {
  const World world =
      read_world("{\"type\": \"FeatureCollection\", \"features\": [\n" +
                 feature(R"({"role": "free", "name": "hall"})", "Polygon", kSquare) + ",\n" +
                 feature(R"({"role": "obstacle"})", "Polygon", "[[[1, 1], [2, 1], [1, 2], [1, 1]]]") + ",\n" +
                 feature(R"({"role": "wall", "thickness": 0.5})", "LineString", "[[0, 3], [3, 3]]") + ",\n" +
                 feature(R"({"role": "wall"})", "Polygon", "[[[2, 2], [3, 2], [2, 3], [2, 2]]]") + ",\n" +
                 feature(R"({"role": "goal"})", "Point", "[3, 1]") + ",\n" +
                 feature(R"({"role": "start"})", "Point", "[0.5, 0.5]") + ",\n" +
                 R"({"type": "Feature", "properties": null, "geometry": null})" + "]}");
  EXPECT_EQ(world.areas().size(), 1U);
  EXPECT_EQ(world.areas()[0].line, 2);
  EXPECT_EQ(world.solids().size(), 1U);
  ASSERT_EQ(world.walls().size(), 4U);
  EXPECT_EQ(world.walls()[0].thickness, 0.5);
  EXPECT_EQ(world.walls()[0].line, 4);
  EXPECT_EQ(world.start(), (Point{0.5, 0.5}));
  EXPECT_EQ(world.goal().point, (Point{3, 1}));
}

TEST(GeoJson, TakesPolygonsWithoutARoleForObstaclesOnRequest) {
  const ReadOptions obstacles{.polygons = ReadOptions::Polygons::obstacles};
  EXPECT_EQ(read_world(feature("{}", "MultiPolygon", "[" + kSquare + "]"), obstacles).solids().size(), 1U);
  EXPECT_EQ(read_world(feature(R"({"role": "free"})", "Polygon", kSquare), obstacles).areas().size(), 1U);
}

TEST(GeoJson, ReadsLimitsAndRooms) {
  const World world =
      read_world("{\"type\": \"FeatureCollection\", \"features\": [" +
                 feature(R"({"role": "free", "boundary": "limit"})", "Polygon", kSquare) + "," +
                 feature(R"({"role": "goal"})", "MultiPolygon", "[[[[2, 2], [2, 3], [3, 3], [3, 2], [2, 2]]]]") + "]}");
  EXPECT_EQ(world.boundary(), Boundary::limit);
  ASSERT_EQ(world.goal().room.size(), 1U);
  EXPECT_EQ(world.goal().room[0], (Box{{2, 2}, {3, 3}}));
}

std::string message_of(const std::string& bytes) {
  return test::refusal_of([&] { read_world(bytes); });
}

TEST(GeoJson, SaysWhatIsWrong) {
  EXPECT_EQ(message_of(feature(R"({"role": "goal"})", "Polygon", "[[[0, 0], [4, 0], [4, 5], [0, 4], [0, 0]]]")),
            "line 1: a goal polygon must be an axis-parallel rectangle");
  EXPECT_EQ(message_of(feature(R"({"role": "free"})", "LineString", "[[0, 0], [4, 0]]")),
            "line 1: a line can only have the role wall");
  EXPECT_EQ(message_of(feature(R"({"thickness": -1})", "LineString", "[[0, 0], [4, 0]]")),
            "line 1: wall thickness -1 is negative");
  EXPECT_EQ(message_of("{\"type\": \"Polygon\"}"), "line 1: Polygon without \"coordinates\"");
  EXPECT_EQ(message_of("{}"), "line 1: a GeoJSON object without \"type\"");
  EXPECT_EQ(message_of("{\"type\": \"FeatureCollection\"}"), "line 1: \"features\" is missing or no array");
  EXPECT_EQ(message_of("{\"type\":\n\n \"Point\"").substr(0, 42), "line 3: not valid JSON: syntax error while");
}

}  // namespace
}  // namespace taut
