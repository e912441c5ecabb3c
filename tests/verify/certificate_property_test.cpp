// What the planners prove the judge approves; of what was tampered with it approves nothing that is false.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "support/certified.h"
#include "support/random_world.h"

namespace taut {
namespace {

using nlohmann::json;
using test::any;

Point any_point(int side) {
  const int x = any(0, 4 * side), y = any(0, 4 * side);
  return {x / 4.0, y / 4.0};
}

test::SmallWorld any_small_world(int& side) {
  const test::RandomWorld kinds[] = {{},
                                     {.side = 4, .walls = 14, .solids = 2, .straight = true},
                                     {.side = 5, .walls = 0, .solids = 6},
                                     {.side = 8, .walls = 20, .solids = 0}};
  const test::RandomWorld& kind = kinds[any(0, 3)];
  side = kind.side;
  return any_world(kind);
}

// Walls that bend where their crossings are rounded still pass through the ends that lie on them.
FreeSpace space_of(const test::SmallWorld& world, Point p, Point q) {
  const std::array places{p, q};
  return FreeSpace(World(world.parts()), Footprint::point(), places);
}

RC_GTEST_PROP(PathCertificate, IsApprovedForEveryAnswer, ()) {
  int side = 0;
  const test::SmallWorld world = any_small_world(side);
  RC_LOG() << test::show(world) << '\n';
  for (int i = 0; i < 6; ++i) {
    const Point p = any_point(side), q = any_point(side);
    const FreeSpace space = space_of(world, p, q);
    if (!test::is_place(space, p) || !test::is_place(space, q)) continue;
    RC_LOG() << test::show(p) << ' ' << test::show(q) << '\n';
    const auto certificate = test::certificate_of(space, p, {q, {}});
    if (!certificate) {
      RC_ASSERT(space.report().displacement > 0);
      continue;
    }
    const proof::Judgement said = proof::judge(write_integers(space.world()), *certificate);
    // Where crossings are rounded the planner sees a leg as tangent, or as free, that exactly is not, and the reverse.
    if (space.report().displacement == 0) RC_ASSERT(said.words == (said.proven ? said.words : ""));
    RC_ASSERT(test::wrong_approval(space, *certificate) == "");
  }
}

Goal any_room(int side) {
  const int x = any(0, 2 * side - 1), y = any(0, 2 * side - 1), w = any(1, 4), h = any(1, 4);
  const double all = 2 * side;
  return {std::nullopt, {{{x / 2.0, y / 2.0}, {std::min<double>(x + w, all) / 2, std::min<double>(y + h, all) / 2}}}};
}

/// Something may stand in the room. Then the planner ends only where the way to its middle is free, of which the judge
/// knows nothing; and sloped walls may meet the border at fractions.
bool is_met_inside(const World& world, const Goal& goal) {
  const Box room = goal.room.front();
  // An interval of no length meets what it lies strictly inside of.
  const auto overlap = [](double from, double to, double low, double high) { return from < high && low < to; };
  const auto meets = [&](Point p, Point q) {
    const auto [left, right] = std::minmax(p.x, q.x);
    const auto [below, above] = std::minmax(p.y, q.y);
    return overlap(left, right, room.min.x, room.max.x) && overlap(below, above, room.min.y, room.max.y);
  };
  const auto solid = [&](const Area& area) {
    const Ring& ring = area.polygon.outer;
    const auto [left, right] = std::minmax_element(ring.begin(), ring.end());
    const auto [below, above] =
        std::minmax_element(ring.begin(), ring.end(), [](Point p, Point q) { return p.y < q.y; });
    return meets({left->x, below->y}, {right->x, above->y});
  };
  return std::any_of(world.walls().begin(), world.walls().end(), [&](const Wall& w) { return meets(w.a, w.b); }) ||
         std::any_of(world.solids().begin(), world.solids().end(), solid);
}

RC_GTEST_PROP(PathCertificate, IsApprovedForEveryAnswerOfARoom, ()) {
  int side = 0;
  const test::SmallWorld world = any_small_world(side);
  RC_LOG() << test::show(world) << '\n';
  for (int i = 0; i < 6; ++i) {
    const Point p = any_point(side);
    const Goal goal = any_room(side);
    const FreeSpace space = space_of(world, p, p);
    if (!test::is_place(space, p) || space.report().displacement > 0) continue;
    RC_LOG() << test::show(p) << " to " << test::show(goal.room[0].min) << ' ' << test::show(goal.room[0].max) << '\n';
    const auto certificate = test::certificate_of(space, p, goal);
    if (!certificate && is_met_inside(space.world(), goal)) continue;
    RC_ASSERT(certificate.has_value());
    const proof::Judgement said = proof::judge(write_integers(space.world()), *certificate);
    // A path that turns back on itself, around the end of a wall that lies on the border, the judge does not follow.
    const bool turns_back = said.words.find("the path bends at") != std::string::npos;
    if (!is_met_inside(space.world(), goal) && !turns_back) RC_ASSERT(said.words == (said.proven ? said.words : ""));
    RC_ASSERT(test::wrong_approval(space, *certificate) == "");
  }
}

// Squares of 115 bits, so little below that of a whole number that a long double's root of them is that number.
TEST(PathCertificate, HasLengthsRoundedDownWhereARootInFloatingPointIsRoundedUp) {
  __extension__ using Wide = __int128;
  constexpr int kSide = 1 << 20;
  const FreeSpace space(World(test::SmallWorld{.area = test::box_ring(0, 0, kSide, kSide)}.parts()));
  for (const int x : {kSide - 241, kSide - 262, kSide - 665, kSide - 917}) {
    const Point goal{double(x), kSide - 12345};
    const json said = json::parse(test::certificate_of(space, {1, 1}, {goal, {}}).value());
    const auto along = [&](int axis) -> Wide {
      return said["path"][1][axis].get<std::int64_t>() - said["path"][0][axis].get<std::int64_t>();
    };
    const Wide square = (along(0) * along(0) + along(1) * along(1)) << (2 * said["fraction_bits"].get<int>());
    const auto length = said["reach"].get<std::int64_t>();
    EXPECT_LE(Wide{length} * length, square) << x;
    EXPECT_GT(Wide{length + 1} * (length + 1), square) << x;
    EXPECT_GT(std::sqrt(static_cast<long double>(square)), static_cast<long double>(length)) << x;
  }
}

// One of what somebody could do to the numbers.
json tampered(json certificate, int side) {
  json& potentials = certificate["potentials"];
  json& path = certificate["path"];
  const auto one_of = [](json& rows) -> json& { return rows[static_cast<std::size_t>(any(0, int(rows.size()) - 1))]; };
  const auto bits = certificate["fraction_bits"].get<int>();
  json& goal = certificate["goal"];
  switch (any(0, 7)) {
    case 0: {
      json& number = one_of(potentials)[2];
      number = number.get<std::int64_t>() + (std::int64_t{any(-3, 3)} << any(0, bits));
      break;
    }
    case 1: one_of(path)[static_cast<std::size_t>(any(0, 1))] = any(0, side * certificate["scale"].get<int>()); break;
    case 2: potentials.erase(static_cast<std::size_t>(any(0, int(potentials.size()) - 1))); break;
    case 3: path.erase(static_cast<std::size_t>(any(0, int(path.size()) - 1))); break;
    case 4:
      certificate["horizon"] = certificate["horizon"].get<std::int64_t>() + (std::int64_t{any(-3, 3)} << bits);
      break;
    case 5: one_of(goal)[static_cast<std::size_t>(any(0, 1))] = any(0, side * certificate["scale"].get<int>()); break;
    case 6:
      if (certificate.contains("reach"))
        certificate["reach"] = certificate["reach"].get<std::int64_t>() + (std::int64_t{any(-3, 3)} << any(0, bits));
      break;
    default: one_of(potentials)[static_cast<std::size_t>(any(0, 1))] = any(0, side); break;
  }
  return certificate;
}

// A wall or a solid less, or moved.
test::SmallWorld changed(test::SmallWorld world, int side) {
  const std::size_t walls = world.walls.size(), solids = world.solids.size();
  if (walls + solids == 0) return world;
  const auto i = static_cast<std::size_t>(any(0, int(walls + solids) - 1));
  if (i >= walls) {
    world.solids.erase(world.solids.begin() + static_cast<std::ptrdiff_t>(i - walls));
  } else if (any(0, 1) == 0) {
    world.walls.erase(world.walls.begin() + static_cast<std::ptrdiff_t>(i));
  } else {
    (any(0, 1) ? world.walls[i].a : world.walls[i].b) = test::any_lattice_point(side);
  }
  return world;
}

bool is_proven(const FreeSpace& space, const std::string& claim) {
  try {
    return proof::judge(write_integers(space.world()), claim).proven;
  } catch (const proof::BadInput&) {  // a wall that was moved may meet the room at a fraction
    return false;
  }
}

// RC_PARAMS=max_success=1000 makes 20 000.
TEST(PathCertificate, ThatWasTamperedWithIsNeverApprovedWrongly) {
  int cases = 0, refused = 0;
  const bool sound = rc::check("tampered certificates", [&] {
    int side = 0;
    const test::SmallWorld world = any_small_world(side);
    const Point p = any_point(side), q = any_point(side);
    const FreeSpace space = space_of(world, p, q);
    RC_PRE(test::is_place(space, p) && test::is_place(space, q));
    const auto certificate = test::certificate_of(space, p, any(0, 1) ? Goal{q, {}} : any_room(side));
    RC_PRE(certificate.has_value());
    RC_LOG() << test::show(world) << '\n' << test::show(p) << ' ' << test::show(q) << '\n' << *certificate << '\n';
    for (int i = 0; i < 10; ++i) {
      const json other = tampered(json::parse(*certificate), side);
      RC_LOG() << other << '\n';
      RC_ASSERT(test::wrong_approval(space, other.dump()) == "");
      const FreeSpace moved = space_of(changed(world, side), p, q);
      const std::string claim = test::about(moved.world(), json::parse(*certificate));
      RC_LOG() << write_integers(moved.world()) << '\n';
      RC_ASSERT(test::wrong_approval(moved, claim) == "");
      cases += 2;
      refused += !is_proven(moved, claim);
    }
  });
  EXPECT_TRUE(sound);
  EXPECT_GT(cases, 1000);
  EXPECT_GT(refused, cases / 50) << "of worlds that were changed";
}

}  // namespace
}  // namespace taut
