#include <taut/search/path_certificate.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include <taut/geometry/expects.h>
#include <taut/search/detail/certificate_net.h>

namespace taut {

namespace {

__extension__ using Wide = __int128;
using Int = std::int64_t;
using Place = PathCertificate::Place;
using Vertex = Roadmap::Vertex;
using detail::CertificateNet;
using detail::CertificatePlaces;

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
int fraction_bits(const Box& box, const CertificatePlaces& places, double length) {
  const double size = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
  const double largest = std::max(2 * length, 4 * size) / places.unit();
  return std::clamp(60 - std::ilogb(largest) - 1, 0, kMostBits);
}

/// Distances from the start, of legs rounded down, as far as length and straight way to the goal together go.
class Distances {
 public:
  Distances(const CertificateNet& net, const std::array<Place, 2>& goal, int bits)
      : net_(net), goal_(goal), bits_(bits), distance_(net.size(), kFar) {
    search();
  }

  Int horizon() const { return horizon_; }
  bool lists(Vertex v) const { return distance_[v] != kFar && estimate(v) <= horizon_ - kGap; }
  Int operator[](Vertex v) const { return distance_[v]; }
  Int reach() const { return *std::min_element(distance_.begin() + net_.start() + 1, distance_.end()); }

 private:
  // The judge rounds a root up and one down: no place may be as near to the horizon.
  static constexpr Int kGap = 4;
  // Legs are rounded down, so estimates fall a little; places beyond the horizon by so much improve none before it.
  static constexpr Int kMargin = 1 << 20;

  Int estimate(Vertex v) const { return distance_[v] + straight(v); }

  Int straight(Vertex v) const {
    const Place p = net_.place(v);
    const auto [min, max] = goal_;
    return rounded_down(p, {std::clamp(p[0], min[0], max[0]), std::clamp(p[1], min[1], max[1])}, bits_);
  }

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
      if (net_.is_goal(v)) bound = std::min(bound, key);
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

  const CertificateNet& net_;
  std::array<Place, 2> goal_;
  int bits_;
  std::vector<Int> distance_;
  Int horizon_ = 0;
};

void keep_one_a_place(std::vector<std::array<Int, 3>>& rows) {
  std::sort(rows.begin(), rows.end());
  const auto same = [](const auto& a, const auto& b) { return a[0] == b[0] && a[1] == b[1]; };
  rows.erase(std::unique(rows.begin(), rows.end(), same), rows.end());
}

using Exactly = std::vector<std::optional<Place>>;

/// By how many halvings of the unit the path's points are near enough to multiples of it: 0 where they are multiples.
int fitting_halvings(const Exactly& exact, const CertificatePlaces& places, const Box& box, int most) {
  if (std::all_of(exact.begin(), exact.end(), [](const auto& place) { return place.has_value(); })) return 0;
  double largest = 1;
  for (const double v : {box.min.x, box.min.y, box.max.x, box.max.y}) largest = std::max(largest, std::abs(v));
  int finer = 0;
  while (finer < most && std::ldexp(largest * places.per_one(), finer + 1) < LatticeIntegers::kLargest) ++finer;
  return finer;
}

/// The path by its ends and bends, in the unit halved so often; rounded where it has to be.
std::vector<Place> bends_of(const std::vector<Point>& points, const Exactly& exact, const CertificatePlaces& places,
                            int finer) {
  const auto whole = [&](double v) {
    return static_cast<Int>(std::llround(std::ldexp(static_cast<long double>(v) * places.per_one(), finer)));
  };
  std::vector<Place> bends;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto place = exact[i];
    const Place q =
        place ? Place{(*place)[0] << finer, (*place)[1] << finer} : Place{whole(points[i].x), whole(points[i].y)};
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

/// Of the path's points; of a room the last may be a crossing with its border.
Exactly exact_places(const std::vector<Point>& points, const CertificatePlaces& places, bool is_room) {
  Exactly exact;
  for (const Point p : points) exact.push_back(places.exactly(p));
  if (is_room && !exact.back()) {
    const Place end = places.nearest(points.back()), min = places.goal()[0], max = places.goal()[1];
    const bool on_border = end[0] == min[0] || end[0] == max[0] || end[1] == min[1] || end[1] == max[1];
    if (on_border) exact.back() = end;
  }
  return exact;
}

void shift(Place& place, int finer) {
  for (Int& v : place) v <<= finer;
}

}  // namespace

bool is_certifiable(const Goal& goal) { return detail::goal_box(goal).has_value(); }

std::optional<PathCertificate> shortest_certificate(const VisibilityGraph& graph, const Path& path, const Goal& to,
                                                    int halvings) {
  TAUT_EXPECTS(!path.points.empty() && graph.kind() == VisibilityKind::reduced);
  const World& world = graph.space().world();
  const CertificatePlaces places(world, path.points.front(), detail::goal_box(to).value());
  if (!places.fits()) return std::nullopt;
  const CertificateNet net(graph, places, path.points.front(), to);
  if (!net.is_exact() || net.start() + 1 == net.size()) return std::nullopt;
  const int bits = fraction_bits(world.box(), places, path.length.value());
  const Exactly exact = exact_places(path.points, places, !to.point);
  const int finer = std::min(bits, fitting_halvings(exact, places, world.box(), halvings));
  const Distances distances(net, places.goal(), bits);
  PathCertificate certificate{.scale = places.scale() << finer, .is_found = true, .goal = places.goal()};
  for (Place& corner : certificate.goal) shift(corner, finer);
  certificate.path = bends_of(path.points, exact, places, finer);
  certificate.fraction_bits = bits - finer;
  certificate.horizon = distances.horizon();
  certificate.reach = distances.reach();
  for (Vertex v = 0; v <= net.start(); ++v) {
    Place p = net.place(v);
    if ((v < net.start() && p == net.place(net.start())) || !distances.lists(v)) continue;
    shift(p, finer);
    certificate.potentials.push_back({p[0], p[1], distances[v]});
  }
  keep_one_a_place(certificate.potentials);
  return certificate;
}

std::optional<PathCertificate> none_certificate(const VisibilityGraph& graph, Point from, const Goal& to) {
  TAUT_EXPECTS(graph.kind() == VisibilityKind::reduced);
  const CertificatePlaces places(graph.space().world(), from, detail::goal_box(to).value());
  if (!places.fits()) return std::nullopt;
  const CertificateNet net(graph, places, from, to);
  if (!net.is_exact()) return std::nullopt;
  PathCertificate certificate{.scale = places.scale(), .path = {net.place(net.start())}, .goal = places.goal()};
  std::vector<Vertex> open{net.start()};
  std::vector<bool> seen(net.size());
  seen[net.start()] = true;
  while (!open.empty()) {
    const Vertex v = open.back();
    open.pop_back();
    if (!net.is_goal(v)) certificate.potentials.push_back({net.place(v)[0], net.place(v)[1], 0});
    net.each_leg(v, [&](Vertex w) {
      if (!seen[w]) open.push_back(w);
      seen[w] = true;
    });
  }
  keep_one_a_place(certificate.potentials);
  return certificate;
}

}  // namespace taut
