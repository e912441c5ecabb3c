#include <taut/search/detail/arc_core.h>

#include <algorithm>
#include <queue>

namespace taut::detail {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

}  // namespace

ArcCore::ArcCore(const ArcHierarchy& hierarchy)
    : number_(hierarchy.size(), kNone),
      rounding_(static_cast<double>(hierarchy.size() + 16) * 0x1p-50) {  // a sum of so many pieces
  for (std::uint32_t n = 0; n < hierarchy.size(); ++n) {
    if (!hierarchy.is_core(n)) continue;
    number_[n] = static_cast<std::uint32_t>(node_.size());
    node_.push_back(n);
  }
  first_.push_back(0);
  for (const std::uint32_t n : node_) {
    turned_.push_back(number_[hierarchy.turned(n)]);
    for (const ArcHierarchy::Edge& edge : hierarchy.up(n)) edges_.push_back({number_[edge.to], edge.length});
    first_.push_back(static_cast<std::uint32_t>(edges_.size()));
  }
  Distances unknown{};
  unknown.fill(kInfinite);
  distance_.assign(node_.size(), unknown);
  if (node_.empty()) return;
  for (std::size_t k = 0; k < kLandmarks; ++k) measure(farthest(k), k);
}

/// The node farthest from all landmarks so far, one that they reach if there is one.
std::uint32_t ArcCore::farthest(std::size_t landmarks) const {
  std::uint32_t best = 0;
  double far = -1;
  for (std::uint32_t i = 0; i < node_.size(); ++i) {
    const double nearest =
        landmarks == 0 ? 0 : *std::min_element(distance_[i].begin(), distance_[i].begin() + landmarks);
    if (nearest == kInfinite || nearest <= far) continue;
    best = i;
    far = nearest;
  }
  return best;
}

void ArcCore::measure(std::uint32_t from, std::size_t k) {
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto reach = [&](std::uint32_t n, double length) {
    double& known = distance_[n][k];
    if (length >= known) return;
    known = length;
    open.emplace(length, n);
  };
  reach(from, 0);
  reach(turned_[from], 0);
  while (!open.empty()) {
    const auto [length, n] = open.top();
    open.pop();
    if (length > distance_[n][k]) continue;
    for (const Edge& edge : edges(n)) reach(edge.to, length + edge.length);
  }
}

void ArcCore::aim(std::span<const ArcDoor> exits) {
  whole_.fill(kInfinite);
  back_.fill(-kInfinite);
  for (const ArcDoor& exit : exits) {
    const Distances &there = distance_[exit.node], &back = distance_[turned_[exit.node]];
    for (std::size_t k = 0; k < kLandmarks; ++k) {
      whole_[k] = std::min(whole_[k], there[k] + exit.length);
      back_[k] = std::max(back_[k], back[k] - exit.length);
    }
  }
}

double ArcCore::least(std::uint32_t i) const {
  const Distances &here = distance_[i], &back = distance_[turned_[i]];
  double least = 0;
  // Where a landmark does not reach what it would have to pass, nothing is known; else where it does not reach the end,
  // there is no way.
  const auto bound = [&](double whole, double part) {
    if (part == kInfinite) return;
    least = whole == kInfinite ? kInfinite : std::max(least, whole - part - rounding_ * (whole + std::abs(part)));
  };
  for (std::size_t k = 0; k < kLandmarks; ++k) {
    bound(whole_[k], here[k]);
    bound(back[k], back_[k]);
  }
  return least;
}

}  // namespace taut::detail
