#include <taut/roadmaps/exact/plain_tangent.h>

#include <array>
#include <cmath>
#include <span>
#include <utility>

#include <taut/geometry/written.h>
#include <taut/roadmaps/exact/plain_leg.h>

namespace taut {

namespace {

double cross(Point p, Point q) { return p.x * q.y - p.y * q.x; }

class PlainTangent {
 public:
  PlainTangent(const TangentWalls& walls, double r, const TangentSite& from, int s, const TangentSite& to, int t)
      : walls_(walls), from_(from), to_(to), s_(s), t_(t), r_(r) {
    const Point a = from.at, b = to.at, d{b.x - a.x, b.y - a.y};
    const double square = d.x * d.x + d.y * d.y, k = (t - s) * r, left = square - k * k;
    size_ = std::sqrt(square);
    // A root near zero magnifies what it is taken of.
    is_known_ = left > square * 0x1p-14;
    if (!is_known_) return;
    const double length = std::sqrt(left);
    const Point u{(length * d.x + k * d.y) / square, (length * d.y - k * d.x) / square};
    leg_ = {{a.x + s * r * u.y, a.y - s * r * u.x}, u, length};
    scale_ = std::abs(a.x) + std::abs(a.y) + std::abs(b.x) + std::abs(b.y) + r;
    slack_ = 0x1p-40 * scale_ * (1 + r / size_);
  }

  std::optional<bool> is_free() {
    if (!is_known_) return std::nullopt;
    if (!clears_own(from_, s_) || !clears_own(to_, t_) || !clears_walls()) return false;
    walls_.openings_meeting(box(0, 1), [&](std::uint32_t) { is_known_ = false; });
    if (!is_known_) return std::nullopt;
    return true;
  }

 private:
  bool is_outer() const { return s_ == t_ && s_ != 0; }

  /// As TangentLine::clears_own; not for sure where that is not known any more.
  bool clears_own(const TangentSite& site, int side) {
    if (side == 0) return true;
    for (const Point w : site.walls) {
      const Point f{w.x - site.at.x, w.y - site.at.y};
      const double value = side * cross(leg_.along, f), size = std::abs(f.x) + std::abs(f.y);
      const double sure = 0x1p-40 * scale_ * (1 + size / size_);
      if (value < -sure) return false;
      if (value > sure) continue;
      if (!is_outer())
        is_known_ = false;
      else if (side * (&site == &to_ ? written::orientation(to_.at, w, from_.at)
                                     : written::orientation(from_.at, to_.at, w)) <
               0)
        return false;
    }
    return true;
  }

  /// Do none of the walls near it come nearer than r? Those that end in a centre are asked elsewhere.
  bool clears_walls() {
    bool clear = true;
    const int pieces = static_cast<int>(
        std::clamp(std::min(std::abs(to_.at.x - from_.at.x), std::abs(to_.at.y - from_.at.y)) / (8 * r_), 1.0, 64.0));
    for (int i = 0; i < pieces && clear; ++i)
      walls_.walls().walls_meeting(box(double(i) / pieces, double(i + 1) / pieces), [&](std::uint32_t c) {
        if (!clear) return;
        const Segment wall = walls_.walls().segment(c);
        if (is_own(wall)) return;
        const int state = leg_.clears(wall.a, wall.b, r_ - slack_, r_ + slack_);
        if (state < 0) clear = false;
        if (state == 0 && !is_beyond(wall)) is_known_ = false;
      });
    return clear;
  }

  bool is_own(const Segment& wall) const {
    return (s_ != 0 && (wall.a == from_.at || wall.b == from_.at)) ||
           (t_ != 0 && (wall.a == to_.at || wall.b == to_.at));
  }
  /// On the other side of the line through both centres, which touches what an outer tangent's disc sweeps.
  bool is_beyond(const Segment& wall) const {
    return is_outer() && s_ * written::orientation(from_.at, to_.at, wall.a) >= 0 &&
           s_ * written::orientation(from_.at, to_.at, wall.b) >= 0;
  }

  Box box(double from, double to) const {
    const double reach = 2.001 * r_ + slack_;
    const Point a = from_.at, b = to_.at;
    const Point p{a.x + from * (b.x - a.x), a.y + from * (b.y - a.y)},
        q{a.x + to * (b.x - a.x), a.y + to * (b.y - a.y)};
    return {{std::min(p.x, q.x) - reach, std::min(p.y, q.y) - reach},
            {std::max(p.x, q.x) + reach, std::max(p.y, q.y) + reach}};
  }

  const TangentWalls& walls_;
  const TangentSite &from_, &to_;
  int s_, t_;
  double r_, size_ = 0, scale_ = 0, slack_ = 0;
  PlainLeg leg_;
  bool is_known_ = true;  // whether the leg is free, unless something in its way is found
};

}  // namespace

std::optional<bool> plainly_free(const TangentWalls& walls, double r, const TangentSite& from, int from_side,
                                 const TangentSite& to, int to_side) {
  return PlainTangent(walls, r, from, from_side, to, to_side).is_free();
}

}  // namespace taut
