// The car's rules once more, from their formulas and complex numbers: shares nothing with taut::roadblocks but the
// types.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include <taut/robots/roadblocks/drive.h>

namespace taut::test {

struct Replay {
  bool reached = false;
  bool collided = false;
  std::size_t steps = 0;
};

/// Does a rectangle of half sides 1.5 and 1 have an inner point in common with the unit square around `cell`? Some axis
/// separates them or it does.
inline bool overlaps_square(std::complex<long double> at, long double heading, std::complex<long double> cell) {
  using Complex = std::complex<long double>;
  const std::array<Complex, 4> axes{1, Complex(0, 1), std::polar(1.0L, heading),
                                    std::polar(1.0L, heading) * Complex(0, 1)};
  return std::all_of(axes.begin(), axes.end(), [&](Complex axis) {
    const auto along = [&](Complex v) { return std::abs((v * std::conj(axis)).real()); };
    const long double reach = 1.5L * along(axes[2]) + along(axes[3]) + (along(1) + along(Complex(0, 1))) / 2;
    return along(cell - at) < reach;
  });
}

/// Collision, then goal, after each step, until either. With walls as squares each step is looked at in 16 places: that
/// misses contacts, but not long ones.
inline Replay replay(const roadblocks::Course& course, roadblocks::RoadblockSet open,
                     const std::vector<double>& controls,
                     roadblocks::WallReading reading = roadblocks::WallReading::points) {
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
  const auto go = [&](double u, long double share) {
    if (u == -2) {
      at -= std::polar(0.05L * share, heading);
    } else if (u == 0) {
      at += std::polar(0.15L * share, heading);
    } else if (u >= -1 && u <= 1) {
      const long double w = 0.05L * u * share, r = 3 / static_cast<long double>(u);
      at += Complex(r * (std::sin(heading + w) - std::sin(heading)), -r * (std::cos(heading + w) - std::cos(heading)));
      heading += w;
    }
  };
  for (const double u : controls) {
    ++result.steps;
    if (reading == roadblocks::WallReading::squares) {
      const Complex was = at;
      const long double turned = heading;
      for (int k = 1; k <= 16; ++k) {
        at = was, heading = turned;
        go(u, k / 16.0L);
        for (const Complex p : closed)
          result.collided = result.collided || (std::norm(p - at) < 9 && overlaps_square(at, heading, p));
      }
    } else {
      go(u, 1);
      for (const Complex p : closed) result.collided = result.collided || inside(p);
    }
    result.reached = inside({course.goal.x, course.goal.y});
    if (result.collided || result.reached) break;
  }
  return result;
}

}  // namespace taut::test
