#include <taut/roadmaps/visibility_graph.h>

#include <algorithm>
#include <utility>

#include <taut/geometry/expects.h>
#include <taut/geometry/ray_walk.h>
#include <taut/geometry/triangular_expansion.h>

namespace taut {

namespace {

using Tri = Triangulation;
using Vertex = Roadmap::Vertex;

/// What a point sees, as roadmap vertices.
class View {
 public:
  View(const Tri& tri, VisibilityKind kind, const std::vector<Vertex>& vertex_of_sector, const std::vector<bool>& bends)
      : tri_(tri),
        reduced_(kind == VisibilityKind::reduced),
        vertex_of_sector_(vertex_of_sector),
        bends_(bends),
        expansion_(tri, *this) {}

  /// Appends the vertices that a point at `at` is joined to, ascending, each once; of a vertex those of all its
  /// sectors.
  void from_point(Point p, const Location& at, std::optional<Point> towards, std::vector<Vertex>& row) {
    origin_ = p;
    row_ = &row;
    first_ = row.size();
    switch (at.kind) {
      case Location::Kind::outside: break;
      case Location::Kind::triangle: around(at.triangle, -1); break;
      case Location::Kind::side: from_side(at, towards); break;
      case Location::Kind::vertex: from_vertex(at, towards); break;
    }
    finish();
  }

  // What the expansion calls.
  bool hides(std::uint32_t v) const { return !reduced_ || bends_[v]; }
  void blocked(std::uint32_t, int, const auto&, const auto&) {}
  void vertex(std::uint32_t t, int k) {
    const std::uint32_t sector = tri_.sector_of[3 * t + k];
    add(sector);
    if (!reduced_ && lets_pass(tri_.sectors[sector])) behind(sector);
  }

 private:
  void finish() {
    const auto first = row_->begin() + static_cast<std::ptrdiff_t>(first_);
    std::sort(first, row_->end());
    row_->erase(std::unique(first, row_->end()), row_->end());
  }

  int side(std::uint32_t a, std::uint32_t b) const {
    return written::orientation(origin_, tri_.points[a], tri_.points[b]);
  }

  void add(std::uint32_t sector) {
    const Vertex v = vertex_of_sector_[sector];
    if (v == kNone || (reduced_ && !tangent_at(tri_.sectors[sector]))) return;
    row_->push_back(v);
  }

  /// Does the line from the origin have the obstacle at the sector's vertex on one side?
  bool tangent_at(const Tri::Sector& s) const { return side(s.vertex, s.right) * side(s.vertex, s.left) >= 0; }

  /// Can a ray that arrives in this sector go straight on in it? Then it spans half a turn at least, and the line does
  /// not leave it.
  bool lets_pass(const Tri::Sector& s) const {
    const int right = side(s.vertex, s.right), left = side(s.vertex, s.left);
    return s.reflex ? right * left >= 0 : right == 0 && left == 0;
  }

  /// The vertices behind one that is seen, on the same ray.
  void behind(std::uint32_t sector) {
    RayWalk walk(tri_, origin_, tri_.points[tri_.sectors[sector].vertex], false);
    walk.stand_at({tri_.sectors[sector].vertex, {sector, kNone}});
    while (walk.next() == RayWalk::End::vertex)
      for (const std::uint32_t s : walk.stand().sectors)
        if (s != kNone) add(s);
  }

  /// All that is seen from a triangle that contains the origin, but not out of side `except`.
  void around(std::uint32_t t, int except) {
    for (int i = 0; i < 3; ++i) {
      vertex(t, i);
      if (i == except) continue;
      const std::uint32_t right = tri_.triangles[t][Tri::ccw(i)], left = tri_.triangles[t][Tri::cw(i)];
      expansion_.spread(origin_, t, i, expansion_.ray(right), expansion_.ray(left));
    }
  }

  void from_side(const Location& at, std::optional<Point> towards) {
    const std::uint32_t n = tri_.neighbours[at.triangle][at.index];
    const auto& corners = tri_.triangles[at.triangle];
    const int turn = towards ? written::orientation(tri_.points[corners[Tri::ccw(at.index)]],
                                                    tri_.points[corners[Tri::cw(at.index)]], *towards)
                             : 0;
    if (turn >= 0) around(at.triangle, at.index);
    if (turn <= 0 && n != kNone && tri_.free[n]) around(n, tri_.mirror(at.triangle, at.index));
  }

  void from_vertex(const Location& at, std::optional<Point> towards) {
    for (const Tri::Sector& sector : tri_.sectors_at(tri_.triangles[at.triangle][at.index])) {
      if (towards && !tri_.looks_to(sector, *towards)) continue;
      const Vertex v = vertex_of_sector_[static_cast<std::size_t>(&sector - tri_.sectors.data())];
      if (v != kNone) row_->push_back(v);
      fan(sector);
    }
  }

  void fan(const Tri::Sector& s) {
    each_triangle(tri_, s, [&](std::uint32_t t, int i) { wedge(t, i); });
  }

  /// One triangle at the origin's vertex.
  void wedge(std::uint32_t t, int i) {
    vertex(t, Tri::ccw(i));
    vertex(t, Tri::cw(i));
    expansion_.spread(origin_, t, i, expansion_.ray(tri_.triangles[t][Tri::ccw(i)]),
                      expansion_.ray(tri_.triangles[t][Tri::cw(i)]));
  }

  const Tri& tri_;
  bool reduced_;
  const std::vector<Vertex>& vertex_of_sector_;
  const std::vector<bool>& bends_;
  Expansion<DoubleCoordinates, View> expansion_;
  Point origin_;
  std::vector<Vertex>* row_ = nullptr;
  std::size_t first_ = 0;
};

std::vector<bool> bending_vertices(const Tri& tri) {
  std::vector<bool> bends(tri.points.size(), false);
  for (const Tri::Sector& s : tri.sectors)
    if (s.reflex) bends[s.vertex] = true;
  return bends;
}

}  // namespace

VisibilityGraph::VisibilityGraph(FreeSpace space, VisibilityKind kind, unsigned jobs, const TellProgress& tell)
    : VisibilityGraph(VisibilityRows(space, kind), kind, jobs, tell) {}

VisibilityGraph::VisibilityGraph(const VisibilityRows& rows, VisibilityKind kind, unsigned jobs,
                                 const TellProgress& tell)
    : space_(rows.space()),
      kind_(kind),
      vertices_(rows.vertices()),
      roadmap_(roadmap_of(rows, jobs, tell)),
      bends_(bending_vertices(space_.triangulation())) {}

VisibilityGraph::VisibilityGraph(FreeSpace space, VisibilityKind kind, Roadmap roadmap)
    : space_(std::move(space)),
      kind_(kind),
      vertices_(space_.triangulation(), kind),
      roadmap_(std::move(roadmap)),
      bends_(bending_vertices(space_.triangulation())) {
  if (vertices_.points(space_.triangulation()) != roadmap_.points())
    throw InputError(space_.world().source(), 0, "the roadmap's vertices are not the corners of this world");
}

std::vector<Vertex> VisibilityGraph::visible_from(Point p, std::optional<Point> towards) const {
  const Tri& tri = space_.triangulation();
  View view(tri, kind_, vertices_.vertex_of_sector, bends_);
  std::vector<Vertex> row;
  const Location at = space_.locate(p);
  TAUT_EXPECTS(at.kind != Location::Kind::outside);
  view.from_point(p, at, towards, row);
  return row;
}

}  // namespace taut
