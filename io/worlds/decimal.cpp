#include <taut/io/worlds/detail/decimal.h>

#include <algorithm>
#include <array>

namespace taut::pursuit::detail {

namespace {

constexpr std::array<std::uint64_t, 20> kPowers = [] {
  std::array<std::uint64_t, 20> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = 10 * powers[i - 1];
  return powers;
}();

constexpr int kMostDigits = 18;
constexpr int kLargestExponent = 100000;

int digits_of(std::uint64_t value) {
  return static_cast<int>(std::upper_bound(kPowers.begin(), kPowers.end(), value) - kPowers.begin());
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Digits on both sides of the point.
struct Digits {
  Decimal value;
  int kept = 0;
  bool any = false;

  void add(char c, bool fraction) {
    any = true;
    const auto digit = static_cast<std::uint64_t>(c - '0');
    if (kept < kMostDigits) {
      value.mantissa = 10 * value.mantissa + digit;
      kept += value.mantissa != 0;
      value.places += fraction;
    } else {
      value.cut = value.cut || digit != 0;
      value.places -= !fraction;
    }
  }
};

// The exponent behind a number, 0 where there is none.
int scan_exponent(const char*& at, const char* end) {
  if (at == end || (*at != 'e' && *at != 'E')) return 0;
  const char* p = at + 1;
  const bool negative = p != end && *p == '-';
  if (p != end && (*p == '-' || *p == '+')) ++p;
  if (p == end || !is_digit(*p)) return 0;
  int exponent = 0;
  for (; p != end && is_digit(*p); ++p) exponent = std::min(kLargestExponent, 10 * exponent + (*p - '0'));
  at = p;
  return negative ? -exponent : exponent;
}

void drop_trailing_zeros(Decimal& value) {
  if (value.mantissa == 0) value.places = 0;
  while (value.mantissa != 0 && value.mantissa % 10 == 0) {
    value.mantissa /= 10;
    --value.places;
  }
}

}  // namespace

std::uint64_t power_of_ten(int n) { return kPowers[static_cast<std::size_t>(n)]; }

bool is_at_least(const Decimal& a, const Decimal& b) {
  if (a.mantissa == 0 || b.mantissa == 0) return b.mantissa == 0;
  const int digits_a = digits_of(a.mantissa), digits_b = digits_of(b.mantissa);
  if (digits_a - a.places != digits_b - b.places) return digits_a - a.places > digits_b - b.places;
  return Wide{a.mantissa} * power_of_ten(kMostDigits - digits_a) >=
         Wide{b.mantissa} * power_of_ten(kMostDigits - digits_b);
}

bool scan(const char*& at, const char* end, Decimal& value) {
  const char* p = at;
  Digits digits;
  for (; p != end && is_digit(*p); ++p) digits.add(*p, false);
  if (p != end && *p == '.')
    for (++p; p != end && is_digit(*p); ++p) digits.add(*p, true);
  if (!digits.any) return false;
  value = digits.value;
  value.places -= scan_exponent(p, end);
  drop_trailing_zeros(value);
  at = p;
  return true;
}

}  // namespace taut::pursuit::detail
