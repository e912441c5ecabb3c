#include <taut/search/alternatives.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

#include <taut/geometry/written.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/detail/string_gates.h>
#include <taut/search/detail/taut_legs.h>
#include <taut/search/funnel.h>

namespace taut {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kDoubt = 1e-12;  // of a sum of lengths in doubles, as a part of it
constexpr std::uint32_t kGoal = kNone;

bool crosses(Point a, Point b, Point c, Point d) {
  const auto apart = [](double p, double q, double r, double s) {
    return std::max(p, q) < std::min(r, s) || std::max(r, s) < std::min(p, q);
  };
  if (apart(a.x, b.x, c.x, d.x) || apart(a.y, b.y, c.y, d.y)) return false;
  return written::orientation(a, b, c) * written::orientation(a, b, d) < 0 &&
         written::orientation(c, d, a) * written::orientation(c, d, b) < 0;
}

/// The least that is left to the goal from each vertex, along legs of any turn.
std::vector<double> rests(const VisibilityGraph& graph, Point goal, const std::vector<Roadmap::Vertex>& seen) {
  const Roadmap& map = graph.roadmap();
  std::vector<double> rest(map.vertex_count(), kInfinity);
  using Open = std::pair<double, Roadmap::Vertex>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  const auto reach = [&](Roadmap::Vertex v, double length) {
    if (length >= rest[v]) return;
    rest[v] = length;
    open.emplace(length, v);
  };
  const auto distance = [](Point p, Point q) { return std::hypot(p.x - q.x, p.y - q.y); };
  for (const Roadmap::Vertex v : seen) reach(v, distance(map.point(v), goal));
  while (!open.empty()) {
    const auto [length, v] = open.top();
    open.pop();
    if (length > rest[v]) continue;
    for (const Roadmap::Vertex w : map.neighbours(v)) reach(w, length + distance(map.point(v), map.point(w)));
  }
  return rest;
}

class Enumeration {
 public:
  Enumeration(const FreeSpace& space, Point s, Point g, const AlternativesRequest& request)
      : space_(space), graph_(space, VisibilityKind::reduced), legs_(graph_), s_(s), g_(g), request_(request) {
    const auto to = graph_.visible_from(g);
    sees_goal_.assign(graph_.roadmap().vertex_count(), false);
    for (const Roadmap::Vertex v : to) sees_goal_[v] = true;
    rest_ = rests(graph_, g, to);
  }

  Alternatives find() {
    begin();
    Alternatives result;
    while (!open_.empty()) {
      const Open next = open_.top();
      if (found_.size() >= request_.count && next.bound > limit()) break;
      if (result.expanded == request_.most_expanded) {
        result.status = SearchStatus::stopped;
        break;
      }
      open_.pop();
      ++result.expanded;
      if (returns(next.label) || !is_taut(next.label)) continue;
      labels_[next.label].vertex == kGoal ? arrive(next.label) : expand(next.label);
    }
    const bool all = open_.empty();
    give(result, all);
    return result;
  }

 private:
  static constexpr std::size_t kPlace = static_cast<std::size_t>(-1);

  /// A way on from that of `before`, kNone being the start, by the leg `via`.
  struct Label {
    double length;
    std::size_t via;
    std::uint32_t vertex;
    std::uint32_t before;
  };
  struct Open {
    double bound;
    std::uint32_t label;
    bool operator<(const Open& other) const { return bound != other.bound ? bound > other.bound : label > other.label; }
  };

  Point point(std::uint32_t label) const {
    if (label == kNone) return s_;
    return labels_[label].vertex == kGoal ? g_ : graph_.roadmap().point(labels_[label].vertex);
  }

  void push(std::uint32_t before, std::uint32_t vertex, double length, std::size_t via) {
    const double rest = vertex == kGoal ? 0 : rest_[vertex];
    if (rest == kInfinity) return;
    labels_.push_back({length, via, vertex, before});
    open_.push({(length + rest) * (1 - kDoubt), static_cast<std::uint32_t>(labels_.size() - 1)});
  }

  void begin() {
    if (s_ == g_ || space_.sees(s_, g_)) push(kNone, kGoal, leg(s_, g_), kPlace);
    if (s_ == g_) return;
    for (const Roadmap::Vertex v : graph_.visible_from(s_)) push(kNone, v, leg(s_, graph_.roadmap().point(v)), kPlace);
  }

  static double leg(Point p, Point q) { return std::hypot(q.x - p.x, q.y - p.y); }

  /// To which sides a string that arrives may turn: where the obstacle is.
  std::pair<bool, bool> turns(std::uint32_t label) const {
    const Triangulation& tri = space_.triangulation();
    const Triangulation::Sector& sector = tri.sectors[graph_.sector(labels_[label].vertex)];
    const Point p = point(labels_[label].before), q = point(label);
    const int right = written::orientation(p, q, tri.points[sector.right]),
              left = written::orientation(p, q, tri.points[sector.left]);
    return {right <= 0 && left <= 0, right >= 0 && left >= 0};
  }

  void expand(std::uint32_t label) {
    const Label here = labels_[label];
    const Point p = point(here.before), q = point(label);
    const auto [to_right, to_left] = turns(label);
    const auto goes_on = [&, to_right = to_right, to_left = to_left](Point next) {  // clang 14 takes no bindings
      const int side = written::orientation(p, q, next);
      return (to_right && side <= 0) || (to_left && side >= 0);
    };
    if (sees_goal_[here.vertex] && goes_on(g_)) push(label, kGoal, here.length + leg(q, g_), kPlace);
    std::uint32_t last = kNone;
    for (detail::TautLegs::Range all = legs_.of(here.vertex); all.first < all.last; ++all.first) {
      const detail::TautLegs::Leg& on = legs_[all.first];
      if (!goes_on(graph_.roadmap().point(on.to))) continue;
      if (all.first + 1 == all.last && on.to == last) break;
      // Legs along a free wall are named twice, first and last.
      if (last == kNone) last = on.to;
      push(label, on.to, here.length + on.length, all.first);
    }
  }

  /// Does the last leg lead back to where the way has been?
  bool returns(std::uint32_t label) const {
    const Point to = point(label);
    std::uint32_t at = labels_[label].before;
    const Point from = point(at);
    if (to == from && at != kNone && labels_[label].vertex != kGoal) return true;
    while (at != kNone) {
      const Point end = point(at);
      at = labels_[at].before;
      const Point begin = point(at);
      if (begin == to && begin != end) return true;
      if (end != from && crosses(begin, end, from, to)) return true;
    }
    return false;
  }

  /// Legs along a wall do not tell on which side; the string does. What is loose stays so however it goes on.
  bool is_taut(std::uint32_t label) const {
    if (labels_[label].before == kNone || labels_[label].vertex == kGoal) return true;
    const Path way = path(label);
    const auto pulled = shortened(space_, way);
    return pulled && pulled->length == way.length;
  }

  Path path(std::uint32_t label) const {
    std::vector<Point> points;
    for (std::uint32_t at = label;; at = labels_[at].before) {
      if (points.empty() || points.back() != point(at)) points.push_back(point(at));
      if (at == kNone) break;
    }
    std::ranges::reverse(points);
    return {points, Length(points)};
  }

  void arrive(std::uint32_t label) {
    const Path way = path(label);
    const auto pulled = shortened(space_, way);
    if (!pulled || pulled->length != way.length) return;
    if (std::ranges::any_of(found_, [&](const Path& other) { return other.points == pulled->points; })) return;
    found_.push_back(*pulled);
    std::ranges::stable_sort(found_, [](const Path& a, const Path& b) {
      const auto order = a.length <=> b.length;
      return order != 0 ? order < 0 : a.points < b.points;
    });
  }

  /// No way longer than this is of interest.
  double limit() const { return found_[request_.count - 1].length.interval().hi * (1 + kDoubt); }

  void give(Alternatives& result, bool all) {
    result.all = all && found_.size() <= request_.count;
    if (found_.size() > request_.count) found_.resize(request_.count);
    if (result.status != SearchStatus::stopped)
      result.status = found_.empty() ? SearchStatus::none : SearchStatus::found;
    // Stopped: what might still be undercut is not among the shortest.
    if (result.status == SearchStatus::stopped && !open_.empty())
      std::erase_if(found_, [&](const Path& way) { return way.length.interval().hi > open_.top().bound; });
    for (Path& way : found_) result.ways.push_back({std::move(way), {}});
  }

  const FreeSpace& space_;
  VisibilityGraph graph_;
  detail::TautLegs legs_;
  Point s_, g_;
  AlternativesRequest request_;
  std::vector<bool> sees_goal_;
  std::vector<double> rest_;
  std::vector<Label> labels_;
  std::priority_queue<Open> open_;
  std::vector<Path> found_;
};

}  // namespace

Alternatives alternatives(const Gates& gates, Point s, Point g, const AlternativesRequest& request) {
  Alternatives result = Enumeration(gates.space(), s, g, request).find();
  for (Alternative& way : result.ways)
    if (const auto gate = detail::narrowest_gate_of(gates, way.path)) way.gate = named_gate(gates, *gate);
  return result;
}

}  // namespace taut
