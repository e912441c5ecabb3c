// Doubles beside exact numbers and their square roots, by integers alone: a root is that of a shifted integer.
#pragma once

#include <taut/geometry/exact/numbers.h>

namespace taut {

/// Which double, of the two that enclose a value; of two equally near ones the even one. Beyond the largest double lies
/// infinity; the least ones, of few digits, are met as all others.
enum class Toward { down, nearest, up };

double as_double(const Rational& v, Toward toward);

/// v 2^exponent. Precondition: v >= 0.
double as_double(const Integer& v, std::int64_t exponent, Toward toward);

/// sqrt(v). Precondition: v >= 0.
double root_as_double(const Rational& v, Toward toward);

}  // namespace taut
