// Legs drawn at random.
#pragma once

#include <rapidcheck.h>

#include "support/length_reference.h"

namespace taut::test {

inline Legs any_legs(int count, int range, double unit) {
  Legs legs;
  const auto coordinate = [&] { return *rc::gen::inRange(0, range) * unit; };
  for (int i = 0; i < count; ++i) {
    const double ax = coordinate(), ay = coordinate(), bx = coordinate(), by = coordinate();
    legs.push_back({{ax, ay}, {bx, by}});
  }
  return legs;
}

}  // namespace taut::test
