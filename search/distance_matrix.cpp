#include <taut/search/distance_matrix.h>

#include <algorithm>
#include <array>
#include <limits>

#include <taut/geometry/expects.h>
#include <taut/search/detail/bend_distances.h>
#include <taut/search/detail/seen_places.h>
#include <taut/search/query_ends.h>

namespace taut {

namespace {

using detail::BendDistances;
using twofold::Pair;

constexpr std::size_t kLanes = 8;  // rows at a time: the bends that a point sees are looked through once for all
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Rows {
 public:
  Rows(const VisibilityGraph& graph, std::span<const Point> points, std::span<double> lengths)
      : points_(points),
        lengths_(lengths),
        distances_(graph),
        seen_(graph.space(), points),
        high_(distances_.size() * kLanes),
        low_(distances_.size() * kLanes) {
    first_.reserve(points.size() + 1);
    first_.push_back(0);
    for (const Point p : points) {
      for (const Roadmap::Vertex v : graph.visible_from(p))
        legs_.push_back({v, detail::leg_of(p, graph.roadmap().point(v))});
      first_.push_back(legs_.size());
    }
  }

  /// Rows first .. first + count, from the diagonal on, and the columns that are their mirror.
  void add(std::size_t first, std::size_t count) {
    for (std::size_t lane = 0; lane < count; ++lane) measure(first + lane, lane);
    for (std::size_t j = first; j < points_.size(); ++j) over_bends(first, std::min(count, j - first + 1), j);
    for (std::size_t i = first; i < first + count; ++i)
      for (const std::uint32_t j : seen_.from(i))
        if (j >= i) set(i, j, detail::leg_of(points_[i], points_[j]).high);
  }

 private:
  void measure(std::size_t i, std::size_t lane) {
    distances_.from(legs(i));
    for (std::size_t v = 0; v < distances_.size(); ++v) {
      high_[v * kLanes + lane] = distances_[v].high;
      low_[v * kLanes + lane] = distances_[v].low;
    }
  }

  void over_bends(std::size_t first, std::size_t count, std::size_t j) {
    std::array<double, kLanes> least;
    least.fill(kInfinity);
    for (const BendDistances::Leg& leg : legs(j)) {
      const double* const to = &high_[leg.to * kLanes];
      for (std::size_t lane = 0; lane < kLanes; ++lane) least[lane] = std::min(least[lane], to[lane] + leg.length.high);
    }
    for (std::size_t lane = 0; lane < count; ++lane)
      set(first + lane, j, least[lane] == kInfinity ? kInfinity : settled(lane, j, least[lane]));
  }

  /// The least of the sums that are as good as `least` in doubles.
  double settled(std::size_t lane, std::size_t j, double least) const {
    const double limit = least * (1 + detail::kDoubt);
    Pair best{kInfinity, 0};
    for (const BendDistances::Leg& leg : legs(j)) {
      const std::size_t at = leg.to * kLanes + lane;
      if (high_[at] + leg.length.high > limit) continue;
      const Pair sum = detail::plus({high_[at], low_[at]}, leg.length);
      if (detail::is_less(sum, best)) best = sum;
    }
    return best.high;
  }

  void set(std::size_t i, std::size_t j, double length) {
    lengths_[i * points_.size() + j] = length;
    lengths_[j * points_.size() + i] = length;
  }

  std::span<const BendDistances::Leg> legs(std::size_t i) const {
    return {legs_.data() + first_[i], legs_.data() + first_[i + 1]};
  }

  std::span<const Point> points_;
  std::span<double> lengths_;
  BendDistances distances_;
  detail::SeenPlaces seen_;
  std::vector<std::size_t> first_;  // by point, into legs_
  std::vector<BendDistances::Leg> legs_;
  std::vector<double> high_, low_;  // by bend and lane
};

}  // namespace

void distance_matrix(const VisibilityGraph& graph, std::span<const Point> points, std::span<double> lengths,
                     const std::function<void(std::size_t)>& finished) {
  TAUT_EXPECTS(graph.kind() == VisibilityKind::reduced);
  TAUT_EXPECTS(lengths.size() == points.size() * points.size());
  for (const Point p : points) require_free(graph.space(), p, "point");
  Rows rows(graph, points, lengths);
  for (std::size_t first = 0; first < points.size(); first += kLanes) {
    const std::size_t count = std::min(kLanes, points.size() - first);
    rows.add(first, count);
    if (finished) finished(first + count);
  }
}

std::vector<double> distance_matrix(const FreeSpace& space, std::span<const Point> points) {
  std::vector<double> lengths(points.size() * points.size());
  distance_matrix(VisibilityGraph(space), points, lengths);
  return lengths;
}

}  // namespace taut
