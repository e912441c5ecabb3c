// How many units of a lattice make 1. Private.
#pragma once

#include <taut/geometry/exact/numbers.h>
#include <taut/geometry/number_lattice.h>

namespace taut::detail {

inline Rational per_one_of(const NumberLattice& lattice) {
  return Rational(power(static_cast<unsigned>(lattice.base), static_cast<unsigned>(lattice.exponent)));
}

}  // namespace taut::detail
