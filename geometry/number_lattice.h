// The lattice that the numbers of a world lie on.
#pragma once

#include <optional>
#include <string>

#include <taut/geometry/point.h>
#include <taut/geometry/world.h>

namespace taut {

/// Multiples of one unit, counted from a corner of the world's box.
struct NumberLattice {
  int base = 10;       ///< the unit is base^-exponent: a decimal (10) or a binary fraction (2)
  int exponent = 0;    ///< >= 0
  Point origin;        ///< the lower left corner of the box
  double largest = 0;  ///< of the integers: the longer side of the box in units, to the nearest double

  double unit() const;
};

/// The lattice of all coordinates that the input gave (walls, rings; thicknesses, start and goal never decide it): the
/// unit 10^-k or 2^-j of which they are multiples counted from the corner, the one with the smaller integers; nothing
/// when these would reach 2^52, or when no such unit exists (computed numbers).
std::optional<NumberLattice> number_lattice(const World& world);

/// `integers`, `decimals, 1 mm if the unit is a metre (0.001)`, `decimals, 1e-07`, `binary fractions, 1/1024`.
std::string text(const NumberLattice& lattice);

}  // namespace taut
