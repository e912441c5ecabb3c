// Drives of a general car: found, checked by the second method, optimal on their lattice, or proven not to exist.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <queue>
#include <tuple>

#include <taut/geometry/errors.h>
#include <taut/geometry/maze_generator.h>
#include <taut/io/worlds/read_world.h>
#include <taut/robots/car/car_planner.h>
#include <taut/robots/car/detail/leg_lattice.h>
#include <taut/robots/car/verify_drive.h>

namespace taut::car {
namespace {

using testing::HasSubstr;

const CarShape kCar = car_shape(0.4, 0.2, 0.3, 0.1);

CarSpace space_of(const std::string& text, const CarShape& shape = kCar) {
  return CarSpace(FreeSpace(read_world(text)), shape);
}

void expect_checked(const PlannedDrive& drive, const CarSpace& space) {
  const auto fault = verify_drive(drive.legs, space.space(), space.shape());
  EXPECT_FALSE(fault) << "leg " << fault->leg << " " << fault->text;
  double length = 0;
  for (const Leg& leg : drive.legs) length += curve_of(leg).length();
  EXPECT_NEAR(length, drive.length, 1e-9);
  EXPECT_LE(drive.lower_bound, drive.length);
}

// A room of 6 by 4 with a wall from below; the goal is behind it.
const char* const kRoom = "boundary 0 0 6 4\n0 0 6 0\n6 0 6 4\n6 4 0 4\n0 4 0 0\n3 0 3 3\n";

TEST(PlannedDrive, GoesAroundAWall) {
  const CarSpace space = space_of(kRoom);
  for (const bool reverse : {true, false}) {
    CarShape shape = kCar;
    shape.reverse = reverse;
    const CarSpace own = space_of(kRoom, shape);
    const PlannedDrive drive = planned_drive(own, {.start = {1, 1}, .heading = 0, .goals = {{5, 1}}, .weight = 1});
    ASSERT_EQ(drive.status, SearchStatus::found);
    EXPECT_EQ(drive.start, (LatticePose{{1, 1}, 0}));
    EXPECT_EQ(drive.legs.back().to.at, (Point{5, 1}));
    expect_checked(drive, own);
    EXPECT_GT(drive.length, 2 * std::sqrt(8));
    EXPECT_LT(drive.length, 7.5);
  }
}

TEST(PlannedDrive, EndsExactlyInAPoseOffTheLattice) {
  const CarSpace space = space_of(kRoom);
  const PlannedDrive drive =
      planned_drive(space, {.start = {1.01, 0.97}, .heading = 5, .goals = {{5.1, 1.3}}, .goal_heading = 33});
  ASSERT_EQ(drive.status, SearchStatus::found);
  EXPECT_EQ(drive.legs.front().from, (LatticePose{{1.01, 0.97}, 5}));
  EXPECT_EQ(drive.legs.back().to, (LatticePose{{5.1, 1.3}, 33}));
  expect_checked(drive, space);
}

TEST(PlannedDrive, NeverGoesBackWhereTheCarCannot) {
  CarShape shape = kCar;
  shape.reverse = false;
  // Its nose in a dead end too narrow to turn in.
  const std::string text = "boundary 0 0 8 4\n0 0 8 0\n8 0 8 4\n8 4 0 4\n0 4 0 0\n5 1.8 8 1.8\n5 2.2 8 2.2\n";
  const DriveQuery query{.start = {7, 2}, .heading = 0, .goals = {{2, 2}}};
  const CarSpace forward = space_of(text, shape), either = space_of(text);
  const PlannedDrive drive = planned_drive(either, query);
  ASSERT_EQ(drive.status, SearchStatus::found);
  EXPECT_TRUE(drive.legs.front().backward);
  expect_checked(drive, either);
  EXPECT_EQ(planned_drive(forward, query).status, SearchStatus::stopped) << "unproven: only lattices were searched";
}

TEST(PlannedDrive, IsProvenNotToExistWhereEvenTheDiscInsideDoesNotPass) {
  const std::string head = "boundary 0 0 6 4\n0 0 6 0\n6 0 6 4\n6 4 0 4\n0 4 0 0\n3 0 3 ";
  const DriveQuery query{.start = {1, 1}, .heading = {}, .goals = {{5, 1}}};
  EXPECT_EQ(planned_drive(space_of(head + "3.7\n"), query).status, SearchStatus::found);
  const PlannedDrive none = planned_drive(space_of(head + "3.81\n"), query);
  EXPECT_EQ(none.status, SearchStatus::none);
  ASSERT_TRUE(none.barrier);
  EXPECT_EQ(none.barrier->status, DiscStatus::none);
  EXPECT_EQ(planned_drive(space_of(head + "4\n"), query).status, SearchStatus::none);
}

TEST(PlannedDrive, GetsThroughAGapOfExactlyItsWidth) {
  const std::string head = "boundary 0 0 6 4\n0 0 6 0\n6 0 6 4\n6 4 0 4\n0 4 0 0\n3 0 3 1.875\n3 4 3 ";
  const CarShape shape{0.25, 0.125, 0.125, 0.25, true};
  const DriveQuery query{.start = {1, 1}, .heading = {}, .goals = {{5, 1}}};
  const CarSpace space = space_of(head + "2.125\n", shape);
  const PlannedDrive drive = planned_drive(space, query);
  ASSERT_EQ(drive.status, SearchStatus::found);
  expect_checked(drive, space);
  EXPECT_EQ(planned_drive(space_of(head + "2.1249999\n", shape), query).status, SearchStatus::none);
}

TEST(PlannedDrive, RefusesEndsInWalls) {
  const CarSpace space = space_of(kRoom);
  const auto message = [&](const DriveQuery& query) {
    try {
      planned_drive(space, query);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(message({.start = {0.05, 0.05}, .heading = {}, .goals = {{5, 1}}}), HasSubstr("whatever its heading"));
  EXPECT_THAT(message({.start = {2.8, 1}, .heading = 0, .goals = {{5, 1}}}), HasSubstr("with that heading"));
  EXPECT_THAT(message({.start = {1, 1}, .heading = {}, .goals = {{9, 1}}}), HasSubstr("goal (9, 1)"));
  EXPECT_THAT(message({.start = {1, 1}, .heading = {}, .goals = {{5.8, 1}}, .goal_heading = 0}),
              HasSubstr("goal (5.8, 1)"));
}

TEST(PlannedDrive, StopsAtItsLimit) {
  const PlannedDrive drive =
      planned_drive(space_of(kRoom), {.start = {1, 1}, .heading = 0, .goals = {{5, 1}}, .limits = {.expansions = 20}});
  EXPECT_EQ(drive.status, SearchStatus::stopped);
  EXPECT_EQ(drive.expanded, 20U);
}

TEST(PlannedDrive, IsFoundInMazesAndPassesTheCheck) {
  for (int seed = 1; seed <= 4; ++seed) {
    const auto maze = std::make_shared<GridMaze>(generate_backtracker(9, 9, static_cast<std::uint64_t>(seed)));
    const CarSpace space(FreeSpace(world_of(maze)), kCar);
    const PlannedDrive drive =
        planned_drive(space, {.start = {0.5, 0.5}, .heading = {}, .goals = {{8.5, 8.5}}, .weight = 1.05});
    ASSERT_EQ(drive.status, SearchStatus::found) << seed;
    expect_checked(drive, space);
    EXPECT_LT(drive.length, 1.25 * drive.lower_bound);
  }
}

/// The optimum on a lattice by Dijkstra without heuristic, index or prepared legs.
double dijkstra(const CarSpace& space, const LatticePose& start, Point goal, const detail::LegLattice& lattice) {
  const auto primitives = detail::primitives(lattice, space.shape());
  using Key = std::tuple<double, double, int>;
  std::map<Key, double> best;
  std::priority_queue<std::pair<double, Key>, std::vector<std::pair<double, Key>>, std::greater<>> open;
  open.push({0, {start.at.x, start.at.y, start.heading}});
  best[{start.at.x, start.at.y, start.heading}] = 0;
  while (!open.empty()) {
    const auto [length, key] = open.top();
    open.pop();
    if (length > best[key]) continue;
    const LatticePose from{{std::get<0>(key), std::get<1>(key)}, std::get<2>(key)};
    if (from.at == goal) return length;
    for (const detail::Primitive& p : primitives[static_cast<std::size_t>(from.heading / lattice.stride)]) {
      const Leg leg{from,
                    {{from.at.x + p.di * lattice.step, from.at.y + p.dj * lattice.step}, p.leg.leg().to.heading},
                    p.leg.leg().backward};
      const Key to{leg.to.at.x, leg.to.at.y, leg.to.heading};
      const double total = length + curve_of(leg).length();
      const auto known = best.find(to);
      if ((known != best.end() && known->second <= total) ||
          space.space().locate(leg.to.at).kind == Location::Kind::outside)
        continue;
      if (!space.is_clear(leg)) continue;
      best[to] = total;
      open.push({total, to});
    }
  }
  return INFINITY;
}

TEST(PlannedDrive, IsTheShortestOnItsLattice) {
  const CarSpace space = space_of("boundary 0 0 2 1.5\n0 0 2 0\n2 0 2 1.5\n2 1.5 0 1.5\n0 1.5 0 0\n1 0 1 0.75\n");
  const DriveQuery query{.start = {0.5, 0.25}, .heading = 0, .goals = {{1.5, 0.25}}, .weight = 1, .shorten = false};
  const PlannedDrive drive = planned_drive(space, query);
  ASSERT_EQ(drive.status, SearchStatus::found);
  expect_checked(drive, space);
  ASSERT_EQ(drive.lattices, 1U);
  DriveQuery shorter = query;
  shorter.shorten = true;
  const PlannedDrive taut = planned_drive(space, shorter);
  expect_checked(taut, space);
  EXPECT_LT(taut.length, drive.length);
  EXPECT_NEAR(drive.length, dijkstra(space, {{0.5, 0.25}, 0}, {1.5, 0.25}, {drive.step, kHeadings / drive.headings}),
              1e-9);
}

TEST(DriveCheck, NamesTheFirstFault) {
  const CarSpace space = space_of(kRoom);
  const auto fault = [&](std::vector<Leg> legs) {
    const auto found = verify_drive(legs, space.space(), kCar);
    return found ? found->text : std::string("none");
  };
  const LatticePose a{{1, 1}, 0}, b{{2, 1}, 0}, c{{4, 1}, 0};
  EXPECT_EQ(fault({{a, b}}), "none");
  EXPECT_THAT(fault({{a, b}, {b, c}}), HasSubstr("meets the wall (3, 0)-(3, 3)"));
  EXPECT_THAT(fault({{a, b}, {a, b}}), HasSubstr("does not begin"));
  EXPECT_THAT(fault({{a, {{1.1, 1.1}, 16}}}), HasSubstr("radius"));
  EXPECT_THAT(fault({{a, {{0, 2}, 16}}}), HasSubstr("direction"));
  const CarSpace open = space_of("boundary 0 0 6 4\n0 0 0 4\n");
  const Leg out{{{5, 1}, 0}, {{7, 1}, 0}};
  EXPECT_THAT(verify_drive(std::vector{out}, open.space(), kCar)->text, HasSubstr("leaves"));
  const Leg bulge{{{5.9, 1}, 8}, {{5.9, 3}, 24}};
  EXPECT_THAT(verify_drive(std::vector{bulge}, open.space(), kCar)->text, HasSubstr("leaves through the opening"));
  EXPECT_FALSE(open.is_clear(bulge));
}

}  // namespace
}  // namespace taut::car
