// Proofs in integers: that a path is the shortest, that there is none. docs/certificates.md says why they prove it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <taut/geometry/lattice_integers.h>
#include <taut/geometry/point.h>
#include <taut/geometry/world.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/path.h>

namespace taut {

/// Numbers that a judge can check without any search. Places are in LatticeIntegers' unit / scale.
///
/// Of a path: `potentials` gives places where paths can bend, the start among them, a number each, in 2^-fraction_bits
/// of that unit; of all other such places it is `horizon` less the distance to the goal, and wherever the goal is
/// reached it is `reach`. No leg that a shortest path could have joins two places whose numbers differ by more than it
/// is long, so no path is shorter than `reach` less the start's. That falls short of the path by less than
/// 2^-fraction_bits a leg.
/// That there is none: `potentials` gives the places that can be reached 0, the start among them; no such leg leads
/// from them to others, nor to the goal.
struct PathCertificate {
  using Place = LatticeIntegers::Place;

  std::int64_t scale = 1;
  bool is_found = false;
  std::vector<Place> path{};    ///< its bends and ends; of none the start
  std::array<Place, 2> goal{};  ///< two corners of the room; of a point twice that
  int fraction_bits = 0;
  std::int64_t horizon = 0;
  std::int64_t reach = 0;
  std::vector<std::array<std::int64_t, 3>> potentials{};  ///< x, y, number; by place
};

/// Is the goal a point, or a room that is a rectangle? Of other goals there are no certificates.
bool is_certifiable(const Goal& goal);

/// Of `path` from its first point into the goal: that it can be followed, and what no path is shorter than; of a path
/// that is not the shortest there is a gap between the two. Where its points are no multiples of the unit as fine as
/// its ends need, they are rounded to about a millionth of it. Bends on walls that are none of a shortest path's the
/// judge refuses. By A* in a reduced graph of the world of a point; the places it takes from its queue are listed.
/// Nothing where rounded crossings leave corners that are no places of the lattice, or where sloped walls cross a
/// room's border at fractions that 51 bits do not hold. Precondition: is_certifiable(to). Throws InputError as
/// LatticeIntegers does. O(search). The unit is halved `halvings` times at most.
std::optional<PathCertificate> shortest_certificate(const VisibilityGraph& graph, const Path& path, const Goal& to,
                                                    int halvings = 20);

/// That there is no path. Preconditions: there is none; is_certifiable(to). O(search).
std::optional<PathCertificate> none_certificate(const VisibilityGraph& graph, Point from, const Goal& to);

}  // namespace taut
