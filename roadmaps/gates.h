// Where walls come near each other: the gates a disc has to pass.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <taut/geometry/free_space.h>

namespace taut {

struct ExactGates;

/// The shortest connection of two pieces of wall that have nothing between them. One of its ends is always an end of a
/// piece.
struct Gate {
  Point end;                         ///< an end point of `constraint`, exact
  Point foot;                        ///< the point of `facing` nearest to `end`, to the nearest doubles
  std::uint32_t constraint = kNone;  ///< the lowest of those that end in `end`
  std::uint32_t facing = kNone;      ///< the constraint that holds the foot; the lowest when the foot is an end
  bool foot_is_end = false;          ///< the foot is an end of `facing`
  bool foot_is_exact = false;  ///< the foot is a pair of doubles, as all ends and all feet on axis-parallel pieces are
  bool to_opening = false;     ///< one of the two is no wall but an opening of the world
  double width = 0;            ///< diameter of the largest disc that passes, to the nearest double
};

/// All gates of a point robot's free space: what decides where a disc of radius r > 0 can go. docs/disc-gates.md has
/// the proofs.
///
///  1. Pieces of wall are the constraints of the space, except for openings. A constraint is an opening when no wall
///     runs along it and it lies on one of World::openings() or, in a Boundary::open world, on the outline: the centre
///     may stand on it, not cross it, and the disc may stick out.
///  2. A gate is a pair of points, nearest to each other, of two pieces of wall (`width`: their distance), or of a
///     piece of wall and an opening (`width`: twice the distance: there the centre has to squeeze through). Between
///     walls, the closed disc that has the pair as diameter touches no further wall; to an opening, no wall is nearer
///     to the place on the opening. Of several equally near pairs (parallel pieces) one is taken. Openings hide
///     nothing.
///  3. They suffice: a disc of radius r gets from s to g, both places for it, iff no closed chain of touching
///     constraints and gates with width < 2r separates s from g. Width 2r passes: a disc may touch on both sides.
///  4. Gates are O(n) between walls, and none crosses another. They may cross openings.
///  5. Exact: what is a gate, and how widths compare. Coordinates and widths in the struct are rounded.
///  6. Ordered by width, then (end, foot, facing). Same space, same gates.
///
/// An end of wall looks outward through the triangulation, no further than what it has seen allows (half-planes: a gate
/// p q with a wall point x has (q - p) (x - p) < |x - p|^2), then each candidate's disc is tested against an R-tree.
/// Expected O(n log n) for walls spread evenly; O(n^2) at worst. Walls outside the world's areas, which the point's
/// free space does not hold, are not seen.
/// Precondition: the space's footprint is Footprint::point().
class Gates {
 public:
  explicit Gates(const FreeSpace& space);

  const FreeSpace& space() const;

  /// Narrowest first.
  const std::vector<Gate>& gates() const;

  /// Is the constraint an opening (guarantee 1)?
  bool is_opening(std::uint32_t constraint) const;

  /// How gate i's exact width compares to `diameter` >= 0, and to gate j's.
  std::strong_ordering compare_width(std::uint32_t i, double diameter) const;
  std::strong_ordering compare_widths(std::uint32_t i, std::uint32_t j) const;

  /// For people: `2/5`, a fraction as in name().
  std::string width_text(std::uint32_t i) const;
  /// For people: `2/5 between (7.5, 3) and (7.9, 3)`. The width is a fraction when it is one with a denominator up to
  /// 1000, of the coordinates read as the decimals they are printed as; else the nearest double.
  std::string name(std::uint32_t i) const;

  /// Widths and shapes as exact numbers (roadmaps/exact/exact_gates.h).
  const ExactGates& exact() const { return *exact_; }

 private:
  std::shared_ptr<const ExactGates> exact_;
};

}  // namespace taut
