#include <taut/geometry/detail/snapper.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include <taut/geometry/detail/near_pairs.h>
#include <taut/geometry/segment_distance.h>
#include <taut/geometry/triangulation.h>
#include <taut/geometry/written.h>

namespace taut::detail {

namespace {

class Snapper {
 public:
  Snapper(const WorldParts& parts, const Joining& joining, std::span<const Point> ends)
      : joining_(joining),
        pairs_(parts, ends),
        fixed_(pairs_.points().size(), false),
        target_(pairs_.points().size(), kNone) {
    for (const Point p : ends) fixed_[number(p)] = true;
  }

  SnappedParts run(WorldParts parts) {
    join_ends();
    gather();
    pass_through();
    if (joining_.reach > 0) list_remaining(parts);
    if (report_.joined > 0) rebuild(parts);
    return {std::move(parts), std::move(report_)};
  }

 private:
  const std::vector<Point>& points() const { return pairs_.points(); }
  std::uint32_t number(Point p) const {
    return static_cast<std::uint32_t>(std::lower_bound(points().begin(), points().end(), p) - points().begin());
  }
  Point moved(std::uint32_t p) const { return points()[target_[p]]; }

  /// The reach of an end: walls do not come to start and goal from farther than rounding.
  double reach_of(std::uint32_t p) const {
    return fixed_[p] ? joining_.rounding : std::max(joining_.reach, joining_.rounding);
  }

  /// May p be joined to s? `computed`: is there such a number among their ends?
  bool is_near(std::uint32_t p, const Foot& foot, const Segment& s, bool computed) const {
    const double reach = fixed_[p] ? 0 : joining_.reach;
    const double most = computed ? std::max(reach, joining_.rounding) : reach;
    return most > 0 && is_within(foot, points()[p], s, most);
  }

  void count(std::uint32_t p, const Segment& s) {
    ++report_.joined;
    report_.displacement = std::max(report_.displacement, segment_distance({points()[p], points()[p]}, s));
  }

  /// Every end gets a target: itself or an end within reach that is its own target. Fixed ones first, then those with
  /// the most others within reach, then what was written: those stay.
  void join_ends() {
    std::vector<std::uint32_t> order(points().size());
    std::vector<std::tuple<bool, std::size_t, bool>> rank(points().size());
    for (std::uint32_t p = 0; p < order.size(); ++p) {
      order[p] = p;
      std::size_t others = 0;
      if (joining_.reach > 0 && !fixed_[p]) others = count_near(p);
      rank[p] = {!fixed_[p], points().size() - others, pairs_.is_computed(p)};
    }
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t p, std::uint32_t q) { return rank[p] < rank[q]; });
    for (const std::uint32_t p : order) {
      if (target_[p] != kNone) continue;
      target_[p] = p;
      pairs_.near(points()[p], reach_of(p), [&](std::uint32_t i) {
        for (const std::uint32_t q : {pairs_.pieces()[i].a, pairs_.pieces()[i].b}) join(p, q);
      });
    }
  }

  /// Ends of walls and sides, each as often as one ends there.
  std::size_t count_near(std::uint32_t p) const {
    std::size_t count = 0;
    pairs_.near(points()[p], joining_.reach, [&](std::uint32_t i) {
      const Segment s = pairs_.segment(i);
      for (const Point q : {s.a, s.b})
        count += is_within(detail::foot(points()[p], {q, q}), points()[p], {q, q}, joining_.reach);
    });
    return count;
  }

  void join(std::uint32_t p, std::uint32_t q) {
    if (target_[q] != kNone || fixed_[q]) return;
    const Segment at{points()[q], points()[q]};
    const Foot foot = detail::foot(points()[p], at);
    if (!is_near(p, foot, at, pairs_.is_computed(p) || pairs_.is_computed(q))) return;
    if (covers(std::max(pairs_.thickness(p), pairs_.thickness(q)), foot.distance) || are_joined_by_a_piece(p, q))
      return;
    if (joining_.polygons_apart && share_a_polygon(pairs_.around(p), pairs_.around(q))) return;
    target_[q] = p;
    count(p, at);
  }

  bool are_joined_by_a_piece(std::uint32_t p, std::uint32_t q) const {
    const auto around = pairs_.around(p);
    return std::any_of(around.begin(), around.end(),
                       [&](std::uint32_t i) { return pairs_.pieces()[i].a == q || pairs_.pieces()[i].b == q; });
  }

  bool share_a_polygon(std::span<const std::uint32_t> s, std::span<const std::uint32_t> t) const {
    for (const std::uint32_t i : s)
      for (const std::uint32_t j : t)
        if (pairs_.pieces()[i].area != 0 && pairs_.pieces()[i].area == pairs_.pieces()[j].area) return true;
    return false;
  }

  /// What the ends that became one have between them.
  void gather() {
    computed_.assign(points().size(), false);
    thickness_.assign(points().size(), 0);
    members_.resize(points().size());
    for (std::uint32_t p = 0; p < points().size(); ++p) {
      const std::uint32_t to = target_[p];
      if (pairs_.is_computed(p)) computed_[to] = true;
      thickness_[to] = std::max(thickness_[to], pairs_.thickness(p));
      if (joining_.polygons_apart)
        members_[to].insert(members_[to].end(), pairs_.around(p).begin(), pairs_.around(p).end());
    }
  }

  /// A piece that has to pass through a target.
  struct Bend {
    std::uint32_t piece;
    double along;
    std::uint32_t through;
    bool exact;

    friend bool operator<(const Bend& a, const Bend& b) {
      return std::tie(a.piece, a.along, a.through) < std::tie(b.piece, b.along, b.through);
    }
  };

  void pass_through() {
    for (std::uint32_t p = 0; p < points().size(); ++p)
      if (target_[p] == p) pairs_.near(points()[p], reach_of(p), [&](std::uint32_t i) { pass_through(p, i); });
    std::sort(bends_.begin(), bends_.end());
  }

  void pass_through(std::uint32_t p, std::uint32_t i) {
    const Piece& piece = pairs_.pieces()[i];
    if (target_[piece.a] == p || target_[piece.b] == p) return;
    const Segment s = pairs_.segment(i);
    const Foot foot = detail::foot(points()[p], s);
    const bool exact = written::on_segment(points()[p], s.a, s.b);
    if (!exact) {
      if (foot.along == 0 || foot.along == 1) return;
      const bool computed = computed_[p] || pairs_.is_computed(piece.a) || pairs_.is_computed(piece.b);
      if (!is_near(p, foot, s, computed)) return;
      if (covers(std::max(piece.thickness, thickness_[p]), foot.distance)) return;
      if (joining_.polygons_apart && share_a_polygon(members_[p], {&i, 1})) return;
      count(p, s);
    }
    bends_.push_back({i, foot.along, p, exact});
  }

  /// What was near enough, but would have had to move farther; where its end is now.
  void list_remaining(const WorldParts& parts) {
    for (const NumberedContact& contact : contacts_within(parts, joining_.reach, 0)) {
      const std::uint32_t to = target_[number(contact.end)];
      const Piece& piece = pairs_.pieces()[contact.piece];
      const auto [first, last] = std::equal_range(bends_.begin(), bends_.end(), Bend{contact.piece, 0, 0, false},
                                                  [](const Bend& a, const Bend& b) { return a.piece < b.piece; });
      const bool passes = std::any_of(first, last, [&](const Bend& bend) { return bend.through == to; });
      if (!passes && target_[piece.a] != to && target_[piece.b] != to) {
        report_.remaining.push_back(contact);
        report_.remaining.back().end = points()[to];
      }
    }
  }

  /// Calls emit(p) for every point of piece i from its first end to its last. Ends that lie on it exactly are among
  /// them only where it no longer is the straight line that it was.
  template <typename Emit>
  void follow(std::uint32_t i, Emit&& emit) {
    const Piece& piece = pairs_.pieces()[i];
    const std::size_t first = next_;
    bool straight = target_[piece.a] == piece.a && target_[piece.b] == piece.b;
    for (; next_ < bends_.size() && bends_[next_].piece == i; ++next_) straight = straight && bends_[next_].exact;
    emit(moved(piece.a));
    if (!straight)
      for (std::size_t k = first; k < next_; ++k) emit(points()[bends_[k].through]);
    emit(moved(piece.b));
  }

  void rebuild(WorldParts& parts) {
    std::uint32_t i = 0;
    std::vector<Wall> walls;
    for (const Wall& wall : parts.walls) {
      std::vector<Point> chain;
      follow(i++, [&](Point p) { chain.push_back(p); });
      for (std::size_t k = 1; k < chain.size(); ++k)
        if (chain[k - 1] != chain[k] || (chain.size() == 2 && (wall.a == wall.b || wall.thickness > 0)))
          walls.push_back({chain[k - 1], chain[k], wall.thickness, wall.line});
    }
    parts.walls = std::move(walls);
    for_each_ring(parts, [&](Ring& ring, std::uint32_t, int) {
      Ring bent;
      const std::size_t sides = ring.size();
      for (std::size_t k = 0; k < sides; ++k)
        follow(i++, [&](Point p) {
          if (bent.empty() || bent.back() != p) bent.push_back(p);
        });
      if (bent.size() > 1 && bent.front() == bent.back()) bent.pop_back();
      ring = std::move(bent);
    });
  }

  Joining joining_;
  NearPairs pairs_;
  std::vector<bool> fixed_;
  std::vector<std::uint32_t> target_;
  std::vector<bool> computed_;  // of targets
  std::vector<double> thickness_;
  std::vector<std::vector<std::uint32_t>> members_;
  std::vector<Bend> bends_;
  std::size_t next_ = 0;
  SnapReport report_;
};

}  // namespace

SnappedParts joined(WorldParts parts, const Joining& joining, std::span<const Point> ends) {
  Snapper snapper(parts, joining, ends);
  return snapper.run(std::move(parts));
}

}  // namespace taut::detail
