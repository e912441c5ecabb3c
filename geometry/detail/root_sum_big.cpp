// Integers of any length: whatever doubles could not decide.
#include <taut/geometry/detail/root_sum.h>

#include <algorithm>

#include <taut/geometry/exact/as_double.h>
#include <taut/geometry/exact/numbers.h>
#include <taut/geometry/exact/signed_roots.h>
#include <taut/geometry/expects.h>

namespace taut::detail {

namespace {

using BigTerm = SignedRoot;
using BigTerms = std::vector<BigTerm>;

Rational exact(const twofold::Pair& p) { return Rational(p.high) + Rational(p.low); }

Rational exact(const twofold::Square& s) {
  if (s.exact) return Rational(s.sum);
  const Rational dx = exact(s.dx), dy = exact(s.dy);
  return dx * dx + dy * dy;
}

BigTerms big_terms(std::span<const RootTerm> terms) {
  BigTerms big;
  big.reserve(terms.size());
  for (const RootTerm& t : terms) big.push_back({exact(t.square), t.count});
  return big;
}

/// sqrt(v) where that is rational.
std::optional<Rational> rational_root(const Rational& v) {
  if (!is_square(numerator(v)) || !is_square(denominator(v))) return std::nullopt;
  return fraction(sqrt(numerator(v)), sqrt(denominator(v)));
}

/// The sum as rational multiples of roots no two of which are rationally dependent; the first is sqrt(1).
struct RootClass {
  Rational square;
  Rational factor;
};

std::vector<RootClass> classes(const BigTerms& terms) {
  std::vector<RootClass> all{{1, 0}};
  for (const BigTerm& t : terms) {
    bool placed = false;
    for (RootClass& c : all) {
      const auto ratio = rational_root(t.square / c.square);
      if (!ratio) continue;
      c.factor += *ratio * integer(t.count);
      placed = true;
      break;
    }
    if (!placed) all.push_back({t.square, integer(t.count)});
  }
  return all;
}

bool is_rational(const std::vector<RootClass>& all) {
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i].factor != 0) return false;
  return true;
}

/// The digits of sqrt(v) before the point in binary, to within one; 0 and less for what begins behind it.
std::int64_t digits_of_root(const Rational& v) {
  return sgn(v) == 0 ? 0 : (bits(numerator(v)) - bits(denominator(v))) / 2;
}

/// The sum of the terms, enclosed by lo 2^exponent and hi 2^exponent: of the largest root so many digits are known.
struct BigInterval {
  std::int64_t exponent = INT64_MIN;
  Integer lo = 0, hi = 0;

  BigInterval(const BigTerms& terms, std::int64_t digits) {
    for (const BigTerm& t : terms) exponent = std::max(exponent, digits_of_root(t.square) - digits);
    for (const BigTerm& t : terms) add(t);
  }

 private:
  void add(const BigTerm& t) {
    const Integer over = shifted(numerator(t.square), std::max<std::int64_t>(0, -2 * exponent)),
                  under = shifted(denominator(t.square), std::max<std::int64_t>(0, 2 * exponent));
    const Integer square = over / under, root = sqrt(square), count = integer(t.count);
    const bool exact = root * root == square && square * under == over;
    const Integer least = root * count, most = exact ? least : Integer(least + count);
    lo += t.count > 0 ? least : most;
    hi += t.count > 0 ? most : least;
  }
};

constexpr std::int64_t kFirstPrecision = 192, kClassPrecision = 384;

/// Doubles the precision until decide(enclosure) answers. An irrational sum is never where an answer changes, so only a
/// rational one needs to be known as such: `rational(value)` answers for it.
template <class Decide, class OfRational>
auto decide_sum(const BigTerms& terms, Decide decide, OfRational rational) {
  for (std::int64_t precision = kFirstPrecision;; precision *= 2) {
    if (precision == kClassPrecision)
      if (const auto all = classes(terms); is_rational(all)) return rational(all.front().factor);
    if (const auto answer = decide(BigInterval(terms, precision))) return *answer;
  }
}

/// The nearest integer, of two the even one. Precondition: v 2^exponent >= 0.
Integer rounded_half_even(const Integer& v, std::int64_t exponent) {
  if (exponent >= 0 || v == 0) return v == 0 ? v : shifted(v, exponent);
  const Integer floor = shifted(v, exponent), rest = v - shifted(floor, -exponent), half = shifted(1, -exponent - 1);
  return rest > half || (rest == half && is_odd(floor)) ? Integer(floor + 1) : floor;
}

Integer rounded_half_even(const Rational& v) {
  const Integer floor = floor_of(v);
  const int side = cmp(Rational(v - floor), fraction(1, 2));
  return side > 0 || (side == 0 && is_odd(floor)) ? Integer(floor + 1) : floor;
}

std::string with_point(const Integer& digits, int places) {
  std::string text = text_of(digits);
  const auto wanted = static_cast<std::size_t>(places);
  if (text.size() <= wanted) text.insert(0, wanted + 1 - text.size(), '0');
  if (places > 0) text.insert(text.size() - wanted, 1, '.');
  return text;
}

}  // namespace

int sign_of_roots(const std::vector<SignedRoot>& terms) {
  const auto decide = [](const BigInterval& sum) -> std::optional<int> {
    if (sgn(sum.lo) > 0) return 1;
    if (sgn(sum.hi) < 0) return -1;
    return std::nullopt;
  };
  return decide_sum(terms, decide, [](const Rational& v) { return sgn(v); });
}

int sign_by_big_numbers(std::span<const RootTerm> terms) { return sign_of_roots(big_terms(terms)); }

double nearest_by_big_numbers(std::span<const RootTerm> terms) {
  const auto decide = [](const BigInterval& sum) -> std::optional<double> {
    const auto toward = Toward::nearest;
    const double lo = as_double(sum.lo, sum.exponent, toward), hi = as_double(sum.hi, sum.exponent, toward);
    return lo == hi ? std::optional(lo) : std::nullopt;
  };
  return decide_sum(big_terms(terms), decide, [](const Rational& v) { return as_double(v, Toward::nearest); });
}

std::string decimals_by_big_numbers(std::span<const RootTerm> terms, int places) {
  TAUT_EXPECTS(places >= 0);
  const Integer scale = power(10, static_cast<unsigned>(places));
  const auto decide = [&](const BigInterval& sum) -> std::optional<Integer> {
    const Integer lo = rounded_half_even(Integer(sum.lo * scale), sum.exponent),
                  hi = rounded_half_even(Integer(sum.hi * scale), sum.exponent);
    return lo == hi ? std::optional(lo) : std::nullopt;
  };
  const auto rational = [&](const Rational& v) { return rounded_half_even(Rational(v * scale)); };
  return with_point(decide_sum(big_terms(terms), decide, rational), places);
}

}  // namespace taut::detail
