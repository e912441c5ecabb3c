// The visibility graph of a free space row by row, for those who do not keep it.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/geometry/progress.h>
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

/// The vertices of a visibility graph: sectors of the triangulation, in their order.
struct VisibilityVertices {
  VisibilityVertices(const Triangulation& tri, VisibilityKind kind);

  std::vector<std::uint32_t> sectors;                         ///< of each vertex, ascending
  std::vector<Roadmap::Vertex> vertex_of_sector;              ///< kNone where it has none
  std::vector<Point> points(const Triangulation& tri) const;  ///< where they are
};

/// The edges of a visibility graph, found one vertex at a time: memory grows with the free space, never with the number
/// of edges. Immutable.
///
///  1. Each edge is found once, from its left end (the lower one of an upright edge): what it costs to look into all
///     directions is halved.
///  2. Exact: int64 on lattices, filtered predicates elsewhere.
///  3. Of a run of vertices in one line, the view passes the first ones on the side where they let it; only where it
///     has to change sides does it follow the line itself.
/// Built in O(n); a row takes O(triangles seen), each counted once a cone. Source: Bungiu, Hemmer, Hershberger, Huang,
/// Kröller, "Efficient computation of visibility polygons" (2014).
class VisibilityRows {
 public:
  using Vertex = Roadmap::Vertex;

  VisibilityRows(const FreeSpace& space, VisibilityKind kind);

  const FreeSpace& space() const;
  const VisibilityVertices& vertices() const;

  /// Finds rows; one for each thread that does.
  class Finder {
   public:
    explicit Finder(const VisibilityRows& rows);
    Finder(Finder&&) noexcept;
    ~Finder();

    /// The neighbours of v to the right of it, or straight above; each once, in an order that is always the same.
    /// Valid until the next call.
    std::span<const Vertex> row(Vertex v);

    struct Impl;

   private:
    std::unique_ptr<Impl> impl_;
  };

 private:
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

/// All of it, in compressed rows, found by `jobs` threads: the same for any number. Told are the vertices whose edges
/// are found.
Roadmap roadmap_of(const VisibilityRows& rows, unsigned jobs = 1, const TellProgress& tell = {});

}  // namespace taut
