#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <taut/geometry/free_space.h>
#include <taut/geometry/noded_parts.h>
#include <taut/geometry/written.h>
#include <taut/io/worlds/geographic_world.h>
#include <taut/io/worlds/read_world.h>
#include <taut/search/polyanya.h>

#include "support/refusal.h"

namespace taut {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

#define EXPECT_REFUSED(work, words) EXPECT_THAT(test::refusal_of([&] { work; }), HasSubstr(words))

// Vincenty's inverse formula: the geodesic between two places of the ellipsoid.
double geodesic(Point p, Point q) {
  constexpr double a = 6378137, f = 1 / 298.257223563, b = a * (1 - f), degree = std::numbers::pi / 180;
  const double u1 = std::atan((1 - f) * std::tan(p.y * degree)), u2 = std::atan((1 - f) * std::tan(q.y * degree));
  const double apart = (q.x - p.x) * degree;
  double lambda = apart, sine = 0, cosine = 1, sigma = 0, cos2 = 1, middle = 0;
  for (int i = 0; i < 100; ++i) {
    sine = std::hypot(std::cos(u2) * std::sin(lambda),
                      std::cos(u1) * std::sin(u2) - std::sin(u1) * std::cos(u2) * std::cos(lambda));
    if (sine == 0) return 0;
    cosine = std::sin(u1) * std::sin(u2) + std::cos(u1) * std::cos(u2) * std::cos(lambda);
    sigma = std::atan2(sine, cosine);
    const double alpha = std::cos(u1) * std::cos(u2) * std::sin(lambda) / sine;
    cos2 = 1 - alpha * alpha;
    middle = cos2 > 0 ? cosine - 2 * std::sin(u1) * std::sin(u2) / cos2 : 0;
    const double c = f / 16 * cos2 * (4 + f * (4 - 3 * cos2));
    const double next =
        apart + (1 - c) * f * alpha * (sigma + c * sine * (middle + c * cosine * (2 * middle * middle - 1)));
    const bool done = std::abs(next - lambda) < 1e-15;
    lambda = next;
    if (done) break;
  }
  const double u = cos2 * (a * a - b * b) / (b * b);
  const double big = 1 + u / 16384 * (4096 + u * (u * (320 - 175 * u) - 768));
  const double small = u / 1024 * (256 + u * (u * (74 - 47 * u) - 128));
  const double delta = small * sine *
                       (middle + small / 4 *
                                     (cosine * (2 * middle * middle - 1) -
                                      small / 6 * middle * (4 * sine * sine - 3) * (4 * middle * middle - 3)));
  return b * big * (sigma - delta);
}

WorldParts box_of(Point low, Point high) {
  WorldParts parts;
  parts.boundary = Boundary::limit;
  parts.areas.push_back({{{low, {high.x, low.y}, high, {low.x, high.y}}, {}}, 0});
  return parts;
}

double at(double v, std::int64_t steps, int places) {
  return written::number(std::llround(v * std::pow(10, places)) + steps, places);
}

TEST(GeographicWorld, MeasuresWithinWhatItSaysOfTheEllipsoid) {
  std::mt19937_64 random(1);
  for (const Point corner : {Point{13.4, 52.5}, {-70.3, -53.2}, {-0.3, -0.2}, {151.2, -33.9}, {25.0, 69.1}})
    for (const std::int64_t extent : {1'000, 100'000, 2'000'000}) {  // 1e-7 degrees: 0.0001 to 0.2 degrees
      const GeographicWorld world(box_of(corner, {at(corner.x, extent, 7), at(corner.y, extent, 7)}));
      double worst = 0;
      for (int i = 0; i < 200; ++i) {
        const auto draw = [&](double v) {
          return at(v, static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(extent)), 7);
        };
        const Point p{draw(corner.x), draw(corner.y)}, q{draw(corner.x), draw(corner.y)};
        const Point a = world.metres(p), b = world.metres(q);
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        const double off = std::abs(length - geodesic(p, q));
        EXPECT_LE(off, world.length_error(std::vector{p, q}, length) + 1e-6);
        EXPECT_LE(world.length_error(std::vector{p, q}, length), 1.0001 * world.relative_error() * length + 1e-7);
        worst = std::max(worst, off / (length + 1));
      }
      EXPECT_LE(worst, world.relative_error() + 1e-5);
      if (extent == 2'000'000 && corner.y > 50) {
        EXPECT_GT(worst, world.relative_error() / 20) << "a bound that says little";
      }
    }
}

TEST(GeographicWorld, GivesLongitudeAndLatitudeBack) {
  std::mt19937_64 random(2);
  for (const Point corner : {Point{13.4, 52.5}, {-170.3, -53.2}, {-0.0003, -0.0002}, {9.2, 80.1}}) {
    const GeographicWorld world(box_of(corner, {at(corner.x, 200'000, 7), at(corner.y, 100'000, 7)}));
    for (int i = 0; i < 1000; ++i) {
      const Point p{at(corner.x, static_cast<std::int64_t>(random() % 20'000'000'000), 12),
                    at(corner.y, static_cast<std::int64_t>(random() % 10'000'000'000), 12)};
      EXPECT_EQ(world.lon_lat(world.metres(p)), p);
    }
  }
}

TEST(GeographicWorld, GivesCornersBackThatNobodyWrote) {
  WorldParts parts = box_of({13.4, 52.5}, {13.5, 52.6});
  const Point computed{std::nextafter(13.45, 14), 52.5 + 0.1 / 3};
  parts.walls.push_back({computed, {13.46, 52.55}, 0, 0});
  const GeographicWorld world(parts);
  EXPECT_EQ(world.lon_lat(world.metres(computed)), computed);
}

// Walls from side to side of a town, and others that end on them in numbers of seven decimals.
TEST(GeographicWorld, KeepsContacts) {
  std::mt19937_64 random(3);
  const auto draw = [&](std::int64_t most) {
    return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(most));
  };
  for (int i = 0; i < 200; ++i) {
    // A long sloped wall through lattice points, one of which another wall ends on.
    const std::int64_t dx = 1 + draw(999), dy = 1 + draw(499), steps = 40 + draw(100), foot = 1 + draw(steps - 1);
    const auto on = [&](std::int64_t k) { return Point{at(13.4, k * dx, 7), at(52.5, k * dy, 7)}; };
    const Point from = on(0), to = on(steps), t = on(foot);
    WorldParts parts = box_of(from, to);
    parts.walls = {{from, to, 0, 1}, {t, {to.x, from.y}, 0, 2}};
    const WorldParts metres = GeographicWorld(parts).in_metres();
    const FreeSpace space{World(metres)};
    EXPECT_EQ(space.component_count(), 3U) << dx << " " << dy << " " << steps << " " << foot;
    EXPECT_GE(metres.walls.size(), 3U);
  }
}

TEST(GeographicWorld, KeepsEndsOnTheWallsTheyAreOn) {
  WorldParts parts = box_of({13.4, 52.5}, {13.42, 52.51});
  parts.walls = {{{13.402, 52.5011}, {13.418, 52.5043}, 0, 1}};
  const Point end{13.407, 52.5021};
  ASSERT_TRUE(written::on_segment(end, parts.walls[0].a, parts.walls[0].b));
  const GeographicWorld geographic(parts);
  const Point place = geographic.metres(end);
  bool corner = false;
  for (const Wall& wall : geographic.in_metres(std::vector{end}).walls) corner = corner || wall.a == place;
  EXPECT_TRUE(corner);
  for (const Wall& wall : geographic.in_metres().walls) EXPECT_NE(wall.a, place);
}

TEST(GeographicWorld, RefusesWhatIsNoLongitudeAndLatitude) {
  EXPECT_REFUSED(GeographicWorld(box_of({389000, 5820000}, {389100, 5820100})), "no longitude and latitude");
  EXPECT_REFUSED(GeographicWorld(box_of({10, 40}, {20, 60})), "too large for --project");
  EXPECT_REFUSED(GeographicWorld(box_of({-179.9, 0}, {179.9, 0.1})), "degrees of longitude");
  EXPECT_REFUSED(GeographicWorld(WorldParts{}), "no wall or polygon");
  const GeographicWorld berlin(box_of({13.4, 52.5}, {13.42, 52.51}));
  EXPECT_REFUSED(berlin.require_end({52.505, 13.41}, "start"), "longitude comes first");
  EXPECT_REFUSED(berlin.require_end({200, 0}, "start"), "no longitude and latitude");
  EXPECT_REFUSED(berlin.require_end({13.4, 62.5}, "start"), "too far");
  EXPECT_NO_THROW(berlin.require_end({13.4, 52.52}, "start"));
}

TEST(NodedParts, PutCornersWhereWallsTouchAndCross) {
  WorldParts parts;
  parts.walls = {
      {{0, 0.6}, {4, 3.1}, 0, 1}, {{0.8, 1.1}, {0.8, 0}, 0, 2}, {{0, 3.1}, {4, 0.6}, 0, 3}, {{0, 1}, {9, 1}, 0, 4}};
  const WorldParts result = noded(parts, std::vector<Point>{{1.6, 1.6}});
  std::vector<Point> first;
  for (const Wall& wall : result.walls)
    if (wall.line == 1) first.push_back(wall.b);
  EXPECT_THAT(first,
              testing::ElementsAre(Point{0.64, 1}, Point{0.8, 1.1}, Point{1.6, 1.6}, Point{2, 1.85}, Point{4, 3.1}));
}

std::string line(const std::string& coordinates, const std::string& further = "") {
  return R"({"type": "FeatureCollection", )" + further +
         R"("features": [{"type": "Feature", "properties": {}, "geometry": {"type": "LineString", "coordinates": )" +
         coordinates + "}}]}";
}

std::vector<std::string> remarks(const std::string& file) {
  ReadNotes notes;
  read_world(file, {}, &notes);
  return notes.remarks;
}

TEST(GeoJson, SaysThatLengthsAreDegreesOnlyWhereTheyAre) {
  const auto told = Contains(HasSubstr("lengths are in degrees"));
  const std::string berlin = "[[13.4012345, 52.5012345], [13.4112345, 52.5022345], [13.4112, 52.5072345]]";
  EXPECT_THAT(remarks(line(berlin)), told);
  EXPECT_THAT(
      remarks(line("[[1, 2], [3, 40]]", R"("crs": {"properties": {"name": "urn:ogc:def:crs:OGC:1.3:CRS84"}}, )")),
      told);
  for (const char* plan :
       {"[[0, 0], [4, 0], [4, 3]]", "[[0.1234, 0.1234], [0.9876, 0.4321]]", "[[12.5, 50.25], [12.75, 50.5]]",
        "[[10.1234, 50.1234], [40.1234, 60.1234]]", "[[389012.1234, 5820012.1234], [389012.2234, 5820012.1234]]"})
    EXPECT_THAT(remarks(line(plan)), Not(told)) << plan;
  EXPECT_THAT(remarks(line(berlin, R"("crs": {"properties": {"name": "EPSG:25833"}}, )")), Not(told));
}

TEST(ReadWorld, ProjectsLongitudeAndLatitude) {
  ReadNotes notes;
  const std::string berlin = line("[[13.4012345, 52.5012345], [13.4112345, 52.5012345]]");
  const World world = read_world(berlin, {.project = true, .start = Point{13.402, 52.502}}, &notes);
  ASSERT_TRUE(notes.geographic);
  ASSERT_EQ(world.walls().size(), 1U);
  EXPECT_NEAR(world.walls()[0].b.x - world.walls()[0].a.x, geodesic({13.4012345, 52.5012345}, {13.4112345, 52.5012345}),
              1e-3);
  EXPECT_EQ(notes.geographic->lon_lat(*world.start()), (Point{13.402, 52.502}));
  EXPECT_THAT(notes.remarks, Contains(HasSubstr("planned in metres")));
  EXPECT_REFUSED(read_world(line("[[13.4, 52.5], [13.5, 52.5]]", R"("crs": {"properties": {"name": "EPSG:25833"}}, )"),
                            {.project = true}),
                 "EPSG:25833");
  EXPECT_REFUSED(read_world("+---+\n|   |\n+---+\n", {.project = true}), "--project takes");
}

}  // namespace
}  // namespace taut
