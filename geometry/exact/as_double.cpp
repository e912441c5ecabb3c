#include <taut/geometry/exact/as_double.h>

#include <algorithm>
#include <bit>
#include <limits>

#include <taut/geometry/expects.h>

namespace taut {

namespace {

constexpr std::int64_t kLeastExponent = -1074;  // of a double's last digit
constexpr std::int64_t kMostDigits = 1024;      // before the point

/// v 2^exponent, and something less than 2^exponent when there is `more`. v >= 0.
struct Digits {
  Integer v;
  std::int64_t exponent = 0;
  bool more = false;
};

/// How many of the digits a double has no room for. 0 or less: it has room for all.
std::int64_t excess_of(const Digits& d) { return std::max(bits(d.v) - 53, kLeastExponent - d.exponent); }

/// Do the last `excess` digits, which are cut off `kept`, make it one more?
bool goes_up(const Digits& d, const Integer& kept, std::int64_t excess, Toward toward) {
  const Integer rest = d.v - shifted(kept, excess);
  if (toward == Toward::down || (rest == 0 && !d.more)) return false;
  if (toward == Toward::up) return true;
  const Integer half = shifted(1, excess - 1);
  return rest > half || (rest == half && (d.more || is_odd(kept)));
}

double made(std::int64_t mantissa, std::int64_t exponent, Toward toward) {
  const auto digits = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(mantissa)));
  if (exponent + digits > kMostDigits)
    return toward == Toward::down ? std::numeric_limits<double>::max() : std::numeric_limits<double>::infinity();
  return std::ldexp(static_cast<double>(mantissa), static_cast<int>(exponent));
}

/// Precondition: where there is more, there are 55 digits already.
double double_of(const Digits& d, Toward toward) {
  if (d.v == 0) return 0;
  const std::int64_t excess = excess_of(d);
  if (excess <= 0) return made(to_int64(d.v), d.exponent, toward);
  const Integer kept = shifted(d.v, -excess);
  return made(to_int64(kept) + goes_up(d, kept, excess, toward), d.exponent + excess, toward);
}

/// The first digits of over / under, so many at least; the exponent is even. Precondition: both are positive.
Digits quotient(const Integer& over, const Integer& under, std::int64_t digits) {
  std::int64_t exponent = bits(over) - bits(under) - digits;
  exponent -= exponent & 1;
  const Integer dividend = exponent < 0 ? shifted(over, -exponent) : over,
                divisor = exponent < 0 ? under : shifted(under, exponent);
  const Integer whole = dividend / divisor;
  return {whole, exponent, whole * divisor != dividend};
}

Toward mirrored(Toward toward) {
  return toward == Toward::down ? Toward::up : toward == Toward::up ? Toward::down : toward;
}

}  // namespace

double as_double(const Rational& v, Toward toward) {
  const int sign = sgn(v);
  if (sign == 0) return 0;
  if (sign < 0) return -as_double(Rational(-v), mirrored(toward));
  return double_of(quotient(numerator(v), denominator(v), 64), toward);
}

double as_double(const Integer& v, std::int64_t exponent, Toward toward) {
  TAUT_EXPECTS(sgn(v) >= 0);
  return double_of({v, exponent, false}, toward);
}

double root_as_double(const Rational& v, Toward toward) {
  TAUT_EXPECTS(sgn(v) >= 0);
  if (sgn(v) == 0) return 0;
  const Digits square = quotient(numerator(v), denominator(v), 128);
  const Integer root = sqrt(square.v);
  return double_of({root, square.exponent / 2, square.more || root * root != square.v}, toward);
}

#ifdef TAUT_BOOST_NUMBERS

double to_double(const Rational& v) { return as_double(v, sgn(v) < 0 ? Toward::up : Toward::down); }

double to_double(const BigFloat& v) {
  const auto near = static_cast<double>(v);
  return abs(BigFloat(near)) > abs(v) ? std::nextafter(near, 0.0) : near;
}

#endif

}  // namespace taut
