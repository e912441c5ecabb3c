#include <taut/robots/roadblocks/detail/growth.h>

#include <taut/robots/roadblocks/detail/pose_index.h>
#include <taut/robots/roadblocks/detail/steering.h>

namespace taut::roadblocks::detail {

namespace {

std::vector<std::vector<double>> motions() {
  std::vector<std::vector<double>> all{std::vector(8, 0.0), std::vector(12, kReverse)};
  for (const double control : {1.0, -1.0, 0.5, -0.5}) all.emplace_back(8, control);
  for (const double angle : {0.2, -0.2}) Turn{angle, true, false}.append_to(all.emplace_back());
  return all;
}

}  // namespace

Growth::Growth(const TreeRoom& room, Time time) : room_(room), time_(time), motions_(motions()) {}

/// Forwards, a motion that comes to the goal may end there: `steps` of it.
std::optional<Pose> Growth::end_of_clear(const Pose& node, std::span<const double> controls, std::size_t& steps) const {
  steps = controls.size();
  if (time_ == Time::forwards) {
    const Stretch way = room_.driven(node, controls);
    if (!way.whole && !way.arrived) return std::nullopt;
    steps = way.poses.size();
    return way.poses.back();
  }
  Pose at = node;
  for (auto control = controls.rbegin(); control != controls.rend(); ++control) {
    const Pose before = unstepped(at, *control);
    if (!room_.stands_clear(before) || !room_.is_clear(before, *control, at)) return std::nullopt;
    at = before;
  }
  return at;
}

std::uint32_t Growth::clear_motions(const Pose& node) const {
  std::uint32_t clear = 0;
  std::size_t steps = 0;
  for (std::size_t m = 0; m < motions_.size(); ++m)
    if (end_of_clear(node, motions_[m], steps)) clear |= 1U << m;
  return clear;
}

Pose Growth::end_of(const Pose& node, std::span<const double> controls) const {
  Pose at = node;
  if (time_ == Time::forwards)
    for (const double control : controls) at = stepped(at, control);
  else
    for (auto control = controls.rbegin(); control != controls.rend(); ++control) at = unstepped(at, *control);
  return at;
}

std::optional<Branch> Growth::towards(const Pose& sample, const Pose& node, Reach& reach) const {
  if (!reach.clear) reach.clear = clear_motions(node);
  double least = distance(node, sample);
  std::optional<std::size_t> best;
  for (std::size_t m = 0; m < motions_.size(); ++m)
    if (((*reach.clear & ~reach.taken) >> m) & 1)
      if (const double far = distance(end_of(node, motions_[m]), sample); far < least) least = far, best = m;
  if (!best) return std::nullopt;
  reach.taken |= 1U << *best;
  std::size_t steps = 0;
  const std::optional<Pose> end = end_of_clear(node, motions_[*best], steps);
  return Branch{*end, std::span(motions_[*best]).first(steps)};
}

}  // namespace taut::roadblocks::detail
