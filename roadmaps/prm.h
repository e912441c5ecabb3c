// Probabilistic roadmaps: sampled vertices, exactly tested edges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/roadmaps/roadmap.h>

namespace taut {

/// Where the vertices of a PRM come from. Every sample is a vertex only if it is clear (PrmOptions, guarantee 1). A
/// zero-thickness wall has no inside to draw from, so "in an obstacle" is read as "not to be reached by a clear
/// straight leg" in gaussian and bridge.
enum class PrmSampler {
  /// Uniform in the world's box.
  uniform,
  /// The points of PrmLattice in the box, row by row from the bottom left; no randomness.
  lattice,
  /// Uniform p, q near it; p when the leg p q is not clear (Boor, Overmars, van der Stappen 1999).
  gaussian,
  /// Uniform p, a point near it and its mirror image in p; p when neither leg is clear (Hsu, Jiang, Reif, Sun 2003).
  bridge,
  /// Uniform p, moved straight away from the nearest obstacle until another is as near, to about a millionth of the way
  /// (Wilmarth, Amato, Stiller 1999).
  medial,
  /// Every other one uniform, the others near a corner that a path can bend around.
  corners,
  /// Spread evenly in the world's box: the first two dimensions of Sobol's sequence (1967), each with the bits of its
  /// 32-digit fractions flipped where those of a number drawn from the seed are set, so that it is another one for each
  /// seed. Of its first 2^k points one lies in each of the 2^k boxes of 2^i columns and 2^(k - i) rows, for all i: no
  /// corridor goes without for long, and in mazes half as many are enough as of uniform ones.
  sobol,
};

/// The points origin + (i, j) * spacing.
struct PrmLattice {
  Point origin;
  double spacing = 1;  ///< > 0
};

/// Which pairs of vertices become edges, when they pass the test.
struct PrmConnection {
  enum class Rule {
    nearest,  ///< each vertex and its `count` nearest (Kavraki, Svestka, Latombe, Overmars 1996)
    visible,  ///< each vertex and the `count` nearest that pass the test, among its 4 * `count` nearest
    radius,   ///< each vertex and all within `radius`
    /// As nearest, among 4 * `count`, but no pair that hangs together already: quick, no cycles, long ways (same
    /// source)
    forest,
    star,  ///< nearest, with count = ceil(e (1 + 1/2) ln n) of n vertices (k-PRM*: Karaman, Frazzoli 2011)
  };
  Rule rule = Rule::nearest;
  std::size_t count = 8;  ///< >= 1
  double radius = 1;      ///< > 0
};

/// How a PRM is made. The default is the basic algorithm: 500 uniform samples, each joined to its 8 nearest.
///
///  1. A vertex is clear: no obstacle (any FreeSpace::constraints(), openings included) is nearer than `clearance`, and
///     none touches it. An edge is clear: a path can go straight along it (FreeSpace::sees), and no obstacle is nearer
///     to it than `clearance`. Both are exact. With clearance 0 an edge may touch obstacles, a vertex never does: so
///     any chain of edges is a path.
///  2. Same space, options and seed, same roadmap, byte for byte: vertices in the order drawn, neighbours equally far
///     by index, draws from std::mt19937_64 alone.
struct PrmOptions {
  PrmSampler sampler = PrmSampler::uniform;
  /// How many samples are drawn, not how many are kept. Absent: 500; of a lattice all its points.
  std::optional<std::size_t> samples{};
  std::uint64_t seed = 1;
  double clearance = 0;  ///< >= 0
  PrmConnection connection{};
  /// Absent: the cell centres of the grid the world came from, else the integers.
  std::optional<PrmLattice> lattice{};
  /// How near "near" is in gaussian, bridge and corners: the standard deviation of each coordinate. Absent: half the
  /// root of the box's area per obstacle piece, about half a corridor in a maze.
  std::optional<double> spread{};
};

/// What it took.
struct PrmCounts {
  std::size_t drawn = 0;         ///< samples
  std::size_t kept = 0;          ///< those that are vertices
  std::size_t edges_tested = 0;  ///< each pair once
  std::size_t edges = 0;         ///< those that passed
  std::size_t components = 0;    ///< connected parts of the roadmap
};

/// The probabilistic roadmap of a space, all edges tested at once. Expected O(n log n + k n * (triangles or obstacles
/// along an edge)) for n vertices with k neighbours. Throws InputError when a lattice would have 2^32 points or more in
/// the box.
Roadmap prm(const FreeSpace& space, const PrmOptions& options = {}, PrmCounts* counts = nullptr);

/// The `count` nearest vertices of a roadmap that p can be joined to straight, nearest first (equally far ones by
/// index): how an end of a query joins a PRM. A leg keeps `clearance` when p itself has it; from a p with less (in an
/// opening, at a wall) a leg is any that FreeSpace::sees. Precondition: p is not outside. O(n log n).
std::vector<Roadmap::Vertex> nearest_visible(const FreeSpace& space, const Roadmap& roadmap, Point p, std::size_t count,
                                             double clearance = 0);

}  // namespace taut
