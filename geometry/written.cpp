#include <taut/geometry/written.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string>

#include <taut/geometry/detail/ring_tests.h>
#include <taut/geometry/detail/written_integers.h>
#include <taut/geometry/exact/exact_point.h>

namespace taut::written {

namespace {

using taut::detail::kPowersOfTen;

constexpr int kExactPowers = 22;  // 10^22 is the last one that is a double
constexpr double kDigits = 1e15;

bool is_integer(double v) { return std::abs(v) <= 0x1p53 && v == std::floor(v); }

Decimal stripped(std::int64_t digits, int places) {
  if (digits == 0) return {};
  for (; digits % 10 == 0; digits /= 10) --places;
  return {digits, places};
}

/// From the shortest text, where powers of ten are no doubles any more.
std::optional<Decimal> decimal_of_text(double v) {
  std::array<char, 32> text;
  char* end = std::to_chars(text.data(), text.data() + text.size(), v, std::chars_format::scientific).ptr;
  char* const exponent_at = std::find(text.data(), end, 'e');
  int exponent = 0;
  std::from_chars(exponent_at[1] == '+' ? exponent_at + 2 : exponent_at + 1, end, exponent);
  end = std::remove(text.data(), exponent_at, '.');
  std::int64_t digits = 0;
  std::from_chars(text.data(), end, digits);
  const int count = static_cast<int>(end - text.data()) - (v < 0 ? 1 : 0);
  if (count > std::numeric_limits<double>::digits10) return std::nullopt;
  return stripped(digits, count - 1 - exponent);
}

double double_of_text(std::int64_t digits, int places) {
  const std::string text = std::to_string(digits) + "e" + std::to_string(-places);
  double result = 0;
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result;
}

/// The decimals of two numbers over one power of ten, when 64 bits hold them.
struct Pair {
  std::int64_t a, b;
  int places;
};

std::optional<std::int64_t> raised(std::int64_t digits, int by) {
  for (; by > 0; --by)
    if (__builtin_mul_overflow(digits, std::int64_t{10}, &digits)) return std::nullopt;
  return digits;
}

std::optional<Pair> over_one_power(double a, double b) {
  const auto p = decimal(a), q = decimal(b);
  if (!p || !q) return std::nullopt;
  const int places = std::max(p->places, q->places);
  const auto x = raised(p->digits, p->digits == 0 ? 0 : places - p->places),
             y = raised(q->digits, q->digits == 0 ? 0 : places - q->places);
  if (!x || !y || std::max(std::abs(*x), std::abs(*y)) > (std::int64_t{1} << 58)) return std::nullopt;
  return Pair{*x, *y, places};
}

double nearest(std::int64_t digits, int places) {
  const Decimal d = stripped(digits, places);
  return number(d.digits, d.places);
}

}  // namespace

std::optional<Decimal> decimal(double v) {
  if (v == 0) return Decimal{};
  int exponent = 0;
  std::frexp(v, &exponent);  // 2^(exponent - 1) <= |v|
  const int decade = static_cast<int>(std::floor((exponent - 1) * 0.30102999566398120));
  const double size = std::abs(v);
  // |v| has its first digit at `decade`, or one above.
  for (int places = 14 - decade; places >= 13 - decade; --places) {
    if (std::abs(places) > kExactPowers) return decimal_of_text(v);
    const double power = kPowersOfTen[std::abs(places)],
                 digits = std::nearbyint(places >= 0 ? size * power : size / power);
    if (digits > kDigits) continue;
    // One division or product of exact numbers: what is nearest to the decimal.
    if ((places >= 0 ? digits / power : digits * power) != size) return std::nullopt;
    return stripped(static_cast<std::int64_t>(std::copysign(digits, v)), places);
  }
  return std::nullopt;
}

double number(std::int64_t digits, int places) {
  constexpr std::int64_t exact = std::int64_t{1} << 53;
  if (digits >= -exact && digits <= exact) {
    if (places >= 0 && places <= kExactPowers) return static_cast<double>(digits) / kPowersOfTen[places];
    if (places < 0 && places >= -kExactPowers) return static_cast<double>(digits) * kPowersOfTen[-places];
  }
  return double_of_text(digits, places);
}

bool is_plain(double v) {
  if (is_integer(v)) return true;
  const auto d = decimal(v);
  if (!d) return true;
  if (d->places >= 0 && d->places <= kExactPowers)
    return std::fma(v, kPowersOfTen[d->places], -static_cast<double>(d->digits)) == 0;
  return taut::meaning(v) == Rational(v);
}

double sum(double a, double b) {
  const double rough = a + b;
  if (is_integer(a) && is_integer(b) && is_integer(rough)) return rough;
  if (const auto p = over_one_power(a, b)) return nearest(p->a + p->b, p->places);
  return taut::nearest_double(taut::meaning(a) + taut::meaning(b));
}

double middle(double a, double b) {
  if (const auto p = over_one_power(a, b)) {
    const std::int64_t twice = p->a + p->b;
    if (twice % 2 == 0) return nearest(twice / 2, p->places);
    if (const auto tenth = raised(twice, 1)) return nearest(*tenth / 2, p->places + 1);
  }
  return taut::nearest_double((taut::meaning(a) + taut::meaning(b)) / 2);
}

double times(std::int64_t n, double a) {
  std::int64_t product = 0;
  if (const auto d = decimal(a); d && !__builtin_mul_overflow(d->digits, n, &product))
    return nearest(product, d->places);
  return static_cast<double>(n) * a;
}

int compare_sum(double a, double b, double c) {
  const double rough = a + b - c, bound = 4.5e-16 * (std::abs(a) + std::abs(b) + std::abs(c)) + 1e-290;
  if (std::abs(rough) > bound) return rough > 0 ? 1 : -1;
  return sgn(Rational(taut::meaning(a) + taut::meaning(b) - taut::meaning(c)));
}

bool segments_meet(const Segment& s, const Segment& t) {
  return written::cross_properly(s, t) || written::on_segment(t.a, s.a, s.b) || written::on_segment(t.b, s.a, s.b) ||
         written::on_segment(s.a, t.a, t.b) || written::on_segment(s.b, t.a, t.b);
}

int ring_orientation(const Ring& ring) { return taut::detail::ring_orientation_by(ring, written::orientation); }

int side_of_ring(Point p, const Ring& ring) {
  return taut::detail::side_of_ring_by(p, ring, written::orientation, written::on_segment);
}

}  // namespace taut::written
