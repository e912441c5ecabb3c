// Proofs in integers: that a path is the shortest, that there is none. docs/certificates.md says why they prove it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <taut/geometry/lattice_integers.h>
#include <taut/geometry/point.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/path.h>

namespace taut {

/// Numbers that a judge can check without any search. Places are in LatticeIntegers' unit / scale.
///
/// Of a path: `potentials` gives places where paths can bend, start and goal among them, a number each, in
/// 2^-fraction_bits of that unit; of all other such places it is `horizon` less the distance to the goal. No leg that a
/// shortest path could have joins two places whose numbers differ by more than it is long, so no path is shorter than
/// the goal's number less the start's. That falls short of the path by less than 2^-fraction_bits a leg.
/// That there is none: `potentials` gives the places that can be reached 0, the start among them; no such leg leads
/// from them to others.
struct PathCertificate {
  using Place = LatticeIntegers::Place;

  std::int64_t scale = 1;
  bool is_found = false;
  std::vector<Place> path{};  ///< its bends and ends; of none the ends
  int fraction_bits = 0;
  std::int64_t horizon = 0;
  std::vector<std::array<std::int64_t, 3>> potentials{};  ///< x, y, number; by place
};

/// Of `path` from its first point to its last: that it can be followed, and what no path is shorter than; of a path
/// that is not the shortest there is a gap between the two. Where its points are no multiples of the unit as fine as
/// its ends need, they are rounded to about a millionth of it. Bends on walls that are none of a shortest path's the
/// judge refuses. By A* in a reduced graph of the world of a point; the places it takes from its queue are listed.
/// Nothing where rounded crossings leave corners that are no places of the lattice. Throws InputError as
/// LatticeIntegers does. O(search).
std::optional<PathCertificate> shortest_certificate(const VisibilityGraph& graph, const Path& path);

/// That there is no path. Precondition: there is none. O(search).
std::optional<PathCertificate> none_certificate(const VisibilityGraph& graph, Point from, Point to);

}  // namespace taut
