#include <taut/io/worlds/detail/text_input.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <system_error>

#include <taut/geometry/text.h>
#include <taut/geometry/world.h>

namespace taut::detail {

namespace {

constexpr std::size_t kLongestQuote = 40;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

bool starts_number(char c) { return (c >= '0' && c <= '9') || c == '.'; }

}  // namespace

void SourceLine::fail(const std::string& message) const { throw InputError(source, line, message); }

std::string quoted(std::string_view text) {
  std::string out = "'";
  for (char c : text.substr(0, kLongestQuote)) out += c < ' ' || c > '~' ? '?' : c;
  return out + (text.size() > kLongestQuote ? "...'" : "'");
}

std::string more_like_it(std::size_t count) { return count == 0 ? "" : "; " + std::to_string(count) + " more like it"; }

std::string printable_name(std::string name) {
  for (char& c : name)
    if (static_cast<unsigned char>(c) < ' ' || c == 0x7f) c = '?';
  return name;
}

std::string_view stripped(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  if (bytes.ends_with('\x1a')) bytes.remove_suffix(1);
  return bytes;
}

std::string_view trimmed_right(std::string_view line) {
  while (!line.empty() && (is_blank(line.back()) || line.back() == '\r')) line.remove_suffix(1);
  return line;
}

std::string_view trimmed(std::string_view line) {
  line = trimmed_right(line);
  while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  return line;
}

std::string_view without_comment(std::string_view line) { return trimmed(line.substr(0, line.find('#'))); }

bool Lines::next() {
  if (rest_.empty()) return false;
  const void* end = std::memchr(rest_.data(), '\n', rest_.size());
  const std::size_t length =
      end ? static_cast<std::size_t>(static_cast<const char*>(end) - rest_.data()) : rest_.size();
  line_ = trimmed_right(rest_.substr(0, length));
  rest_.remove_prefix(end ? length + 1 : length);
  ++number_;
  return true;
}

Fields::Fields(std::string_view line, const SourceLine& place) : rest_(trimmed(line)), place_(place) {}

bool Fields::next(std::string_view& field) {
  if (rest_.empty()) {
    if (after_comma_) place_.fail("the line ends with a comma");
    return false;
  }
  std::size_t end = 0;
  while (end < rest_.size() && rest_[end] != ',' && !is_blank(rest_[end])) ++end;
  if (end == 0) place_.fail("there is nothing before a comma");
  field = rest_.substr(0, end);
  while (end < rest_.size() && is_blank(rest_[end])) ++end;
  after_comma_ = end < rest_.size() && rest_[end] == ',';
  if (after_comma_) ++end;
  while (end < rest_.size() && is_blank(rest_[end])) ++end;
  rest_.remove_prefix(end);
  return true;
}

std::vector<std::string_view> fields_of(std::string_view line, const SourceLine& place) {
  std::vector<std::string_view> result;
  Fields fields(line, place);
  for (std::string_view field; fields.next(field);) result.push_back(field);
  return result;
}

namespace {

/// Up to 15 digits, with a point among or before them: the quotient of two exact doubles is the nearest. NaN for
/// anything else.
double short_decimal(std::string_view field) {
  constexpr std::array<double, 16> kPowers{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                           1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const bool negative = field.starts_with('-');
  field.remove_prefix(negative);
  std::int64_t digits = 0;
  std::size_t places = 0, count = 0;
  bool after_point = false;
  for (const char c : field) {
    if (c == '.' && !after_point) {
      after_point = true;
    } else if (c >= '0' && c <= '9' && count < 15) {
      digits = 10 * digits + (c - '0');
      ++count;
      places += after_point;
    } else {
      return NAN;
    }
  }
  if (count == 0) return NAN;
  const double value = static_cast<double>(digits) / kPowers[places];
  return negative ? -value : value;
}

}  // namespace

double coordinate(std::string_view field, const SourceLine& place) {
  if (const double quick = short_decimal(field); !std::isnan(quick)) return quick + 0.0;
  std::string_view digits = field;
  if (digits.size() > 1 && digits[0] == '+' && starts_number(digits[1])) digits.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range) place.fail(quoted(field) + " is out of the range of numbers");
  if (error != std::errc() || end != digits.data() + digits.size()) place.fail(quoted(field) + " is not a number");
  if (!std::isfinite(value)) place.fail(quoted(field) + " is not a finite number");
  if (std::abs(value) > World::kLargest)
    place.fail(quoted(field) + " is beyond the largest coordinate, " + text(World::kLargest));
  return value + 0.0;
}

int whole(std::string_view field, int lo, int hi, const char* what, const SourceLine& place) {
  long long value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  const bool parsed = error != std::errc::invalid_argument && end == field.data() + field.size();
  if (!parsed || error != std::errc() || value < lo || value > hi)
    place.fail(std::string(what) + " " + quoted(field) + " is not a whole number between " + std::to_string(lo) +
               " and " + std::to_string(hi));
  return static_cast<int>(value);
}

}  // namespace taut::detail
