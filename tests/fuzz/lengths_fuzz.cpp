// Sums of distances that are equal or nearly so: compared, enclosed, rounded to a double and to decimals, beside 3000 bits.
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "fuzz/fuzzed.h"
#include "support/length_reference.h"

namespace {

using namespace taut;
using namespace taut::test;

double coordinate(FuzzedDataProvider& bytes, double unit, bool wobbles) {
  const double v = bytes.ConsumeIntegralInRange(-9, 9) * unit;
  if (!wobbles || v == 0) return v;  // beside 0 are numbers so small that 3000 bits do not hold the sums
  const int step = bytes.ConsumeIntegralInRange(-1, 1);
  return step == 0 ? v : std::nextafter(v, step * HUGE_VAL);
}

Legs draw(FuzzedDataProvider& bytes, double unit, bool wobbles) {
  Legs legs(bytes.ConsumeIntegralInRange<std::size_t>(0, 4));
  for (Segment& leg : legs)
    for (double* v : {&leg.a.x, &leg.a.y, &leg.b.x, &leg.b.y}) *v = coordinate(bytes, unit, wobbles);
  return legs;
}

/// The same sum by other legs: turned, mirrored, cut in two, in another order.
Legs disguised(const Legs& legs, FuzzedDataProvider& bytes) {
  Legs result;
  for (const Segment& leg : legs) {
    const Point a = leg.a, b = leg.b;
    switch (bytes.ConsumeIntegralInRange(0, 3)) {
      case 0: result.push_back({b, a}); break;
      case 1: result.insert(result.begin(), Segment{{a.y, a.x}, {b.y, b.x}}); break;
      case 2: result.push_back({{-a.x, a.y}, {-b.x, b.y}}); break;
      default: {
        const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
        result.push_back({a, middle});
        result.push_back({middle, b});
      }
    }
  }
  return result;
}

std::string words(const Legs& legs) {
  std::string text;
  for (const Segment& leg : legs) text += fmt::format(" ({:a}, {:a})-({:a}, {:a})", leg.a.x, leg.a.y, leg.b.x, leg.b.y);
  return text;
}

void judge_order(const Legs& a, const Legs& b, const Reference& right_a, const Reference& right_b) {
  const int told = sign(compare_lengths(a, b)), right = right_a.compare(right_b);
  fuzz::require(told == right, fmt::format("{} instead of {} of{} and{}", told, right, words(a), words(b)));
  fuzz::require(sign(length_of(b) <=> length_of(a)) == -right, "otherwise in reverse:" + words(a) + " and" + words(b));
}

void judge_value(const Legs& legs, const Reference& right, int places) {
  const Length length = length_of(legs);
  fuzz::require(right.is_in(length.interval()), "not enclosed:" + words(legs));
  fuzz::require(length.value() == right.nearest(), "not the nearest double:" + words(legs));
  fuzz::require(length.decimals(places) == right.decimals(places), fmt::format("{} places:{}", places, words(legs)));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider bytes(data, size);
  constexpr double kUnits[] = {1, 0.1, 0.5, 1.0 / 3, 1e60, 1e-70};
  const double unit = bytes.PickValueInArray(kUnits);
  const bool wobbles = bytes.ConsumeIntegralInRange(0, 3) == 0;
  const int places = bytes.ConsumeIntegralInRange(0, 20);
  const Legs a = draw(bytes, unit, wobbles);
  const Legs b = bytes.ConsumeBool() ? draw(bytes, unit, wobbles) : disguised(a, bytes);
  const Reference right_a(a), right_b(b);
  judge_order(a, b, right_a, right_b);
  judge_value(a, right_a, places);
  return 0;
}
