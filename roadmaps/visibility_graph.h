// The visibility graph of a free space.
#pragma once

#include <optional>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/roadmaps/roadmap.h>

namespace taut {

/// Which vertices and edges there are. Both kinds hold all shortest paths.
enum class VisibilityKind {
  /// Vertices: the sectors of all triangulation vertices on constraints (see Triangulation). Edges: all pairs that a
  /// path can join in a straight line, touching and running along obstacles allowed. The textbook graph. O(n^2) edges.
  full,
  /// Vertices: the reflex sectors, the only places where a shortest path bends. Edges: the tangent (taut) ones among
  /// the full graph's: obstacles at either end lie on one side of the line; and no other reflex sector that the edge
  /// grazes lies between its ends (the shorter edges are there instead). All shortest paths between bends survive.
  reduced,
};

/// A visibility graph and how a point joins it.
///
/// Built by triangular expansion (Bungiu, Hemmer, Hershberger, Huang, Kröller: "Efficient computation of visibility
/// polygons", 2014) from every vertex, exact, int64 on lattices. O(sum over vertices of the triangles seen).
class VisibilityGraph {
 public:
  /// By `jobs` threads, the calling one among them (each_in_parallel); the graph is the same for any number.
  explicit VisibilityGraph(FreeSpace space, VisibilityKind kind = VisibilityKind::reduced, unsigned jobs = 1);
  /// From the roadmap of another VisibilityGraph of the same world, footprint and kind, as a file keeps it. Its edges
  /// are taken on trust. Throws InputError when its vertices are not this space's. O(n).
  VisibilityGraph(FreeSpace space, VisibilityKind kind, Roadmap roadmap);

  const FreeSpace& space() const { return space_; }
  VisibilityKind kind() const { return kind_; }
  const Roadmap& roadmap() const { return roadmap_; }

  /// The sector of the triangulation that a roadmap vertex stands for.
  std::uint32_t sector(Roadmap::Vertex v) const { return sectors_[v]; }
  /// The roadmap vertex of a sector, kNone when it has none.
  Roadmap::Vertex vertex_of_sector(std::uint32_t sector) const { return vertex_of_sector_[sector]; }

  /// The vertices that a path can join to p in a straight line, tangent at the vertex when the graph is reduced;
  /// ascending. Of a point on a constraint: those on all its free sides. Of a vertex: of all its sectors; the vertex'
  /// own places are among them (at distance 0). With `towards`, only what is seen from the part of the surroundings of
  /// p that a straight leg from p to `towards` starts in (used for the sides of a room). Precondition: p is not
  /// outside.
  std::vector<Roadmap::Vertex> visible_from(Point p, std::optional<Point> towards = std::nullopt) const;

 private:
  void number_sectors();

  FreeSpace space_;
  VisibilityKind kind_;
  Roadmap roadmap_;
  std::vector<std::uint32_t> sectors_;
  std::vector<Roadmap::Vertex> vertex_of_sector_;
  std::vector<bool> bends_;  // by triangulation vertex: does it have a reflex sector?
};

/// The reference: every pair of vertices against every constraint, without the triangulation's visibility. O(n^3): up
/// to a few hundred corners. Gives the same roadmap as VisibilityGraph(space, kind).roadmap(), vertex for vertex, edge
/// for edge.
Roadmap visibility_graph_brute_force(const FreeSpace& space, VisibilityKind kind);

}  // namespace taut
