// The visibility graph of a free space.
#pragma once

#include <optional>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/roadmaps/roadmap.h>
#include <taut/roadmaps/visibility_rows.h>

namespace taut {

/// A visibility graph and how a point joins it.
///
/// Built of VisibilityRows. O(sum over vertices of the triangles seen); 12 bytes an edge while it is built.
class VisibilityGraph {
 public:
  /// By `jobs` threads, the calling one among them (each_in_parallel); the graph is the same for any number. Told are
  /// the vertices whose edges are found.
  explicit VisibilityGraph(FreeSpace space, VisibilityKind kind = VisibilityKind::reduced, unsigned jobs = 1,
                           const TellProgress& tell = {});
  /// From the roadmap of another VisibilityGraph of the same world, footprint and kind, as a file keeps it. Its edges
  /// are taken on trust. Throws InputError when its vertices are not this space's. O(n).
  VisibilityGraph(FreeSpace space, VisibilityKind kind, Roadmap roadmap);

  const FreeSpace& space() const { return space_; }
  VisibilityKind kind() const { return kind_; }
  const Roadmap& roadmap() const { return roadmap_; }

  /// The sector of the triangulation that a roadmap vertex stands for.
  std::uint32_t sector(Roadmap::Vertex v) const { return vertices_.sectors[v]; }
  /// The roadmap vertex of a sector, kNone when it has none.
  Roadmap::Vertex vertex_of_sector(std::uint32_t sector) const { return vertices_.vertex_of_sector[sector]; }

  /// The vertices that a path can join to p in a straight line, tangent at the vertex when the graph is reduced;
  /// ascending. Of a point on a constraint: those on all its free sides. Of a vertex: of all its sectors; the vertex'
  /// own places are among them (at distance 0). With `towards`, only what is seen from the part of the surroundings of
  /// p that a straight leg from p to `towards` starts in (used for the sides of a room). Precondition: p is not
  /// outside.
  std::vector<Roadmap::Vertex> visible_from(Point p, std::optional<Point> towards = std::nullopt) const;

 private:
  VisibilityGraph(const VisibilityRows& rows, VisibilityKind kind, unsigned jobs, const TellProgress& tell);

  FreeSpace space_;
  VisibilityKind kind_;
  VisibilityVertices vertices_;
  Roadmap roadmap_;
  std::vector<bool> bends_;  // by triangulation vertex: does it have a reflex sector?
};

/// The reference: every pair of vertices against every constraint, without the triangulation's visibility. O(n^3): up
/// to a few hundred corners. Gives the same roadmap as VisibilityGraph(space, kind).roadmap(), vertex for vertex, edge
/// for edge.
Roadmap visibility_graph_brute_force(const FreeSpace& space, VisibilityKind kind);

}  // namespace taut
