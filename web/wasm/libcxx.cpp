// Doubles as text and back, as libstdc++ has them: the shortest digits that read back.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>

#if _LIBCPP_VERSION < 14000

namespace {

std::to_chars_result copied(char* first, char* last, std::string_view text) {
  if (text.size() > static_cast<std::size_t>(last - first)) return {last, std::errc::value_too_large};
  return {first + text.copy(first, text.size()), std::errc{}};
}

/// digits 10^exponent, the digits an integer without zeros at its end.
struct Shortest {
  std::string digits;
  int exponent;
};

Shortest shortest(double v) {
  if (v == 0) return {"0", 0};
  const auto decimal = fmt::detail::dragonbox::to_decimal(v);
  return {std::to_string(decimal.significand), decimal.exponent};
}

std::string scientific(const Shortest& s) {
  const int power = s.exponent + static_cast<int>(s.digits.size()) - 1;
  std::string text = s.digits.substr(0, 1);
  if (s.digits.size() > 1) text += "." + s.digits.substr(1);
  return text + fmt::format("e{}{:02}", power < 0 ? '-' : '+', std::abs(power));
}

/// Integers are written in full.
std::string fixed(const Shortest& s, double v) {
  if (s.exponent >= 0) return fmt::format("{:.0f}", v);
  const int whole = static_cast<int>(s.digits.size()) + s.exponent;
  if (whole > 0) return s.digits.substr(0, whole) + "." + s.digits.substr(whole);
  return "0." + std::string(-whole, '0') + s.digits;
}

std::string sign_of(double v) { return std::signbit(v) ? "-" : ""; }

}  // namespace

namespace std {

to_chars_result to_chars(char* first, char* last, double value) {
  if (!std::isfinite(value)) return copied(first, last, sign_of(value) + (std::isnan(value) ? "nan" : "inf"));
  const Shortest digits = shortest(std::abs(value));
  const std::string full = fixed(digits, std::abs(value)), power = scientific(digits);
  return copied(first, last, sign_of(value) + (full.size() <= power.size() ? full : power));
}

to_chars_result to_chars(char* first, char* last, double value, chars_format) {
  return copied(first, last, sign_of(value) + scientific(shortest(std::abs(value))));
}

to_chars_result to_chars(char* first, char* last, double value, chars_format, int precision) {
  char text[64];
  const int size = std::snprintf(text, sizeof text, "%.*g", precision, value);
  return copied(first, last, {text, static_cast<std::size_t>(size)});
}

from_chars_result from_chars(const char* first, const char* last, double& value) {
  // strtod takes more: blanks, a plus, hexadecimal digits; and needs an end.
  const char* end = first;
  while (end != last && (std::isalnum(static_cast<unsigned char>(*end)) || *end == '.' || *end == '-' || *end == '+'))
    ++end;
  const string text(first, end);
  const size_t sign = text.starts_with('-') ? 1 : 0;
  if (text.size() == sign || text[sign] == '+' || text[sign] == '-') return {first, errc::invalid_argument};
  const bool is_hexadecimal = text.size() > sign + 1 && text[sign] == '0' && (text[sign + 1] | 0x20) == 'x';
  if (is_hexadecimal) return value = sign ? -0.0 : 0.0, from_chars_result{first + sign + 1, errc{}};
  char* read = nullptr;
  const double result = std::strtod(text.c_str(), &read);
  const char* const at = first + (read - text.c_str());
  if (read == text.c_str()) return {first, errc::invalid_argument};
  const bool is_word = std::isalpha(static_cast<unsigned char>(text[sign]));
  if (std::isinf(result) && !is_word) return {at, errc::result_out_of_range};
  value = result;
  return {at, errc{}};
}

}  // namespace std

#endif
