// The judge's world: edges of integers, the places where a shortest path can bend, and what stops a straight leg.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <taut/verify/tree.h>

namespace taut::proof {

/// A wall, or a side of a ring, solid on its left.
struct Edge {
  Place a, b;
  bool is_side = false;
  bool holds(Place p) const { return side(a, b, p) == 0 && dot(a - p, b - p) <= 0; }
  Box box() const { return {least(a, b), most(a, b)}; }
};

/// Is all of the box, as seen from u, behind edges of a chain? They have u on their left and the box on their right.
/// From beyond the box's right to beyond its left each begins at the end of the one before, or further right: no leg
/// from u into the box is open. Greedily from `last` on, so O(edges^2).
bool is_hidden(const Box& box, Place u, const std::vector<Edge>& edges, const Edge* last = nullptr);

/// All that stands at `at` lies within less than half a turn, counter-clockwise from `right` to `left`, so a shortest
/// path can bend around it. An end of the path, where it need not, has no such directions.
struct Corner {
  Place at, right{}, left{};
  Int low = 0, high = 0;  ///< of its potential: what is not listed may be rounded to either
  bool is_listed = false;
  Box box() const { return {at, at, low, high}; }
  bool is_end() const { return right == Place{}; }
  /// Can a shortest path come or go along d: neither into what stands there nor straight away from it?
  bool is_tangent(Place d) const { return sign(cross(right, d)) * sign(cross(left, d)) >= 0; }
};

struct World {
  Tree<Edge> edges;
  std::map<Place, Corner> corners;
  Real unit = 0;                            ///< of the coordinates
  std::uint64_t hash = 0xcbf29ce484222325;  ///< FNV-1a of all lines but start and goal

  /// Of what `taut convert --as integers` writes, coordinates times `scale`. Throws BadInput.
  World(const std::string& text, Int scale);

  bool joins(Place p, Place q) const;        ///< one edge holds both
  std::vector<Edge> leaving(Place p) const;  ///< what stands at p, as edges from p; sides with their solid on the left

  /// What stops the leg u v: the edge that crosses it between its ends; or `closed`, where pieces that touch each other
  /// on the leg hang together, and some such component closes it on the left and on the right. Sides may be closed at
  /// its ends, 1 the left and 2 the right, as that to which a path turns there. What only touches an end of the path
  /// closes nothing, but for a solid that it begins in.
  const Edge* leg(const Corner& u, const Corner& v, int closed_at_u = 0, int closed_at_v = 0) const;
  const Edge closed{};

 private:
  // Is p, moved by next to nothing along d and then aside to the left (shift +1) or right, no place for a path?
  bool is_solid(Place p, Place d, int shift) const;

  bool has_area_ = false;  // then all that is outside is solid
};

}  // namespace taut::proof
