#include <taut/roadmaps/cell_graph.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <taut/geometry/written.h>

namespace taut {

namespace {

using Vertex = Roadmap::Vertex;
using Edge = std::pair<Vertex, Vertex>;

constexpr double kMostCells = 1e8;

[[noreturn]] void refuse(const World& world, int line, const std::string& why) {
  throw InputError(world.source(), line, "has no cells: " + why);
}

bool is_one_box(const World& world) {
  if (world.areas().size() != 1 || world.boundary() == Boundary::open) return false;
  const Polygon& polygon = world.areas()[0].polygon;
  const Box box = world.box();
  const Ring corners{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
  return polygon.holes.empty() &&
         std::is_permutation(polygon.outer.begin(), polygon.outer.end(), corners.begin(), corners.end());
}

double largest_thickness(const World& world) {
  double largest = 0;
  for (const Wall& wall : world.walls()) largest = std::max(largest, wall.thickness);
  return largest;
}

/// One axis of the lattice: posts at first + k * side, k = 0 .. cells.
struct Axis {
  double first;
  double side;
  double cells;

  /// The posts that lie along lo .. hi, one of them being `post`.
  static Axis along(double lo, double hi, double post, double side) {
    const double first = post - std::round((post - lo) / side) * side;
    return {first, side, std::round((hi - first) / side)};
  }
  double at(double k) const { return first + k * side; }
  bool is_post(double v) const { return at(std::round((v - first) / side)) == v; }
  bool ends_at(double lo, double hi, double slack) const {
    return cells >= 1 && std::abs(lo - first) <= slack && std::abs(hi - at(cells)) <= slack;
  }
};

void require_on_posts(const World& world, const Axis& x, const Axis& y) {
  for (const Wall& wall : world.walls()) {
    const std::string named = fmt::format("the wall ({}, {}) to ({}, {}) ", wall.a.x, wall.a.y, wall.b.x, wall.b.y);
    if (wall.a.x != wall.b.x && wall.a.y != wall.b.y) refuse(world, wall.line, named + "is not axis-parallel");
    for (const Point p : {wall.a, wall.b})
      if (!x.is_post(p.x) || !y.is_post(p.y))
        refuse(world, wall.line,
               named +
                   fmt::format("does not end at a post; those are at ({}, {}) and every {}", x.first, y.first, x.side));
  }
}

}  // namespace

CellLattice cell_lattice(const World& world) {
  if (!is_one_box(world)) refuse(world, 0, "the world is not one box");
  if (!world.solids().empty()) refuse(world, world.solids()[0].line, "it has obstacles that are no walls");
  const Box box = world.box();
  const double side = world.grid() ? (box.max.x - box.min.x) / world.grid()->width() : 1;
  if ((box.max.x - box.min.x) / side * ((box.max.y - box.min.y) / side) > kMostCells)
    refuse(world, 0, fmt::format("there would be more than {} of them", kMostCells));
  const Point post = world.walls().empty() || world.grid() ? box.min : world.walls()[0].a;
  const Axis x = Axis::along(box.min.x, box.max.x, post.x, side), y = Axis::along(box.min.y, box.max.y, post.y, side);
  require_on_posts(world, x, y);
  const double slack = largest_thickness(world) / 2;
  if (!x.ends_at(box.min.x, box.max.x, slack) || !y.ends_at(box.min.y, box.max.y, slack))
    refuse(world, 0, fmt::format("the boundary does not run along cells of side {}", side));
  return {{x.first, y.first}, side, static_cast<int>(x.cells), static_cast<int>(y.cells)};
}

std::vector<Cell> CellLattice::cells_at(Point p) const {
  const auto post = [this](int x, int y) { return Point{corner.x + x * side, corner.y + y * side}; };
  const double column = std::floor((p.x - corner.x) / side), row = std::floor((p.y - corner.y) / side);
  std::vector<Cell> cells;
  if (!(column >= -1 && column <= width && row >= -1 && row <= height)) return cells;
  const Cell middle{static_cast<int>(column), static_cast<int>(row)};
  for (int x = middle.x - 1; x <= middle.x + 1; ++x)
    for (int y = middle.y - 1; y <= middle.y + 1; ++y)
      if (contains({x, y}) && Box{post(x, y), post(x + 1, y + 1)}.contains(p)) cells.push_back({x, y});
  return cells;
}

CellGraph::CellGraph(FreeSpace space, CellNeighbours neighbours)
    : space_(std::move(space)), neighbours_(neighbours), lattice_(cell_lattice(space_.world())) {
  std::vector<Point> points = number_cells();
  std::vector<Edge> edges;
  const auto join = [&](Cell from, Cell to) {
    const Vertex u = vertex_of(from), v = vertex_of(to);
    if (u != kNone && v != kNone && space_.sees(points[u], points[v])) edges.emplace_back(u, v);
  };
  for (int x = 0; x < lattice_.width; ++x)
    for (int y = 0; y < lattice_.height; ++y) {
      join({x, y}, {x, y + 1});
      join({x, y}, {x + 1, y});
      if (neighbours_ == CellNeighbours::four) continue;
      join({x, y}, {x + 1, y + 1});
      join({x, y}, {x + 1, y - 1});
    }
  roadmap_ = Roadmap(std::move(points), edges);
}

CellGraph::CellGraph(FreeSpace space, CellNeighbours neighbours, Roadmap roadmap)
    : space_(std::move(space)), neighbours_(neighbours), lattice_(cell_lattice(space_.world())) {
  if (number_cells() != roadmap.points())
    throw InputError(space_.world().source(), 0, "the roadmap's vertices are not the centres of this world's cells");
  roadmap_ = std::move(roadmap);
}

std::vector<Point> CellGraph::number_cells() {
  std::vector<Point> points;
  vertex_of_cell_.reserve(static_cast<std::size_t>(lattice_.width) * static_cast<std::size_t>(lattice_.height));
  for (int x = 0; x < lattice_.width; ++x)
    for (int y = 0; y < lattice_.height; ++y) {
      const Point centre = lattice_.centre({x, y});
      const bool stands = space_.locate(centre).kind != Location::Kind::outside;
      vertex_of_cell_.push_back(stands ? static_cast<Vertex>(points.size()) : kNone);
      if (stands) points.push_back(centre);
    }
  return points;
}

Vertex CellGraph::vertex_of(Cell c) const {
  if (!lattice_.contains(c)) return kNone;
  return vertex_of_cell_[static_cast<std::size_t>(c.x) * static_cast<std::size_t>(lattice_.height) +
                         static_cast<std::size_t>(c.y)];
}

std::vector<Vertex> CellGraph::joined_to(Point p) const {
  std::vector<Vertex> joined;
  for (const Cell c : lattice_.cells_at(p)) {
    const Vertex v = vertex_of(c);
    if (v != kNone && space_.sees(p, roadmap_.point(v))) joined.push_back(v);
  }
  if (joined.empty())
    if (const auto v = nearest_seen(p)) joined.push_back(*v);
  return joined;
}

// Rings of cells around p's; in the k-th no centre is nearer than k - 1/2 sides.
std::optional<Vertex> CellGraph::nearest_seen(Point p) const {
  const auto column = [](double v, double first, double side, int cells) {
    return static_cast<int>(std::clamp(std::floor((v - first) / side), 0.0, cells - 1.0));
  };
  const Cell middle{column(p.x, lattice_.corner.x, lattice_.side, lattice_.width),
                    column(p.y, lattice_.corner.y, lattice_.side, lattice_.height)};
  std::optional<Vertex> best;
  double reach = std::numeric_limits<double>::infinity();
  const auto look = [&](Cell c) {
    const Vertex v = vertex_of(c);
    if (v == kNone) return;
    const Point q = roadmap_.point(v);
    const int nearer = best ? written::compare_distance(p, q, roadmap_.point(*best)) : -1;
    if (nearer > 0 || (nearer == 0 && v > *best) || !space_.sees(p, q)) return;
    best = v;
    reach = std::hypot(q.x - p.x, q.y - p.y);
  };
  const int rings = std::max(lattice_.width, lattice_.height);
  for (int k = 0; k < rings && (k - 0.75) * lattice_.side <= reach; ++k)
    for (int x = middle.x - k; x <= middle.x + k; ++x) {
      const bool whole = x == middle.x - k || x == middle.x + k;
      for (int y = middle.y - k; y <= middle.y + k; y += whole ? 1 : std::max(1, 2 * k)) look({x, y});
    }
  return best;
}

}  // namespace taut
