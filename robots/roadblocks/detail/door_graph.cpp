#include <taut/robots/roadblocks/detail/door_graph.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace taut::roadblocks::detail {

namespace {

constexpr double kLeave = 2 * kHalfLength / kForward;  // from where a table's point is covered to where it is left
constexpr double kThrough = 0.5;                       // of the steps through a door: more, and a leg leads through it
constexpr std::size_t kMostKept = 20'000;

Pose turned(Pose pose) {
  pose.heading += std::numbers::pi;
  return pose;
}

StepTable table(const Obstacles& obstacles, Point goal) {
  return PoseDistance(obstacles, DiscDistance(obstacles, goal), goal).table();
}

}  // namespace

std::optional<DoorGraph> DoorGraph::within(std::size_t bytes, const Course& course, WallReading reading,
                                           std::vector<Door> doors) {
  std::optional<DoorGraph> graph{DoorGraph()};
  graph->doors_ = std::move(doors);
  std::erase_if(graph->doors_, [](const Door& door) { return door.sides.size() < 2; });
  if (!graph->make_tables(bytes, course, reading)) return std::nullopt;
  graph->choose_poses();
  graph->order_blocks(course);
  graph->make_legs();
  return graph;
}

/// False as soon as they are too many.
bool DoorGraph::make_tables(std::size_t bytes, const Course& course, WallReading reading) {
  const RoadblockSet all_blocks = ObservedMap(course).all();
  std::size_t used = 0;
  const auto add = [&](RoadblockSet closed, Point to) {
    tables_.push_back(table(Obstacles(course, closed, reading), to));
    used += tables_.back().bytes();
  };
  first_side_.push_back(0);
  for (std::size_t d = 0; d < doors_.size(); ++d) {
    for (const DoorSide& side : doors_[d].sides) {
      add(all_blocks & ~doors_[d].blocks, side.look);
      door_of_.push_back(d);
      if (used > bytes) return false;
    }
    first_side_.push_back(door_of_.size());
  }
  add(all_blocks, course.goal);
  return used <= bytes;
}

void DoorGraph::make_legs() {
  const auto nodes = static_cast<std::size_t>(goal());
  legs_.assign(nodes, std::vector<double>(nodes + 1, kFar));
  for (std::size_t k = 0; k < door_of_.size(); ++k)
    for (std::size_t other = first_side_[door_of_[k]]; other < first_side_[door_of_[k] + 1]; ++other)
      if (other != k) legs_[k][door_of_.size() + other] = std::min(kFar, steps(sights_[k], other) + kLeave);
  for (std::size_t k = 0; k < door_of_.size(); ++k) {
    const std::vector<double> from_sight = legs_from(sights_[k], 0), from_beyond = legs_from(beyonds_[k], 0);
    for (std::size_t v = 0; v <= nodes; ++v) {
      legs_[k][v] = std::min(legs_[k][v], from_sight[v]);
      legs_[door_of_.size() + k][v] = from_beyond[v];
    }
  }
}

void DoorGraph::choose_poses() {
  for (std::size_t k = 0; k < door_of_.size(); ++k) {
    const auto sight = best_arrival(k, [&](const Pose& pose) { return leave(pose, k) < kFar ? pass(pose, k) : kFar; });
    sights_.push_back(sight ? *sight
                            : best_arrival(k, [&](const Pose& pose) { return pass(pose, k); }).value_or(Pose{}));
    const auto beyond = best_arrival(k, [&](const Pose& pose) { return leave(pose, k) + pass(turned(pose), k); });
    beyonds_.push_back(beyond.value_or(turned(sights_.back())));
  }
}

template <typename Cost>
std::optional<Pose> DoorGraph::best_arrival(std::size_t side, Cost cost) const {
  const Door& door = doors_[door_of_[side]];
  std::optional<Pose> best;
  double least = kFar;
  for (const Point p : door.sides[side - first_side_[door_of_[side]]].arrival)
    for (int h = 0; h < PoseDistance::kTableHeadings; ++h) {
      const Pose pose{p.x, p.y, h * 2 * std::numbers::pi / PoseDistance::kTableHeadings};
      if (const double now = cost(pose); now < least) best = pose, least = now;
    }
  return best;
}

double DoorGraph::pass(const Pose& pose, std::size_t side) const {
  double least = kFar;
  for (std::size_t other = first_side_[door_of_[side]]; other < first_side_[door_of_[side] + 1]; ++other)
    if (other != side) least = std::min(least, steps(pose, other));
  return least;
}

double DoorGraph::leave(const Pose& pose, std::size_t side) const {
  double least = kFar;
  for (std::size_t other = 0; other < tables_.size(); ++other)
    if (other >= door_of_.size() || door_of_[other] != door_of_[side]) least = std::min(least, steps(pose, other));
  return least;
}

std::vector<double> DoorGraph::legs_from(const Pose& pose, DoorSet open) const {
  const std::size_t m = door_of_.size();
  std::vector<double> legs(2 * m + 1, kFar);
  for (std::size_t k = 0; k < m; ++k) {
    const double direct = steps(pose, k);
    if (direct >= kFar) continue;
    legs[k] = direct;
    for (std::size_t other = first_side_[door_of_[k]]; other < first_side_[door_of_[k] + 1]; ++other)
      if (other != k && direct > steps(pose, other) + kThrough * (legs_[other][m + k] - kLeave)) legs[k] = kFar;
    if ((open >> door_of_[k]) & 1) legs[m + k] = direct + kLeave;
  }
  legs[2 * m] = steps(pose, m);
  return legs;
}

void DoorGraph::stand_at(int door, const Pose& pose, std::vector<double>& legs) const {
  const std::size_t begin = first_side_[static_cast<std::size_t>(door)],
                    end = first_side_[static_cast<std::size_t>(door) + 1];
  std::size_t here = begin;
  const auto away = [&](std::size_t side) { return std::hypot(sights_[side].x - pose.x, sights_[side].y - pose.y); };
  for (std::size_t side = begin; side < end; ++side)
    if (away(side) < away(here)) here = side;
  const double back = steps(pose, here);
  if (back >= kFar) return;
  for (std::size_t v = 0; v < legs.size(); ++v) legs[v] = std::min(legs[v], back + legs_[here][v]);
  for (std::size_t side = begin; side < end; ++side) {
    legs[side] = side == here ? 0 : kFar;
    legs[door_of_.size() + side] = kFar;
  }
}

void DoorGraph::order_blocks(const Course& course) {
  for (std::size_t k = 0; k < door_of_.size(); ++k) {
    const Door& door = doors_[door_of_[k]];
    const Point look = door.sides[k - first_side_[door_of_[k]]].look;
    std::vector<std::pair<double, RoadblockSet>> blocks;
    for (RoadblockSet rest = door.blocks; rest != 0; rest &= rest - 1) {
      double away = kFar;
      for (const Cell c : course.roadblocks[static_cast<std::size_t>(std::countr_zero(rest))].cells)
        away = std::min(away, std::hypot(c.x - look.x, c.y - look.y));
      blocks.emplace_back(away, rest & (~rest + 1));
    }
    std::ranges::sort(blocks);
    const double first = blocks.front().first;
    for (auto& [away, block] : blocks) away = (away - first) * (1 / kForward + 1 / kBackward);
    blocks_.push_back(std::move(blocks));
  }
}

double DoorGraph::trap(int side, RoadblockSet open) const {
  for (const auto& [steps, block] : blocks_[static_cast<std::size_t>(side)])
    if (!(block & open)) return steps;
  return 0;
}

double DoorGraph::price(DoorSet door, DoorSet open, double penalty) const {
  if (open & door) return 0;
  const double p = doors_[static_cast<std::size_t>(std::countr_zero(door))].open_probability;
  return p > 0 ? penalty * (1 - p) / p : kFar;
}

const DoorGraph::Ways& DoorGraph::ways(DoorSet open, DoorSet closed, double penalty) {
  if (penalty == std::numeric_limits<double>::infinity()) closed = all() & ~open, penalty = 0;
  const std::tuple key{open, closed, penalty};
  const auto at = kept_.find(key);
  if (at != kept_.end()) return at->second;
  if (kept_.size() >= kMostKept) kept_.clear();
  return kept_.emplace(key, made(open, closed, penalty)).first->second;
}

/// Dijkstra from the goal on a dense graph.
DoorGraph::Ways DoorGraph::made(DoorSet open, DoorSet closed, double penalty) const {
  const auto nodes = static_cast<std::size_t>(goal()) + 1, end = nodes - 1;
  const auto m = door_of_.size();
  Ways ways{std::vector<double>(nodes, kFar), std::vector<int>(nodes, -1), std::vector<int>(nodes, goal()),
            std::vector<double>(nodes, 0)};
  std::vector<bool> done(nodes);
  ways.steps[end] = 0;
  for (;;) {
    std::size_t v = nodes;
    for (std::size_t u = 0; u < nodes; ++u)
      if (!done[u] && ways.steps[u] < kFar && (v == nodes || ways.steps[u] < ways.steps[v])) v = u;
    if (v == nodes) return ways;
    done[v] = true;
    const DoorSet door = v == end ? 0 : door_of(side_of(static_cast<int>(v)));
    if (door & closed) continue;
    const bool is_stop = v == end || (v < m && !(door & open));
    const double extra = v >= m && v < end ? price(door, open, penalty) : 0;
    for (std::size_t u = 0; u < end; ++u) {
      const double through = legs_[u][v] + extra + ways.steps[v];
      if (done[u] || through >= ways.steps[u]) continue;
      ways.steps[u] = through;
      ways.next[u] = static_cast<int>(v);
      ways.stop[u] = is_stop ? static_cast<int>(v) : ways.stop[v];
      ways.to_stop[u] = legs_[u][v] + (is_stop ? 0 : ways.to_stop[v]);
    }
  }
}

std::pair<int, double> DoorGraph::first(const std::vector<double>& legs, const Ways& ways, DoorSet closed) const {
  std::pair<int, double> best{goal(), legs.back()};
  for (int v = 0; v < goal(); ++v) {
    if (door_of(side_of(v)) & closed) continue;
    const auto at = static_cast<std::size_t>(v);
    if (legs[at] + ways.steps[at] < best.second) best = {v, legs[at] + ways.steps[at]};
  }
  return best;
}

std::pair<std::vector<double>, std::vector<int>> DoorGraph::from_here(std::vector<double> legs, DoorSet open) const {
  const auto nodes = static_cast<std::size_t>(goal()), m = door_of_.size();
  std::vector<int> before(nodes + 1, -1);
  std::vector<bool> done(nodes);
  for (;;) {
    std::size_t u = nodes;
    for (std::size_t v = 0; v < nodes; ++v)
      if (!done[v] && legs[v] < kFar && (u == nodes || legs[v] < legs[u])) u = v;
    if (u == nodes) return {std::move(legs), std::move(before)};
    done[u] = true;
    if (u < m && !(door_of(static_cast<int>(u)) & open)) continue;  // what is behind it is another question
    for (std::size_t v = 0; v <= nodes; ++v) {
      if (v >= m && v < nodes && !(door_of(side_of(static_cast<int>(v))) & open)) continue;
      if (legs[u] + legs_[u][v] >= legs[v]) continue;
      legs[v] = legs[u] + legs_[u][v];
      before[v] = static_cast<int>(u);
    }
  }
}

}  // namespace taut::roadblocks::detail
