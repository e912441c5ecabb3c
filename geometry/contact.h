// Where a straight leg touches constraints, and on which side it passes. The ground of verify() and of the brute-force
// visibility graph, written without the triangulation so that both can judge what is built on it.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <taut/geometry/free_space.h>

namespace taut {

/// Numbers of sectors of one Star, ascending: the places at a point where a path may be.
using Sectors = std::vector<std::uint32_t>;

/// The sides of a constraint that a path can be on, seen in its direction of travel. Away from constraints: both.
enum Sides : unsigned { kNoSide = 0, kLeftSide = 1, kRightSide = 2, kBothSides = 3 };

/// The constraints around a point, sorted by exact angle, and the sectors between them.
///
///  1. A piece that ends at the centre is one ray; a piece whose interior contains it is two.
///  2. Sector i is the open angle counter-clockwise from ray i to the next ray; one ray alone bounds a sector of 360
///     degrees on both sides; without rays there is sector 0, the full circle.
///  3. Rays are numbered from the direction of the positive x axis counter-clockwise, so two stars at one point agree.
///  4. A path that touches the centre stays within one sector, however it turns there: rays separate sectors.
/// Precondition: pieces meet only at end points, and every piece given contains the centre.
class Star {
 public:
  struct Ray {
    Point towards;        ///< the end of the piece, != centre
    std::uint32_t piece;  ///< its index among the constraints
    bool solid_ccw;       ///< an obstacle's inside lies counter-clockwise of the ray
    bool solid_cw;
  };

  explicit Star(Point centre) : centre_(centre) {}
  /// The star of those constraints that `pieces` names.
  Star(Point centre, std::span<const Constraint> constraints, std::span<const std::uint32_t> pieces);

  Point centre() const { return centre_; }
  const std::vector<Ray>& rays() const { return rays_; }

  std::uint32_t sector_count() const { return rays_.empty() ? 1 : static_cast<std::uint32_t>(rays_.size()); }
  /// Does the sector lie inside an obstacle?
  bool solid(std::uint32_t sector) const;
  /// All sectors that are not solid.
  Sectors free_sectors() const;
  /// Is its angle greater than 180 degrees? False without rays.
  bool reflex(std::uint32_t sector) const;

  /// The sector that a path which leaves straight towards `to`, just to the left of that line, starts in.
  /// Precondition: to != centre.
  std::uint32_t sector_left_of(Point to) const;

  /// The sides on which a straight leg towards `to` can run when it leaves from one of `sectors`; kNoSide when
  /// rays are in the way. Precondition: to != centre.
  Sides leave(const Sectors& sectors, Point to) const;

  /// The free sectors in which a leg that comes straight from `from` on `sides` can be. Precondition: from != centre.
  Sectors arrive(Point from, Sides sides) const;

  /// Do all rays lie in one closed half-plane of the line through the centre and q? Precondition: q != centre.
  bool tangent(Point q) const;

 private:
  struct Direction {
    std::uint32_t left, right;  ///< the sectors just counter-clockwise and just clockwise of it
  };
  Direction direction(Point to) const;

  Point centre_;
  std::vector<Ray> rays_;
};

/// How a closed leg meets a constraint.
enum class Contact {
  none,
  touch,  ///< they share points, but which side the leg passes on depends on what else is there
  cross,  ///< interior through interior: no path
};

/// Exact. A leg of length zero never crosses.
Contact contact(const Segment& leg, const Constraint& constraint);

/// What became of a path on one leg.
struct LegPassage {
  bool blocked = false;
  Point at;                           ///< when blocked: the point it cannot pass
  std::vector<std::uint32_t> pieces;  ///< when blocked: the constraints at that point
  Sectors sectors;  ///< when not: the sectors of the star at the leg's end that it can be in; not empty
};

/// The star at an end of a leg. Precondition: `touching` names at least all constraints that contain the point.
Star star_at(Point centre, std::span<const Constraint> constraints, std::span<const std::uint32_t> touching);

/// Pushes the set of places of a path at leg.a along the leg: from contact to contact, in each within one sector,
/// between them on one side of the constraint it runs along. Exact. O(k log k) for k contacts. Precondition: `touching`
/// names all constraints whose contact with the leg is Contact::touch, and none is Contact::cross; `from` are sectors
/// of the star at leg.a.
LegPassage pass(const Segment& leg, const Sectors& from, std::span<const Constraint> constraints,
                std::span<const std::uint32_t> touching);

}  // namespace taut
