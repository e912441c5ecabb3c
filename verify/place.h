// Places of integers, and what is asked of them: signs, squares.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>

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

struct Box {
  Place min, max;
  Int low = 0, high = 0;  ///< of numbers of places in it
  /// How far p is outside, along each axis.
  Place away(Place p) const { return most({}, most(min - p, p - max)); }
  /// How far its middle is, along both axes together, twice.
  Int middle(Place p) const { return std::abs(min.x - p.x + max.x - p.x) + std::abs(min.y - p.y + max.y - p.y); }
  bool holds(Place p) const { return min.x <= p.x && p.x <= max.x && min.y <= p.y && p.y <= max.y; }
  /// Does all of it lie to the left of the line from p along d?
  bool is_left(Place p, Place d) const {
    return cross(d, Place{d.y > 0 ? max.x : min.x, d.x > 0 ? min.y : max.y} - p) > 0;
  }
};

}  // namespace taut::proof
