// The sign of a sum of square roots of rationals.
#pragma once

#include <cstdint>
#include <vector>

#include <taut/geometry/exact/numbers.h>

namespace taut {

/// count * sqrt(square). Precondition: square >= 0.
struct SignedRoot {
  Rational square;
  std::int64_t count = 1;
};

/// A rational as a term of such a sum.
inline SignedRoot rational_term(const Rational& v) { return {Rational(v * v), sgn(v) < 0 ? -1 : 1}; }

/// The sign of their sum, exactly: by roots of ever more digits; a sum that is 0 is known by its classes of rationally
/// dependent roots (as in length.h, 2), each of which cancels.
int sign_of_sum(const std::vector<SignedRoot>& terms);

}  // namespace taut
