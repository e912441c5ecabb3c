#include <taut/search/detail/arc_landmarks.h>

#include <algorithm>
#include <queue>
#include <utility>

namespace taut::detail {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

}  // namespace

ArcLandmarks::ArcLandmarks(ArcWalk& walk)
    : distance_(walk.nodes()),
      opened_(walk.nodes(), 0),
      rounding_(static_cast<double>(walk.nodes() + 16) * 0x1p-50) {  // a sum of so many pieces
  for (Distances& all : distance_) all.fill(kInfinite);
  for (std::uint32_t n = 0; n < walk.nodes(); n += 2) round_.push_back(walk.turned(n) != n);
  find_pockets(walk);
  if (distance_.empty()) return;
  for (std::size_t k = 0; k < kLandmarks; ++k) measure(walk, farthest(k), k);
}

/// The node farthest from all landmarks so far, one that they reach if there is one.
std::uint32_t ArcLandmarks::farthest(std::size_t landmarks) const {
  std::uint32_t best = 0;
  double far = -1;
  for (std::uint32_t n = 0; n < distance_.size(); ++n) {
    const double nearest =
        landmarks == 0 ? 0 : *std::min_element(distance_[n].begin(), distance_[n].begin() + landmarks);
    if (nearest == kInfinite || nearest <= far || (pocket_[n] && pocket_[n ^ 1])) continue;
    best = n;
    far = nearest;
  }
  return best;
}

void ArcLandmarks::measure(ArcWalk& walk, std::uint32_t from, std::size_t k) {
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto reach = [&](std::uint32_t n, double length) {
    if (length >= distance_[n][k]) return;
    distance_[n][k] = length;
    open.emplace(length, n);
  };
  reach(from, 0);
  reach(from ^ 1, 0);
  while (!open.empty()) {
    const auto [length, n] = open.top();
    open.pop();
    if (length > distance_[n][k]) continue;
    walk.onward(n, [&, so_far = length](std::uint32_t m, const Interval& leg) { reach(m, so_far + leg.middle()); });
  }
}

/// Again and again, what has no way on but into pockets.
void ArcLandmarks::find_pockets(ArcWalk& walk) {
  pocket_.assign(walk.nodes(), 0);
  std::vector<std::uint32_t> ways(walk.nodes(), 0), ends;
  for (std::uint32_t n = 0; n < ways.size(); ++n) {
    walk.onward(n, [&](std::uint32_t, const Interval&) { ++ways[n]; });
    if (ways[n] == 0) ends.push_back(n);
  }
  while (!ends.empty()) {
    const std::uint32_t n = ends.back();
    ends.pop_back();
    pocket_[n] = 1;
    walk.backward(n, [&](std::uint32_t m) {
      if (--ways[m] == 0) ends.push_back(m);
    });
  }
}

void ArcLandmarks::aim(ArcWalk& walk, std::span<const ArcExit> exits) {
  ++query_;
  targets_.clear();
  std::vector<std::uint32_t> open;
  const auto enter = [&](std::uint32_t n) {
    if (!pocket_[n] || opened_[n] == query_) return;
    opened_[n] = query_;
    open.push_back(n);
  };
  for (const ArcExit& exit : exits) {
    targets_.push_back({std::max(0.0, exit.length.lo), distance_[exit.node], distance_[turned(exit.node)]});
    enter(exit.node);
  }
  while (!open.empty()) {
    const std::uint32_t n = open.back();
    open.pop_back();
    walk.backward(n, enter);
  }
}

double ArcLandmarks::least(std::uint32_t n) const {
  if (pocket_[n] && opened_[n] != query_) return kInfinite;
  double best = kInfinite;
  for (const Target& target : targets_) best = std::min(best, target.length + least(n, target));
  return best;
}

/// From l by n to the exit, d(l, exit) <= d(l, n) + d(n, exit). And the way to the exit, turned, goes from the turned
/// exit to the turned n.
double ArcLandmarks::least(std::uint32_t n, const Target& target) const {
  const Distances &here = distance_[n], &back = distance_[turned(n)];
  double least = 0;
  const auto bound = [&](double whole, double part) {
    if (part == kInfinite) return;
    least = whole == kInfinite ? kInfinite : std::max(least, whole - part - rounding_ * (whole + part));
  };
  for (std::size_t k = 0; k < kLandmarks; ++k) {
    bound(target.there[k], here[k]);
    bound(back[k], target.turned[k]);
  }
  return least;
}

}  // namespace taut::detail
