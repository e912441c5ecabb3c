#include <taut/geometry/detail/obstacles.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <taut/geometry/box.h>
#include <taut/geometry/detail/polygon_triangles.h>
#include <taut/geometry/written.h>

namespace taut::detail {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kUlp = 0x1p-52;

/// What a + b means, or the number below it.
double sum_down(double a, double b) {
  const double s = written::sum(a, b);
  return written::compare_sum(a, b, s) < 0 ? std::nextafter(s, -kInfinity) : s;
}
double sum_up(double a, double b) { return -sum_down(-a, -b); }
bool sum_is_exact(double a, double b) { return written::compare_sum(a, b, written::sum(a, b)) == 0; }

double magnitude(const Ring& ring) {
  double m = 0;
  for (const Point p : ring) m = std::max({m, std::abs(p.x), std::abs(p.y)});
  return m;
}

/// Is the ring an axis-parallel rectangle (of positive or zero extent)?
bool is_box(const Ring& ring) {
  return ring.size() == 4 &&
         ((ring[0].x == ring[1].x && ring[2].x == ring[3].x && ring[0].y == ring[3].y && ring[1].y == ring[2].y) ||
          (ring[0].y == ring[1].y && ring[2].y == ring[3].y && ring[0].x == ring[3].x && ring[1].x == ring[2].x));
}

/// a's box widened by w on each side, rounded outwards.
Box widened(const Box& a, double left, double below, double right, double above) {
  return {{sum_down(a.min.x, -left), sum_down(a.min.y, -below)}, {sum_up(a.max.x, right), sum_up(a.max.y, above)}};
}

double widening_error(const Box& a, double w) {
  return sum_is_exact(a.min.x, -w) && sum_is_exact(a.min.y, -w) && sum_is_exact(a.max.x, w) && sum_is_exact(a.max.y, w)
             ? 0
             : 2 * kUlp * (std::max({std::abs(a.min.x), std::abs(a.min.y), std::abs(a.max.x), std::abs(a.max.y)}) + w);
}

class Builder {
 public:
  Builder(const World& world, const Footprint& footprint, std::span<const Point> fixed) : world_(world), fixed_(fixed) {
    for (const Point p : footprint.ring()) reflected_.push_back({-p.x, -p.y});
    footprint_is_box_ = is_box(reflected_);
  }

  Obstacles run() {
    add_walls();
    for (const Area& solid : world_.solids()) add_polygon(solid.polygon);
    add_outside();
    return std::move(result_);
  }

  Obstacles run_beside_rings() {
    add_walls();
    if (world_.areas().size() > 1 || !result_.pieces.empty()) add_outside();
    return std::move(result_);
  }

 private:
  bool is_point() const { return reflected_.empty(); }

  void add_walls() {
    for (std::uint32_t i = 0; i < world_.walls().size(); ++i) add_wall(i);
  }

  void add_wall(std::uint32_t i) {
    const Wall& wall = world_.walls()[i];
    if (wall.thickness == 0) {
      if (!is_point()) add_summed({wall.a, wall.b}, i);
    } else if (is_point()) {
      result_.pieces.push_back({rectangle(wall), i});
    } else {
      add_summed(rectangle(wall), i);
    }
  }

  /// The wall's rectangle, square caps included.
  Ring rectangle(const Wall& wall) {
    const double h = written::middle(0, wall.thickness);
    if (wall.a.x == wall.b.x || wall.a.y == wall.b.y) {
      const Box box = box_around(wall.a, wall.b);
      note(widening_error(box, h));
      return ring_of(widened(box, h, h, h, h));
    }
    const double dx = wall.b.x - wall.a.x, dy = wall.b.y - wall.a.y, length = std::hypot(dx, dy);
    // Directions are good to 4 ulp, corners to 8 of their magnitude: that much is added on all sides.
    const double slack = kUlp * (16 * (magnitude({wall.a, wall.b}) + h));
    note(2 * slack);
    const double ux = dx / length * (h + slack), uy = dy / length * (h + slack);
    return convex_hull({{wall.a.x - ux + uy, wall.a.y - uy - ux},
                        {wall.b.x + ux + uy, wall.b.y + uy - ux},
                        {wall.b.x + ux - uy, wall.b.y + uy + ux},
                        {wall.a.x - ux - uy, wall.a.y - uy + ux}});
  }

  /// The Minkowski sum of the convex hull of `points` with the reflected footprint.
  void add_summed(const Ring& points, std::uint32_t wall) {
    if (footprint_is_box_ &&
        (points.size() == 2 ? points[0].x == points[1].x || points[0].y == points[1].y : is_box(points))) {
      const Box box = box_around(points), f = box_around(reflected_);
      note(std::max(widening_error(box, f.max.x), widening_error(box, f.max.y)));
      result_.pieces.push_back({ring_of(widened(box, -f.min.x, -f.min.y, f.max.x, f.max.y)), wall});
      return;
    }
    bool exact = true;
    for (const Point p : points)
      for (const Point f : reflected_) exact = exact && sum_is_exact(p.x, f.x) && sum_is_exact(p.y, f.y);
    // Widening the footprint moves every side outwards by more than rounding can move it back.
    const double slack = exact ? 0 : 4 * kUlp * (magnitude(points) + magnitude(reflected_)),
                 factor = 1 + slack / inradius();
    note(slack * magnitude(reflected_) / inradius() * 2);
    std::vector<Point> sums;
    for (const Point p : points)
      for (const Point f : reflected_)
        sums.push_back(exact ? Point{written::sum(p.x, f.x), written::sum(p.y, f.y)}
                             : Point{p.x + f.x * factor, p.y + f.y * factor});
    result_.pieces.push_back({convex_hull(std::move(sums)), wall});
  }

  /// A lower bound of the distance from the reference point to the footprint's sides.
  double inradius() const {
    double least = kInfinity;
    for (std::size_t i = 0, j = reflected_.size() - 1; i < reflected_.size(); j = i++) {
      const Point a = reflected_[j], b = reflected_[i];
      least = std::min(least, std::abs(a.x * b.y - a.y * b.x) / std::hypot(b.x - a.x, b.y - a.y));
    }
    return least * (1 - 8 * kUlp);
  }

  void add_convex(Ring ring, bool summed) {
    if (summed)
      add_summed(ring, kNone);
    else
      result_.pieces.push_back({std::move(ring), kNone});
  }

  void add_polygon(const Polygon& polygon) {
    if (polygon.holes.empty() && is_strictly_convex(polygon.outer)) return add_convex(polygon.outer, !is_point());
    const Polygon* const one[] = {&polygon};
    add_triangles(inside_triangles(one, unit_, fixed_), !is_point());
  }

  static bool is_strictly_convex(const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (written::orientation(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]) <= 0) return false;
    return true;
  }

  /// What lies outside the areas. Only walled outlines hold a footprint back by more than its reference point.
  void add_outside() {
    const Box box = world_.box();
    const double least =
        std::max({box.max.x - box.min.x, box.max.y - box.min.y, 1e-300}) / 4 + magnitude(ring_of(box)) * kUlp * 64;
    // One digit, so that the frame lies on the lattice of the world.
    const double margin = written::number(1, -static_cast<int>(std::ceil(std::log10(least))));
    const Box frame = widened(box, margin, margin, margin, margin);
    const bool grows = !is_point() && world_.boundary() == Boundary::walled;
    if (world_.areas().size() == 1 && world_.areas()[0].polygon.holes.empty() &&
        is_box(world_.areas()[0].polygon.outer))
      return add_frame(box, frame, grows);
    std::vector<const Polygon*> polygons;
    for (const Area& area : world_.areas()) polygons.push_back(&area.polygon);
    add_triangles(outside_triangles(polygons, frame, unit_, fixed_), grows);
  }

  void add_frame(const Box& box, const Box& frame, bool grows) {
    const Box parts[] = {{frame.min, {box.min.x, frame.max.y}},
                         {{box.max.x, frame.min.y}, frame.max},
                         {{box.min.x, frame.min.y}, {box.max.x, box.min.y}},
                         {{box.min.x, box.max.y}, {box.max.x, frame.max.y}}};
    for (const Box& part : parts) add_convex(ring_of(part), grows);
  }

  void add_triangles(const PolygonTriangles& tiles, bool summed) {
    note(tiles.displacement);
    for (const auto& [a, b, c] : tiles.triangles) add_convex({a, b, c}, summed);
  }

  void note(double excess) { result_.excess = std::max(result_.excess, excess); }

  const World& world_;
  std::span<const Point> fixed_;
  DecimalUnit unit_{world_.box()};
  Ring reflected_;
  bool footprint_is_box_ = false;
  Obstacles result_;
};

}  // namespace

Ring convex_hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Ring hull;
  const auto chain = [&](auto first, auto last) {
    const std::size_t base = hull.size();
    for (; first != last; ++first) {
      while (hull.size() >= base + 2 && written::orientation(hull[hull.size() - 2], hull.back(), *first) <= 0)
        hull.pop_back();
      hull.push_back(*first);
    }
    hull.pop_back();
  };
  chain(points.begin(), points.end());
  chain(points.rbegin(), points.rend());
  return hull;
}

Obstacles obstacles_of(const World& world, const Footprint& footprint, std::span<const Point> fixed) {
  return Builder(world, footprint, fixed).run();
}

Obstacles obstacles_beside_rings(const World& world, std::span<const Point> fixed) {
  return Builder(world, Footprint::point(), fixed).run_beside_rings();
}

}  // namespace taut::detail
