#include <taut/search/detail/sight_lists.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace taut::detail {

namespace {

using Tri = Triangulation;
using Place = IntegerPlaces::Place;

Place minus(Place a) { return {-a[0], -a[1]}; }

class Lookout {
 public:
  Lookout(const VisibilityGraph& graph, const HubGraph& hubs, const IntegerPlaces& integers, std::size_t most)
      : tri_(graph.space().triangulation()), graph_(graph), hubs_(hubs), most_(most), per_unit_(integers.per_unit()) {
    lists_.places = ray_places(graph, integers);
  }

  std::optional<SightLists> lists() && {
    for (std::uint32_t v = 0; v < hubs_.size(); ++v)
      for (const BendSide side : {kRightTurn, kLeftTurn}) {
        look_from(v, side);
        if (found_.size() > most_) return {};
      }
    sort_in();
    sort_halves();
    return std::move(lists_);
  }

 private:
  struct Found {
    std::uint32_t triangle;
    Sight sight;
  };
  struct View {
    std::uint32_t triangle;
    int side;
    std::uint32_t right, left;
  };
  struct Half {
    std::uint32_t from, to;
    double angle, length;
  };

  /// Along which a string can have come: from the sector's right side to the straight continuation of its left one
  /// where the obstacle is to the left, else the other way round.
  void look_from(std::uint32_t v, BendSide side) {
    const Tri::Sector& sector = tri_.sectors[graph_.sector(v)];
    bend_ = 2 * v + side;
    at_ = lists_.places[sector.vertex];
    vertex_ = v;
    right_side_ = to(sector.right);
    left_side_ = to(sector.left);
    const Place limit = minus(side == kLeftTurn ? left_side_ : right_side_);
    const auto opposite = static_cast<std::uint32_t>(tri_.points.size()) + bend_;
    bool started = side == kLeftTurn, ended = false;
    each_triangle(tri_, sector, [&](std::uint32_t t, int i) {
      if (ended) return;
      std::uint32_t right = tri_.triangles[t][Tri::ccw(i)], left = tri_.triangles[t][Tri::cw(i)];
      const bool is_limit = cross(to(right), limit) >= 0 && cross(limit, to(left)) > 0;
      if (side == kLeftTurn && is_limit) {
        ended = true;
        if (cross(to(right), limit) == 0) return;
        left = opposite;
      } else if (!started) {
        if (!is_limit) return;
        started = true;
        right = opposite;
      }
      add(t, right, left);
      if (right != opposite) add_half(tri_.sector_of[3 * t + Tri::ccw(i)], to(right));
      if (left != opposite) add_half(tri_.sector_of[3 * t + Tri::cw(i)], to(left));
      spread(t, i, right, left);
    });
  }

  void spread(std::uint32_t triangle, int side, std::uint32_t right, std::uint32_t left) {
    enter(triangle, side, right, left);
    while (!open_.empty()) {
      const View view = open_.back();
      open_.pop_back();
      const std::uint32_t t = tri_.neighbours[view.triangle][view.side];
      const int corner = tri_.mirror(view.triangle, view.side);
      add(t, view.right, view.left);
      const std::uint32_t apex = tri_.triangles[t][corner];
      const std::int64_t from_right = cross(to(view.right), to(apex)), from_left = cross(to(apex), to(view.left));
      if (from_right >= 0 && from_left >= 0) add_half(tri_.sector_of[3 * t + corner], to(apex));
      if (from_left > 0) enter(t, Tri::cw(corner), from_right >= 0 ? apex : view.right, view.left);
      if (from_right > 0) enter(t, Tri::ccw(corner), view.right, from_left >= 0 ? apex : view.left);
    }
  }

  void enter(std::uint32_t t, int side, std::uint32_t right, std::uint32_t left) {
    if (tri_.is_constrained(t, side) || tri_.neighbours[t][side] == kNone || cross(to(right), to(left)) <= 0) return;
    open_.push_back({t, side, right, left});
  }

  void add(std::uint32_t t, std::uint32_t right, std::uint32_t left) {
    Place most_right = to(right), most_left = to(left);
    Sight sight{bend_, kNone, kNone, 0};
    std::array<Place, 3> corners;
    std::size_t count = 0;
    for (const std::uint32_t v : tri_.triangles[t])
      if (lists_.places[v] != at_) corners[count++] = to(v);
    for (std::size_t i = 0; i < count; ++i) {
      if (cross(most_right, corners[i]) < 0) sight.right = right;
      if (cross(corners[i], most_left) < 0) sight.left = left;
    }
    // All within, the corners themselves bound what is seen here.
    if (sight.right == kNone) most_right = extreme(corners, count, 1);
    if (sight.left == kNone) most_left = extreme(corners, count, -1);
    sight.edges = std::max(edges_behind(most_right), edges_behind(most_left));
    found_.push_back({t, sight});
  }

  static Place extreme(const std::array<Place, 3>& corners, std::size_t count, int turn) {
    Place most = corners[0];
    for (std::size_t i = 1; i < count; ++i)
      if (turn * cross(corners[i], most) > 0) most = corners[i];
    return most;
  }

  /// How many may follow where a string comes from that direction: monotone in it.
  std::uint32_t edges_behind(Place from) const {
    const std::uint32_t first = hubs_.first[vertex_], last = hubs_.first[vertex_ + 1];
    const auto turn = [&](std::uint32_t e) {
      return cross(minus(from), to(tri_.sectors[graph_.sector(hubs_.edges[e].to)].vertex));
    };
    std::uint32_t count = 0;
    if (bend_ % 2 == kRightTurn)
      while (first + count < last && turn(first + count) <= 0) ++count;
    else
      while (first + count < last && turn(last - 1 - count) >= 0) ++count;
    return count;
  }

  void add_half(std::uint32_t sector, Place d) {
    const std::uint32_t v = sector == kNone ? kNone : graph_.vertex_of_sector(sector);
    if (v == kNone || v == vertex_ || is_tangent(tri_.sectors[sector], d)) return;
    const Place side = bend_ % 2 == kRightTurn ? right_side_ : left_side_;
    const double turn = static_cast<double>(bend_ % 2 == kRightTurn ? cross(side, d) : cross(d, side));
    const double ahead = static_cast<double>(side[0]) * d[0] + static_cast<double>(side[1]) * d[1];
    double angle = std::atan2(turn, ahead);
    if (angle < -1e-9) angle += 2 * std::numbers::pi;
    halves_.push_back({bend_, v, angle, IntegerPlaces::distance(d, {0, 0}) / per_unit_});
  }

  /// Does the line along d, from the bend looked from, have the obstacle at the sector's vertex on one side?
  bool is_tangent(const Tri::Sector& sector, Place d) const {
    const std::int64_t right = cross(d, to(sector.right)), left = cross(d, to(sector.left));
    return (right >= 0 && left >= 0) || (right <= 0 && left <= 0);
  }

  void sort_in() {
    const auto tests = [](const Sight& s) { return (s.right != kNone ? 1 : 0) + (s.left != kNone ? 2 : 0); };
    lists_.first.assign(4 * tri_.triangles.size() + 1, 0);
    for (const Found& f : found_) ++lists_.first[4 * f.triangle + tests(f.sight) + 1];
    for (std::size_t i = 1; i < lists_.first.size(); ++i) lists_.first[i] += lists_.first[i - 1];
    lists_.sights.resize(found_.size());
    std::vector<std::uint32_t> next(lists_.first.begin(), lists_.first.end() - 1);
    for (const Found& f : found_) lists_.sights[next[4 * f.triangle + tests(f.sight)]++] = f.sight;
  }

  void sort_halves() {
    std::sort(halves_.begin(), halves_.end(), [](const Half& a, const Half& b) {
      return a.from != b.from ? a.from < b.from : a.angle != b.angle ? a.angle < b.angle : a.to < b.to;
    });
    const auto is_same = [](const Half& a, const Half& b) { return a.from == b.from && a.to == b.to; };
    halves_.erase(std::unique(halves_.begin(), halves_.end(), is_same), halves_.end());
    HalfLegs& legs = lists_.halves;
    legs.first.assign(2 * std::size_t{hubs_.size()} + 1, 0);
    legs.in_first.assign(hubs_.size() + std::size_t{1}, 0);
    for (const Half& h : halves_) {
      ++legs.first[h.from + 1];
      ++legs.in_first[h.to + 1];
      legs.out.push_back({h.to, h.length});
    }
    for (std::size_t i = 1; i < legs.first.size(); ++i) legs.first[i] += legs.first[i - 1];
    for (std::size_t i = 1; i < legs.in_first.size(); ++i) legs.in_first[i] += legs.in_first[i - 1];
    legs.in.resize(halves_.size());
    std::vector<std::uint32_t> next(legs.in_first.begin(), legs.in_first.end() - 1);
    for (const Half& h : halves_) legs.in[next[h.to]++] = {h.from / 2, h.length};
  }

  Place to(std::uint32_t place) const { return IntegerPlaces::difference(lists_.places[place], at_); }
  static std::int64_t cross(Place a, Place b) { return IntegerPlaces::cross(a, b); }

  const Tri& tri_;
  const VisibilityGraph& graph_;
  const HubGraph& hubs_;
  std::size_t most_;
  double per_unit_;
  SightLists lists_;
  std::vector<Found> found_;
  std::vector<Half> halves_;
  std::vector<View> open_;
  std::uint32_t bend_ = 0, vertex_ = 0;
  Place at_{}, right_side_{}, left_side_{};
};

}  // namespace

std::vector<Place> ray_places(const VisibilityGraph& graph, const IntegerPlaces& integers) {
  const Tri& tri = graph.space().triangulation();
  std::vector<Place> places(tri.points.size());
  for (std::size_t v = 0; v < tri.points.size(); ++v) integers.find(tri.points[v], places[v]);
  for (std::uint32_t v = 0; v < graph.roadmap().vertex_count(); ++v) {
    const Tri::Sector& sector = tri.sectors[graph.sector(v)];
    const Place at = places[sector.vertex];
    for (const std::uint32_t side : {sector.right, sector.left}) {
      const Place limit = minus(IntegerPlaces::difference(places[side], at));
      places.push_back({at[0] + limit[0], at[1] + limit[1]});
    }
  }
  return places;
}

std::optional<SightLists> sight_lists(const VisibilityGraph& graph, const HubGraph& hubs, const IntegerPlaces& places,
                                      std::size_t most) {
  return Lookout(graph, hubs, places, most).lists();
}

}  // namespace taut::detail
