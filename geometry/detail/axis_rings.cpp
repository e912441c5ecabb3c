#include <taut/geometry/detail/axis_rings.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <taut/geometry/detail/radix_sort.h>
#include <taut/geometry/detail/rank_set.h>

namespace taut::detail {

namespace {

constexpr double kLimit = 1 << 30;

/// A corner and where its two sides go, as bits: 1 to the east, 2 to the north, 4 to the west, 8 to the south.
struct RingCorner {
  std::uint64_t key;  // y above x, counted from the least
  std::uint32_t ring;
  std::uint8_t sides;
  std::int8_t turn;  // of the side to the north: winding number to the left less that to the right
};
constexpr std::uint8_t kEast = 1, kNorth = 2, kWest = 4, kSouth = 8;

bool is_small_integer(double v) {
  return std::abs(v) < kLimit && v == static_cast<double>(static_cast<std::int32_t>(v));
}

/// 0 where a side is sloped or has no length.
std::uint8_t side_towards(Point from, Point to) {
  if (from.y == to.y) return from.x < to.x ? kEast : from.x > to.x ? kWest : 0;
  if (from.x != to.x) return 0;
  return from.y < to.y ? kNorth : kSouth;
}

__extension__ typedef __int128 Int128;  // NOLINT(modernize-use-using): pedantic compilers take no other

/// Of rings that cross themselves anything.
bool turns_left(const Ring& ring) {
  Int128 area = 0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    area += static_cast<std::int64_t>(ring[j].x + ring[i].x) * static_cast<std::int64_t>(ring[i].y - ring[j].y);
  return area > 0;
}

class Check {
 public:
  explicit Check(const Polygon& polygon) : polygon_(polygon) {}

  bool run() {
    if (!measure() || !add(polygon_.outer, 0)) return false;
    for (std::uint32_t i = 0; i < polygon_.holes.size(); ++i)
      if (!add(polygon_.holes[i], i + 1)) return false;
    radix_sort(corners_, width_ + bits_of(rows_), [](const RingCorner& c) { return c.key; });
    return sweep();
  }

 private:
  bool measure() {
    if (polygon_.outer.size() < 4) return false;
    least_ = most_ = polygon_.outer.front();
    const auto see = [&](const Ring& ring) {
      return std::all_of(ring.begin(), ring.end(), [&](Point p) {
        least_ = {std::min(least_.x, p.x), std::min(least_.y, p.y)};
        most_ = {std::max(most_.x, p.x), std::max(most_.y, p.y)};
        return is_small_integer(p.x) && is_small_integer(p.y);
      });
    };
    if (!see(polygon_.outer) || !std::all_of(polygon_.holes.begin(), polygon_.holes.end(), see)) return false;
    columns_ = static_cast<std::uint64_t>(most_.x - least_.x);
    rows_ = static_cast<std::uint64_t>(most_.y - least_.y);
    width_ = bits_of(columns_);
    if (columns_ >= 1 << 16 || (std::uint64_t{1} << width_) * rows_ > std::uint64_t{1} << 62) return false;
    active_ = RankSet(columns_ + 2);
    right_.assign(columns_ + 2, 0);
    return true;
  }

  bool add(const Ring& ring, std::uint32_t number) {
    if (ring.size() < 4) return false;
    // Free space lies to the left of every ring.
    const bool turned = turns_left(ring) != (number == 0);
    for (std::size_t i = 0, h = ring.size() - 1; i < ring.size(); h = i++) {
      const Point p = ring[i], q = ring[i + 1 == ring.size() ? 0 : i + 1];
      const std::uint8_t in = side_towards(p, ring[h]), out = side_towards(p, q);
      if (in == 0 || out == 0 || in == out) return false;
      const int turn = out == kNorth ? 1 : in == kNorth ? -1 : 0;
      corners_.push_back(
          {static_cast<std::uint64_t>(p.y - least_.y) << width_ | static_cast<std::uint64_t>(p.x - least_.x), number,
           static_cast<std::uint8_t>(in | out), static_cast<std::int8_t>(turned ? -turn : turn)});
    }
    return true;
  }

  /// Rings that touch at a corner, neither crossing the other, as one; false for all other contacts.
  static bool touch(RingCorner& c, const RingCorner& d) {
    const bool straight = c.sides == (kEast | kWest) || c.sides == (kNorth | kSouth);
    if (c.ring == d.ring || (c.sides & d.sides) != 0 || straight) return false;
    c.sides |= d.sides;
    c.turn = static_cast<std::int8_t>(c.turn + d.turn);
    return true;
  }

  bool sweep() {
    active_.insert(0);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      RingCorner c = corners_[i];
      const auto is_next_here = [&] { return i + 1 < corners_.size() && corners_[i + 1].key == c.key; };
      if (is_next_here() && !touch(c, corners_[++i])) return false;
      if (is_next_here() || !pass(c)) return false;
    }
    return true;
  }

  bool pass(const RingCorner& c) {
    const auto x = 1 + static_cast<std::uint32_t>(c.key & ((std::uint64_t{1} << width_) - 1));
    if (active_.contains(x) != ((c.sides & kSouth) != 0)) return false;
    const std::uint32_t left = active_.before(x);
    // A side from the west comes from the corner before, over no other side.
    if (((c.sides & kWest) != 0) != came_east_ || (came_east_ && left > last_x_)) return false;
    came_east_ = (c.sides & kEast) != 0;
    last_x_ = x;
    if (c.sides & kSouth) active_.erase(x);
    if (!(c.sides & kNorth)) return true;
    active_.insert(x);
    const int winding = right_[left] - c.turn;
    right_[x] = static_cast<std::int8_t>(winding);
    return winding == 0 || winding == 1;
  }

  const Polygon& polygon_;
  Point least_, most_;
  std::uint64_t columns_ = 0, rows_ = 0;
  int width_ = 0;
  std::vector<RingCorner> corners_;
  RankSet active_{1};               // upright sides that the line crosses
  std::vector<std::int8_t> right_;  // the winding number right of them
  bool came_east_ = false;          // a side leaves the last corner to the east
  std::uint32_t last_x_ = 0;
};

}  // namespace

bool is_surely_regular(const Polygon& polygon) { return Check(polygon).run(); }

}  // namespace taut::detail
