#include <taut/io/pictures/alternatives_svg.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <taut/geometry/segment_distance.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/results/words.h>

namespace taut {

namespace {

std::vector<Bezier> curves(const std::vector<Point>& points) {
  std::vector<Bezier> all;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point p = points[i - 1], q = points[i];
    all.push_back({p, {(p.x + q.x) / 2, (p.y + q.y) / 2}, q});
  }
  return all;
}

double distance_to(const std::vector<Point>& path, Point p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < path.size(); ++i)
    least = std::min(least, segment_distance_interval({p, p}, {path[i - 1], path[i]}).middle());
  return least;
}

/// The middle of the leg that is farthest from all other ways.
Point own_place(const std::vector<Alternative>& ways, std::size_t i) {
  const std::vector<Point>& points = ways[i].path.points;
  Point best = points.front();
  double most = -1;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Point middle{(points[k - 1].x + points[k].x) / 2, (points[k - 1].y + points[k].y) / 2};
    double least = std::hypot(points[k].x - points[k - 1].x, points[k].y - points[k - 1].y) / 2;
    for (std::size_t j = 0; j < ways.size() && least > most; ++j)
      if (j != i) least = std::min(least, distance_to(ways[j].path.points, middle));
    if (least > most) {
      most = least;
      best = middle;
    }
  }
  return best;
}

std::string meaning(const Alternative& way) {
  const std::string length = "length " + length_text(way.path.length);
  return way.gate ? fmt::format("{}, {:.6g} wide", length, way.gate->width) : length;
}

}  // namespace

std::string alternatives_svg(const AlternativesAnswer& answer, const FreeSpace& space, const std::string& title,
                             const std::vector<EndMove>& moves) {
  SvgPicture picture;
  picture.title = title;
  picture.start = answer.start;
  picture.goal.point = answer.goal;
  picture.moves = moves;
  const std::vector<Alternative>& ways = answer.found.ways;
  picture.facts = {ways.empty() ? "no path" : count_text(ways.size(), "way")};
  for (std::size_t i = ways.size(); i-- > 0;) {
    const double shade = ways.size() > 1 ? static_cast<double>(i) / static_cast<double>(ways.size() - 1) : 0;
    picture.shades.push_back({curves(ways[i].path.points), shade});
    if (ways[i].gate) picture.gates.push_back(ways[i].gate->at);
  }
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const std::string number = fmt::format("{}", i + 1);
    picture.labels.push_back({own_place(ways, i), number});
    picture.label_keys.push_back({number, meaning(ways[i])});
  }
  return svg(space, picture);
}

}  // namespace taut
