// The car's rules once more, from the formulas of the course and complex numbers: shares nothing with taut::car but the types.
#pragma once

#include <cmath>
#include <complex>
#include <vector>

#include <taut/robots/car/drive.h>

namespace taut::test {

struct Replay {
  bool reached = false;
  bool collided = false;
  std::size_t steps = 0;
};

/// With walls as points: collision, then goal, after each step, until either.
inline Replay replay(const car::Course& course, car::RoadblockSet open, const std::vector<double>& controls) {
  using Complex = std::complex<long double>;
  Complex at(course.start.x, course.start.y);
  long double heading = 0;
  std::vector<Complex> closed;
  for (int y = 1; y <= course.height; ++y)
    for (int x = 1; x <= course.width; ++x)
      if (course.is_wall({x, y})) closed.emplace_back(x, y);
  for (std::size_t i = 0; i < course.roadblocks.size(); ++i)
    if (!((open >> i) & 1))
      for (const Cell c : course.roadblocks[i].cells) closed.emplace_back(c.x, c.y);
  const auto inside = [&](Complex p) {
    if (std::norm(p - at) > 4) return false;
    const Complex q = (p - at) * std::polar(1.0L, -heading);
    return std::abs(q.real()) <= 1.5L && std::abs(q.imag()) <= 1;
  };
  Replay result;
  for (const double u : controls) {
    ++result.steps;
    if (u == -2) {
      at -= std::polar(0.05L, heading);
    } else if (u == 0) {
      at += std::polar(0.15L, heading);
    } else if (u >= -1 && u <= 1) {
      const long double w = 0.05L * u, r = 3 / static_cast<long double>(u);
      at += Complex(r * (std::sin(heading + w) - std::sin(heading)), -r * (std::cos(heading + w) - std::cos(heading)));
      heading += w;
    }
    for (const Complex p : closed) result.collided = result.collided || inside(p);
    result.reached = inside({course.goal.x, course.goal.y});
    if (result.collided || result.reached) break;
  }
  return result;
}

}  // namespace taut::test
