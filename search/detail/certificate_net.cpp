#include <taut/search/detail/certificate_net.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <taut/search/detail/world_pieces.h>

namespace taut::detail {

namespace {

__extension__ using Wide = __int128;
using Int = std::int64_t;
using Place = CertificatePlaces::Place;

Wide greatest_divisor(Wide a, Wide b) {
  while (b != 0) a = std::exchange(b, a % b);
  return a < 0 ? -a : a;
}

/// By what places have to be multiplied so that the edge meets the box' lines x = min.x, x = max.x in whole places.
Wide denominator(Place a, Place b, const std::array<Place, 2>& box, int axis) {
  const auto x = static_cast<std::size_t>(axis), y = 1 - x;
  const Wide run = Wide{b[x]} - a[x], rise = Wide{b[y]} - a[y];
  Wide all = 1;
  for (const Place corner : box) {
    const Wide to = Wide{corner[x]} - a[x], part = to * (run < 0 ? -1 : 1);
    if (part <= 0 || part >= (run < 0 ? -run : run)) continue;
    const Wide at = a[y] + rise * to / run;
    if (at < box[0][y] || at > box[1][y]) continue;
    const Wide one = (run < 0 ? -run : run) / greatest_divisor(rise * to, run);
    all = all / greatest_divisor(all, one) * one;
  }
  return all;
}

/// The least factor for all edges; 0 where it would be too large.
Int factor_for(const World& world, const LatticeIntegers& integers, const std::array<Place, 2>& box) {
  Int largest = 1;
  for (const Point p : {world.box().min, world.box().max}) {
    const Place place = integers.place(p).value();
    largest = std::max({largest, std::abs(place[0]), std::abs(place[1])});
  }
  Wide all = 1;
  each_piece(world, [&](Point p, Point q) {
    const auto a = integers.place(p), b = integers.place(q);
    if (!a || !b || all == 0) return;
    for (const int axis : {0, 1}) {
      const Wide one = denominator(*a, *b, box, axis);
      if (all == 0 || one > LatticeIntegers::kLargest) all = 0;
      if (all == 0) return;
      all = all / greatest_divisor(all, one) * one;
      if (all * largest >= LatticeIntegers::kLargest) all = 0;
    }
  });
  return static_cast<Int>(all);
}

}  // namespace

CertificatePlaces::CertificatePlaces(const World& world, Point from, const Box& goal)
    : integers_(world, std::array{from, goal.min, goal.max}) {
  goal_ = {integers_.place(goal.min).value(), integers_.place(goal.max).value()};
  if (goal.min != goal.max) factor_ = factor_for(world, integers_, goal_);
  for (Place& corner : goal_)
    for (Int& v : corner) v *= factor_;
}

std::optional<Place> CertificatePlaces::exactly(Point p) const {
  const auto place = integers_.place(p);
  if (!place) return std::nullopt;
  return Place{(*place)[0] * factor_, (*place)[1] * factor_};
}

Place CertificatePlaces::nearest(Point p) const {
  const auto whole = [&](double v) { return static_cast<Int>(std::llround(static_cast<long double>(v) * per_one())); };
  return exactly(p).value_or(Place{whole(p.x), whole(p.y)});
}

CertificateNet::CertificateNet(const VisibilityGraph& graph, const CertificatePlaces& places, Point from,
                               const Goal& to)
    : graph_(graph.roadmap()), query_(visibility_query(graph, from, to)), goals_(start() + 1) {
  places_.reserve(start() + 1 + query_.goals.size());
  for (const Point p : graph_.points()) {
    const auto place = places.exactly(p);
    is_exact_ &= place.has_value();
    places_.push_back(place.value_or(Place{}));
  }
  places_.push_back(places.exactly(from).value());
  for (const std::size_t goal : query_.direct) goals_[start()].push_back(start() + 1 + static_cast<Vertex>(goal));
  for (const Terminal& terminal : query_.goals) {
    for (const Vertex v : terminal.vertices) goals_[v].push_back(static_cast<Vertex>(places_.size()));
    places_.push_back(places.nearest(terminal.point));
  }
}

std::optional<Box> goal_box(const Goal& goal) {
  if (goal.point) return Box{*goal.point, *goal.point};
  if (goal.room.empty()) return std::nullopt;
  Box all = goal.room.front();
  std::vector<double> xs, ys;
  for (const Box& b : goal.room) {
    xs.insert(xs.end(), {b.min.x, b.max.x}), ys.insert(ys.end(), {b.min.y, b.max.y});
    all = {{std::min(all.min.x, b.min.x), std::min(all.min.y, b.min.y)},
           {std::max(all.max.x, b.max.x), std::max(all.max.y, b.max.y)}};
  }
  std::sort(xs.begin(), xs.end()), std::sort(ys.begin(), ys.end());
  for (std::size_t i = 0; i + 1 < xs.size(); ++i)
    for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
      const auto holds = [&](const Box& b) {
        return b.min.x <= xs[i] && xs[i + 1] <= b.max.x && b.min.y <= ys[j] && ys[j + 1] <= b.max.y;
      };
      if (std::none_of(goal.room.begin(), goal.room.end(), holds)) return std::nullopt;
    }
  return all;
}

}  // namespace taut::detail
