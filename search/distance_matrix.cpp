#include <taut/search/distance_matrix.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <utility>

#include <taut/geometry/expects.h>
#include <taut/geometry/parallel.h>
#include <taut/search/detail/bend_distances.h>
#include <taut/search/detail/seen_places.h>
#include <taut/search/query_ends.h>

namespace taut {

namespace {

using detail::BendDistances;
using twofold::Pair;

constexpr std::size_t kLanes =
    DistanceRows::kRows;  // at a time: the bends that a point sees are looked through once for all
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Leg = BendDistances::Leg;

/// For each point the bends that it sees, and how far they are.
class Entries {
 public:
  Entries(const VisibilityGraph& graph, std::span<const Point> points, unsigned jobs) {
    std::vector<std::vector<Leg>> of(points.size());
    each_in_parallel(points.size(), {jobs}, [&](std::size_t i) {
      for (const Roadmap::Vertex v : graph.visible_from(points[i]))
        of[i].push_back({v, detail::leg_of(points[i], graph.roadmap().point(v))});
    });
    first_.reserve(points.size() + 1);
    for (const std::vector<Leg>& legs : of) {
      first_.push_back(legs_.size());
      legs_.insert(legs_.end(), legs.begin(), legs.end());
    }
    first_.push_back(legs_.size());
  }

  std::span<const Leg> operator[](std::size_t i) const {
    return {legs_.data() + first_[i], legs_.data() + first_[i + 1]};
  }

 private:
  std::vector<std::size_t> first_;  // by point, into legs_
  std::vector<Leg> legs_;
};

/// What one thread measures rows with.
class Rows {
 public:
  Rows(std::span<const Point> points, const Entries& entries, const BendDistances& distances,
       const detail::SeenPlaces& seen)
      : points_(points),
        entries_(entries),
        distances_(distances),
        seen_(seen),
        high_(distances_.size() * kLanes),
        low_(distances_.size() * kLanes) {}

  /// Rows first .. first + count, each from the diagonal on, into `lengths`, where row `first` begins.
  void measure(std::size_t first, std::size_t count, double* lengths) {
    first_ = first;
    lengths_ = lengths;
    for (std::size_t lane = 0; lane < count; ++lane) start_from(first + lane, lane);
    for (std::size_t j = first; j < points_.size(); ++j) over_bends(first, std::min(count, j - first + 1), j);
    for (std::size_t i = first; i < first + count; ++i)
      for (const std::uint32_t j : seen_.from(i))
        if (j >= i) set(i, j, detail::leg_of(points_[i], points_[j]).high);
  }

 private:
  void start_from(std::size_t i, std::size_t lane) {
    distances_.from(entries_[i]);
    for (std::size_t v = 0; v < distances_.size(); ++v) {
      high_[v * kLanes + lane] = distances_[v].high;
      low_[v * kLanes + lane] = distances_[v].low;
    }
  }

  void over_bends(std::size_t first, std::size_t count, std::size_t j) {
    std::array<double, kLanes> least;
    least.fill(kInfinity);
    for (const Leg& leg : entries_[j]) {
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
    for (const Leg& leg : entries_[j]) {
      const std::size_t at = leg.to * kLanes + lane;
      if (high_[at] + leg.length.high > limit) continue;
      const Pair sum = detail::plus({high_[at], low_[at]}, leg.length);
      if (detail::is_less(sum, best)) best = sum;
    }
    return best.high;
  }

  void set(std::size_t i, std::size_t j, double length) {
    if (j >= i) lengths_[(i - first_) * points_.size() + j] = length;
  }

  std::span<const Point> points_;
  std::size_t first_ = 0;
  double* lengths_ = nullptr;
  const Entries& entries_;
  BendDistances distances_;
  detail::SeenPlaces seen_;
  std::vector<double> high_, low_;  // by bend and lane
};

/// What all threads share.
class Measurement {
 public:
  Measurement(const VisibilityGraph& graph, std::span<const Point> points, unsigned jobs)
      : points_(points), entries_(graph, points, jobs), distances_(graph), seen_(graph.space(), points) {}

  std::span<const Point> points() const { return points_; }
  std::size_t groups() const { return (points_.size() + kLanes - 1) / kLanes; }
  std::size_t rows_of(std::size_t group) const { return std::min(kLanes, points_.size() - group * kLanes); }
  std::shared_ptr<Rows> rows() const { return std::make_shared<Rows>(points_, entries_, distances_, seen_); }

 private:
  std::span<const Point> points_;
  const Entries entries_;
  const BendDistances distances_;
  const detail::SeenPlaces seen_;
};

void require_all_free(const VisibilityGraph& graph, std::span<const Point> points) {
  TAUT_EXPECTS(graph.kind() == VisibilityKind::reduced);
  for (const Point p : points) require_free(graph.space(), p, "point");
}

/// The columns that are the mirror of rows first .. first + count: nobody else writes them.
void mirror(std::span<double> lengths, std::size_t n, std::size_t first, std::size_t count) {
  for (std::size_t j = first; j < n; ++j)
    for (std::size_t i = first; i < std::min(first + count, j); ++i) lengths[j * n + i] = lengths[i * n + j];
}

}  // namespace

void distance_matrix(const VisibilityGraph& graph, std::span<const Point> points, std::span<double> lengths,
                     const std::function<void(std::size_t)>& finished, unsigned jobs) {
  TAUT_EXPECTS(lengths.size() == points.size() * points.size());
  require_all_free(graph, points);
  const Measurement all(graph, points, jobs);
  Parallel how{jobs};
  if (finished) how.finished = [&](std::size_t groups) { finished(std::min(groups * kLanes, points.size())); };
  each_in_parallel(all.groups(), how, [&] {
    return [&, rows = all.rows()](std::size_t group) {
      const std::size_t first = group * kLanes;
      rows->measure(first, all.rows_of(group), lengths.data() + first * points.size());
      mirror(lengths, points.size(), first, all.rows_of(group));
    };
  });
}

struct DistanceRows::Impl : Measurement {
  using Measurement::Measurement;
};

DistanceRows::DistanceRows(const VisibilityGraph& graph, std::span<const Point> points, unsigned jobs) {
  require_all_free(graph, points);
  impl_ = std::make_shared<const Impl>(graph, points, jobs);
}

std::size_t DistanceRows::groups() const { return impl_->groups(); }

std::function<std::vector<double>(std::size_t)> DistanceRows::worker() const {
  return [impl = impl_, rows = impl_->rows(), whole = std::vector<double>()](std::size_t group) mutable {
    const std::size_t first = group * kLanes, count = impl->rows_of(group), n = impl->points().size();
    whole.resize(count * n);
    rows->measure(first, count, whole.data());
    std::vector<double> lengths;
    for (std::size_t i = 0; i < count; ++i)
      lengths.insert(lengths.end(), whole.begin() + static_cast<std::ptrdiff_t>(i * n + first + i),
                     whole.begin() + static_cast<std::ptrdiff_t>((i + 1) * n));
    return lengths;
  };
}

void put_rows(std::size_t group, std::span<const double> rows, std::span<double> lengths, std::size_t n) {
  const std::size_t first = group * kLanes, count = std::min(kLanes, n - first);
  for (std::size_t i = first; i < first + count; ++i) {
    std::copy_n(rows.begin(), n - i, lengths.begin() + static_cast<std::ptrdiff_t>(i * n + i));
    rows = rows.subspan(n - i);
  }
  mirror(lengths, n, first, count);
}

std::vector<double> distance_matrix(const FreeSpace& space, std::span<const Point> points, unsigned jobs) {
  std::vector<double> lengths(points.size() * points.size());
  distance_matrix(VisibilityGraph(space, VisibilityKind::reduced, jobs), points, lengths, {}, jobs);
  return lengths;
}

}  // namespace taut
