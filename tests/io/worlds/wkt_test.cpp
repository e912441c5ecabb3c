#include <gtest/gtest.h>

#include <string>

#include <taut/io/worlds/read_world.h>

#include "support/refusal.h"

namespace taut {
namespace {

const Ring kSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

TEST(Wkt, PolygonsAreFloorPlans) {
  const World world = read_world("POLYGON ((0 0, 0 4, 4 4, 4 0, 0 0), (1 1, 2 1, 1 2, 1 1))");
  EXPECT_EQ(world.boundary(), Boundary::walled);
  ASSERT_EQ(world.areas().size(), 1U);
  EXPECT_EQ(world.areas()[0].polygon.outer, kSquare);
  EXPECT_EQ(world.areas()[0].polygon.holes, (std::vector<Ring>{{{1, 1}, {1, 2}, {2, 1}}}));
}

TEST(Wkt, PolygonsAreObstaclesOnRequest) {
  const World world = read_world("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))", {.polygons = ReadOptions::Polygons::obstacles});
  EXPECT_EQ(world.boundary(), Boundary::open);
  ASSERT_EQ(world.solids().size(), 1U);
  EXPECT_EQ(world.box(), (Box{{-2, -2}, {6, 6}}));
}

TEST(Wkt, ReadsEveryKindInAnySpelling) {
  const World world = read_world(
      "# a plan\nSRID=25832; point z (1 1 9)\nMultiPolygon(((0 0,4 0,4 4,0 4,0 0)),((9 9,10 9,9 10,9 9)), EMPTY);"
      "LINESTRINGZM(1 1 0 0,2 2 0 0,3 1 0 0)\r\nMULTILINESTRING ((0 1, 1 2), EMPTY)\nPOLYGON EMPTY\nGEOMETRYCOLLECTION "
      "M EMPTY\n"
      "GeometryCollection (POINT M (3 3 7), GEOMETRYCOLLECTION(LINESTRING (2 0, 2 1)))\nPOINT EMPTY");
  EXPECT_EQ(world.areas().size(), 2U);
  EXPECT_EQ(world.walls().size(), 4U);
  EXPECT_EQ(world.walls()[3].line, 7);
  EXPECT_EQ(world.start(), (Point{1, 1}));
  EXPECT_EQ(world.goal().point, (Point{3, 3}));
}

TEST(Wkt, ReadsBothSpellingsOfMultipoints) {
  EXPECT_EQ(read_world("MULTIPOINT (1 2, 3 4)\nLINESTRING (0 0, 1 0)").goal().point, (Point{3, 4}));
  EXPECT_EQ(read_world("MULTIPOINT ((1 2), (3 4))\nLINESTRING (0 0, 1 0)").goal().point, (Point{3, 4}));
}

std::string message_of(const std::string& bytes) {
  return test::refusal_of([&] { read_world(bytes); });
}

TEST(Wkt, SaysWhatItExpected) {
  EXPECT_EQ(message_of("POLYGON (0 0, 1 1)"), "line 1: '(' is expected, not '0'");
  EXPECT_EQ(message_of("LINESTRING (0 0,\n 1)"), "line 2: a number is expected, not ')'");
  EXPECT_EQ(message_of("LINESTRING (0 0)"), "line 1: a line needs at least two points");
  EXPECT_EQ(message_of("GEOMETRYCOLLECTION (CURVE (0 0))"), "line 1: geometry 'CURVE' is not supported");
  EXPECT_EQ(message_of("LINESTRING (0 0, 1 nan)"), "line 1: 'nan' is not a finite number");
  EXPECT_EQ(message_of("POINT (0 0) POINT"), "line 1: '(' is expected, not the end of the file");
  EXPECT_EQ(message_of("POINT EMPTY"), "no walls and no areas");
}

TEST(Wkt, ReadsWhatShapelyAndGdalWrite) {
  const World world =
      read_world("LINEARRING (0 0, 4 0, 4 4, 0 0)\nPOINT Z (1 1 NaN)\nLINESTRING ZM (0 0 nan -nan, 1 0 2 nan)");
  EXPECT_EQ(world.walls().size(), 4U);
  EXPECT_EQ(world.start(), (Point{1, 1}));
  EXPECT_EQ(message_of("POINT (nan 1)"), "line 1: 'nan' is not a finite number");
}

TEST(Wkt, LeavesOutPointsThatCannotBeEnds) {
  ReadNotes notes;
  EXPECT_FALSE(read_world("LINESTRING (0 0, 1 0)\nMULTIPOINT (0 1, 1 1, 2 1)", {}, &notes).start());
  EXPECT_EQ(notes.remarks.size(), 1U);
}

}  // namespace
}  // namespace taut
