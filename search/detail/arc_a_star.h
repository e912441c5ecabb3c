// A* in the directed graph of a disc, and the path that it or others find there. Private.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <taut/search/arc_search.h>
#include <taut/search/detail/arc_ends.h>

namespace taut::detail {

/// What a path bends around that leads from one door along nodes to another.
template <class Walk>
ArcPath path_along(const Walk& walk, const ArcEnds& ends, Point s, Point g, const ArcExit& entry,
                   const std::vector<std::uint32_t>& nodes, const ArcExit& exit) {
  ArcPath path{walk.radius(), s, g, {}, {}};
  // The stops: the site and the side, and how many points of its circle the path stops at.
  std::vector<std::pair<ArcBend, std::size_t>> stops;
  std::uint32_t last = kNone;
  const auto stop = [&](std::uint32_t site, int side) {
    if (site != last) stops.push_back({{walk.site(site).at, walk.site(site).round ? side : 0}, 0});
    last = site;
    ++stops.back().second;
  };
  if (entry.by_arc) stop(ends.from_start[entry.leg].site, ends.from_start[entry.leg].side);
  for (const std::uint32_t n : nodes) stop(walk.site_of(n / 2), n % 2 == 1 ? 1 : -1);
  if (exit.by_arc) stop(ends.to_goal[exit.leg].site, ends.to_goal[exit.leg].side);
  for (const auto& [bend, points] : stops)
    if (bend.turn == 0 || points > 1) path.bends.push_back(bend);
  path.length = length_of(pieces(path));
  return path;
}

template <class Walk>
ArcPath path_apart(const Walk& walk, const ArcEnds& ends, Point s, Point g, const ArcEnds::Apart& apart) {
  ArcPath path{walk.radius(), s, g, {}, {}};
  if (apart.by_arc) {
    const ArcEndLeg& leg = ends.from_start[apart.start_leg];
    path.bends.push_back({walk.site(leg.site).at, walk.site(leg.site).round ? leg.side : 0});
  }
  path.length = length_of(pieces(path));
  return path;
}

/// Walk: ArcWalk or RadiusWalk. In the same memory for query after query.
template <class Walk>
class ArcAStar {
 public:
  explicit ArcAStar(Walk& walk) : walk_(walk), labels_(walk.nodes()) {}

  ArcSearchResult find(Point s, Point g, const ArcEnds& ends) {
    ++query_;
    goal_ = g;
    ends_ = &ends;
    open_.clear();
    best_ = {};
    for (std::uint32_t i = 0; i < ends.apart.size(); ++i) arrive(ends.apart[i].length, kNone, i);
    for (std::uint32_t i = 0; i < ends.entries.size(); ++i)
      reach(ends.entries[i].node, ends.entries[i].length, kStart - 1 - i);
    ArcSearchResult result;
    while (!open_.empty()) {
      const Open next = open_.front();
      if (next.least > best_.length.hi) break;
      std::pop_heap(open_.begin(), open_.end());
      open_.pop_back();
      if (next.version != labels_[next.node].version) continue;
      ++result.expanded;
      expand(next.node);
    }
    if (!best_.found) return result;
    result.status = DiscStatus::found;
    result.path = path(s, g);
    return result;
  }

 private:
  static constexpr std::uint32_t kStart = kNone;
  static constexpr double kInfinite = std::numeric_limits<double>::infinity();

  struct Label {
    Interval length;
    double estimate = 0;  // of what is left
    std::uint32_t before = kStart;
    std::uint32_t version = 0;
    std::uint32_t query = 0;
  };
  struct Open {
    double least;
    std::uint32_t node;
    std::uint32_t version;
    bool operator<(const Open& other) const { return least != other.least ? least > other.least : node > other.node; }
  };
  /// The best way to the goal so far: along `node` and out, or apart from the graph.
  struct Best {
    Interval length{kInfinite};
    std::uint32_t node = kNone;
    std::uint32_t number = 0;  // of the exit, or of the way apart
    bool found = false;
  };

  void arrive(const Interval& length, std::uint32_t node, std::uint32_t number) {
    if (!best_.found || length.hi < best_.length.lo) best_ = {length, node, number, true};
  }

  double estimate(std::uint32_t n) const {
    const TangentPoint& p = walk_.point(n / 2);
    const double r = p.here.side == 0 ? 0 : walk_.radius();
    const double x = p.here.centre.x + r * p.x.middle() - goal_.x, y = p.here.centre.y + r * p.y.middle() - goal_.y;
    const double far = std::sqrt(x * x + y * y);
    return std::max(0.0, far - 1e-13 * (far + std::abs(goal_.x) + std::abs(goal_.y)));
  }

  void reach(std::uint32_t n, const Interval& length, std::uint32_t before) {
    if (n >= labels_.size()) labels_.resize(walk_.nodes());
    Label& label = labels_[n];
    if (label.query != query_)
      label = {Interval(kInfinite), estimate(n), kStart, label.version, query_};
    else if (length.hi >= label.length.lo)
      return;
    const double least = std::max(0.0, length.lo) + label.estimate;
    if (!(least <= best_.length.hi)) return;
    label.length = length;
    label.before = before;
    open_.push_back({least, n, ++label.version});
    std::push_heap(open_.begin(), open_.end());
  }

  void expand(std::uint32_t n) {
    const Interval so_far = labels_[n].length;
    for (std::uint32_t i = 0; i < ends_->exits.size(); ++i)
      if (ends_->exits[i].node == n) arrive(so_far + ends_->exits[i].length, n, i);
    walk_.onward(n, [&](std::uint32_t m, const Interval& length) { reach(m, so_far + length, n); });
  }

  bool is_entry(std::uint32_t before) const { return before >= kStart - ends_->entries.size() && before < kStart; }

  ArcPath path(Point s, Point g) const {
    if (best_.node == kNone) return path_apart(walk_, *ends_, s, g, ends_->apart[best_.number]);
    std::vector<std::uint32_t> nodes;
    std::uint32_t n = best_.node;
    for (; !is_entry(n); n = labels_[n].before) nodes.push_back(n);
    std::reverse(nodes.begin(), nodes.end());
    return path_along(walk_, *ends_, s, g, ends_->entries[kStart - 1 - n], nodes, ends_->exits[best_.number]);
  }

  Walk& walk_;
  std::vector<Label> labels_;
  std::vector<Open> open_;
  const ArcEnds* ends_ = nullptr;
  Best best_;
  Point goal_;
  std::uint32_t query_ = 0;
};

}  // namespace taut::detail
