// Ends and walls, and which are near to which. Private: the ground of snap.h.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <taut/geometry/box_index.h>
#include <taut/geometry/point.h>
#include <taut/geometry/snap.h>
#include <taut/geometry/world.h>

namespace taut::detail {

/// Has the point a coordinate that was computed: a double that no decimal of at most 15 digits means?
bool is_computed(Point p);

/// Where a segment is nearest to a point.
struct Foot {
  double distance = 0;
  double along = 0;  ///< 0 at a, 1 at b
};
Foot foot(Point p, const Segment& s);

/// Is p no farther from s than `reach`? By what the numbers mean where doubles are not sure.
bool is_within(const Foot& foot, Point p, const Segment& s, double reach);

/// Does a wall that thick reach so far from its middle line?
inline bool covers(double thickness, double distance) { return thickness > 0 && thickness >= 2 * distance; }

/// A wall, or a side of a ring.
struct Piece {
  std::uint32_t a = 0;  ///< numbers of its ends
  std::uint32_t b = 0;
  std::uint32_t area = 0;  ///< number of its polygon, from 1, areas first; 0: a wall
  double thickness = 0;
  int line = 0;
};

/// All walls and sides of a world, in order: walls, then the rings of areas and solids, outer ring first; and all
/// their different ends, in lexicographic order.
class NearPairs {
 public:
  /// `ends` are further points, of no wall. Precondition: all coordinates are valid.
  explicit NearPairs(const WorldParts& parts, std::span<const Point> ends = {});

  const std::vector<Point>& points() const { return points_; }
  const std::vector<Piece>& pieces() const { return pieces_; }
  Segment segment(std::uint32_t piece) const { return {points_[pieces_[piece].a], points_[pieces_[piece].b]}; }
  /// The pieces that end there.
  std::span<const std::uint32_t> around(std::uint32_t point) const {
    return {around_.data() + first_[point], first_[point + 1] - first_[point]};
  }
  /// Is a coordinate no number that anybody writes?
  bool is_computed(std::uint32_t point) const { return computed_[point]; }
  bool any_computed() const;
  /// The largest thickness around.
  double thickness(std::uint32_t point) const;

  /// Calls visit(piece) for all pieces whose box is no farther than `reach` from p's.
  template <typename Visit>
  void near(Point p, double reach, Visit&& visit) const {
    const double wide = reach + 0x1p-50 * (std::abs(p.x) + std::abs(p.y));  // what a number means may lie beside it
    index_.meeting({{p.x - wide, p.y - wide}, {p.x + wide, p.y + wide}}, visit);
  }

 private:
  void add_ring(const Ring& ring, std::uint32_t area, int line);
  std::uint32_t number(Point p) const;

  std::vector<Point> points_;
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> first_, around_;
  std::vector<bool> computed_;
  BoxIndex index_{{}};
};

/// Calls visit(ring, area's number from 1, line) for every ring in the order of NearPairs.
template <typename Parts, typename Visit>
void for_each_ring(Parts& parts, Visit&& visit) {
  std::uint32_t number = 0;
  for (auto* areas : {&parts.areas, &parts.solids})
    for (auto& area : *areas) {
      visit(area.polygon.outer, ++number, area.line);
      for (auto& hole : area.polygon.holes) visit(hole, number, area.line);
    }
}

/// Calls visit(p) for all ends of walls and corners of rings.
template <typename Visit>
void for_each_place(const WorldParts& parts, Visit&& visit) {
  for (const Wall& wall : parts.walls) {
    visit(wall.a);
    visit(wall.b);
  }
  for_each_ring(parts, [&](const Ring& ring, std::uint32_t, int) {
    for (const Point p : ring) visit(p);
  });
}

/// The longer side of the box around all places.
double extent(const WorldParts& parts);

/// A contact and the number of the other piece.
struct NumberedContact : NearContact {
  std::uint32_t piece = 0;
};

/// All contacts no farther apart than `reach` and, with a `share` above 0, nearer than that of the shorter wall; see
/// near_contacts.
std::vector<NumberedContact> contacts_within(const WorldParts& parts, double reach, double share);

}  // namespace taut::detail
