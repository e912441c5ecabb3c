#include <taut/search/verify_arcs.h>

#include <fmt/format.h>
#include <taut/geometry/exact/numbers.h>

#include <cmath>
#include <memory>
#include <optional>

#include <taut/geometry/exact/exact_point.h>

namespace taut {

namespace {

/// a + b sqrt(c) with a c that all numbers of one question share.
struct QuadraticNumber {
  Rational a, b;
  const Rational* c;

  QuadraticNumber operator+(const QuadraticNumber& o) const { return {a + o.a, b + o.b, c}; }
  QuadraticNumber operator-(const QuadraticNumber& o) const { return {a - o.a, b - o.b, c}; }
  QuadraticNumber operator*(const QuadraticNumber& o) const { return {a * o.a + b * o.b * *c, a * o.b + b * o.a, c}; }
  int sign() const {
    if (sgn(*c) == 0 || sgn(b) == 0) return sgn(a);
    if (sgn(a) == 0 || sgn(a) == sgn(b)) return sgn(b);
    const Rational difference = a * a - b * b * *c;
    return sgn(difference) * sgn(a);
  }
};

struct ExactPosition {
  QuadraticNumber x, y;
  ExactPosition operator-(const ExactPosition& o) const { return {x - o.x, y - o.y}; }
};

QuadraticNumber dot(const ExactPosition& u, const ExactPosition& v) { return u.x * v.x + u.y * v.y; }
QuadraticNumber cross(const ExactPosition& u, const ExactPosition& v) { return u.x * v.y - u.y * v.x; }

struct End {
  Point at;
  int turn;
};

/// A leg with its tangent points, exactly.
class ExactLeg {
 public:
  ExactLeg(const End& p, const End& q, double r) : r2_(meaning(r) * meaning(r)) {
    const Rational dx = meaning(q.at.x) - meaning(p.at.x), dy = meaning(q.at.y) - meaning(p.at.y),
                   d2 = dx * dx + dy * dy;
    const Rational k = meaning(r) * (q.turn - p.turn);
    root_ = d2 - k * k;
    if (sgn(d2) == 0 || sgn(root_) < 0) return;
    const ExactPosition normal{QuadraticNumber{k * dx / d2, -dy / d2, &root_},
                               QuadraticNumber{k * dy / d2, dx / d2, &root_}};
    const auto touch = [&](const End& end) {
      const QuadraticNumber s = number(meaning(r) * end.turn), ex = number(meaning(end.at.x)),
                            ey = number(meaning(end.at.y));
      return ExactPosition{ex - s * normal.x, ey - s * normal.y};
    };
    from_ = touch(p);
    to_ = touch(q);
    exists_ = touches(p, *from_, r) && touches(q, *to_, r);
  }
  ExactLeg(const ExactLeg&) = delete;
  ExactLeg& operator=(const ExactLeg&) = delete;

  bool exists() const { return exists_; }
  const ExactPosition& from() const { return *from_; }
  const ExactPosition& to() const { return *to_; }
  const Rational& root() const { return root_; }
  ExactPosition place(Point p) const { return {number(meaning(p.x)), number(meaning(p.y))}; }
  QuadraticNumber number(const Rational& v) const { return {v, 0, &root_}; }

  bool keeps_away(const Segment& wall) const {
    const ExactPosition a = place(wall.a), b = place(wall.b);
    return far(a, *from_, *to_) && far(b, *from_, *to_) && far(*from_, a, b) && far(*to_, a, b) && !crosses(a, b);
  }
  /// Goes from one side of the segment's inside to the other, or into the wrong one.
  bool crosses_opening(const Constraint& c) const {
    const ExactPosition a = place(c.a), b = place(c.b);
    const int solid = c.solid_left ? 1 : -1;
    if (side(*from_, *to_, a) * side(*from_, *to_, b) >= 0) return false;
    const int s = side(a, b, *from_), t = side(a, b, *to_);
    return s * t < 0 || (s == 0 && t == solid) || (t == 0 && s == solid);
  }

 private:
  static int side(const ExactPosition& a, const ExactPosition& b, const ExactPosition& p) {
    return cross(b - a, p - a).sign();
  }
  bool crosses(const ExactPosition& a, const ExactPosition& b) const {
    return side(*from_, *to_, a) * side(*from_, *to_, b) < 0 && side(a, b, *from_) * side(a, b, *to_) < 0;
  }
  /// |p - segment a b| >= r.
  bool far(const ExactPosition& p, const ExactPosition& a, const ExactPosition& b) const {
    const ExactPosition u = b - a, v = p - a, w = p - b;
    const QuadraticNumber r2 = number(r2_);
    if (dot(u, v).sign() <= 0) return (dot(v, v) - r2).sign() >= 0;
    if (dot(u, w).sign() >= 0) return (dot(w, w) - r2).sign() >= 0;
    const QuadraticNumber area = cross(u, v);
    return (area * area - r2 * dot(u, u)).sign() >= 0;
  }
  /// The point is on the end's circle, the leg perpendicular to its radius, the centre on the right side.
  bool touches(const End& end, const ExactPosition& at, double) const {
    const ExactPosition radius = at - place(end.at), way = *to_ - *from_;
    if (end.turn == 0) return dot(radius, radius).sign() == 0;
    if ((dot(radius, radius) - number(r2_)).sign() != 0 || dot(radius, way).sign() != 0) return false;
    return sgn(root_) == 0 || cross(way, radius).sign() * end.turn < 0;
  }

  Rational r2_, root_;
  std::optional<ExactPosition> from_, to_;
  bool exists_ = false;
};

constexpr int kBits = 512;
struct Fine {
  BigFloat x, y;
};
BigFloat fine(double v) { return big_float(meaning(v), kBits); }
Fine fine(const ExactPosition& p) {
  const BigFloat root = sqrt(big_float(*p.x.c, kBits));
  return {big_float(p.x.a, kBits) + big_float(p.x.b, kBits) * root,
          big_float(p.y.a, kBits) + big_float(p.y.b, kBits) * root};
}

class Arc {
 public:
  Arc(const End& end, const ExactLeg& in, const ExactLeg& out, double r)
      : end_(end), in_(in), out_(out), r_(r), from_(fine(in.to())), to_(fine(out.from())) {
    for (Fine* p : {&from_, &to_}) {
      p->x -= fine(end.at.x);
      p->y -= fine(end.at.y);
    }
    const BigFloat together = from_.x * to_.x + from_.y * to_.y, t = big_float(end.turn, kBits);
    BigFloat mx = big_float(0, kBits), my = big_float(0, kBits);
    if (together > 0) {
      mx = from_.x + to_.x;
      my = from_.y + to_.y;
    } else {
      mx = t * (to_.y - from_.y);
      my = t * (from_.x - to_.x);
    }
    middle_x_ = Rational(mx);
    middle_y_ = Rational(my);
  }

  bool is_sound() const { return turn_from(middle_x_, middle_y_) > 0 && turn_to(middle_x_, middle_y_) > 0; }

  bool keeps_away(const Segment& wall) const {
    const Rational fx = meaning(wall.b.x) - meaning(wall.a.x), fy = meaning(wall.b.y) - meaning(wall.a.y);
    Rational x = meaning(wall.a.x) - meaning(end_.at.x), y = meaning(wall.a.y) - meaning(end_.at.y);
    Rational t = -(x * fx + y * fy) / (fx * fx + fy * fy);
    if (t < 0) t = 0;
    if (t > 1) t = 1;
    x += t * fx;
    y += t * fy;
    if (x * x + y * y >= 4 * meaning(r_) * meaning(r_)) return true;
    if (x == 0 && y == 0) {
      x = t == 0 ? fx : Rational(-fx);
      y = t == 0 ? fy : Rational(-fy);
    }
    return !passes(x, y);
  }

  bool crosses_opening(const Segment& s) const {
    const BigFloat ax = fine(s.a.x), ay = fine(s.a.y), r = fine(r_);
    const BigFloat x = ax - fine(end_.at.x), y = ay - fine(end_.at.y), fx = fine(s.b.x) - ax, fy = fine(s.b.y) - ay;
    const BigFloat F = fx * fx + fy * fy, half = (x * fx + y * fy) / F;
    const BigFloat disc = half * half - (x * x + y * y - r * r) / F;
    if (disc <= tiny()) return false;
    for (const int way : {-1, 1}) {
      const BigFloat at = -half + way * sqrt(disc);
      if (at <= tiny() || at >= 1 - tiny()) continue;
      const BigFloat px = x + at * fx, py = y + at * fy;
      const BigFloat after = end_.turn * (from_.x * py - from_.y * px), before = end_.turn * (px * to_.y - py * to_.x);
      if (after > tiny() && before > tiny()) return true;
    }
    return false;
  }

 private:
  static BigFloat tiny() { return big_float(fraction(1, power(10, 100)), kBits); }
  int turn_from(const Rational& x, const Rational& y) const {
    const ExactPosition radius = in_.to() - in_.place(end_.at);
    return end_.turn * cross(radius, {in_.number(x), in_.number(y)}).sign();
  }
  int turn_to(const Rational& x, const Rational& y) const {
    const ExactPosition radius = out_.from() - out_.place(end_.at);
    return end_.turn * cross({out_.number(x), out_.number(y)}, radius).sign();
  }
  /// Is the direction strictly within one of the halves, or the middle itself?
  bool passes(const Rational& x, const Rational& y) const {
    const int beside = end_.turn * sgn(Rational(middle_x_ * y - middle_y_ * x));
    const bool same = sgn(Rational(middle_x_ * x + middle_y_ * y)) > 0;
    if (beside == 0) return same;
    return beside > 0 ? turn_to(x, y) > 0 && (same || turn_from(x, y) >= 0)
                      : turn_from(x, y) > 0 && (same || turn_to(x, y) >= 0);
  }

  const End& end_;
  const ExactLeg& in_;
  const ExactLeg& out_;
  double r_;
  Fine from_, to_;
  Rational middle_x_, middle_y_;
};

std::string text(const Segment& s) { return fmt::format("({}, {}) to ({}, {})", s.a.x, s.a.y, s.b.x, s.b.y); }

/// Farther from all a piece can reach than doubles can err.
bool is_far(const Segment& s, Point p, Point q, double reach) {
  const double scale =
      std::abs(p.x) + std::abs(p.y) + std::abs(q.x) + std::abs(q.y) + std::abs(s.a.x) + std::abs(s.a.y);
  const double more = reach * 1.001 + 1e-9 * scale;
  return std::min(s.a.x, s.b.x) > std::max(p.x, q.x) + more || std::max(s.a.x, s.b.x) < std::min(p.x, q.x) - more ||
         std::min(s.a.y, s.b.y) > std::max(p.y, q.y) + more || std::max(s.a.y, s.b.y) < std::min(p.y, q.y) - more;
}

}  // namespace

ArcVerdict verify_arcs(const ArcPath& path, const Gates& gates, Point from, Point to) {
  const auto refuse = [](std::string reason) { return ArcVerdict{false, std::move(reason)}; };
  if (path.start != from || path.goal != to) return refuse("does not lead from start to goal");
  if (!(path.radius > 0) || !std::isfinite(path.radius)) return refuse("has no radius");
  const FreeSpace& space = gates.space();
  for (const Point p : {from, to})
    if (space.locate(p).kind == Location::Kind::outside) return refuse("has an end outside");
  const double r = path.radius;
  std::vector<End> ends{{from, 0}};
  for (const ArcBend& bend : path.bends) ends.push_back({bend.corner, bend.turn});
  ends.push_back({to, 0});
  const bool stays = ends.size() == 2 && from == to;
  std::vector<std::unique_ptr<ExactLeg>> legs;
  for (std::size_t i = 0; !stays && i + 1 < ends.size(); ++i) {
    legs.push_back(std::make_unique<ExactLeg>(ends[i], ends[i + 1], r));
    if (!legs.back()->exists()) return refuse(fmt::format("leg {} does not exist", i));
  }
  const auto& constraints = space.constraints();
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const bool bends = i > 0 && ends[i].turn != 0;
    const std::optional<Arc> arc =
        bends ? std::optional<Arc>(std::in_place, ends[i], *legs[i - 1], *legs[i], r) : std::nullopt;
    if (arc && !arc->is_sound()) return refuse(fmt::format("arc {} does not turn as it says", i - 1));
    for (std::uint32_t c = 0; c < constraints.size(); ++c) {
      const Segment s{constraints[c].a, constraints[c].b};
      if (is_far(s, ends[i].at, ends[i + 1].at, 2 * r)) continue;
      if (gates.is_opening(c)) {
        if (legs[i]->crosses_opening(constraints[c]) || (arc && arc->crosses_opening(s)))
          return refuse(fmt::format("piece {} crosses the opening {}", i, text(s)));
        continue;
      }
      if (!legs[i]->keeps_away(s)) return refuse(fmt::format("leg {} comes too near the wall {}", i, text(s)));
      if (arc && !arc->keeps_away(s)) return refuse(fmt::format("arc {} comes too near the wall {}", i - 1, text(s)));
    }
  }
  const Interval length = length_of(pieces(path));
  if (!(path.length.lo <= length.hi * (1 + 1e-9) && path.length.hi >= length.lo * (1 - 1e-9)))
    return refuse("is not as long as it says");
  return {true, {}};
}

}  // namespace taut
