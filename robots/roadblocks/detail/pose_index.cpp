#include <taut/robots/roadblocks/detail/pose_index.h>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace taut::roadblocks::detail {

namespace bg = boost::geometry;
using Spot = bg::model::point<double, 4, bg::cs::cartesian>;
using Entry = std::pair<Spot, std::uint32_t>;

namespace {

std::array<double, 4> coordinates(const Pose& pose) {
  return {pose.x, pose.y, kArm * std::cos(pose.heading), kArm * std::sin(pose.heading)};
}

Spot spot(const Pose& pose) {
  const auto c = coordinates(pose);
  Spot at;
  bg::set<0>(at, c[0]);
  bg::set<1>(at, c[1]);
  bg::set<2>(at, c[2]);
  bg::set<3>(at, c[3]);
  return at;
}

}  // namespace

struct PoseIndex::Impl {
  bg::index::rtree<Entry, bg::index::quadratic<16>> tree;
};

PoseIndex::PoseIndex() : impl_(std::make_unique<Impl>()) {}
PoseIndex::~PoseIndex() = default;
PoseIndex::PoseIndex(PoseIndex&&) noexcept = default;

void PoseIndex::insert(const Pose& pose, std::uint32_t which) { impl_->tree.insert({spot(pose), which}); }
void PoseIndex::erase(const Pose& pose, std::uint32_t which) { impl_->tree.remove({spot(pose), which}); }
std::uint32_t PoseIndex::nearest(const Pose& pose) const { return nearest(pose, 1).front(); }

std::vector<std::uint32_t> PoseIndex::nearest(const Pose& pose, unsigned n) const {
  const Spot at = spot(pose);
  std::vector<Entry> found;
  impl_->tree.query(bg::index::nearest(at, n), std::back_inserter(found));
  std::vector<std::pair<double, std::uint32_t>> by_distance;
  for (const auto& [where, which] : found) by_distance.emplace_back(bg::comparable_distance(where, at), which);
  std::ranges::sort(by_distance);
  std::vector<std::uint32_t> numbers;
  for (const auto& [far, which] : by_distance) numbers.push_back(which);
  return numbers;
}

double distance(const Pose& a, const Pose& b) {
  const auto p = coordinates(a), q = coordinates(b);
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += (p[i] - q[i]) * (p[i] - q[i]);
  return std::sqrt(sum);
}

}  // namespace taut::roadblocks::detail
