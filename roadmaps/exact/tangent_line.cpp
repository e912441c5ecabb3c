#include <taut/roadmaps/exact/tangent_line.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/written.h>

namespace taut {

TangentLine::TangentLine(const TangentEnd& from, const TangentEnd& to, double r)
    : from_(from), to_(to), r_(r), frame_(from, to, r) {
  const auto known = sign(frame_.R);
  if (!known) exact_ = std::make_unique<TangentFrame<Rational>>(from, to, r);
  exists_ = from.side == to.side || (known ? *known : sgn(exact_->R)) >= 0;
  S_ = root(frame_.R);
}

template <class Question>
int TangentLine::decide(Question question) const {
  const Surd<Interval> near = question(frame_);
  if (const auto known = sign(near.a + near.b * S_)) return *known;
  if (!exact_) exact_ = std::make_unique<TangentFrame<Rational>>(from_, to_, r_);
  const Surd<Rational> value = question(*exact_);
  return surd_sign(value.a, value.b, exact_->R);
}

int TangentLine::along(Point w) const {
  return decide([&](const auto& frame) { return frame.along(w); });
}

int TangentLine::left_over(Point w) const {
  return decide([&](const auto& frame) { return frame.left_over(w); });
}

int TangentLine::off(Point w) const {
  return decide([&](const auto& frame) { return frame.off(w, 0); });
}

int TangentLine::turn(Point w, Point v) const {
  return decide([&](const auto& frame) { return frame.turn(w, v); });
}

int TangentLine::onward(Point w, Point v) const {
  return decide([&](const auto& frame) { return frame.onward(w, v); });
}

bool TangentLine::clears_own(Point w, Point v, bool second) const {
  const int side = second ? to_.side : from_.side;
  // Outer tangents are parallel to d: an orientation, which grids need most.
  if (from_.side == to_.side) {
    const Point a = from_.centre, b = to_.centre;
    return side * (second ? written::orientation(b, v, a) : written::orientation(a, b, v)) >= 0;
  }
  return side * decide([&](const auto& frame) { return frame.across(w, v); }) >= 0;
}

bool TangentLine::clears_end(Point w) const {
  if ((from_.side != 0 && w == from_.centre) || (to_.side != 0 && w == to_.centre)) return true;
  const auto off_by = [&](int sides) {
    if (sides == from_.side && from_.side == to_.side) return written::orientation(from_.centre, to_.centre, w);
    return decide([&](const auto& frame) { return frame.off(w, sides); });
  };
  if (off_by(1) >= 0 || off_by(-1) <= 0) return true;
  if (along(w) <= 0) return decide([&](const auto& frame) { return frame.reach(w, false); }) >= 0;
  if (left_over(w) <= 0) return decide([&](const auto& frame) { return frame.reach(w, true); }) >= 0;
  return false;
}

bool TangentLine::tangent_point_clears(Point w, Point v, bool second) const {
  const TangentEnd& end = second ? to_ : from_;
  if (end.side != 0 && w == end.centre) return clears_own(w, v, second);
  if (end.side != 0 && v == end.centre) return clears_own(v, w, second);
  if (decide([&](const auto& frame) { return frame.foot(w, v, second, false); }) <= 0) return true;
  if (decide([&](const auto& frame) { return frame.foot(w, v, second, true); }) <= 0) return true;
  return decide([&](const auto& frame) { return frame.beside(w, v, second); }) >= 0;
}

bool TangentLine::clears(Point w, Point v) const {
  const auto beyond = [&](int sides) {
    const auto is_beyond = [&](Point p) {
      // A centre is a radius away from the line, exactly: no question for doubles.
      if ((sides == from_.side && p == from_.centre) || (sides == to_.side && p == to_.centre)) return true;
      if (sides == from_.side && from_.side == to_.side)
        return sides * written::orientation(from_.centre, to_.centre, p) >= 0;
      return sides * decide([&](const auto& frame) { return frame.off(p, sides); }) >= 0;
    };
    return is_beyond(w) && is_beyond(v);
  };
  if (beyond(1) || beyond(-1)) return true;
  if (!clears_end(w) || !clears_end(v)) return false;
  if (!tangent_point_clears(w, v, false) || !tangent_point_clears(w, v, true)) return false;
  if (off(w) * off(v) >= 0) return true;
  const int first = decide([&](const auto& frame) { return frame.side(w, v, false); });
  const int second = decide([&](const auto& frame) { return frame.side(w, v, true); });
  return first * second > 0;
}

bool TangentLine::leaves_by(Point w, Point v, bool solid_left) const {
  if (off(w) * off(v) >= 0) return false;
  const int first = decide([&](const auto& frame) { return frame.side(w, v, false); });
  const int second = decide([&](const auto& frame) { return frame.side(w, v, true); });
  const int solid = solid_left ? 1 : -1;
  return first * second < 0 || (first == 0 && second == solid) || (second == 0 && first == solid);
}

Box TangentLine::box(double from, double to) const {
  const double reach = 2.001 * r_;  // a tangent point is r from its centre
  const Point p = from_.centre, q = to_.centre;
  const double more = 1e-12 * (std::abs(p.x) + std::abs(p.y) + std::abs(q.x) + std::abs(q.y));
  const auto at = [&](double share) { return Point{p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)}; };
  const Point a = at(from), b = at(to);
  return {{std::min(a.x, b.x) - reach - more, std::min(a.y, b.y) - reach - more},
          {std::max(a.x, b.x) + reach + more, std::max(a.y, b.y) + reach + more}};
}

int TangentLine::pieces() const {
  const double x = std::abs(to_.centre.x - from_.centre.x), y = std::abs(to_.centre.y - from_.centre.y);
  return static_cast<int>(std::clamp(std::min(x, y) / (8 * r_), 1.0, 64.0));
}

}  // namespace taut
