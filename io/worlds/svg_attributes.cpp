#include <taut/io/worlds/detail/svg_attributes.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

namespace taut::detail {

namespace {

// `10-5.5.5` are three numbers.
class Numbers {
 public:
  Numbers(std::string_view text, const SourceLine& place) : rest_(text), place_(place) {}

  bool at_end() {
    while (!rest_.empty() && (std::isspace(static_cast<unsigned char>(rest_[0])) != 0 || rest_[0] == ','))
      rest_.remove_prefix(1);
    return rest_.empty();
  }
  bool at_number() { return !at_end() && std::string_view("+-.0123456789").find(rest_[0]) != std::string_view::npos; }

  double next() {
    if (!at_number()) place_.fail("a number is expected, not " + (rest_.empty() ? "the end" : quoted(rest_)));
    std::string_view from = rest_;
    if (from[0] == '+') from.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(from.data(), from.data() + from.size(), value);
    if (error != std::errc{}) place_.fail(quoted(rest_) + " is not a number");
    const auto length = static_cast<std::size_t>(end - from.data());
    value = coordinate(from.substr(0, length), place_);
    rest_ = from.substr(length);
    return value;
  }
  Point point() {
    const double x = next();
    return {x, next()};
  }

  /// The letter that stands here.
  char letter() {
    const char c = at_end() ? '\0' : rest_[0];
    if (std::isalpha(static_cast<unsigned char>(c)) == 0) place_.fail("a command is expected, not " + quoted(rest_));
    rest_.remove_prefix(1);
    return c;
  }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  const SourceLine& place_;
};

double rounded(long double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.15Lg", value);
  double result = 0;
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result + 0.0;
}

SvgTransform turned(double degrees) {
  // Quarter turns are exact.
  if (std::fmod(degrees, 90) == 0) {
    const int quarter = static_cast<int>(std::fmod(degrees / 90, 4) + 4) % 4;
    const std::array<double, 5> sines{0, 1, 0, -1, 0};
    const double s = sines[static_cast<std::size_t>(quarter)], c = sines[static_cast<std::size_t>(quarter) + 1];
    return {c, s, -s, c, 0, 0};
  }
  const double angle = degrees * 0.017453292519943295;
  return {std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle), 0, 0};
}

SvgTransform named(std::string_view name, const std::vector<double>& v, const SourceLine& place) {
  const std::size_t n = v.size();
  const auto tangent = [](double degrees) { return std::tan(degrees * 0.017453292519943295); };
  if (name == "matrix" && n == 6) return {v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate" && (n == 1 || n == 2)) return {1, 0, 0, 1, v[0], n == 2 ? v[1] : 0};
  if (name == "scale" && (n == 1 || n == 2)) return {v[0], 0, 0, n == 2 ? v[1] : v[0], 0, 0};
  if (name == "rotate" && n == 1) return turned(v[0]);
  if (name == "rotate" && n == 3)
    return SvgTransform{1, 0, 0, 1, v[1], v[2]}.after(turned(v[0])).after({1, 0, 0, 1, -v[1], -v[2]});
  if (name == "skewX" && n == 1) return {1, 0, tangent(v[0]), 1, 0, 0};
  if (name == "skewY" && n == 1) return {1, tangent(v[0]), 0, 1, 0, 0};
  place.fail("transform " + quoted(name) + " with " + std::to_string(n) + " numbers is not known");
}

class Path {
 public:
  Path(std::string_view text, const SourceLine& place) : numbers_(text, place), place_(place) {}

  std::vector<SvgSubpath> read() {
    char command = '\0';
    while (!numbers_.at_end()) {
      if (!numbers_.at_number()) {
        command = numbers_.letter();
      } else if (command == '\0' || command == 'Z' || command == 'z') {
        place_.fail("a path begins with M, not " + quoted(numbers_.rest()));
      }
      step(command);
      // What follows the first point of a move are lines.
      if (command == 'M') command = 'L';
      if (command == 'm') command = 'l';
    }
    std::erase_if(subpaths_, [](const SvgSubpath& s) { return s.points.size() < 2; });
    return std::move(subpaths_);
  }

 private:
  void step(char command) {
    const bool relative = std::islower(static_cast<unsigned char>(command)) != 0;
    const Point from = relative ? at_ : Point{};
    switch (std::toupper(static_cast<unsigned char>(command))) {
      case 'M': return move(sum(from, numbers_.point()));
      case 'L': return line(sum(from, numbers_.point()));
      case 'H': return line({sum(from, {numbers_.next(), 0}).x, at_.y});
      case 'V': return line({at_.x, sum(from, {0, numbers_.next()}).y});
      case 'Z': return close();
      default: break;
    }
    const bool is_curve =
        std::string_view("CSQTA").find(static_cast<char>(std::toupper(command))) != std::string_view::npos;
    place_.fail(std::string("path command '") + command + (is_curve ? "' draws a curve" : "' is not known") +
                "; only straight pieces are read (M L H V Z)");
  }

  static Point sum(Point a, Point b) { return {rounded_sum(a.x, b.x), rounded_sum(a.y, b.y)}; }
  static double rounded_sum(double a, double b) {
    return a == 0 ? b : rounded(static_cast<long double>(a) + static_cast<long double>(b));
  }

  void move(Point p) {
    subpaths_.push_back({{p}, false});
    at_ = start_ = p;
  }

  void line(Point p) {
    if (subpaths_.empty()) place_.fail("a path begins with M");
    if (subpaths_.back().closed) move(start_);
    subpaths_.back().points.push_back(p);
    at_ = p;
  }

  void close() {
    if (subpaths_.empty()) place_.fail("a path begins with M");
    subpaths_.back().closed = true;
    at_ = start_;
  }

  Numbers numbers_;
  const SourceLine& place_;
  std::vector<SvgSubpath> subpaths_;
  Point at_, start_;
};

}  // namespace

SvgTransform SvgTransform::after(const SvgTransform& i) const {
  return {a * i.a + c * i.b, b * i.a + d * i.b,     a * i.c + c * i.d,
          b * i.c + d * i.d, a * i.e + c * i.f + e, b * i.e + d * i.f + f};
}

Point SvgTransform::operator()(Point p) const {
  if (a == 1 && b == 0 && c == 0 && d == 1 && e == 0 && f == 0) return p;
  const long double x = p.x, y = p.y;
  return {rounded(a * x + c * y + e), rounded(b * x + d * y + f)};
}

SvgTransform svg_transform(std::string_view text, const SourceLine& place) {
  SvgTransform result;
  for (text = trimmed(text); !text.empty();) {
    const std::size_t open = text.find('('), close = text.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open)
      place.fail("transform " + quoted(text) + " is not name(numbers)");
    std::vector<double> values;
    for (Numbers numbers(text.substr(open + 1, close - open - 1), place); !numbers.at_end();)
      values.push_back(numbers.next());
    result = result.after(named(trimmed(text.substr(0, open)), values, place));
    text.remove_prefix(close + 1);
    while (!text.empty() && (text[0] == ',' || std::isspace(static_cast<unsigned char>(text[0])) != 0))
      text.remove_prefix(1);
  }
  return result;
}

Ring svg_points(std::string_view text, const SourceLine& place) {
  Ring points;
  for (Numbers numbers(text, place); !numbers.at_end();) points.push_back(numbers.point());
  return points;
}

double svg_length(std::string_view text, const SourceLine& place) {
  Numbers numbers(text, place);
  const double value = numbers.next();
  if (!numbers.at_end() && numbers.rest() != "px") place.fail(quoted(text) + " is not in the drawing's own units");
  return value;
}

std::vector<SvgSubpath> svg_subpaths(std::string_view text, const SourceLine& place) {
  return Path(text, place).read();
}

}  // namespace taut::detail
