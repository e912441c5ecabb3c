#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include <taut/geometry/detail/near_pairs.h>
#include <taut/geometry/number_lattice.h>
#include <taut/geometry/segment_distance.h>
#include <taut/geometry/snap.h>
#include <taut/geometry/triangulation.h>
#include <taut/geometry/written.h>

namespace taut {

namespace {

using detail::Foot;
using detail::NearPairs;
using detail::NumberedContact;
using detail::Piece;

constexpr double kNear = 1e-6;         // of the extent
constexpr double kLargestUnit = 1e-4;  // of the extent
constexpr double kShortShare = 0.1;    // of the shorter wall
constexpr double kGapBelow = 1e-3;     // of the extent
constexpr double kLeastRatio = 10;
constexpr double kAlike = 1e-7;  // of the extent: ratios of smaller distances say nothing

double length(const Segment& s) { return std::hypot(s.b.x - s.a.x, s.b.y - s.a.y); }

// Finds the nearest wall of each end.
class Contacts {
 public:
  Contacts(const WorldParts& parts, double reach, double share)
      : pairs_(parts), reach_(reach), share_(share), partner_(pairs_.points().size(), kNone) {}

  std::vector<NumberedContact> all() {
    for (std::uint32_t p = 0; p < pairs_.points().size(); ++p) add_nearest(p);
    return std::move(result_);
  }

 private:
  void add_nearest(std::uint32_t p) {
    const Point at = pairs_.points()[p];
    Foot least{std::numeric_limits<double>::infinity(), 0};
    std::uint32_t nearest = kNone;
    pairs_.near(at, reach_, [&](std::uint32_t i) {
      const Foot foot = detail::foot(at, pairs_.segment(i));
      if (foot.distance > least.distance || (foot.distance == least.distance && i > nearest)) return;
      if (!detail::is_within(foot, at, pairs_.segment(i), reach_) || !is_contact(p, i, foot.distance)) return;
      least = foot;
      nearest = i;
    });
    if (nearest == kNone) return;
    const Piece& wall = pairs_.pieces()[nearest];
    if (least.along == 0 || least.along == 1) {
      partner_[p] = least.along == 0 ? wall.a : wall.b;
      if (partner_[partner_[p]] == p) return;  // listed from the other end
    }
    const Segment s = pairs_.segment(nearest);
    const int line = pairs_.pieces()[pairs_.around(p).front()].line;
    result_.push_back({{at, s, segment_distance({at, at}, s), line, wall.line}, nearest});
  }

  bool is_contact(std::uint32_t p, std::uint32_t i, double distance) const {
    const Piece& wall = pairs_.pieces()[i];
    if (detail::covers(std::max(wall.thickness, pairs_.thickness(p)), distance)) return false;
    const Segment s = pairs_.segment(i);
    double longest = 0;
    for (const std::uint32_t own : pairs_.around(p)) {
      const Segment t = pairs_.segment(own);
      if (own == i || written::segments_meet(t, s)) return false;
      longest = std::max(longest, length(t));
    }
    return share_ == 0 || distance < share_ * std::min(longest, length(s));
  }

  NearPairs pairs_;
  double reach_, share_;
  std::vector<std::uint32_t> partner_;  // the end that is nearest, where an end is
  std::vector<NumberedContact> result_;
};

// Distances by their binary exponents: the greatest ratio of neighbours is one between the largest below and the
// smallest above an empty stretch.
class Distances {
 public:
  void add(double d) {
    Bucket& b = buckets_[static_cast<std::size_t>(std::ilogb(d) + kOffset)];
    b.smallest = std::min(b.smallest, d);
    b.largest = std::max(b.largest, d);
  }

  // The distance below the greatest ratio, if it is below `limit`; nothing is known beyond `searched`. Those below
  // `alike` are alike.
  double gap(double limit, double searched, double alike) const {
    double below = 0, best = 0, greatest = kLeastRatio;
    const auto look = [&](double above) {
      const double ratio = std::max(above, alike) / std::max(below, alike);
      if (below == 0 || below >= limit || ratio < greatest || (best > 0 && ratio == greatest)) return;
      greatest = ratio;
      best = below;
    };
    for (const Bucket& b : buckets_) {
      if (b.largest == 0) continue;
      look(b.smallest);
      below = b.largest;
    }
    look(std::max(searched, below));
    return best;
  }

  bool any_from(double limit) const {
    return std::any_of(buckets_.begin(), buckets_.end(), [&](const Bucket& b) { return b.largest >= limit; });
  }

 private:
  static constexpr int kOffset = 1080;
  struct Bucket {
    double smallest = std::numeric_limits<double>::infinity(), largest = 0;
  };
  std::array<Bucket, 2200> buckets_{};
};

Distances distances_between(const NearPairs& pairs, double least, double exact, double reach) {
  Distances distances;
  for (const Point p : pairs.points())
    pairs.near(p, reach, [&](std::uint32_t i) {
      const Segment s = pairs.segment(i);
      double d = detail::foot(p, s).distance;
      if (d < exact) d = segment_distance({p, p}, s);
      if (least < d && d <= reach && !written::on_segment(p, s.a, s.b)) distances.add(d);
    });
  return distances;
}

bool is_axis_parallel(const World& world) {
  const auto parallel = [](Point a, Point b) { return a.x == b.x || a.y == b.y; };
  const auto ring_is = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (!parallel(ring[i], ring[(i + 1) % ring.size()])) return false;
    return true;
  };
  const auto area_is = [&](const Area& area) {
    return ring_is(area.polygon.outer) && std::all_of(area.polygon.holes.begin(), area.polygon.holes.end(), ring_is);
  };
  const auto& [walls, areas, solids] = std::tie(world.walls(), world.areas(), world.solids());
  return std::all_of(walls.begin(), walls.end(), [&](const Wall& w) { return parallel(w.a, w.b); }) &&
         std::all_of(areas.begin(), areas.end(), area_is) && std::all_of(solids.begin(), solids.end(), area_is);
}

}  // namespace

std::vector<detail::NumberedContact> detail::contacts_within(const WorldParts& parts, double reach, double share) {
  return Contacts(parts, reach, share).all();
}

double auto_tolerance(const WorldParts& parts) {
  const double extent = detail::extent(parts);
  const NearPairs pairs(parts);
  const double rounding = rounding_tolerance(parts);
  for (double searched = 10 * kGapBelow * extent;; searched *= 10) {
    const Distances distances = distances_between(pairs, rounding, kGapBelow * extent, searched);
    if (searched > 2 * extent || distances.any_from(kGapBelow * extent))
      return distances.gap(kGapBelow * extent, searched, kAlike * extent);
  }
}

std::vector<NearContact> near_contacts(const World& world) {
  if (world.grid()) return {};
  const std::optional<NumberLattice> lattice = number_lattice(world);
  if (lattice && is_axis_parallel(world)) return {};
  const WorldParts parts = world.parts();
  const double extent = detail::extent(parts);
  const double unit = lattice && lattice->base == 10 ? lattice->unit() : 0;
  const auto found =
      detail::contacts_within(parts, std::max(kNear * extent, unit <= kLargestUnit * extent ? unit : 0), kShortShare);
  return {found.begin(), found.end()};
}

}  // namespace taut
