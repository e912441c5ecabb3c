#include <taut/io/pictures/arc_curves.h>

#include <algorithm>
#include <cmath>

namespace taut {

namespace {

constexpr double kStep = M_PI / 12;  // of a curve along an arc

void add_arc(const ArcPiece& arc, std::vector<Bezier>& curves) {
  const double radius = std::hypot(arc.from.x - arc.centre.x, arc.from.y - arc.centre.y);
  const double parts = std::max(1.0, std::ceil(arc.sweep / kStep)), step = arc.turn * arc.sweep / parts;
  const auto at = [&](double angle, double r) {
    return Point{arc.centre.x + r * std::cos(angle), arc.centre.y + r * std::sin(angle)};
  };
  Point from = arc.from;
  for (double k = 1; k <= parts; ++k) {
    const double angle = arc.from_angle + k * step;
    const Point to = k < parts ? at(angle, radius) : arc.to;
    curves.push_back({from, at(angle - step / 2, radius / std::cos(step / 2)), to});
    from = to;
  }
}

}  // namespace

std::vector<Bezier> arc_curves(const std::vector<ArcPiece>& pieces) {
  std::vector<Bezier> curves;
  for (const ArcPiece& piece : pieces) {
    if (piece.turn != 0) {
      add_arc(piece, curves);
    } else if (piece.from != piece.to) {
      curves.push_back({piece.from, {(piece.from.x + piece.to.x) / 2, (piece.from.y + piece.to.y) / 2}, piece.to});
    }
  }
  return curves;
}

}  // namespace taut
