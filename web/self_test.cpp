// Exactness, asked of the machine that this runs on: another compiler, another arithmetic.
#include <cmath>
#include <limits>
#include <utility>

#include <taut/geometry/length.h>
#include <taut/geometry/predicates.h>
#include <taut/search/shortest_path.h>
#include <taut/web/detail/answers.h>

namespace taut::web {

namespace {

Length chain(std::vector<Point> points) { return Length(points); }

/// To each of these sums 5000000 is added in another way; they differ in the 19th digit.
Length far_from_home(std::vector<Segment> legs, Point far) {
  Length sum;
  sum.add({0, 0}, far);
  for (const Segment& leg : legs) sum.add(leg.a, leg.b);
  return sum;
}

bool sums_of_roots_compare() {
  const Length less = far_from_home({{{0, 0}, {2, 17}}, {{0, 0}, {13, 23}}, {{0, 0}, {0, 28}}}, {3e6, 4e6});
  const Length more = far_from_home({{{0, 0}, {5, 19}}, {{0, 0}, {1, 25}}, {{0, 0}, {19, 19}}}, {5e6, 0});
  return less < more && chain({{0, 0}, {1, 1}, {4, 4}}) == chain({{0, 0}, {4, 4}});
}

bool digits_are_right() {
  return chain({{0, 0}, {1, 1}}).decimals(50) == "1.41421356237309504880168872420969807856967187537695";
}

/// Rounded to the nearest, ties to even, with no more digits held in between.
bool doubles_are_doubles() {
  const volatile double tiny = std::numeric_limits<double>::epsilon() / 2;
  const volatile double one = 1;
  const volatile double sum = one + tiny;
  const volatile double least = std::numeric_limits<double>::denorm_min();
  return sum == one && one + 3 * tiny == 1 + 2 * std::numeric_limits<double>::epsilon() && least > 0 &&
         std::fma(one + 2 * tiny, one - 2 * tiny, -1.0) == -4 * tiny * tiny;
}

/// Points on a line and beside it by a few last bits: the doubles' determinant has nearly any sign.
bool orientation_is_exact() {
  const double ulp = std::ldexp(1.0, -53);
  for (int i = 0; i < 16; ++i)
    for (int j = 0; j < 16; ++j) {
      const Point p{0.5 + i * ulp, 0.5 + j * ulp};
      const int side = (j > i) - (j < i);
      if (orientation({12, 12}, {24, 24}, p) != side || orientation(p, {24, 24}, {12, 12}) != -side) return false;
    }
  return true;
}

/// (0.8, 1.1) lies on the wall from (0, 0.6) to (4, 3.1) as written, though no doubles do.
bool written_numbers_mean_decimals() {
  WorldParts parts;
  parts.walls = {{{0, 0.6}, {4, 3.1}}, {{0.8, 1.1}, {0.8, 3}}};
  const FreeSpace space{World(std::move(parts))};
  const auto path = shortest_path(space, {0.7, 1.2}, {0.9, 1.3});
  return path && path->points.size() == 3 && path->points[1] == Point{0.8, 3};
}

}  // namespace

Json self_test_answer() {
  const std::pair<const char*, bool> checks[]{{"doubles are IEEE 754", doubles_are_doubles()},
                                              {"orientation is exact", orientation_is_exact()},
                                              {"sums of roots compare exactly", sums_of_roots_compare()},
                                              {"digits of roots are right", digits_are_right()},
                                              {"numbers mean what is written", written_numbers_mean_decimals()}};
  Json list = Json::array();
  bool passed = true;
  for (const auto& [what, holds] : checks) {
    passed = passed && holds;
    list.push_back({{"what", what}, {"passed", holds}});
  }
  return {{"passed", passed}, {"checks", std::move(list)}};
}

}  // namespace taut::web
