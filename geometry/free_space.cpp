#include <taut/geometry/free_space.h>

#include <algorithm>
#include <chrono>

#include <taut/geometry/detail/cell_sight.h>
#include <taut/geometry/detail/free_space_impl.h>
#include <taut/geometry/detail/noding.h>
#include <taut/geometry/detail/obstacles.h>
#include <taut/geometry/detail/outline.h>
#include <taut/geometry/detail/outline_rings.h>
#include <taut/geometry/detail/triangulate.h>
#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/ray_walk.h>
#include <taut/geometry/written.h>

namespace taut {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Where paths will end: what these points lie on may bend elsewhere, not there.
std::vector<Point> ends_of(const World& world, std::span<const Point> places) {
  std::vector<Point> ends(places.begin(), places.end());
  if (world.start()) ends.push_back(*world.start());
  if (world.goal().point) ends.push_back(*world.goal().point);
  return ends;
}

/// Of a point robot: the sides of the solids, of the one area with `area`, and the walls without thickness. Where
/// polygons overlap winding numbers tell what is solid.
void add_rings_and_walls(const World& world, bool area, std::vector<detail::Edge>& edges) {
  const auto add = [&](const Polygon& polygon, int turn) {
    for (const Segment& side : detail::outline(polygon)) edges.push_back({side.a, side.b, turn, kNone});
  };
  for (const Area& solid : world.solids()) add(solid.polygon, 1);
  if (area) add(world.areas().front().polygon, -1);
  for (std::uint32_t i = 0; i < world.walls().size(); ++i)
    if (const Wall& wall = world.walls()[i]; wall.thickness == 0) edges.push_back({wall.a, wall.b, 0, i});
}

/// The outlines of the obstacles and the zero-thickness walls, split where they meet.
detail::Noded noded_edges(const World& world, const Footprint& footprint, std::span<const Point> places) try {
  const std::vector<Point> ends = ends_of(world, places);
  const bool point = footprint.kind() == Footprint::Kind::point;
  const detail::Obstacles obstacles =
      point ? detail::obstacles_beside_rings(world, ends) : detail::obstacles_of(world, footprint, ends);
  detail::Outline outline = detail::outline_of_union(obstacles.pieces, world.box(), ends);
  std::vector<detail::Edge> edges = std::move(outline.edges);
  if (point) add_rings_and_walls(world, obstacles.pieces.empty(), edges);
  detail::Noded noded = detail::node(std::move(edges), DecimalUnit(world.box()), ends);
  // The seam of two blocks is no obstacle.
  std::erase_if(noded.edges, [](const detail::Edge& e) { return e.turn == 0 && e.wall == kNone; });
  noded.crossings += outline.crossings;
  noded.displacement = std::max({noded.displacement, outline.displacement, obstacles.excess});
  return noded;
} catch (const TooFine& error) {
  throw InputError(world.source(), 0, error.what());
}

/// What stops a path: the edges that border free triangles, and whether there were others.
struct Classified {
  std::vector<Constraint> constraints;
  bool buried = false;
};

Classified constraints_of(const detail::Mesh& mesh, const std::vector<detail::Edge>& edges) {
  constexpr std::uint8_t kLeft = 1, kRight = 2;
  const Triangulation& tri = mesh.triangulation;
  std::vector<std::uint8_t> free_sides(edges.size(), 0);
  for (std::uint32_t t = 0; t < tri.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t edge = mesh.edge_of[3 * t + i];
      if (edge != kNone && tri.free[t]) free_sides[edge] |= detail::is_left_of_edge(tri, t, i) ? kLeft : kRight;
    }
  Classified result;
  result.constraints.reserve(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const detail::Edge& e = edges[i];
    if (free_sides[i] != 0)
      result.constraints.push_back({e.a, e.b, !(free_sides[i] & kLeft), !(free_sides[i] & kRight), e.wall});
  }
  result.buried = result.constraints.size() < edges.size();
  return result;
}

std::vector<detail::Edge> edges_of(const std::vector<Constraint>& constraints) {
  std::vector<detail::Edge> edges;
  edges.reserve(constraints.size());
  for (const Constraint& c : constraints) edges.push_back({c.a, c.b, int{c.solid_left} - int{c.solid_right}, c.wall});
  return edges;
}

/// Numbers the connected parts of the free triangles.
std::uint32_t number_components(const Triangulation& tri, std::vector<std::uint32_t>& component) {
  component.assign(tri.triangles.size(), kNone);
  std::uint32_t count = 0;
  std::vector<std::uint32_t> open;
  for (std::uint32_t first = 0; first < tri.triangles.size(); ++first) {
    if (!tri.free[first] || component[first] != kNone) continue;
    component[first] = count;
    open.push_back(first);
    while (!open.empty()) {
      const std::uint32_t t = open.back();
      open.pop_back();
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t n = tri.neighbours[t][i];
        if (n == kNone || tri.is_constrained(t, i) || component[n] != kNone) continue;
        component[n] = count;
        open.push_back(n);
      }
    }
    ++count;
  }
  return count;
}

/// Is the part of the surroundings of a place that lies towards q free?
bool looks_towards(const Triangulation& tri, const Location& at, Point q) {
  if (at.kind == Location::Kind::vertex) {
    const auto sectors = tri.sectors_at(tri.triangles[at.triangle][at.index]);
    return std::any_of(sectors.begin(), sectors.end(), [&](const auto& s) { return tri.looks_to(s, q); });
  }
  if (at.kind != Location::Kind::side) return true;
  const auto& corners = tri.triangles[at.triangle];
  const std::uint32_t n = tri.neighbours[at.triangle][at.index];
  return (n != kNone && tri.free[n]) || written::orientation(tri.points[corners[Triangulation::ccw(at.index)]],
                                                             tri.points[corners[Triangulation::cw(at.index)]], q) >= 0;
}

std::unique_ptr<const detail::FreeSpaceMade> made_of(const World& world, const Footprint& footprint,
                                                     std::span<const Point> places) {
  auto made = std::make_unique<detail::FreeSpaceMade>();
  auto start = std::chrono::steady_clock::now();
  detail::Noded noded = noded_edges(world, footprint, places);
  made->report.crossings = noded.crossings;
  made->report.displacement = noded.displacement;
  made->report.seconds_union = seconds_since(start);

  start = std::chrono::steady_clock::now();
  detail::Mesh mesh = detail::triangulate(noded.edges);
  detail::classify(mesh, noded.edges);
  Classified classified = constraints_of(mesh, noded.edges);
  noded.edges = {};
  if (classified.buried) {
    const std::vector<detail::Edge> edges = edges_of(classified.constraints);
    mesh = detail::triangulate(edges);
    detail::classify(mesh, edges);
  }
  made->constraints = std::move(classified.constraints);
  made->tri = std::move(mesh.triangulation);
  made->piece_of = std::move(mesh.edge_of);
  made->component_count = number_components(made->tri, made->components);
  made->locator = detail::Locator(made->tri);
  made->report.seconds_triangulation = seconds_since(start);
  return made;
}

}  // namespace

FreeSpace::Impl::Impl(World w, Footprint f, std::span<const Point> p)
    : world(std::move(w)), footprint(std::move(f)), places(p.begin(), p.end()) {
  if (footprint.kind() == Footprint::Kind::point) cells = CellPlan::of(world);
  if (!cells) make();
}

const detail::FreeSpaceMade& FreeSpace::Impl::make() const {
  std::call_once(making, [this] {
    made = made_of(world, footprint, places);
    is_made.store(true, std::memory_order_release);
  });
  return *made;
}

FreeSpace::FreeSpace(World world, Footprint footprint, std::span<const Point> places)
    : impl_(std::make_shared<const Impl>(std::move(world), std::move(footprint), places)) {}

const World& FreeSpace::world() const { return impl_->world; }
const Footprint& FreeSpace::footprint() const { return impl_->footprint; }
const CellPlan* FreeSpace::cells() const { return impl_->cells ? &*impl_->cells : nullptr; }
bool FreeSpace::is_triangulated() const { return impl_->is_made.load(std::memory_order_acquire); }
double FreeSpace::displacement() const { return impl_->cells ? 0 : impl_->parts().report.displacement; }
const FreeSpaceReport& FreeSpace::report() const { return impl_->parts().report; }
const std::vector<Constraint>& FreeSpace::constraints() const { return impl_->parts().constraints; }
const Triangulation& FreeSpace::triangulation() const { return impl_->parts().tri; }
std::uint32_t FreeSpace::component(std::uint32_t triangle) const { return impl_->parts().components[triangle]; }
std::uint32_t FreeSpace::component_count() const { return impl_->parts().component_count; }

const std::vector<Polygon>& FreeSpace::polygons() const {
  const Triangulation& tri = triangulation();
  std::call_once(impl_->polygons_made, [&] { impl_->polygons = detail::outline_rings(tri); });
  return impl_->polygons;
}

Location FreeSpace::locate(Point p) const { return impl_->parts().locator.locate(impl_->parts().tri, p); }

bool FreeSpace::holds(Point p) const {
  return impl_->cells ? impl_->cells->around(p).free != 0 : locate(p).kind != Location::Kind::outside;
}

bool FreeSpace::opens_towards(Point p, Point q) const {
  if (impl_->cells) return impl_->cells->around(p).towards(p, q) != 0;
  const Location at = locate(p);
  return at.kind != Location::Kind::outside && looks_towards(triangulation(), at, q);
}

bool FreeSpace::sees(Point p, Point q, std::optional<Point> towards) const {
  if (!is_triangulated()) return detail::sees_among_cells(*cells(), p, q, towards);
  const Location from = locate(p);
  if (from.kind == Location::Kind::outside || locate(q).kind == Location::Kind::outside) return false;
  const Triangulation& tri = triangulation();
  if (p == q) return !towards || looks_towards(tri, from, *towards);
  RayWalk walk(tri, p, q, true);
  auto end = walk.start(from, towards);
  while (end == RayWalk::End::vertex) end = walk.next();
  return end == RayWalk::End::reached;
}

}  // namespace taut
