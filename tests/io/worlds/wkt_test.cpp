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

TEST(Wkt, MayStandInAColumnOfATable) {
  const std::vector<std::string> tables{
      "WKT,id,name\n\"POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\",1,\"a \"\"room\"\", large\"\n\"LINESTRING (1 1, 2 "
      "2)\",2,\n",
      "id,the_geom\r\n1,\r\n2,\"POLYGON ((0 0, 4 0,\n 4 4, 0 4, 0 0))\"\r\n3,\"LINESTRING (1 1, 2 2)\"\r\n",
      "id;name;geom\n1;a, b;POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\n2;c;LINESTRING (1 1, 2 2)\n",
      "1\tPOLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\n2\tLINESTRING (1 1, 2 2)",
      "1,POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0)),x\n2,LINESTRING (1 1, 2 2),y",
      "geometry\n\"POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\"\n\"LINESTRING (1 1, 2 2)\"\n"};
  for (const std::string& table : tables) {
    EXPECT_EQ(detect_format(table), Format::wkt) << table;
    const World world = read_world(table);
    ASSERT_EQ(world.areas().size(), 1U) << table;
    EXPECT_EQ(world.areas()[0].polygon.outer, kSquare);
    EXPECT_EQ(world.walls().size(), 1U);
  }
  EXPECT_EQ(read_world(tables[1]).walls()[0].line, 5);
}

TEST(Wkt, StandsInTheColumnWithTheMostGeometries) {
  ReadNotes notes;
  const World world = read_world(
      "note,wkt\n\"POINT (9 9)\",\"POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\"\nx,\"LINESTRING (1 1, 2 2)\"\n", {}, &notes);
  EXPECT_EQ(world.areas().size(), 1U);
  EXPECT_EQ(world.walls().size(), 1U);
  EXPECT_EQ(notes.remarks,
            std::vector<std::string>{"geometries are read from column 2, those of column 1 are left out"});
}

std::string message_of(const std::string& bytes) {
  return test::refusal_of([&] { read_world(bytes); });
}

TEST(Wkt, NamesTheLineOfATable) {
  EXPECT_EQ(message_of("id,wkt\n1,\"POLYGON ((0 0, 4 0, 4 4, 0 0))\"\n2,\"LINESTRING (0 0)\"\n"),
            "line 3: a line needs at least two points");
  EXPECT_EQ(message_of("id,wkt\n1,\"POINT (0 0)\"\n2,NULL\n"), "line 3: geometry 'NULL' is not supported");
}

TEST(Wkt, IsNotWkb) {
  const char* const says = "holds geometries as WKB in hexadecimal: write them as WKT (ST_AsText, .wkt, to_wkt)";
  EXPECT_EQ(message_of("0101000000000000000000F03F0000000000000040\n"), says);
  EXPECT_EQ(message_of("id,geom\n1,0101000020E6100000000000000000F03F0000000000000040\n"), says);
  EXPECT_EQ(message_of("00000000013ff00000000000004000000000000000"), says);
  EXPECT_EQ(message_of(std::string("\x01\x01\0\0\0\0\0\0\0\0\0\xF0\x3F\0\0\0\0\0\0\0\x40", 21)),
            "holds a geometry as WKB: write it as WKT");
}

TEST(Wkt, SaysWhatItExpected) {
  EXPECT_EQ(message_of("POLYGON (0 0, 1 1)"), "line 1: '(' is expected, not '0'");
  EXPECT_EQ(message_of("LINESTRING (0 0,\n 1)"), "line 2: a number is expected, not ')'");
  EXPECT_EQ(message_of("LINESTRING (0 0)"), "line 1: a line needs at least two points");
  EXPECT_EQ(message_of("CURVEPOLYGON (CIRCULARSTRING (0 0, 5 5, 10 0, 5 -5, 0 0))"),
            "line 1: geometry 'CURVEPOLYGON' is not supported: write its curves as legs (ST_CurveToLine)");
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

TEST(Wkt, ReadsTrianglesAndSurfacesOfPolygons) {
  EXPECT_EQ(read_world("TRIANGLE ((0 0, 10 0, 0 10, 0 0))").areas().size(), 1U);
  EXPECT_EQ(
      read_world("POLYHEDRALSURFACE Z (((0 0 1, 4 0 1, 0 4 1, 0 0 1)), ((4 0 1, 4 4 1, 0 4 1, 4 0 1)))").areas().size(),
      2U);
}

}  // namespace
}  // namespace taut
