#include <taut/search/arc_path.h>

#include <algorithm>
#include <cmath>

#include <taut/roadmaps/exact/tangent_circle.h>

namespace taut {

namespace {

/// The tangent point on the first end's circle.
Point touched(const TangentPoint& at, double r) {
  const Point c = at.here.centre;
  if (at.here.side == 0) return c;
  return {c.x + r * at.x.middle(), c.y + r * at.y.middle()};
}

/// From a circle's centre to the leg, whose normal v is of.
Interval turned(const Interval& v, int side) { return side == 0 ? Interval(0) : side > 0 ? -v : v; }

Interval not_negative(const Interval& range) { return {std::max(0.0, range.lo), range.hi}; }

ArcPiece arc(const ArcBend& bend, const TangentPoint& in, const TangentPoint& out, double r) {
  ArcPiece piece{touched(in, r), touched(out, r), bend.turn, bend.corner, 0, 0, {}};
  const Interval angle = angle_between(in, out);
  piece.from_angle = std::atan2(in.y.middle(), in.x.middle());
  piece.sweep = angle.middle();
  piece.length = not_negative(Interval(r) * angle);
  return piece;
}

}  // namespace

std::vector<ArcPiece> pieces(const ArcPath& path) {
  const double r = path.radius;
  std::vector<ArcPiece> result;
  if (path.start == path.goal && path.bends.empty()) return result;
  std::vector<TangentEnd> ends{{path.start, 0}};
  for (const ArcBend& bend : path.bends) ends.push_back({bend.corner, bend.turn});
  ends.push_back({path.goal, 0});
  std::optional<TangentPoint> arrived;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const TangentEnd &from = ends[i], &to = ends[i + 1];
    const TangentFrame<Interval> frame(from, to, r);
    const Interval length = root(frame.R);
    // The line's normal, to its left.
    const Interval x = (frame.k * frame.dx - length * frame.dy) / frame.D,
                   y = (frame.k * frame.dy + length * frame.dx) / frame.D;
    const TangentPoint leaves(from, to, r, turned(x, from.side), turned(y, from.side));
    const TangentPoint arrives({to.centre, -to.side}, {from.centre, -from.side}, r, turned(x, to.side),
                               turned(y, to.side));
    if (from.side != 0) result.push_back(arc(path.bends[i - 1], *arrived, leaves, r));
    result.push_back({touched(leaves, r), touched(arrives, r), 0, {}, 0, 0, not_negative(length)});
    arrived = arrives;
  }
  return result;
}

Interval length_of(const std::vector<ArcPiece>& pieces) {
  Interval sum(0);
  for (const ArcPiece& piece : pieces) sum = sum + Interval(piece.length.lo, piece.length.hi);
  return not_negative(sum);
}

std::vector<Point> sampled(const ArcPath& path, double tolerance) {
  std::vector<Point> result{path.start};
  const auto add = [&](Point p) {
    if (result.back() != p) result.push_back(p);
  };
  const double step = 2 * std::acos(std::clamp(1 - tolerance / path.radius, 0.0, 1.0));
  for (const ArcPiece& piece : pieces(path)) {
    if (piece.turn != 0) {
      const double parts = std::clamp(std::ceil(piece.sweep / step), 1.0, 65536.0);
      for (double k = 1; k < parts; ++k) {
        const double angle = piece.from_angle + piece.turn * piece.sweep * (k / parts);
        add({piece.centre.x + path.radius * std::cos(angle), piece.centre.y + path.radius * std::sin(angle)});
      }
    }
    add(piece.to);
  }
  return result;
}

}  // namespace taut
