#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <taut/io/worlds/read_points.h>

#include "support/refusal.h"

namespace taut {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<Point> points_of(const std::string& text) {
  std::vector<Point> points;
  for (const ReadPoint& p : read_points(text)) points.push_back(p.point);
  return points;
}

std::string refusal(const std::string& text) {
  return test::refusal_of([&] { read_points(text, "p.txt"); });
}

TEST(ReadPoints, TakesALineEach) {
  EXPECT_THAT(points_of("# head\n1 2\r\n\n 3,4 # there\n3, 4"), ElementsAre(Point{1, 2}, Point{3, 4}, Point{3, 4}));
  EXPECT_EQ(read_points("\n\n1 2\n")[0].line, 3);
  EXPECT_THAT(points_of("# nothing\n"), IsEmpty());
}

TEST(ReadPoints, FindsTheColumnsOfATable) {
  EXPECT_THAT(points_of("x,y\n1,2\n"), ElementsAre(Point{1, 2}));
  EXPECT_THAT(points_of("id, Lat, name of it, LON\n1, 50.5, a b, 9\n"), ElementsAre(Point{9, 50.5}));
  EXPECT_THAT(refusal("x,y,name\n1,2\n"), HasSubstr("p.txt:2: has 2 columns, the heading 3"));
  EXPECT_THAT(refusal("x,y\n1,b\n"), HasSubstr("p.txt:2"));
}

TEST(ReadPoints, TakesListsAndGeoJson) {
  EXPECT_THAT(points_of("[[1, 2], [3, 4]]"), ElementsAre(Point{1, 2}, Point{3, 4}));
  EXPECT_THAT(points_of(R"({"type": "MultiPoint", "coordinates": [[1, 2, 9], [3, 4]]})"),
              ElementsAre(Point{1, 2}, Point{3, 4}));
  EXPECT_THAT(points_of(R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": null,
                "geometry": {"type": "Point", "coordinates": [5, 6]}}]})"),
              ElementsAre(Point{5, 6}));
}

TEST(ReadPoints, RefusesWhatIsNoPoint) {
  EXPECT_THAT(refusal("1 2\n1 2 3\n"), HasSubstr("p.txt:2: a point is two numbers, not 3"));
  EXPECT_THAT(refusal("a,b\n1,2\n"), HasSubstr("p.txt:1"));
  EXPECT_THAT(refusal(""), HasSubstr("p.txt: file is empty"));
  EXPECT_THAT(refusal(R"({"type": "Polygon", "coordinates": []})"), HasSubstr("a Polygon is no point"));
  EXPECT_THAT(refusal("[[1, 2],\n[\"a\", 4]]"), HasSubstr("p.txt:2: a coordinate is no number"));
  EXPECT_THAT(refusal("[[1, 1e80]]"), HasSubstr("beyond 1e+75"));
}

}  // namespace
}  // namespace taut
