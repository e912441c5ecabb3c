#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/io/worlds/read_world.h>
#include <taut/search/shortest_path.h>

#include "support/refusal.h"

namespace taut {
namespace {

std::string svg(const std::string& shapes) {
  return "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 9 9\">\n" + shapes +
         "\n</svg>";
}

World plan(const std::string& shapes, ReadNotes* notes = nullptr) { return read_world(svg(shapes), {}, notes); }

std::string message_of(const std::string& shapes) {
  return test::refusal_of([&] { plan(shapes); });
}

const Ring kSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

TEST(SvgPlan, LinesAreWallsAndFilledShapesFloorPlans) {
  ReadNotes notes;
  const World world = plan(
      "<rect width='4' height='4'/><g fill='none'><polyline points='1,0 1,2 2,2'/></g>\n<line x1='3' y1='4' x2='3' "
      "y2='1'/>"
      "<text x='1' y='1'>hall</text><defs><circle r='3'/></defs>",
      &notes);
  EXPECT_EQ(notes.format, Format::svg);
  EXPECT_EQ(notes.remarks, std::vector<std::string>{"1 <text> left out"});
  EXPECT_TRUE(world.y_down());
  ASSERT_EQ(world.areas().size(), 1U);
  EXPECT_EQ(world.areas()[0].polygon.outer, kSquare);
  ASSERT_EQ(world.walls().size(), 3U);
  EXPECT_EQ(world.walls()[2].a, (Point{3, 4}));
  EXPECT_EQ(world.walls()[2].line, 4);
  EXPECT_EQ(shortest_path(FreeSpace(world), {0.5, 1}, {{Point{1.5, 1}}, {}})->length.decimals(4), "3.2361");
}

TEST(SvgPlan, WhatNothingFillsIsWalls) {
  EXPECT_EQ(plan("<rect width='4' height='4' style='stroke:#000; fill:none'/>").walls().size(), 4U);
  EXPECT_EQ(plan("<g fill='none'><path d='M0 0h4v4z'/><polygon points='1 1 2 1 2 2'/></g>").walls().size(), 6U);
  EXPECT_EQ(plan("<g fill='none'><polygon fill='red' points='0 0 4 0 4 4'/></g>").areas().size(), 1U);
}

TEST(SvgPlan, PathsHaveStraightPiecesAndHoles) {
  for (const char* d :
       {"M0,0 4,0 4,4 0,4Z M1 1 L2 1 2 2 1 2z", "m0 0h4v4h-4z m1 1h1v1H1z", "M0 0H4V4H0ZM1,1l1,0 0,1-1,0z"}) {
    const World world = plan("<path d='" + std::string(d) + "'/>");
    ASSERT_EQ(world.areas().size(), 1U) << d;
    EXPECT_EQ(world.areas()[0].polygon.outer, kSquare) << d;
    EXPECT_EQ(world.areas()[0].polygon.holes, (std::vector<Ring>{{{1, 1}, {1, 2}, {2, 2}, {2, 1}}})) << d;
  }
  EXPECT_EQ(plan("<path d='M0 0L1-.5.5.5'/>").walls()[1].b, (Point{0.5, 0.5}));
}

TEST(SvgPlan, TransformsCountAndDecimalsStayDecimals) {
  const World moved =
      plan("<g transform='translate(0.1 0.2)'><rect transform='scale(2,3)' width='0.1' height='0.1'/></g>");
  EXPECT_EQ(moved.areas()[0].polygon.outer, (Ring{{0.1, 0.2}, {0.3, 0.2}, {0.3, 0.5}, {0.1, 0.5}}));
  EXPECT_EQ(plan("<line x1='1' x2='2' transform='rotate(90 1 1)'/>").walls()[0].b, (Point{2, 2}));
  EXPECT_EQ(plan("<line x2='1' transform='matrix(1 2 3 4 5 6)'/>").walls()[0].b, (Point{6, 8}));
  EXPECT_NEAR(plan("<line x2='2' transform='rotate(30)'/>").walls()[0].b.y, 1, 1e-14);
  EXPECT_NEAR(plan("<line y2='1' transform='skewX(45)'/>").walls()[0].b.x, 1, 1e-14);
}

TEST(SvgPlan, SaysThatStyleSheetsCountForNothing) {
  ReadNotes notes;
  plan("<style>.a{fill:none}</style><rect class='a' width='4' height='4'/>", &notes);
  EXPECT_EQ(notes.remarks, std::vector<std::string>{"1 <style> left out"});
}

TEST(SvgPlan, NamesWhatItDoesNotRead) {
  EXPECT_EQ(message_of("<circle r='1'/>"), "line 3: <circle> is not read; line, polyline, polygon, rect and path are");
  EXPECT_EQ(message_of("<rect width='1' height='1' rx='.1'/>"), "line 3: <rect> with round corners is not read");
  EXPECT_EQ(message_of("<path d='M0 0C1 1 2 2 3 3'/>"),
            "line 3: path command 'C' draws a curve; only straight pieces are read (M L H V Z)");
  EXPECT_EQ(message_of("<path d='0 0L1 1'/>"), "line 3: a path begins with M, not '0 0L1 1'");
  EXPECT_EQ(message_of("\n<line x1='1cm'/>"), "line 4: '1cm' is not in the drawing's own units");
  EXPECT_EQ(message_of("<line transform='turn(3)'/>"), "line 3: transform 'turn' with 1 numbers is not known");
  for (const char* how : {"transform-origin='4 4' transform='rotate(90)'", "style='fill:none;transform:scale(2)'"})
    EXPECT_EQ(message_of(std::string("<line x2='1' ") + how + "/>"),
              "line 3: of what transforms <line> only an attribute transform=\"...\" is read");
  EXPECT_EQ(message_of("<polyline points='0 0 1'/>"), "line 3: a number is expected, not the end");
  EXPECT_EQ(message_of("<g>"), "line 4: not valid XML: Start-end tags mismatch");
  EXPECT_EQ(test::refusal_of([] { read_world("<?xml version='1.0'?>\n<kml/>"); }),
            "line 2: is XML, but no SVG drawing");
}

}  // namespace
}  // namespace taut
