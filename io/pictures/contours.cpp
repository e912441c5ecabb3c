#include <taut/io/pictures/contours.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <taut/search/polyanya.h>

namespace taut {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr int kSteps = 200;
constexpr double kShift =
    0.37;  // so that a line of corners hardly ever lies on a wall, whose sides are not equally far

/// Distances at the corners of squares.
class Field {
 public:
  Field(const FreeSpace& space, Point from) : space_(space), box_(space.world().box()) {
    const double width = box_.max.x - box_.min.x, height = box_.max.y - box_.min.y;
    step_ = std::max(width, height) / kSteps;
    columns_ = static_cast<std::size_t>(std::ceil(width / step_)) + 1;
    rows_ = static_cast<std::size_t>(std::ceil(height / step_)) + 1;
    for (std::size_t i = 0; i < columns_ * rows_; ++i) points_.push_back(place(i));
    const auto paths = PolyanyaSearch(Polyanya(space)).find_each(from, points_);
    for (const auto& path : paths) distances_.push_back(path ? path->length.interval().lo : kFar);
  }

  double farthest() const {
    double most = 0;
    for (const double d : distances_)
      if (d < kFar) most = std::max(most, d);
    return most;
  }

  /// Where all of its sides are free: its corners, counter-clockwise.
  template <class Visit>
  void each_square(Visit visit) const {
    for (std::size_t r = 0; r + 1 < rows_; ++r)
      for (std::size_t c = 0; c + 1 < columns_; ++c) {
        const std::size_t i = r * columns_ + c;
        const std::array<std::size_t, 4> corners{i, i + 1, i + columns_ + 1, i + columns_};
        if (is_open(corners)) visit(corners);
      }
  }

  double distance(std::size_t i) const { return distances_[i]; }
  Point point(std::size_t i) const { return points_[i]; }

 private:
  Point place(std::size_t i) const {
    const auto along = [&](std::size_t k) { return (static_cast<double>(k) + kShift) * step_; };
    return {std::min(box_.min.x + along(i % columns_), box_.max.x),
            std::min(box_.min.y + along(i / columns_), box_.max.y)};
  }

  bool is_open(const std::array<std::size_t, 4>& corners) const {
    for (std::size_t k = 0; k < 4; ++k)
      if (distances_[corners[k]] == kFar || !space_.sees(points_[corners[k]], points_[corners[(k + 1) % 4]]))
        return false;
    return space_.sees(points_[corners[0]], points_[corners[2]]) &&
           space_.sees(points_[corners[1]], points_[corners[3]]);
  }

  const FreeSpace& space_;
  Box box_;
  double step_ = 1;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<Point> points_;
  std::vector<double> distances_;
};

/// Where the line at `level` enters and leaves the triangle.
void add_line(const Field& field, const std::array<std::size_t, 3>& corners, double level,
              std::vector<Segment>& lines) {
  std::vector<Point> ends;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = corners[k], j = corners[(k + 1) % 3];
    const double a = field.distance(i), b = field.distance(j);
    if ((a < level) == (b < level)) continue;
    const double part = (level - a) / (b - a);
    const Point p = field.point(i), q = field.point(j);
    ends.push_back({p.x + part * (q.x - p.x), p.y + part * (q.y - p.y)});
  }
  if (ends.size() == 2 && ends[0] != ends[1]) lines.push_back({ends[0], ends[1]});
}

}  // namespace

std::vector<Segment> contours(const FreeSpace& space, Point from, std::size_t count) {
  const Field field(space, from);
  const double between = field.farthest() / static_cast<double>(count);
  std::vector<Segment> lines;
  if (!(between > 0)) return lines;
  field.each_square([&](const std::array<std::size_t, 4>& s) {
    for (const std::array<std::size_t, 3>& corners : {std::array{s[0], s[1], s[2]}, std::array{s[0], s[2], s[3]}}) {
      const auto [least, most] =
          std::minmax({field.distance(corners[0]), field.distance(corners[1]), field.distance(corners[2])});
      for (double k = std::floor(least / between) + 1; k * between <= most; ++k)
        add_line(field, corners, k * between, lines);
    }
  });
  return lines;
}

}  // namespace taut
