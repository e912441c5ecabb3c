#include <taut/io/results/path_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <numbers>

#include <taut/io/results/drive_path.h>
#include <taut/io/results/pose_file.h>
#include <taut/io/worlds/read_path.h>

#include "support/refusal.h"

namespace taut {
namespace {

using testing::HasSubstr;

const std::vector<PathToWrite> kOne{{.name = "polyanya",
                                     .points = {{0.1, 0.2}, {1.0 / 3, 2}, {5, 2}},
                                     .length = Length(std::vector<Point>{{0.1, 0.2}, {1.0 / 3, 2}, {5, 2}}).value()}};

TEST(PathFile, ReadsBackAsItselfInEachFormat) {
  for (const std::string& file :
       {path_geojson(kOne), path_wkt(kOne), path_csv(kOne), path_poses(kOne), path_listing(kOne[0])})
    EXPECT_EQ(read_path(file).points, kOne[0].points) << file;
  EXPECT_EQ(read_path(path_geojson(kOne)).length, kOne[0].length);
}

TEST(PathFile, HoldsAPathOfOnePoint) {
  const std::vector<PathToWrite> stands{{.name = "polyanya", .points = {{3, 4}}}};
  for (const std::string& file : {path_geojson(stands), path_wkt(stands), path_csv(stands), path_poses(stands)})
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
  for (const std::string& file :
       {path_geojson(curve), path_wkt(curve), path_csv(curve), path_poses(curve), path_listing(curve[0])}) {
    EXPECT_TRUE(read_path(file).approximate) << file;
    EXPECT_EQ(read_path(file).tolerance, 0.25) << file;
  }
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
  for (const std::string& file : {path_geojson(two), path_wkt(two), path_csv(two), path_poses(two)}) {
    EXPECT_THAT(test::refusal_of([&] { read_path(file, "x"); }), HasSubstr("holds 2 paths")) << file;
    const std::vector<ClaimedPath> back = read_paths(file);
    ASSERT_EQ(back.size(), 2u) << file;
    for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(back[k].points, two[k].points) << file;
  }
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
  EXPECT_NEAR(back.tolerance, 1e-3, 1e-15);
  EXPECT_GT(back.points.size(), 15u);
  for (std::size_t i = 1; i + 1 < back.points.size(); ++i)
    EXPECT_NEAR(std::hypot(back.points[i].x - 2, back.points[i].y), 1, 1e-12) << "on the arc";
  EXPECT_EQ(read_path("CIRCULARSTRING (0 0, 1 1, 2 0)").points.front(), (Point{0, 0}));
  EXPECT_THAT(test::refusal_of([&] { read_path("CIRCULARSTRING (0 0, 1 1)", "x"); }), HasSubstr("3, 5, 7"));
}

TEST(DrivePath, HasHeadingsAndTheGear) {
  const std::vector<car::Leg> legs{{{{0, 0}, 0}, {{3, 0}, 0}, false}, {{{3, 0}, 0}, {{1, 0}, 0}, true}};
  const PathToWrite path = drive_path(legs, legs[0].from, 5);
  EXPECT_EQ(path.points, (std::vector<Point>{{0, 0}, {3, 0}, {1, 0}}));
  EXPECT_EQ(path.columns[0].second, (std::vector<double>{0, 0, 0}));
  EXPECT_EQ(path.columns[1].second, (std::vector<double>{1, 1, -1}));
  EXPECT_EQ(path.tolerance, 0);
}

TEST(PoseFile, LooksAlongThePath) {
  const std::vector<PathToWrite> square{{.name = "x", .points = {{0, 0}, {0, 0}, {2, 0}, {2, 3}, {2, 3}}}};
  const YAML::Node message = YAML::Load(path_poses(square));
  EXPECT_EQ(message["header"]["frame_id"].as<std::string>(), "map");
  ASSERT_EQ(message["poses"].size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    const YAML::Node pose = message["poses"][i]["pose"];
    EXPECT_EQ(pose["position"]["y"].as<double>(), square[0].points[i].y);
    const double half = i < 2 ? 0 : std::numbers::pi / 4;
    EXPECT_NEAR(pose["orientation"]["z"].as<double>(), std::sin(half), 1e-15) << i;
    EXPECT_NEAR(pose["orientation"]["w"].as<double>(), std::cos(half), 1e-15) << i;
  }
}

TEST(PoseFile, HasHeadingsAndSecondsThatWereGiven) {
  std::vector<PathToWrite> drive = kOne;
  drive[0].columns = {{"heading", {90, 90, 180}}, {"second", {0, 1.5, 3}}};
  const YAML::Node pose = YAML::Load(path_poses(drive))["poses"][1];
  EXPECT_NEAR(pose["pose"]["orientation"]["z"].as<double>(), std::sqrt(0.5), 1e-15);
  EXPECT_EQ(pose["header"]["stamp"]["sec"].as<int>(), 1);
  EXPECT_EQ(pose["header"]["stamp"]["nanosec"].as<int>(), 500000000);
}

TEST(PoseFile, IsRefusedWithItsLine) {
  EXPECT_THAT(test::refusal_of([&] { read_path("header:\nposes:\n- pose:\n    orientation: {w: 1}\n", "x"); }),
              HasSubstr("x:3: a pose without a position"));
  EXPECT_THAT(test::refusal_of([&] { read_path("poses:\n- position: {x: 1, y: z}\n", "x"); }), HasSubstr("x:2"));
  EXPECT_THAT(test::refusal_of([&] { read_path("poses: [\n", "x"); }), HasSubstr("no YAML"));
  EXPECT_EQ(read_path("poses:\n- position: {x: 1, y: 2}\n").points, (std::vector<Point>{{1, 2}}));
}

}  // namespace
}  // namespace taut
