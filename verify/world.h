// The judge's world: edges of integers, the places where a shortest path can bend, and what stops a straight leg.
#pragma once

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace taut::proof {

using Int = std::int64_t;
__extension__ using Wide = __int128;
using Real = long double;  ///< of nothing but words and guesses

/// A text that cannot be read. what() is one line.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline constexpr Int kLargest = Int{1} << 51;  ///< of coordinates: products of differences leave 128 bits room
struct Place {
  Int x = 0, y = 0;
  friend auto operator<=>(Place, Place) = default;
};
inline Place operator-(Place p, Place q) { return {p.x - q.x, p.y - q.y}; }
inline Place least(Place p, Place q) { return {std::min(p.x, q.x), std::min(p.y, q.y)}; }
inline Place most(Place p, Place q) { return {std::max(p.x, q.x), std::max(p.y, q.y)}; }
inline Wide cross(Place d, Place e) { return Wide{d.x} * e.y - Wide{d.y} * e.x; }
inline Wide dot(Place d, Place e) { return Wide{d.x} * e.x + Wide{d.y} * e.y; }
inline int sign(Wide v) { return (v > 0) - (v < 0); }
inline int side(Place p, Place q, Place r) { return sign(cross(q - p, r - p)); }  ///< +1: r is to the left of p -> q

/// A wall, or a side of a ring, solid on its left.
struct Edge {
  Place a, b;
  bool is_side = false;
  bool holds(Place p) const { return side(a, b, p) == 0 && dot(a - p, b - p) <= 0; }
};

/// All that stands at `at` lies within less than half a turn, counter-clockwise from `right` to `left`, so a shortest
/// path can bend around it. An end of the path, where it need not, has no such directions.
struct Corner {
  Place at, right{}, left{};
  bool is_end() const { return right == Place{}; }
  /// Can a shortest path come or go along d: neither into what stands there nor straight away from it?
  bool is_tangent(Place d) const { return sign(cross(right, d)) * sign(cross(left, d)) >= 0; }
};

struct World {
  std::vector<Edge> edges;
  std::vector<Corner> corners;
  Place low, high;                          ///< the box of all edges
  Real unit = 0;                            ///< of the coordinates
  std::uint64_t hash = 0xcbf29ce484222325;  ///< FNV-1a of all lines but start and goal

  /// Of what `taut convert --as integers` writes, coordinates times `scale`. Throws BadInput.
  World(const std::string& text, Int scale);

  std::string text(Place p) const;     ///< `(0.5, 1)`, in the world's own unit
  bool joins(Place p, Place q) const;  ///< one edge holds both

  /// The edge that crosses the leg u v between its ends; else kOpen, or kClosed: pieces that touch each other on the
  /// leg hang together, and some such component closes it on the left and on the right. Where a path turns at an end,
  /// +1 to the left, -1 to the right, that side is closed there. What only touches an end of the path closes nothing,
  /// but for a solid that it begins in.
  int leg(const Corner& u, const Corner& v, int turn_at_u = 0, int turn_at_v = 0) const;
  static constexpr int kOpen = -1, kClosed = -2;

 private:
  // Is p, moved by next to nothing along d and then aside to the left (shift +1) or right, no place for a path?
  bool is_solid(Place p, Place d, int shift) const;
  void find_corners();
  template <class Visit>
  bool cells(Place p, Place q, Visit visit) const;

  bool has_area_ = false;  // then all that is outside is solid
  Int size_ = 1, columns_ = 1, rows_ = 1;
  std::vector<std::vector<std::uint32_t>> grid_;  // edges by cell
};

}  // namespace taut::proof
