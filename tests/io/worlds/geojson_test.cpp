#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

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
  EXPECT_EQ(message_of("{\"type\": \"Polygon\"}"), "line 1: Polygon without \"coordinates\"");
  EXPECT_EQ(message_of("{}"), "line 1: a GeoJSON object without \"type\"");
  EXPECT_EQ(message_of("{\"type\": \"FeatureCollection\"}"), "line 1: \"features\" is missing or no array");
  EXPECT_EQ(message_of("{\"type\":\n\n \"Point\"").substr(0, 42), "line 3: not valid JSON: syntax error while");
}

std::string collection(const std::string& features) {
  return "{\"type\": \"FeatureCollection\", \"features\": [" + features + "]}";
}

// RFC 7946, 3.2: what others write there is none of our business.
TEST(GeoJson, LeavesPropertiesThatAreNoneOfItsWordsToTheirWriter) {
  const World world = read_world(
      collection(feature(R"({"boundary": "census", "role": "outer", "thickness": null})", "Polygon", kSquare) + "," +
                 feature(R"({"role": "start", "thickness": -2})", "LineString", "[[1, 1], [1, 2]]") + "," +
                 feature(R"({"role": 7, "thickness": "thin"})", "LineString", "[[2, 1], [2, 2]]")));
  EXPECT_EQ(world.boundary(), Boundary::walled);
  ASSERT_EQ(world.walls().size(), 2U);
  EXPECT_EQ(world.walls()[0].thickness, 0);
}

TEST(GeoJson, FindsItsWordsInAnObjectOfItsOwn) {
  const World world =
      read_world(collection(feature(R"({"role": "outer", "taut": {"role": "obstacle"}})", "Polygon", kSquare) + "," +
                            feature(R"({"taut": {"thickness": 0.25}})", "LineString", "[[9, 9], [9, 8]]")));
  EXPECT_EQ(world.solids().size(), 1U);
  EXPECT_EQ(world.walls().at(0).thickness, 0.25);
}

TEST(GeoJson, TakesTwoPointsForEndsOnlyWhenTheyAreAllThereAre) {
  const std::string a = feature("{}", "Point", "[1, 1]"), b = feature("{}", "Point", "[3, 3]"),
                    square = feature("{}", "Polygon", kSquare);
  ReadNotes notes;
  EXPECT_EQ(read_world(collection(square + "," + a + "," + b), {}, &notes).goal().point, (Point{3, 3}));
  EXPECT_TRUE(notes.remarks.empty());
  EXPECT_FALSE(read_world(collection(square + "," + a + "," + b + "," + b), {}, &notes).start());
  ASSERT_EQ(notes.remarks.size(), 1U);
  EXPECT_EQ(notes.remarks[0],
            "3 points without a role left out; start and goal are points with these roles, or two alone");
  const std::string start = feature(R"({"role": "start"})", "Point", "[2, 2]");
  EXPECT_EQ(read_world(collection(square + "," + a + "," + start), {}, &notes).start(), (Point{2, 2}));
  EXPECT_EQ(notes.remarks.size(), 1U);
}

TEST(GeoJson, OpensTheWallThatADoorLiesOn) {
  const auto world_with = [](const std::string& door, const std::string& thickness, ReadNotes* notes = nullptr) {
    return read_world(collection(feature("{}", "Polygon", kSquare) + "," +
                                 feature(R"({"thickness": )" + thickness + "}", "LineString", "[[2, 4], [2, 0]]") +
                                 "," + feature(R"({"role": "door"})", "LineString", door)),
                      {}, notes);
  };
  const World opened = world_with("[[2, 1], [2, 2]]", "0");
  ASSERT_EQ(opened.walls().size(), 2U);
  EXPECT_EQ(opened.walls()[0].b, (Point{2, 1}));
  EXPECT_EQ(opened.walls()[1].a, (Point{2, 2}));
  const World thick = world_with("[[2, 2], [2, 1]]", "0.5");  // caps do not reach into the door
  EXPECT_EQ(thick.walls()[0].b, (Point{2, 0.75}));
  EXPECT_EQ(thick.walls()[1].a, (Point{2, 2.25}));
  EXPECT_TRUE(world_with("[[2, -1], [2, 5]]", "0").walls().empty());
  ReadNotes notes;
  EXPECT_EQ(world_with("[[1, 1], [1, 2]]", "0", &notes).walls().size(), 1U);
  EXPECT_EQ(notes.remarks.at(0), "the door (1, 1)-(1, 2) lies on no wall and is left out");
}

TEST(GeoJson, DoorsStayAsWideAsDrawnInWallsThatAreMadeThick) {
  ReadOptions options;
  options.wall_thickness = 0.5;
  const World thick =
      read_world(collection(feature("{}", "Polygon", kSquare) + "," + feature("{}", "LineString", "[[2, 4], [2, 0]]") +
                            "," + feature(R"({"role": "door"})", "LineString", "[[2, 1], [2, 2]]")),
                 options);
  ASSERT_EQ(thick.walls().size(), 2U);
  EXPECT_EQ(thick.walls()[0].b, (Point{2, 0.75}));
  EXPECT_EQ(thick.walls()[1].a, (Point{2, 2.25}));
  EXPECT_EQ(thick.walls()[0].thickness, 0.5);
}

TEST(GeoJson, OpensTheWallThatADoorLiesBesideWhereThatIsJoined) {
  const auto with_door = [](const std::string& wall, const std::string& door, Snap snap) {
    ReadOptions options;
    options.snap = snap;
    return read_world(collection(feature("{}", "Polygon", kSquare) + "," + feature("{}", "LineString", wall) + "," +
                                 feature(R"({"role": "door"})", "LineString", door)),
                      options)
        .walls();
  };
  const std::string wall = "[[2, 4], [2, 0]]", door = "[[2.001, 1], [1.9995, 2]]";
  EXPECT_EQ(with_door(wall, door, {}).size(), 1U) << "a millimetre that was written is a millimetre";
  const std::vector<Wall> joined = with_door(wall, door, {Snap::What::within, 0.001});
  ASSERT_EQ(joined.size(), 2U);
  EXPECT_EQ(joined[0].b, (Point{2.001, 1}));
  EXPECT_EQ(with_door(wall, door, {Snap::What::within, 0.0009}).size(), 1U);
  EXPECT_EQ(with_door(wall, "[[2, 0.0005], [2, 3.9999]]", {Snap::What::within, 0.001}).size(), 0U) << "no slivers";
  // A door in a wall that was turned lies beside it by a rounding.
  const double c = std::cos(0.3), s = std::sin(0.3);
  const auto at = [&](double along) { return fmt::format("[{}, {}]", 0.5 + c * along, 0.4 + s * along); };
  const std::string sloped = "[" + at(0.1) + ", " + at(3.1) + "]";
  for (int k = 1; k < 40; ++k) {
    const std::string opening = "[" + at(0.31 + 0.03 * k) + ", " + at(1.17 + 0.03 * k) + "]";
    EXPECT_EQ(with_door(sloped, opening, {}).size(), 2U) << opening;
  }
}

TEST(GeoJson, ReadsOneFeatureALineWithOrWithoutRecordSeparators) {
  const std::string square = feature("{}", "Polygon", kSquare), wall = feature("{}", "LineString", "[[1, 1], [1, 2]]");
  for (const std::string& text :
       {square + "\n" + wall + "\n", square + "\r\n\n" + wall, "\x1e" + square + "\n\x1e" + wall + "\n"}) {
    const World world = read_world(text);
    EXPECT_EQ(world.areas().size(), 1U);
    EXPECT_EQ(world.walls().size(), 1U);
  }
  EXPECT_EQ(test::refusal_of([&] { read_world(square + "\n" + wall + "\n{\"type\": 3}\n"); }),
            "line 3: a GeoJSON object without \"type\"");
  EXPECT_EQ(test::refusal_of([&] { read_world(square + "\n{\"type\": \n"); }).substr(0, 23), "line 2: not valid JSON:");
}

TEST(GeoJson, IsNotEsriJson) {
  const std::string rings = R"({"rings": [[[0, 0], [1, 0], [1, 1], [0, 0]]], "spatialReference": {"wkid": 4326}})";
  EXPECT_NE(test::refusal_of([&] { read_world(rings); }).find("is ESRI JSON"), std::string::npos);
}

}  // namespace
}  // namespace taut
