#include <taut/geometry/detail/near_pairs.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/detail/implied_area.h>
#include <taut/geometry/detail/written_integers.h>
#include <taut/geometry/segment_distance.h>
#include <taut/geometry/written.h>

namespace taut::detail {

bool is_computed(Point p) {
  // Three places, which are as many as most numbers have, are told at once.
  const auto is_computed = [](double v) {
    if (std::abs(v) < 0x1p49 && v * 2 == std::floor(v * 2)) return false;  // halves, the same
    return std::isnan(integer_over(v, 3)) && !written::decimal(v);
  };
  return is_computed(p.x) || is_computed(p.y);
}

Foot foot(Point p, const Segment& s) {
  const double dx = s.b.x - s.a.x, dy = s.b.y - s.a.y, square = dx * dx + dy * dy;
  const double ax = p.x - s.a.x, ay = p.y - s.a.y, bx = p.x - s.b.x, by = p.y - s.b.y;
  const double from_a = ax * dx + ay * dy, from_b = -(bx * dx + by * dy);
  if (!(from_a > 0)) return {std::hypot(ax, ay), 0};
  if (!(from_b > 0)) return {std::hypot(bx, by), 1};
  // From the nearer end: fewer digits cancel.
  const double cross = from_a < from_b ? dx * ay - dy * ax : dx * by - dy * bx;
  return {std::abs(cross) / std::sqrt(square), from_a < from_b ? from_a / square : 1 - from_b / square};
}

bool is_within(const Foot& foot, Point p, const Segment& s, double reach) {
  const auto size = [](Point q) { return std::abs(q.x) + std::abs(q.y); };
  const double slack = 0x1p-50 * (size(p) + size(s.a) + size(s.b));
  if (foot.distance <= reach - slack) return true;
  return foot.distance <= reach + slack && segment_distance({p, p}, s) <= reach;
}

double extent(const WorldParts& parts) {
  Bounds bounds;
  for_each_place(parts, [&](Point p) { bounds.add(p); });
  if (bounds.empty()) return 0;
  const Box& b = bounds.box();
  return std::max(b.max.x - b.min.x, b.max.y - b.min.y);
}

NearPairs::NearPairs(const WorldParts& parts, std::span<const Point> ends) {
  for_each_place(parts, [&](Point p) { points_.push_back(p); });
  points_.insert(points_.end(), ends.begin(), ends.end());
  std::sort(points_.begin(), points_.end());
  points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  for (const Wall& wall : parts.walls)
    pieces_.push_back({number(wall.a), number(wall.b), 0, wall.thickness, wall.line});
  for_each_ring(parts, [&](const Ring& ring, std::uint32_t area, int line) { add_ring(ring, area, line); });

  first_.assign(points_.size() + 1, 0);
  for (const Piece& piece : pieces_)
    for (const std::uint32_t end : {piece.a, piece.b}) ++first_[end + 1];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  around_.resize(2 * pieces_.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  std::vector<Box> boxes;
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    for (const std::uint32_t end : {pieces_[i].a, pieces_[i].b}) around_[next[end]++] = i;
    boxes.push_back(box_around(points_[pieces_[i].a], points_[pieces_[i].b]));
  }
  index_ = BoxIndex(std::move(boxes));
  for (const Point p : points_) computed_.push_back(detail::is_computed(p));
}

void NearPairs::add_ring(const Ring& ring, std::uint32_t area, int line) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    pieces_.push_back({number(ring[i]), number(ring[(i + 1) % ring.size()]), area, 0, line});
}

std::uint32_t NearPairs::number(Point p) const {
  return static_cast<std::uint32_t>(std::lower_bound(points_.begin(), points_.end(), p) - points_.begin());
}

bool NearPairs::any_computed() const { return std::find(computed_.begin(), computed_.end(), true) != computed_.end(); }

double NearPairs::thickness(std::uint32_t point) const {
  double most = 0;
  for (const std::uint32_t piece : around(point)) most = std::max(most, pieces_[piece].thickness);
  return most;
}

}  // namespace taut::detail
