#include <taut/search/detail/passage_faces.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include <taut/geometry/written.h>
#include <taut/roadmaps/exact/exact_gates.h>
#include <taut/search/detail/gate_crossings.h>

namespace taut::detail {

namespace {

Direction half_direction(const std::vector<Direction>& directions, std::uint32_t half_edge) {
  const Direction& along = directions[half_edge / 2];
  return half_edge % 2 == 0 ? along : along.opposite();
}

}  // namespace

/// Who needs which vectors while they grow.
struct PassageFaces::Builder {
  PassageFaces& to;
  const ExactGates& exact;
  const WallIndex& walls;
  std::vector<std::uint32_t> foot_stop = {};              // of each gate: its stop, kNone when its foot is an end
  std::vector<std::vector<GateCrossing>> crossings = {};  // of each gate, in order; `stop` is set

  explicit Builder(PassageFaces& faces) : to(faces), exact(faces.gates_.exact()), walls(exact.walls) {}

  void build() {
    find_stops();
    sort_stops();
    number_edges();
    cut_gates();
    link();
    walk();
    find_components();
  }

  void find_stops() {
    const auto& gates = exact.gates;
    foot_stop.assign(gates.size(), kNone);
    for (std::uint32_t i = 0; i < gates.size(); ++i) {
      if (gates[i].foot_is_end) continue;
      foot_stop[i] = static_cast<std::uint32_t>(to.stops_.size());
      Stop stop{gates[i].facing, kNone, gates[i].end, {}};
      if (walls.is_opening(stop.constraint)) stop.along = place_along(walls.segment(stop.constraint), gates[i].end);
      to.stops_.push_back(std::move(stop));
    }
    crossings = gate_crossings(exact);
    for (auto& of_gate : crossings)
      for (GateCrossing& crossing : of_gate) {
        if (crossing.vertex != kNone) continue;
        crossing.stop = static_cast<std::uint32_t>(to.stops_.size());
        to.stops_.push_back({crossing.opening, kNone, {}, crossing.along});
      }
  }

  /// Where a is before b, or 0 at the same place. Of one constraint.
  int compare(const Stop& a, const Stop& b) const {
    if (walls.is_opening(a.constraint)) return cmp(a.along, b.along);
    const Segment c = walls.segment(a.constraint);
    return compare_along(c.a, c.b, a.end, b.end);
  }

  /// Sorts the stops, gives each place a node, and sends on who knew their old numbers.
  void sort_stops() {
    std::vector<Stop>& stops = to.stops_;
    std::vector<std::uint32_t> order(stops.size()), node_of(stops.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
      if (stops[i].constraint != stops[j].constraint) return stops[i].constraint < stops[j].constraint;
      const int sign = compare(stops[i], stops[j]);
      return sign != 0 ? sign < 0 : i < j;
    });
    to.places_ = to.gates_.space().triangulation().points;
    std::vector<Stop> sorted;
    for (const std::uint32_t i : order) {
      const bool again =
          !sorted.empty() && sorted.back().constraint == stops[i].constraint && compare(sorted.back(), stops[i]) == 0;
      if (!again) {
        stops[i].node = static_cast<std::uint32_t>(to.places_.size());
        to.places_.push_back(place(stops[i]));
        sorted.push_back(stops[i]);
      }
      node_of[i] = sorted.back().node;
    }
    stops = std::move(sorted);
    for (std::uint32_t& stop : foot_stop)
      if (stop != kNone) stop = node_of[stop];
    for (auto& of_gate : crossings)
      for (GateCrossing& crossing : of_gate)
        if (crossing.stop != kNone) crossing.vertex = node_of[crossing.stop];
  }

  Point place(const Stop& stop) const {
    const Segment c = walls.segment(stop.constraint);
    if (!walls.is_opening(stop.constraint)) return nearest_foot(*gate_to_inside(stop.end, c));
    return nearest_point(point_along(c, stop.along));
  }

  void number_edges() {
    const auto count = static_cast<std::uint32_t>(walls.ends().size());
    to.first_stop_.assign(count + 1, 0);
    for (const Stop& stop : to.stops_) ++to.first_stop_[stop.constraint + 1];
    std::partial_sum(to.first_stop_.begin(), to.first_stop_.end(), to.first_stop_.begin());
    to.first_edge_.resize(count + 1);
    for (std::uint32_t c = 0; c <= count; ++c) to.first_edge_[c] = to.first_stop_[c] + c;
    for (std::uint32_t c = 0; c < count; ++c) {
      const auto [a, b] = walls.ends()[c];
      std::uint32_t last = a;
      for (const Stop& stop : to.stops(c)) add_edge(std::exchange(last, stop.node), stop.node, along(c));
      add_edge(last, b, along(c));
    }
  }

  Direction along(std::uint32_t c) const {
    const Segment s = walls.segment(c);
    return {s.a, s.b, 0};
  }

  void add_edge(std::uint32_t u, std::uint32_t v, const Direction& direction) {
    to.to_.push_back(v);
    to.to_.push_back(u);
    to.directions_.push_back(direction);
  }

  Direction direction_of(std::uint32_t gate) const {
    const GateShape& shape = exact.shapes[gate];
    if (shape.exact()) return {shape.end, shape.facing.a, 0};
    const bool left = written::orientation(shape.facing.a, shape.facing.b, shape.end) > 0;
    return {shape.facing.a, shape.facing.b, static_cast<std::uint8_t>(left ? 3 : 1)};
  }

  /// Gates may run along each other and along openings: one piece a place, of the narrowest.
  void cut_gates() {
    std::vector<Piece> all;
    for (std::uint32_t i = 0; i < exact.gates.size(); ++i) {
      std::uint32_t last = exact.nodes[i][0];
      for (const GateCrossing& crossing : crossings[i])
        all.push_back({std::exchange(last, crossing.vertex), crossing.vertex, i});
      all.push_back({last, foot_stop[i] == kNone ? exact.nodes[i][1] : foot_stop[i], i});
    }
    const auto key = [](const Piece& p) { return std::pair(std::minmax({p.u, p.v})); };
    std::vector<std::pair<std::uint32_t, std::uint32_t>> taken;
    for (std::uint32_t c = 0; c < walls.ends().size(); ++c)
      if (walls.is_opening(c))
        for (std::uint32_t e = to.first_edge_[c]; e < to.first_edge_[c + 1]; ++e)
          taken.push_back(std::minmax({to.to_[2 * e], to.to_[2 * e + 1]}));
    std::sort(taken.begin(), taken.end());
    std::sort(all.begin(), all.end(),
              [&](const Piece& p, const Piece& q) { return std::tuple(key(p), p.gate) < std::tuple(key(q), q.gate); });
    for (std::size_t i = 0; i < all.size(); ++i)
      if ((i == 0 || key(all[i - 1]) != key(all[i])) && !std::binary_search(taken.begin(), taken.end(), key(all[i])))
        to.pieces_.push_back(all[i]);
    std::sort(to.pieces_.begin(), to.pieces_.end(), [](const Piece& p, const Piece& q) {
      return std::tuple(p.gate, p.u, p.v) < std::tuple(q.gate, q.u, q.v);
    });
    for (const Piece& piece : to.pieces_) add_edge(piece.u, piece.v, direction_of(piece.gate));
  }

  void link() {
    const auto halves = static_cast<std::uint32_t>(to.to_.size());
    to.first_around_.assign(to.places_.size() + 1, 0);
    for (std::uint32_t h = 0; h < halves; ++h) ++to.first_around_[to.to_[h] + 1];
    std::partial_sum(to.first_around_.begin(), to.first_around_.end(), to.first_around_.begin());
    to.around_.resize(halves);
    std::vector<std::uint32_t> next(to.first_around_.begin(), to.first_around_.end() - 1);
    for (std::uint32_t h = 0; h < halves; ++h) to.around_[next[to.to_[h ^ 1]]++] = h;
    to.next_.resize(halves);
    for (std::size_t n = 0; n + 1 < to.first_around_.size(); ++n) {
      const std::span around =
          std::span(to.around_).subspan(to.first_around_[n], to.first_around_[n + 1] - to.first_around_[n]);
      std::sort(around.begin(), around.end(), [&](std::uint32_t g, std::uint32_t h) {
        return angle_less(half_direction(to.directions_, g), half_direction(to.directions_, h));
      });
      // Whoever comes in along an edge goes out along the one before it: the face is to the left.
      for (std::size_t i = 0; i < around.size(); ++i) to.next_[around[(i + 1) % around.size()] ^ 1] = around[i];
    }
  }

  void walk() {
    to.face_.assign(to.to_.size(), kNone);
    for (std::uint32_t h = 0; h < to.to_.size(); ++h) {
      if (to.face_[h] != kNone) continue;
      const std::uint32_t face = to.face_count();
      to.walk_.push_back(h);
      for (std::uint32_t at = h; to.face_[at] == kNone; at = to.next_[at]) to.face_[at] = face;
    }
  }

  /// By the triangles along constraints; where a face has none, by its neighbours across gates.
  void find_components() {
    const Triangulation& tri = walls.triangulation();
    to.component_.assign(to.face_count(), kNone);
    std::vector<std::uint32_t> known;
    const auto mark = [&](std::uint32_t face, std::uint32_t component) {
      if (to.component_[face] != kNone) return;
      to.component_[face] = component;
      known.push_back(face);
    };
    for (std::uint32_t t = 0; t < tri.triangles.size(); ++t)
      for (int i = 0; i < 3 && tri.free[t]; ++i) {
        const std::uint32_t c = walls.along(t, i);
        if (c == kNone) continue;
        const bool left = walls.ends()[c][0] == tri.triangles[t][Triangulation::ccw(i)];
        for (std::uint32_t e = to.first_edge_[c]; e < to.first_edge_[c + 1]; ++e)
          mark(to.face_[2 * e + (left ? 0 : 1)], walls.space().component(t));
      }
    while (!known.empty()) {
      const std::uint32_t face = known.back(), first = to.walk_[face];
      known.pop_back();
      std::uint32_t h = first;
      do {
        if (h / 2 >= to.first_gate_edge()) mark(to.face_[h ^ 1], to.component_[face]);
        h = to.next_[h];
      } while (h != first);
    }
  }
};

PassageFaces::PassageFaces(const Gates& gates) : gates_(gates) { Builder(*this).build(); }

std::uint32_t PassageFaces::at_node(std::uint32_t node, const Direction& outward) const {
  const auto first = around_.begin() + first_around_[node], last = around_.begin() + first_around_[node + 1];
  const auto after = std::upper_bound(first, last, outward, [&](const Direction& d, std::uint32_t half_edge) {
    return angle_less(d, half_direction(directions_, half_edge));
  });
  return face_[after == first ? *(last - 1) : *(after - 1)];
}

std::uint32_t PassageFaces::beside_wall(std::uint32_t constraint, bool left, Point p) const {
  const std::span<const Stop> all = stops(constraint);
  const Constraint& c = gates_.space().constraints()[constraint];
  const auto after = std::partition_point(all.begin(), all.end(),
                                          [&](const Stop& stop) { return compare_along(c.a, c.b, stop.end, p) <= 0; });
  return piece_face(constraint, static_cast<std::uint32_t>(after - all.begin()), left);
}

std::uint32_t PassageFaces::beside_opening(std::uint32_t constraint, bool left, const Rational& along,
                                           const Direction& outward) const {
  const std::span<const Stop> all = stops(constraint);
  const auto at = std::partition_point(all.begin(), all.end(), [&](const Stop& stop) { return stop.along < along; });
  if (at != all.end() && at->along == along) return at_node(at->node, outward);
  return piece_face(constraint, static_cast<std::uint32_t>(at - all.begin()), left);
}

}  // namespace taut::detail
