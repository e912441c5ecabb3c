// The line that a mouse draws on a speed run.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <taut/robots/micromouse/detail/turn_shapes.h>
#include <taut/robots/micromouse/speed_run.h>

namespace taut::micromouse {

namespace {

using detail::is_diagonal;
using detail::kDx;
using detail::kDy;

Point unit_vector(Eighth heading) {
  const double scale = is_diagonal(heading) ? 1 / std::numbers::sqrt2 : 1;
  return {kDx[heading] * scale, kDy[heading] * scale};
}

Point in_cells(double x, double y) { return {x / 2, y / 2}; }

/// An arc around `centre` that begins at `from` and turns by `angle` (clockwise positive), all in half cells.
void add_arc(std::vector<Point>& line, Point centre, Point from, double angle, double step) {
  const double radius = std::hypot(from.x - centre.x, from.y - centre.y);
  const int pieces = std::max(2, static_cast<int>(std::ceil(std::abs(angle) * radius / 2 / step)));
  const double begin = std::atan2(from.y - centre.y, from.x - centre.x);
  for (int i = 1; i <= pieces; ++i) {
    const double at = begin - angle * i / pieces;
    line.push_back(in_cells(centre.x + radius * std::cos(at), centre.y + radius * std::sin(at)));
  }
}

}  // namespace

// A turn is an arc between two tangents, which reach as far as the shorter of them allows.
std::vector<Point> trace(const Drive& drive, double step) {
  std::vector<Point> line{in_cells(drive.from.x, drive.from.y)};
  if (drive.kind == Drive::Kind::pivot) return line;
  const Point end = in_cells(drive.to.x, drive.to.y);
  if (drive.kind == Drive::Kind::turn) {
    const Point u = unit_vector(drive.heading), w = unit_vector(drive.after);
    const int eighths = ((drive.after - drive.heading + 12) & 7) - 4;  // -4..3, clockwise positive
    const double dx = drive.to.x - drive.from.x, dy = drive.to.y - drive.from.y;
    if (eighths == -4) {
      const double side = u.y * dx - u.x * dy > 0 ? 1 : -1;
      const Point from{drive.from.x + u.x, drive.from.y + u.y};
      line.push_back(in_cells(from.x, from.y));
      add_arc(line, {from.x + dx / 2, from.y + dy / 2}, from, side * std::numbers::pi, step);
    } else {
      const double cross = u.x * w.y - u.y * w.x;
      const double before = (dx * w.y - dy * w.x) / cross, behind = (u.x * dy - u.y * dx) / cross;
      const double tangent = std::min(before, behind), angle = eighths * std::numbers::pi / 4;
      const double radius = tangent / std::tan(std::abs(angle) / 2), side = eighths > 0 ? 1 : -1;
      const Point from{drive.from.x + (before - tangent) * u.x, drive.from.y + (before - tangent) * u.y};
      line.push_back(in_cells(from.x, from.y));
      add_arc(line, {from.x + side * radius * u.y, from.y - side * radius * u.x}, from, angle, step);
    }
  }
  line.push_back(end);
  return line;
}

}  // namespace taut::micromouse
