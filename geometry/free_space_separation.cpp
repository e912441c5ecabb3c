
#include <taut/geometry/detail/free_space_impl.h>
#include <taut/geometry/expects.h>
#include <taut/geometry/predicates.h>
#include <taut/geometry/written.h>

namespace taut {

namespace {

using Tri = Triangulation;

/// One closed walk along the constraints that bound a component.
struct Loop {
  std::vector<std::uint32_t> pieces;
  Ring ring;  // the starts of the sides walked along
};

/// The loops around a component of free triangles.
class Loops {
 public:
  Loops(const Tri& tri, const std::vector<std::uint32_t>& piece_of, const std::vector<std::uint32_t>& component)
      : tri_(tri), piece_of_(piece_of), component_(component), done_(piece_of.size(), false) {}

  std::vector<Loop> around(std::uint32_t component) {
    std::vector<Loop> loops;
    for (std::uint32_t t = 0; t < tri_.triangles.size(); ++t)
      for (int i = 0; i < 3; ++i)
        if (component_[t] == component && piece_of_[3 * t + i] != kNone && !done_[3 * t + i])
          loops.push_back(trace(t, i));
    return loops;
  }

 private:
  Loop trace(std::uint32_t t, int i) {
    Loop loop;
    while (!done_[3 * t + i]) {
      done_[3 * t + i] = true;
      loop.pieces.push_back(piece_of_[3 * t + i]);
      loop.ring.push_back(tri_.points[tri_.triangles[t][Tri::ccw(i)]]);
      const std::uint32_t v = tri_.triangles[t][Tri::cw(i)];
      for (;;) {
        const int c = tri_.corner(t, v);
        i = Tri::cw(c);
        if (piece_of_[3 * t + i] != kNone) break;
        t = tri_.cw_triangle(t, c);
      }
    }
    return loop;
  }

  const Tri& tri_;
  const std::vector<std::uint32_t>& piece_of_;
  const std::vector<std::uint32_t>& component_;
  std::vector<bool> done_;
};

/// How often a closed walk, which may touch itself, turns around p; p is not on it.
int winding_number(const Ring& ring, Point p) {
  int winding = 0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Point a = ring[j], b = ring[i];
    if (a.y <= p.y && b.y > p.y && written::orientation(a, b, p) > 0) ++winding;
    if (a.y > p.y && b.y <= p.y && written::orientation(a, b, p) < 0) --winding;
  }
  return winding;
}

/// The middle of a free triangle, which need not have double coordinates to be good enough: a loop of another component
/// never enters the triangle, so its corners' mean lies on the same side as all of it, unless rounding moves it out.
Point inner_point(const Tri& tri, std::uint32_t t) {
  const auto& v = tri.triangles[t];
  const Point a = tri.points[v[0]], b = tri.points[v[1]], c = tri.points[v[2]];
  return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
}

/// The loop of `component` on whose other side p lies: its outer one (counter-clockwise) when p is not within, else the
/// hole (clockwise) around p.
const Loop* separating(const std::vector<Loop>& loops, Point p) {
  for (const Loop& loop : loops) {
    const int winding = winding_number(loop.ring, p);
    const bool outer = ring_area(loop.ring) > 0;
    if (outer ? winding == 0 : winding != 0) return &loop;
  }
  return nullptr;
}

}  // namespace

std::vector<Constraint> FreeSpace::separation(Point p, Point q) const {
  const Location at_p = locate(p), at_q = locate(q);
  TAUT_EXPECTS(at_p.kind != Location::Kind::outside && at_q.kind != Location::Kind::outside);
  const std::uint32_t cp = component(at_p.triangle), cq = component(at_q.triangle);
  std::vector<Constraint> result;
  if (cp == cq) return result;
  const detail::FreeSpaceMade& made = impl_->parts();
  Loops loops(made.tri, made.piece_of, made.components);
  const std::vector<Loop> around_p = loops.around(cp), around_q = loops.around(cq);
  const Loop* first = separating(around_p, inner_point(made.tri, at_q.triangle));
  const Loop* second = separating(around_q, inner_point(made.tri, at_p.triangle));
  if (!first || (second && second->pieces.size() < first->pieces.size())) first = second;
  if (!first) return result;
  for (const std::uint32_t piece : first->pieces) result.push_back(made.constraints[piece]);
  return result;
}

}  // namespace taut
