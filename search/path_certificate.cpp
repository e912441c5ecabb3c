#include <taut/search/path_certificate.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include <taut/geometry/expects.h>
#include <taut/search/shortest_path.h>

namespace taut {

namespace {

__extension__ using Wide = __int128;
using Int = std::int64_t;
using Place = PathCertificate::Place;
using Vertex = Roadmap::Vertex;

constexpr Int kFar = INT64_MAX;
constexpr int kMostBits = 40;

Wide squared(Place p, Place q) {
  const Wide x = q[0] - p[0], y = q[1] - p[1];
  return x * x + y * y;
}

/// The distance in 2^-bits, rounded down.
Int rounded_down(Place p, Place q, int bits) {
  const Wide square = squared(p, q) << (2 * bits);
  auto root = static_cast<Int>(std::sqrt(static_cast<long double>(square)));
  while (Wide{root} * root > square) --root;
  while (Wide{root + 1} * (root + 1) <= square) ++root;
  return root;
}

/// So many that lengths up to twice the path's, and distances in the box, stay below 2^60.
int fraction_bits(const Box& box, const LatticeIntegers& integers, double length) {
  const double size = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
  const double largest =
      std::max(2 * length, 4 * size) * static_cast<double>(integers.scale()) / integers.lattice().unit();
  return std::clamp(60 - std::ilogb(largest) - 1, 0, kMostBits);
}

/// The reduced graph with both ends, its vertices as places: v, then start and goal.
class Net {
 public:
  Net(const VisibilityGraph& graph, const LatticeIntegers& integers, Point from, Point to)
      : graph_(graph.roadmap()), query_(visibility_query(graph, from, Goal{to, {}})) {
    sees_goal_.assign(goal() + 1, false);
    if (!query_.goals.empty())
      for (const Vertex v : query_.goals.front().vertices) sees_goal_[v] = true;
    sees_goal_[start()] = !query_.direct.empty();
    places_.reserve(goal() + 1);
    for (const Point p : graph_.points()) add(integers.place(p));
    add(integers.place(from));
    add(integers.place(to));
  }

  bool is_exact() const { return is_exact_; }
  Vertex start() const { return static_cast<Vertex>(graph_.vertex_count()); }
  Vertex goal() const { return start() + 1; }
  Place place(Vertex v) const { return places_[v]; }
  std::size_t size() const { return places_.size(); }

  template <class Visit>
  void each_leg(Vertex v, Visit&& visit) const {
    if (v == goal()) return;
    if (v == start())
      for (const Vertex w : query_.start.vertices) visit(w);
    else
      for (const Vertex w : graph_.neighbours(v)) visit(w);
    if (sees_goal_[v]) visit(goal());
  }

 private:
  void add(const std::optional<Place>& place) {
    is_exact_ &= place.has_value();
    places_.push_back(place.value_or(Place{}));
  }

  const Roadmap& graph_;
  GraphQuery query_;
  std::vector<bool> sees_goal_;
  std::vector<Place> places_;
  bool is_exact_ = true;
};

/// Distances from the start, of legs rounded down, as far as length and straight way to the goal together go.
class Distances {
 public:
  Distances(const Net& net, int bits) : net_(net), bits_(bits), distance_(net.size(), kFar) { search(); }

  Int horizon() const { return horizon_; }
  bool lists(Vertex v) const { return distance_[v] != kFar && estimate(v) <= horizon_ - kGap; }
  Int operator[](Vertex v) const { return distance_[v]; }

 private:
  // The judge rounds a root up and one down: no place may be as near to the horizon.
  static constexpr Int kGap = 4;
  // Legs are rounded down, so estimates fall a little; places beyond the horizon by so much improve none before it.
  static constexpr Int kMargin = 1 << 20;

  Int estimate(Vertex v) const { return distance_[v] + straight(v); }
  Int straight(Vertex v) const { return rounded_down(net_.place(v), net_.place(net_.goal()), bits_); }

  void search() {
    using Entry = std::pair<Int, Vertex>;  // estimate
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    std::vector<Int> seen(net_.size(), kFar);  // the estimate it was taken with
    distance_[net_.start()] = 0;
    queue.push({straight(net_.start()), net_.start()});
    Int bound = kFar;
    while (!queue.empty()) {
      const Int key = queue.top().first;
      const Vertex v = queue.top().second;
      queue.pop();
      if (bound != kFar && key > bound + kMargin && key > highest(seen, bound) + kMargin) break;
      if (key != estimate(v) || seen[v] == key) continue;
      seen[v] = key;
      if (v == net_.goal()) bound = key;
      net_.each_leg(v, [&](Vertex w) {
        const Int through = distance_[v] + rounded_down(net_.place(v), net_.place(w), bits_);
        if (through >= distance_[w]) return;
        distance_[w] = through;
        queue.push({estimate(w), w});
      });
    }
    horizon_ = highest(seen, bound) + kGap;
  }

  // From the bound on upwards as long as there is no gap between estimates.
  Int highest(const std::vector<Int>& seen, Int bound) const {
    std::vector<Int> near;
    for (const Int key : seen)
      if (key != kFar && key > bound && key <= bound + 16 * kMargin) near.push_back(key);
    std::sort(near.begin(), near.end());
    Int top = bound;
    for (const Int key : near) {
      if (key > top + 2 * kGap) break;
      top = key;
    }
    return top;
  }

  const Net& net_;
  int bits_;
  std::vector<Int> distance_;
  Int horizon_ = 0;
};

void keep_one_a_place(std::vector<std::array<Int, 3>>& rows) {
  std::sort(rows.begin(), rows.end());
  const auto same = [](const auto& a, const auto& b) { return a[0] == b[0] && a[1] == b[1]; };
  rows.erase(std::unique(rows.begin(), rows.end(), same), rows.end());
}

constexpr int kFiner = 20;

/// By how many halvings of the unit the path's points are near enough to multiples of it: 0 where they are multiples.
int halvings(const std::vector<Point>& points, const LatticeIntegers& integers, const Box& box) {
  if (std::all_of(points.begin(), points.end(), [&](Point p) { return integers.place(p).has_value(); })) return 0;
  double largest = 1;
  for (const double v : {box.min.x, box.min.y, box.max.x, box.max.y}) largest = std::max(largest, std::abs(v));
  int finer = 0;
  while (finer < kFiner && std::ldexp(largest * integers.per_one(), finer + 1) < LatticeIntegers::kLargest) ++finer;
  return finer;
}

/// The path by its ends and bends, in the unit halved so often; rounded where it has to be.
std::vector<Place> bends_of(const std::vector<Point>& points, const LatticeIntegers& integers, int finer) {
  const auto whole = [&](double v) {
    return static_cast<Int>(std::llround(std::ldexp(static_cast<long double>(v) * integers.per_one(), finer)));
  };
  std::vector<Place> bends;
  for (const Point p : points) {
    const auto place = integers.place(p);
    const Place q = place ? Place{(*place)[0] << finer, (*place)[1] << finer} : Place{whole(p.x), whole(p.y)};
    if (!bends.empty() && bends.back() == q) continue;
    while (bends.size() > 1) {
      const Place a = bends[bends.size() - 2], b = bends.back();
      const Wide turn = Wide{b[0] - a[0]} * (q[1] - b[1]) - Wide{b[1] - a[1]} * (q[0] - b[0]);
      const Wide along = Wide{b[0] - a[0]} * (q[0] - b[0]) + Wide{b[1] - a[1]} * (q[1] - b[1]);
      if (turn != 0 || along < 0) break;
      bends.pop_back();
    }
    bends.push_back(q);
  }
  return bends;
}

}  // namespace

std::optional<PathCertificate> shortest_certificate(const VisibilityGraph& graph, const Path& path) {
  TAUT_EXPECTS(!path.points.empty() && graph.kind() == VisibilityKind::reduced);
  const std::array ends{path.points.front(), path.points.back()};
  const World& world = graph.space().world();
  const LatticeIntegers integers(world, ends);
  const Net net(graph, integers, ends[0], ends[1]);
  if (!net.is_exact()) return std::nullopt;
  const int bits = fraction_bits(world.box(), integers, path.length.value());
  const int finer = std::min(bits, halvings(path.points, integers, world.box()));
  PathCertificate certificate{.scale = integers.scale() << finer, .is_found = true};
  certificate.path = bends_of(path.points, integers, finer);
  certificate.fraction_bits = bits - finer;
  const Distances distances(net, bits);
  certificate.horizon = distances.horizon();
  for (Vertex v = 0; v < net.size(); ++v) {
    const Place p = net.place(v);
    const bool at_end = v < net.start() && (p == net.place(net.start()) || p == net.place(net.goal()));
    if (!at_end && distances.lists(v)) certificate.potentials.push_back({p[0] << finer, p[1] << finer, distances[v]});
  }
  keep_one_a_place(certificate.potentials);
  return certificate;
}

std::optional<PathCertificate> none_certificate(const VisibilityGraph& graph, Point from, Point to) {
  TAUT_EXPECTS(graph.kind() == VisibilityKind::reduced);
  const std::array ends{from, to};
  const LatticeIntegers integers(graph.space().world(), ends);
  const Net net(graph, integers, from, to);
  if (!net.is_exact()) return std::nullopt;
  PathCertificate certificate{.scale = integers.scale(), .path = {net.place(net.start()), net.place(net.goal())}};
  std::vector<Vertex> open{net.start()};
  std::vector<bool> seen(net.size());
  seen[net.start()] = true;
  while (!open.empty()) {
    const Vertex v = open.back();
    open.pop_back();
    certificate.potentials.push_back({net.place(v)[0], net.place(v)[1], 0});
    net.each_leg(v, [&](Vertex w) {
      if (!seen[w]) open.push_back(w);
      seen[w] = true;
    });
  }
  keep_one_a_place(certificate.potentials);
  return certificate;
}

}  // namespace taut
