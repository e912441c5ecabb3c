#include <taut/robots/roadblocks/tree_planner.h>

#include <map>

#include <taut/robots/roadblocks/detail/tree_search.h>

namespace taut::roadblocks {

struct TreePlanner::Impl {
  Impl(const Course& c, WallReading r, TreeKind k, std::uint64_t seed) : course(c), reading(r), kind(k), draws(seed) {}

  const detail::TreeRoom& room(RoadblockSet closed) {
    auto at = rooms.find(closed);
    if (at == rooms.end()) at = rooms.emplace(closed, detail::TreeRoom(course, closed, reading)).first;
    return at->second;
  }

  std::optional<std::vector<double>> search(const detail::TreeRoom& in, const Pose& from,
                                            std::vector<TreeBranch>* tree) {
    detail::Samples budget{draws, most_samples(kind), samples, tree};
    switch (kind) {
      case TreeKind::rrt: return detail::rrt(in, from, budget, false);
      case TreeKind::rrt_field: return detail::rrt(in, from, budget, true);
      case TreeKind::rrt_star: return detail::rrt_star(in, from, budget);
      case TreeKind::rrt_connect: break;
    }
    return detail::rrt_connect(in, from, budget);
  }

  const Course& course;
  WallReading reading;
  TreeKind kind;
  Draws draws;
  std::size_t samples = 0;
  std::map<RoadblockSet, detail::TreeRoom> rooms;
};

TreePlanner::TreePlanner(const Course& course, WallReading reading, TreeKind kind, std::uint64_t seed)
    : impl_(std::make_unique<Impl>(course, reading, kind, seed)) {}

TreePlanner::~TreePlanner() = default;

Attempt TreePlanner::plan(const Pose& from, RoadblockSet closed, std::vector<TreeBranch>* tree) {
  const detail::TreeRoom& room = impl_->room(closed);
  if (!room.distance().reaches({from.x, from.y})) return {std::nullopt, true};
  const std::optional<std::vector<double>> controls = impl_->search(room, from, tree);
  if (!controls) return {};
  const detail::Stretch way = room.driven(from, *controls);
  if (!way.arrived) return {};
  return {DrivePlan{{controls->begin(), controls->begin() + static_cast<std::ptrdiff_t>(way.poses.size())}, way.poses}};
}

std::size_t TreePlanner::samples() const { return impl_->samples; }

std::vector<TreeBranch> trees_of(const Course& course, WallReading reading, TreeKind kind, std::uint64_t seed,
                                 const Drive& drive) {
  std::vector<TreeBranch> all;
  TreePlanner planner(course, reading, kind, seed);
  planner.plan(drive.poses.front(), 0, &all);
  // The same questions again: whenever a roadblock showed closed and the drive was not over.
  RoadblockSet closed = 0;
  for (const auto& [steps, seen] : drive.sights) {
    const RoadblockSet before = closed;
    closed |= seen & ~drive.open;
    const bool over = static_cast<std::size_t>(steps) == drive.controls.size() && drive.outcome == Outcome::reached;
    if (closed != before && !over) planner.plan(drive.poses[static_cast<std::size_t>(steps)], closed, &all);
  }
  return all;
}

std::size_t most_samples(TreeKind kind) {
  switch (kind) {
    case TreeKind::rrt:
    case TreeKind::rrt_field:
    case TreeKind::rrt_star: return 300'000;
    case TreeKind::rrt_connect: break;
  }
  return 100'000;
}

}  // namespace taut::roadblocks
