#include <taut/robots/car/verify_drive.h>

#include <taut/geometry/exact/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <taut/geometry/text.h>
#include <taut/roadmaps/wall_index.h>

namespace taut::car {

namespace {

/// c[0] + c[1] t + c[2] t^2
struct Quadratic {
  std::array<Rational, 3> c;

  friend Quadratic operator+(Quadratic a, const Quadratic& b) {
    for (std::size_t i = 0; i < 3; ++i) a.c[i] += b.c[i];
    return a;
  }
  friend Quadratic operator*(const Rational& k, Quadratic a) {
    for (Rational& x : a.c) x *= k;
    return a;
  }
  friend Quadratic operator-(const Quadratic& a, const Quadratic& b) { return a + Rational(-1) * b; }
};

/// p + q sqrt(d)
struct Surd {
  Rational p, q, d;

  int sign() const {
    const int a = sgn(p), b = sgn(d) == 0 ? 0 : sgn(q);
    if (a == b || b == 0) return a;
    if (a == 0) return b;
    const Rational rest = p * p - q * q * d;
    return sgn(rest) * a;
  }
};

Surd value(const Quadratic& f, const Surd& t) {
  const Rational square = t.p * t.p + t.q * t.q * t.d;
  return {f.c[0] + f.c[1] * t.p + f.c[2] * square, t.q * (f.c[1] + 2 * f.c[2] * t.p), t.d};
}

/// The sign right after t.
int sign_after(const Quadratic& f, const Surd& t) {
  if (const int s = value(f, t).sign(); s != 0) return s;
  const Rational twice = 2 * f.c[2];
  if (const int s = Surd{f.c[1] + twice * t.p, twice * t.q, t.d}.sign(); s != 0) return s;
  return sgn(f.c[2]);
}

/// Adds the roots in [0, end).
void add_roots(const Quadratic& f, const Rational& end, std::vector<Surd>& roots) {
  const auto add = [&](Surd t) {
    if (t.sign() >= 0 && Surd{end - t.p, -t.q, t.d}.sign() > 0) roots.push_back(std::move(t));
  };
  if (sgn(f.c[2]) == 0) {
    if (sgn(f.c[1]) != 0) add({-f.c[0] / f.c[1], 0, 0});
    return;
  }
  const Rational d = f.c[1] * f.c[1] - 4 * f.c[2] * f.c[0];
  if (sgn(d) < 0) return;
  const Rational by = 1 / (2 * f.c[2]);
  for (const int side : {-1, 1}) add({-f.c[1] * by, side * by, d});
}

struct ExactVector {
  Rational x, y;
};
ExactVector operator-(const ExactVector& a, const ExactVector& b) { return {a.x - b.x, a.y - b.y}; }
ExactVector operator+(const ExactVector& a, const ExactVector& b) { return {a.x + b.x, a.y + b.y}; }
ExactVector times(const Rational& k, const ExactVector& a) { return {k * a.x, k * a.y}; }
Rational inner(const ExactVector& a, const ExactVector& b) { return a.x * b.x + a.y * b.y; }
Rational outer(const ExactVector& a, const ExactVector& b) { return a.x * b.y - a.y * b.x; }
ExactVector turned(const ExactVector& a) { return {-a.y, a.x}; }
ExactVector place(Point p) { return {p.x, p.y}; }
ExactVector direction(int heading) {
  const HeadingVector h = heading_vector(heading);
  return {Rational(h.x) / kHeadingScale, Rational(h.y) / kHeadingScale};
}

/// A motion from t = 0 to `end`: a point X of the plane is, in the frame of the first pose, at X(t) = (x0 + x1 t + x2
/// t^2) / weight, and a point of the car goes the other way round.
struct Piece {
  ExactVector at, along;  ///< the first pose
  Rational end;
  bool straight = true;
  ExactVector pivot;  ///< of an arc
  int sense = 0;      ///< of a straight piece: of the gear

  Quadratic weight() const { return {{1, 0, straight ? 0 : 1}}; }

  /// The motion of a point for t, or against it, times the weight.
  std::pair<Quadratic, Quadratic> moved(const ExactVector& p, int way) const {
    if (straight) {
      const ExactVector d = times(Rational(way * sense), along);
      return {{{p.x, d.x, 0}}, {{p.y, d.y, 0}}};
    }
    // (1 - t^2, 2 t) / (1 + t^2) is the cosine and the sine.
    const ExactVector r = p - pivot, q = times(Rational(2 * way * sense), turned(r));
    return {{{pivot.x + r.x, q.x, pivot.x - r.x}}, {{pivot.y + r.y, q.y, pivot.y - r.y}}};
  }
};

/// The conditions of one separating line: apart where all are >= 0.
using Line = std::vector<Quadratic>;

std::vector<Line> lines_of(const Piece& piece, const CarShape& shape, const Segment& wall) {
  const Quadratic weight = piece.weight();
  const ExactVector left = turned(piece.along);
  std::vector<Line> lines(6);
  for (const Point end : {wall.a, wall.b}) {
    const std::pair<Quadratic, Quadratic> moved = piece.moved(place(end), -1);
    const auto along = [&](const ExactVector& axis) {
      return axis.x * moved.first + axis.y * moved.second - inner(axis, piece.at) * weight;
    };
    const Quadratic ahead = along(piece.along), aside = along(left);
    const Rational front(shape.front), back(shape.back), half(shape.half_width);
    lines[0].push_back(ahead - front * weight);
    lines[1].push_back(Rational(-1) * (ahead + back * weight));
    lines[2].push_back(aside - half * weight);
    lines[3].push_back(Rational(-1) * (aside + half * weight));
  }
  const ExactVector a = place(wall.a), d = place(wall.b) - a;
  for (const double along : {shape.front, -shape.back})
    for (const double aside : {shape.half_width, -shape.half_width}) {
      const ExactVector corner = piece.at + times(Rational(along), piece.along) + times(Rational(aside), left);
      const auto [x, y] = piece.moved(corner, 1);
      const Quadratic side = d.x * y - d.y * x - outer(d, a) * weight;
      lines[4].push_back(side);
      lines[5].push_back(Rational(-1) * side);
    }
  return lines;
}

/// Is there a t in [0, end] at which, for each line, some condition is < 0?
bool is_met(const std::vector<Line>& lines, const Rational& end) {
  std::vector<Surd> times{{0, 0, 0}};
  for (const Line& line : lines)
    for (const Quadratic& f : line) add_roots(f, end, times);
  const bool moves = sgn(end) > 0;
  return std::ranges::any_of(times, [&](const Surd& t) {
    return std::ranges::all_of(lines, [&](const Line& line) {
      return std::ranges::any_of(
          line, [&](const Quadratic& f) { return (moves ? sign_after(f, t) : value(f, t).sign()) < 0; });
    });
  });
}

std::vector<Piece> pieces_of(const Leg& leg) {
  const int gear = leg.backward ? -1 : 1;
  const ExactVector from = place(leg.from.at), to = place(leg.to.at), u = direction(leg.from.heading),
                    v = direction(leg.to.heading);
  const Rational sine = outer(u, v), cosine = inner(u, v);
  std::vector<Piece> pieces;
  const auto add_straight = [&](const ExactVector& at, const ExactVector& along, const Rational& length) {
    pieces.push_back({at, along, length, true, {}, gear});
  };
  if (sgn(sine) == 0) {
    add_straight(from, u, abs(inner(to - from, u)));
    return pieces;
  }
  // The tangents meet x before the arc's line and y after it; the arc uses up the shorter one.
  const Rational x = gear * outer(to - from, v) / sine, y = gear * outer(u, to - from) / sine;
  const Rational used = std::min(x, y), half = abs(sine) / (1 + cosine), radius = used / half;
  const int sense = sgn(sine);
  const ExactVector begin = from + times(Rational(gear * (x - used)), u);
  const ExactVector pivot = begin + times(Rational(sense * gear * radius), turned(u));
  if (x > used) add_straight(from, u, x - used);
  pieces.push_back({begin, u, half, false, pivot, sense});
  if (y > used) add_straight(to - times(Rational(gear * (y - used)), v), v, y - used);
  return pieces;
}

/// Does the reference point get across the opening? It is beyond its line, and beside neither end.
bool crosses(const Leg& leg, const Segment& opening, bool solid_left) {
  for (const Piece& piece : pieces_of(leg)) {
    const auto [x, y] = piece.moved(piece.at, 1);
    const Quadratic weight = piece.weight();
    const ExactVector a = place(opening.a), b = place(opening.b), d = b - a;
    const Quadratic left = d.x * y - d.y * x - outer(d, a) * weight;
    const Quadratic after_a = d.x * x + d.y * y - inner(d, a) * weight;
    const Quadratic after_b = d.x * x + d.y * y - inner(d, b) * weight;
    const Rational minus(-1);
    if (is_met({{solid_left ? minus * left : left}, {minus * after_a}, {after_b}}, piece.end)) return true;
  }
  return false;
}

/// May anything of the leg be near the box around the segment?
bool is_near(const Leg& leg, double reach, const Segment& s) {
  const auto apart = [reach](double a, double b, double c, double d) {
    return std::min(a, b) - reach > std::max(c, d) || std::max(a, b) + reach < std::min(c, d);
  };
  return !apart(leg.from.at.x, leg.to.at.x, s.a.x, s.b.x) && !apart(leg.from.at.y, leg.to.at.y, s.a.y, s.b.y);
}

std::optional<DriveFault> verify_leg(const Leg& leg, std::size_t index, const FreeSpace& space,
                                     const taut::WallIndex& walls, const CarShape& shape) {
  if (const auto fault = validate(leg, shape)) return DriveFault{index, *fault};
  for (const Point p : {leg.from.at, leg.to.at})
    if (space.locate(p).kind == Location::Kind::outside)
      return DriveFault{index, "leaves free space at " + taut::text(p)};
  const double reach = 1.01 * (curve_of(leg).length() + shape.outer_radius());
  for (std::uint32_t c = 0; c < space.constraints().size(); ++c) {
    const Constraint& wall = space.constraints()[c];
    const Segment s{wall.a, wall.b};
    if (!is_near(leg, reach, s)) continue;
    if (walls.is_opening(c) ? crosses(leg, s, wall.solid_left) : drive_meets(leg, shape, s))
      return DriveFault{index,
                        (walls.is_opening(c) ? "leaves through the opening " : "meets the wall ") + taut::text(s), c};
  }
  return std::nullopt;
}

}  // namespace

std::optional<DriveFault> verify_drive(std::span<const Leg> legs, const FreeSpace& space, const CarShape& shape) {
  const taut::WallIndex walls(space);
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (i > 0 && legs[i].from != legs[i - 1].to) return DriveFault{i, "does not begin where the one before ends"};
    if (auto fault = verify_leg(legs[i], i, space, walls, shape)) return fault;
  }
  return std::nullopt;
}

bool drive_meets(const Leg& leg, const CarShape& shape, const Segment& wall) {
  return std::ranges::any_of(pieces_of(leg),
                             [&](const Piece& piece) { return is_met(lines_of(piece, shape, wall), piece.end); });
}

bool stand_meets(const LatticePose& pose, const CarShape& shape, const Segment& wall) {
  const Piece piece{place(pose.at), direction(pose.heading), 0, true, {}, 1};
  return is_met(lines_of(piece, shape, wall), piece.end);
}

}  // namespace taut::car
