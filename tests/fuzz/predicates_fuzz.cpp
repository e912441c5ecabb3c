// Signs, contacts and distances of a few points that nearly coincide, in whole numbers, decimals, neighbouring doubles and numbers of all
// sizes: of doubles as they are and of what was written, beside textbook formulas in rationals that share no code with them.
#include <gmpxx.h>

#include <charconv>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include <taut/geometry/contact.h>
#include <taut/geometry/predicates.h>
#include <taut/geometry/segment_distance.h>
#include <taut/geometry/world.h>
#include <taut/geometry/written.h>

#include "fuzz/fuzzed.h"

namespace {

using namespace taut;

/// Coordinates that make coincidences likely; the bytes decide of which kind.
class Numbers {
 public:
  explicit Numbers(FuzzedDataProvider& bytes) : bytes_(bytes) {
    constexpr double kUnits[] = {1, 1, 2, 10, 100, 1000, 3, 1024};
    unit_ = bytes.PickValueInArray(kUnits);
    constexpr double kShifts[] = {0, 0, 0, 500000, 4.5e6, -0x1p40};
    shift_ = bytes.PickValueInArray(kShifts);
    wobbles_ = bytes.ConsumeIntegralInRange(0, 3) == 0;
    is_wide_ = bytes.ConsumeIntegralInRange(0, 15) == 0;
  }

  Point point() {
    const double x = number(), y = number();
    return {x, y};
  }

 private:
  double number() {
    double v = shift_ + bytes_.ConsumeIntegralInRange(-12, 12) / unit_;
    if (wobbles_) v = wobbled(v, bytes_.ConsumeIntegralInRange(-2, 2));
    if (is_wide_) v *= std::pow(10.0, bytes_.ConsumeIntegralInRange(-70, 70));
    return std::abs(v) < World::kSmallest || std::abs(v) > World::kLargest ? 0 : v;
  }

  static double wobbled(double v, int steps) {
    for (; steps > 0; --steps) v = std::nextafter(v, HUGE_VAL);
    for (; steps < 0; ++steps) v = std::nextafter(v, -HUGE_VAL);
    return v;
  }

  FuzzedDataProvider& bytes_;
  double unit_ = 1, shift_ = 0;
  bool wobbles_ = false, is_wide_ = false;
};

// ---- what points are, in rationals --------------------------------------------------------------------------------------------------
struct Exact {
  mpq_class x, y;
};

mpq_class as_it_is(double v) { return mpq_class(v); }

/// The shortest text that reads back, when it has at most 15 digits.
mpq_class as_written(double v) {
  char text[48];
  const std::string all(text, std::to_chars(text, text + sizeof text, v, std::chars_format::scientific).ptr);
  const std::size_t e = all.find('e');
  std::string digits;
  for (const char c : all.substr(0, e))
    if (c != '.') digits += c;
  const int count = static_cast<int>(digits.size()) - (digits[0] == '-');
  if (count > 15) return mpq_class(v);
  const int power = std::stoi(all.substr(e + 1)) - (count - 1);
  mpz_class ten;
  mpz_ui_pow_ui(ten.get_mpz_t(), 10, static_cast<unsigned>(std::abs(power)));
  mpq_class result = mpz_class(digits);
  if (power < 0)
    result /= ten;
  else
    result *= ten;
  return result;
}

mpq_class cross(const Exact& a, const Exact& b, const Exact& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
mpq_class squared(const Exact& a, const Exact& b) { return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y); }
mpq_class dot(const Exact& o, const Exact& a, const Exact& b) {
  return (a.x - o.x) * (b.x - o.x) + (a.y - o.y) * (b.y - o.y);
}
bool on(const Exact& q, const Exact& a, const Exact& b) { return cross(a, b, q) == 0 && dot(q, a, b) <= 0; }

struct ExactSegment {
  Exact a, b;
};
/// In one point inside of both.
bool cross_properly(const ExactSegment& s, const ExactSegment& t) {
  return sgn(cross(s.a, s.b, t.a)) * sgn(cross(s.a, s.b, t.b)) < 0 &&
         sgn(cross(t.a, t.b, s.a)) * sgn(cross(t.a, t.b, s.b)) < 0;
}
bool meet(const ExactSegment& s, const ExactSegment& t) {
  return cross_properly(s, t) || on(s.a, t.a, t.b) || on(s.b, t.a, t.b) || on(t.a, s.a, s.b) || on(t.b, s.a, s.b);
}
mpq_class squared_distance(const Exact& p, const ExactSegment& s) {
  if (dot(s.a, p, s.b) <= 0) return squared(p, s.a);
  if (dot(s.b, p, s.a) <= 0) return squared(p, s.b);
  const mpq_class area = cross(s.a, s.b, p);
  return area * area / squared(s.a, s.b);
}
mpq_class squared_distance(const ExactSegment& s, const ExactSegment& t) {
  if (meet(s, t)) return 0;
  return std::min(std::min(squared_distance(s.a, t), squared_distance(s.b, t)),
                  std::min(squared_distance(t.a, s), squared_distance(t.b, s)));
}

int in_circle(const Exact& a, const Exact& b, const Exact& c, const Exact& d) {
  const Exact u{a.x - d.x, a.y - d.y}, v{b.x - d.x, b.y - d.y}, w{c.x - d.x, c.y - d.y};
  const auto lift = [](const Exact& p) -> mpq_class { return p.x * p.x + p.y * p.y; };
  return sgn(mpq_class(lift(u) * (v.x * w.y - v.y * w.x) - lift(v) * (u.x * w.y - u.y * w.x) +
                       lift(w) * (u.x * v.y - u.y * v.x)));
}

// ---- the two opinions beside each other ---------------------------------------------------------------------------------------------
/// Four points, and both segments between them.
struct Four {
  Point p[4];
  Segment s() const { return {p[0], p[1]}; }
  Segment t() const { return {p[2], p[3]}; }
};

std::string words(const Four& four) {
  std::string text;
  for (const Point& p : four.p) text += fmt::format(" ({:a} = {}, {:a} = {})", p.x, p.x, p.y, p.y);
  return text;
}

struct ExactFour {
  Exact p[4];
  ExactSegment s() const { return {p[0], p[1]}; }
  ExactSegment t() const { return {p[2], p[3]}; }
};

template <class Meaning>
ExactFour exact(const Four& four, Meaning meaning) {
  ExactFour result;
  for (int i = 0; i < 4; ++i) result.p[i] = {meaning(four.p[i].x), meaning(four.p[i].y)};
  return result;
}

void same(int told, int right, const char* what, const Four& four) {
  fuzz::require(told == right, fmt::format("{}: {} instead of {} of{}", what, told, right, words(four)));
}

int sign_of_difference(const mpq_class& a, const mpq_class& b) {
  const int sign = cmp(a, b);
  return (sign > 0) - (sign < 0);
}

void judge_doubles(const Four& four) {
  const ExactFour right = exact(four, as_it_is);
  const auto& [a, b, c, d] = four.p;
  same(orientation(a, b, c), sgn(cross(right.p[0], right.p[1], right.p[2])), "orientation", four);
  same(on_segment(c, a, b), on(right.p[2], right.p[0], right.p[1]), "on_segment", four);
  same(cross_properly(four.s(), four.t()), cross_properly(right.s(), right.t()), "cross_properly", four);
  same(segments_meet(four.s(), four.t()), meet(right.s(), right.t()), "segments_meet", four);
  same(compare_distance(a, b, c), sign_of_difference(squared(right.p[0], right.p[1]), squared(right.p[0], right.p[2])),
       "compare_distance", four);
}

void judge_written(const Four& four, const ExactFour& right) {
  const auto& [a, b, c, d] = four.p;
  const int turn = sgn(cross(right.p[0], right.p[1], right.p[2]));
  same(written::orientation(a, b, c), turn, "written::orientation", four);
  same(written::on_segment(c, a, b), on(right.p[2], right.p[0], right.p[1]), "written::on_segment", four);
  same(written::cross_properly(four.s(), four.t()), cross_properly(right.s(), right.t()), "written::cross_properly",
       four);
  same(written::segments_meet(four.s(), four.t()), meet(right.s(), right.t()), "written::segments_meet", four);
  same(written::compare_distance(a, b, c),
       sign_of_difference(squared(right.p[0], right.p[1]), squared(right.p[0], right.p[2])),
       "written::compare_distance", four);
  if (turn > 0)
    same(written::side_of_circle(a, b, c, d), in_circle(right.p[0], right.p[1], right.p[2], right.p[3]),
         "written::side_of_circle", four);
}

void judge_contact(const Four& four, const ExactFour& right) {
  if (four.p[2] == four.p[3]) return;  // a constraint has a length
  const Contact expected = cross_properly(right.s(), right.t()) ? Contact::cross
                           : meet(right.s(), right.t())         ? Contact::touch
                                                                : Contact::none;
  same(static_cast<int>(contact(four.s(), {four.p[2], four.p[3]})), static_cast<int>(expected), "contact", four);
}

/// Enclosed, to the nearest double, and compared with another.
void judge_distance(const Four& four, const ExactFour& right) {
  const mpq_class square = squared_distance(right.s(), right.t());
  const Interval enclosed = segment_distance_interval(four.s(), four.t());
  const mpq_class low(std::max(0.0, enclosed.lo)), high(std::min(enclosed.hi, 1e200));
  fuzz::require(low * low <= square && square <= high * high, "an enclosure without the distance of" + words(four));
  const double nearest = segment_distance(four.s(), four.t());
  const mpq_class below((mpq_class(nearest) + mpq_class(std::nextafter(nearest, -HUGE_VAL))) / 2),
      above((mpq_class(nearest) + mpq_class(std::nextafter(nearest, HUGE_VAL))) / 2);
  const bool is_nearest = (below < 0 || below * below <= square) && square <= above * above;
  fuzz::require(is_nearest && (nearest == 0) == (square == 0),
                "not the nearest double to the distance of" + words(four));
  const auto& [a, b, c, d] = four.p;
  const mpq_class other = squared_distance({right.p[0], right.p[2]}, {right.p[1], right.p[3]});
  same(compare_segment_distances(four.s(), four.t(), {a, c}, {b, d}), sign_of_difference(square, other),
       "compare_segment_distances", four);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider bytes(data, size);
  Numbers numbers(bytes);
  Four four;
  for (Point& p : four.p) p = numbers.point();
  judge_doubles(four);
  const ExactFour right = exact(four, as_written);
  judge_written(four, right);
  judge_contact(four, right);
  judge_distance(four, right);
  return 0;
}
