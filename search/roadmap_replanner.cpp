#include <taut/search/roadmap_replanner.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <taut/geometry/exact/twofold.h>
#include <taut/geometry/expects.h>
#include <taut/search/dstar_lite.h>

namespace taut {

namespace {

using Vertex = Roadmap::Vertex;

/// A leg as an edge of the graph: its length counts `factor` times, 0 when blocked.
struct CountedLeg {
  Segment leg;
  std::uint32_t factor = 1;
};

/// Sums of legs, each a leg and an older sum. A sum never changes, so it can be compared exactly at any time.
class LegSums {
 public:
  /// The number of a sum; the empty one and the infinite one are always there.
  struct Cost {
    std::uint32_t id = 0;
  };
  using Key = double;

  LegSums() : sums_(2) { sums_[kInfinite].length = {HUGE_VAL, HUGE_VAL}; }

  static Cost infinity() { return {kInfinite}; }
  static Key key_infinity() { return HUGE_VAL; }
  static bool is_infinite(Cost a) { return a.id == kInfinite; }
  static Key key_plus(Key a, Key b) { return a + b; }
  static Key weakened(Key heuristic) { return heuristic * (1 - 1.0 / 1024); }

  Key key(Cost a) const { return sums_[a.id].length.lo; }
  bool is_equal(Cost a, Cost b) const { return a.id == b.id || compare(a, b) == 0; }
  bool is_less(Cost a, Cost b) const { return a.id != b.id && compare(a, b) < 0; }

  Cost plus(const CountedLeg& leg, Cost rest) {
    if (leg.factor == 0 || is_infinite(rest)) return infinity();
    sums_.push_back(sum(leg, rest));
    return {static_cast<std::uint32_t>(sums_.size() - 1)};
  }

  bool plus_is_less(const CountedLeg& leg, Cost rest, Cost than) {
    if (leg.factor == 0 || is_infinite(rest)) return false;
    if (is_infinite(than)) return true;
    const Sum candidate = sum(leg, rest);
    const Interval &a = candidate.length, &b = sums_[than.id].length;
    if (a.hi < b.lo) return true;
    if (a.lo > b.hi) return false;
    const Cost temporary = plus(leg, rest);
    const bool less = compare(temporary, than) < 0;
    sums_.pop_back();
    return less;
  }

  std::size_t size() const { return sums_.size(); }

  Length length(Cost a) const {
    Length length;
    for (; a.id != kEmpty; a = {sums_[a.id].rest})
      for (std::uint32_t k = 0; k < sums_[a.id].leg.factor; ++k)
        length.add(sums_[a.id].leg.leg.a, sums_[a.id].leg.leg.b);
    return length;
  }

 private:
  static constexpr std::uint32_t kEmpty = 0, kInfinite = 1;

  struct Sum {
    CountedLeg leg;
    std::uint32_t rest = 0;
    Interval length;
  };

  Sum sum(const CountedLeg& leg, Cost rest) const {
    const Interval one = distance_interval(leg.leg.a, leg.leg.b), more = sums_[rest.id].length;
    const auto factor = static_cast<double>(leg.factor);
    const auto times = [factor](double x, double away) { return factor == 1 ? x : std::nextafter(x * factor, away); };
    return {leg,
            rest.id,
            {twofold::add_down(more.lo, std::max(0.0, times(one.lo, 0))),
             twofold::add_up(more.hi, times(one.hi, HUGE_VAL))}};
  }

  std::strong_ordering compare(Cost a, Cost b) const {
    const Interval &x = sums_[a.id].length, &y = sums_[b.id].length;
    if (x.hi < y.lo) return std::strong_ordering::less;
    if (x.lo > y.hi) return std::strong_ordering::greater;
    if (is_infinite(a) || is_infinite(b)) return is_infinite(a) <=> is_infinite(b);
    return compare_legs(a, b);
  }

  std::strong_ordering compare_legs(Cost a, Cost b) const {
    // Only what was added after the last common sum can differ; a sum is younger than its rest.
    std::vector<Segment> legs_a, legs_b;
    const auto climb = [this](Cost& from, std::vector<Segment>& legs) {
      const Sum& s = sums_[from.id];
      legs.insert(legs.end(), s.leg.factor, s.leg.leg);
      from = {s.rest};
    };
    while (a.id != b.id) a.id > b.id ? climb(a, legs_a) : climb(b, legs_b);
    return compare_lengths(legs_a, legs_b);
  }

  std::vector<Sum> sums_;
};

/// The roadmap with what was changed in it.
struct ChangingRoadmap {
  using State = Vertex;

  explicit ChangingRoadmap(std::shared_ptr<const Roadmap> map) : roadmap(std::move(map)) {}

  std::size_t state_count() const { return roadmap->vertex_count(); }
  void each_out(Vertex v, auto&& visit) const {
    for (const Vertex w : roadmap->neighbours(v)) visit(w, leg(v, w));
  }
  void each_in(Vertex v, auto&& visit) const {
    for (const Vertex w : roadmap->neighbours(v)) visit(w, leg(w, v));
  }
  double heuristic(Vertex v, Vertex w) const { return distance_interval(roadmap->point(v), roadmap->point(w)).lo; }

  CountedLeg leg(Vertex v, Vertex w) const {
    const CountedLeg free{{roadmap->point(v), roadmap->point(w)}, 1};
    if (changes.empty()) return free;
    const auto found = changes.find(std::minmax(v, w));
    if (found == changes.end()) return free;
    return {free.leg, found->second.blocked ? 0 : found->second.factor};
  }

  struct Change {
    std::uint32_t factor = 1;
    bool blocked = false;
  };

  std::shared_ptr<const Roadmap> roadmap;
  std::map<std::pair<Vertex, Vertex>, Change> changes;
};

}  // namespace

struct RoadmapReplanner::Impl {
  Impl(std::shared_ptr<const Roadmap> map, Vertex start, Vertex goal)
      : graph(std::move(map)), search(graph, start, goal) {}
  Impl(const Impl&) = delete;  // the search points to the graph

  ChangingRoadmap::Change& change(Vertex u, Vertex v) {
    TAUT_EXPECTS(graph.roadmap->adjacent(u, v));
    return graph.changes[std::minmax(u, v)];
  }

  void changed(Vertex u, Vertex v) {
    const auto it = graph.changes.find(std::minmax(u, v));
    if (it != graph.changes.end() && !it->second.blocked && it->second.factor == 1) graph.changes.erase(it);
    search.changed(u);
    search.changed(v);
  }

  void restart(Vertex start, Vertex goal) {
    search.costs() = LegSums();
    search.restart(start, goal);
  }

  ChangingRoadmap graph;
  DstarLite<ChangingRoadmap, LegSums> search;
};

RoadmapReplanner::RoadmapReplanner(std::shared_ptr<const Roadmap> roadmap, Vertex start, Vertex goal) {
  TAUT_EXPECTS(std::max(start, goal) < roadmap->vertex_count());
  impl_ = std::make_unique<Impl>(std::move(roadmap), start, goal);
}
RoadmapReplanner::~RoadmapReplanner() = default;
RoadmapReplanner::RoadmapReplanner(RoadmapReplanner&&) noexcept = default;
RoadmapReplanner& RoadmapReplanner::operator=(RoadmapReplanner&&) noexcept = default;

void RoadmapReplanner::block(Vertex u, Vertex v) {
  impl_->change(u, v).blocked = true;
  impl_->changed(u, v);
}

void RoadmapReplanner::unblock(Vertex u, Vertex v) {
  impl_->change(u, v).blocked = false;
  impl_->changed(u, v);
}

void RoadmapReplanner::set_factor(Vertex u, Vertex v, std::uint32_t factor) {
  TAUT_EXPECTS(factor > 0);
  impl_->change(u, v).factor = factor;
  impl_->changed(u, v);
}

void RoadmapReplanner::move_to(Vertex start) { impl_->search.move_to(start); }
void RoadmapReplanner::set_goal(Vertex goal) { impl_->restart(impl_->search.start(), goal); }

SearchStatus RoadmapReplanner::replan(const SearchLimits& limits) {
  constexpr std::size_t kMostSums = std::size_t{1} << 22;
  if (impl_->search.costs().size() > kMostSums) impl_->restart(impl_->search.start(), impl_->search.goal());
  return impl_->search.replan(limits);
}

std::optional<Path> RoadmapReplanner::path() const {
  const std::vector<Vertex> vertices = impl_->search.path();
  if (vertices.empty()) return std::nullopt;
  Path path;
  for (const Vertex v : vertices) {
    const Point p = impl_->graph.roadmap->point(v);
    if (path.points.empty() || path.points.back() != p) path.points.push_back(p);
  }
  path.length = Length(path.points);
  return path;
}

std::optional<Length> RoadmapReplanner::cost() const {
  const auto cost = impl_->search.cost();
  if (LegSums::is_infinite(cost)) return std::nullopt;
  return impl_->search.costs().length(cost);
}

std::size_t RoadmapReplanner::expanded() const { return impl_->search.expanded(); }

}  // namespace taut
