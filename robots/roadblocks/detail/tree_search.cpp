#include <taut/robots/roadblocks/detail/tree_search.h>

#include <cmath>
#include <numbers>

namespace taut::roadblocks::detail {

TreeBranch branch_of(Pose from, std::span<const double> controls, bool from_goal) {
  TreeBranch branch{{{from.x, from.y}}, from_goal};
  for (const double control : controls) {
    from = stepped(from, control);
    branch.way.push_back({from.x, from.y});
  }
  return branch;
}

namespace {

constexpr double kFieldStep = 1.0 / kRaster;

}  // namespace

Stretch TreeRoom::driven(const Pose& from, std::span<const double> controls) const {
  Stretch way;
  Pose at = from;
  for (const double control : controls) {
    const Pose to = stepped(at, control);
    if (!is_clear(at, control, to)) return way;
    way.poses.push_back(at = to);
    if ((way.arrived = is_goal(at))) return way;
  }
  way.whole = true;
  return way;
}

bool TreeRoom::drives(const Pose& from, std::span<const double> controls, Pose& end) const {
  Pose at = from;
  for (const double control : controls) {
    const Pose to = stepped(at, control);
    if (!is_clear(at, control, to)) return false;
    at = to;
  }
  end = at;
  return true;
}

Pose TreeRoom::sample(Draws& draws) const {
  Pose pose;
  do {
    const double across = draws.unit();
    const double down = draws.unit();
    pose.x = 0.5 + across * course().width;
    pose.y = 0.5 + down * course().height;
  } while (!distance_.reaches({pose.x, pose.y}));
  pose.heading = draws.unit() * 2 * std::numbers::pi;
  return pose;
}

Pose TreeRoom::ahead(const Pose& from, double far) const {
  Point at{from.x, from.y};
  for (double gone = 0; gone < far; gone += kFieldStep) {
    Point best = at;
    for (const double dy : {-kFieldStep, 0.0, kFieldStep})
      for (const double dx : {-kFieldStep, 0.0, kFieldStep}) {
        const Point next{at.x + dx, at.y + dy};
        if (distance_.steps_from(next) < distance_.steps_from(best)) best = next;
      }
    if (best == at) break;
    at = best;
  }
  return {at.x, at.y, std::atan2(at.y - from.y, at.x - from.x)};
}

}  // namespace taut::roadblocks::detail
