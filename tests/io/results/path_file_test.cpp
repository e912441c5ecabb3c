#include <taut/io/results/path_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <taut/io/results/drive_path.h>
#include <taut/io/worlds/read_path.h>

#include "support/refusal.h"

namespace taut {
namespace {

using testing::HasSubstr;

const std::vector<PathToWrite> kOne{{.name = "polyanya",
                                     .points = {{0.1, 0.2}, {1.0 / 3, 2}, {5, 2}},
                                     .length = Length(std::vector<Point>{{0.1, 0.2}, {1.0 / 3, 2}, {5, 2}}).value()}};

TEST(PathFile, ReadsBackAsItselfInEachFormat) {
  for (const std::string& file : {path_geojson(kOne), path_wkt(kOne), path_csv(kOne)})
    EXPECT_EQ(read_path(file).points, kOne[0].points) << file;
  EXPECT_EQ(read_path(path_geojson(kOne)).length, kOne[0].length);
}

TEST(PathFile, HoldsAPathOfOnePoint) {
  const std::vector<PathToWrite> stands{{.name = "polyanya", .points = {{3, 4}}}};
  for (const std::string& file : {path_geojson(stands), path_wkt(stands), path_csv(stands)})
    EXPECT_EQ(read_path(file).points, stands[0].points) << file;
}

TEST(PathFile, SaysWhoCountsAndHowFarCurvesAre) {
  EXPECT_THAT(path_geojson(kOne), HasSubstr("\"path\": \"polyanya\""));
  EXPECT_THAT(path_geojson(kOne), HasSubstr("\"corners\": 1"));
  std::vector<PathToWrite> curve = kOne;
  curve[0].tolerance = 0.25;
  EXPECT_THAT(path_geojson(curve), HasSubstr("\"tolerance\": 0.25"));
  EXPECT_THAT(path_wkt(curve), testing::StartsWith("# legs between points of a curve, no farther than 0.25 from it\n"));
  EXPECT_THAT(path_csv(curve), testing::StartsWith("# legs"));
  EXPECT_TRUE(read_path(path_geojson(curve)).approximate);
}

TEST(PathFile, HasColumnsInCsvAndGeoJson) {
  std::vector<PathToWrite> chase = kOne;
  chase[0].columns = {{"second", {0, 3, 7}}};
  EXPECT_THAT(path_csv(chase), testing::StartsWith("x,y,second\n0.1,0.2,0\n"));
  EXPECT_THAT(path_geojson(chase), HasSubstr("\"second\": [0.0, 3.0, 7.0]"));
  EXPECT_EQ(read_path(path_csv(chase)).points, chase[0].points);
}

TEST(PathFile, HasSeveralPathsOrNone) {
  const std::vector<PathToWrite> two{kOne[0], {.name = "other", .points = {{0, 0}, {1, 1}}}};
  EXPECT_THAT(path_csv(two), HasSubstr("path,x,y\n1,0.1,0.2\n"));
  EXPECT_THAT(path_csv(two), HasSubstr("\n2,1,1\n"));
  for (const std::string& file : {path_geojson(two), path_wkt(two), path_csv(two)})
    EXPECT_THAT(test::refusal_of([&] { read_path(file, "x"); }), HasSubstr("paths")) << file;
  EXPECT_EQ(path_wkt({}), "");
}

TEST(PathFile, WritesArcsAsCircularStringsOfWkt) {
  // Around (2, 0) by a quarter, between two legs.
  const ArcPath path{1, {1, -2}, {4, 1}, {{{2, 0}, -1}}, {}};
  const std::vector<PathToWrite> arcs{
      {.name = "arcs", .points = sampled(path, 1e-3), .tolerance = 1e-3, .arcs = pieces(path)}};
  const std::string wkt = path_wkt(arcs);
  EXPECT_THAT(wkt, testing::MatchesRegex("COMPOUNDCURVE \\(\\(1 -2, ([^ ]+ [^ ]+)\\), CIRCULARSTRING \\([^ ]+ [^ ]+, "
                                         "1.2928932188134[0-9]* 0.7071067811865[0-9]*, [^ ]+ [^ ]+\\), "
                                         "\\([^ ]+ [^ ]+, 4 1\\)\\)\n"));
  const ClaimedPath back = read_path(wkt);
  EXPECT_EQ(back.points.size(), 5u) << "the middle of the arc among them";
  EXPECT_TRUE(back.approximate);
}

TEST(DrivePath, HasHeadingsAndTheGear) {
  const std::vector<car::Leg> legs{{{{0, 0}, 0}, {{3, 0}, 0}, false}, {{{3, 0}, 0}, {{1, 0}, 0}, true}};
  const PathToWrite path = drive_path(legs, legs[0].from, 5);
  EXPECT_EQ(path.points, (std::vector<Point>{{0, 0}, {3, 0}, {1, 0}}));
  EXPECT_EQ(path.columns[0].second, (std::vector<double>{0, 0, 0}));
  EXPECT_EQ(path.columns[1].second, (std::vector<double>{1, 1, -1}));
  EXPECT_EQ(path.tolerance, 0);
}

}  // namespace
}  // namespace taut
