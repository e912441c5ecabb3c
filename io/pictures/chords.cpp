#include <taut/io/pictures/chords.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include <taut/geometry/written.h>

namespace taut {

namespace {

/// Pieces meet only in their ends: do all of them hang together?
bool hang_together(const std::vector<Constraint>& pieces) {
  std::map<std::pair<double, double>, std::size_t> numbers;
  std::vector<std::size_t> above;
  const auto number = [&](Point p) {
    const auto [at, is_new] = numbers.try_emplace({p.x, p.y}, numbers.size());
    if (is_new) above.push_back(at->second);
    return at->second;
  };
  const auto top = [&](std::size_t i) {
    for (; above[i] != i; i = above[i]) above[i] = above[above[i]];
    return i;
  };
  std::size_t parts = 0;
  for (const Constraint& piece : pieces) {
    const std::size_t before = numbers.size(), a = number(piece.a), b = number(piece.b);
    parts += numbers.size() - before;
    parts -= top(a) != top(b);
    above[top(a)] = top(b);
  }
  return parts == 1;
}

double cross(Point d, Point e) { return d.x * e.y - d.y * e.x; }
Point minus(Point p, Point q) { return {p.x - q.x, p.y - q.y}; }

/// Where a ray from p along d first meets a piece, p itself apart.
std::optional<Point> first_hit(const std::vector<Constraint>& pieces, Point p, Point d) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Constraint& piece : pieces) {
    if (piece.a == p || piece.b == p) continue;
    const Point a = minus(piece.a, p), along = minus(piece.b, piece.a);
    const double left = cross(d, a), right = cross(d, minus(piece.b, p)), slant = cross(d, along);
    if (left * right > 0 || slant == 0) continue;
    const double way = cross(a, along) / slant;
    if (way > 0) nearest = std::min(nearest, way);
  }
  if (nearest == std::numeric_limits<double>::infinity()) return std::nullopt;
  return Point{p.x + nearest * d.x, p.y + nearest * d.y};
}

}  // namespace

std::vector<Segment> chords(const FreeSpace& space, const Path& path) {
  std::vector<Segment> found;
  if (path.points.size() < 3 || !hang_together(space.constraints())) return found;
  for (std::size_t i = 1; i + 1 < path.points.size(); ++i) {
    const Point before = path.points[i - 1], bend = path.points[i], after = path.points[i + 1];
    const int turn = written::orientation(before, bend, after);
    if (turn == 0) continue;
    for (const Point leg : {minus(bend, before), minus(after, bend)})
      if (const auto end = first_hit(space.constraints(), bend, {turn * leg.y, -turn * leg.x}))
        found.push_back({bend, *end});
  }
  return found;
}

void add_chords(SvgPicture& picture, const FreeSpace& space, const Path& path) {
  picture.guides = chords(space, path);
  picture.guide_label = "chord across a leg: every path crosses it";
}

}  // namespace taut
