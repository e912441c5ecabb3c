// How walls stand together: the constants of the random field that sampled mazes follow. Private.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace taut::micromouse::detail {

/// How four walls around a post, or around a cell, can stand, up to symmetry.
enum class Quad : std::uint8_t { none, one, straight, corner, three, four };

/// Of a set of sides as bits in Side's order.
constexpr Quad quad_of(unsigned sides) {
  switch (std::popcount(sides & 15U)) {
    case 0: return Quad::none;
    case 1: return Quad::one;
    case 2: return (sides & 15U) == 5 || (sides & 15U) == 10 ? Quad::straight : Quad::corner;
    case 3: return Quad::three;
    default: return Quad::four;
  }
}

/// Logarithms of the factors. Fitted by maximum pseudo-likelihood (each wall given all others: a logistic regression;
/// ridge 1) to generated mazes of 12 to 16 cells a side with 38 % of the interior walls, 90 plain ones and 60 whose
/// shortest routes are kept long. A wall of them is foretold at 0.47 nats, against 0.66 when walls are taken for
/// independent; of competition mazes, which were not fitted, the samples serve as well as with constants fitted to
/// those.
struct WallField {
  std::array<double, 6> post{0.35, 0.70, 0.98, 0.45, -0.40, -2.1};  // by Quad; interior posts
  std::array<double, 6> cell{0.12, 0.62, 0.82, 1.5, 0.5, -8};       // no cell is walled in
  double border_arm = -1.53;                                        // a wall that ends at the border
  double wall = -0.21;                                              // any wall

  double post_of(unsigned arms) const { return post[static_cast<std::size_t>(quad_of(arms))]; }
  double cell_of(unsigned sides) const { return cell[static_cast<std::size_t>(quad_of(sides))]; }
};

inline constexpr WallField kField;

}  // namespace taut::micromouse::detail
