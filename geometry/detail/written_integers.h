// Coordinates as integers over one power of ten. Private.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace taut::detail {

/// 10^0 to 10^22: all that are doubles.
inline constexpr std::array<double, 23> kPowersOfTen{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// The largest integer made of a coordinate: differences of two are exact in double, products of two fit 128 bits.
inline constexpr double kLargestInteger = 1e15;

/// v times 10^places when v means an integer of at most 15 digits over that power; else NaN. Precondition: places is in
/// [0, 22].
inline double integer_over(double v, int places) {
  const double power = kPowersOfTen[places], product = v * power;
  if (!(std::abs(product) < 2e15)) return NAN;
  const double n = (product + 0x1.8p52) - 0x1.8p52;  // the nearest integer
  return std::abs(n) <= kLargestInteger && n / power == v ? n : NAN;
}

/// The least power of ten over which all `count` numbers mean integers up to kLargestInteger; -1 when there is none.
int common_places(const double* values, std::size_t count);

/// The numbers as integers over one power of ten. Tries the power that did last time first: a world has one.
bool to_integers(const double* values, std::size_t count, double* integers);

}  // namespace taut::detail
