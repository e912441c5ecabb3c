#include <taut/robots/roadblocks/peers.h>

#include <algorithm>
#include <array>

#include <taut/robots/roadblocks/tree_planner.h>
#include <taut/robots/roadblocks/value_planner.h>

namespace taut::roadblocks {

namespace {

template <typename Planner, typename... Arguments>
std::unique_ptr<Driver> driver_of(Arguments&&... arguments) {
  auto planner = std::make_shared<Planner>(std::forward<Arguments>(arguments)...);
  return replanning_driver([planner](const Pose& from, RoadblockSet closed) { return planner->plan(from, closed); });
}

template <TreeKind kind>
std::unique_ptr<Driver> tree(const Course& course, WallReading reading, std::uint64_t seed) {
  return driver_of<TreePlanner>(course, reading, kind, seed);
}

std::unique_ptr<Driver> values(const Course& course, WallReading reading, std::uint64_t) {
  return driver_of<ValuePlanner>(course, reading);
}

constexpr std::array<Peer, 5> kPeers{{
    {"rrt", "a random tree of the car's controls", tree<TreeKind::rrt>},
    {"rrt-field", "the same, half of the samples along the way of a disc", tree<TreeKind::rrt_field>},
    {"rrt-star", "a random tree that rewires", tree<TreeKind::rrt_star>},
    {"rrt-connect", "two random trees", tree<TreeKind::rrt_connect>},
    {"value-iteration", "on cells x 8 headings", values},
}};

}  // namespace

std::span<const Peer> peers() { return kPeers; }

const Peer* peer_named(std::string_view name) {
  const auto at = std::ranges::find(kPeers, name, &Peer::name);
  return at == kPeers.end() ? nullptr : &*at;
}

}  // namespace taut::roadblocks
