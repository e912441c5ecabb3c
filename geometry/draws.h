// Random draws that are the same with every standard library.
#pragma once

#include <cstdint>
#include <random>

namespace taut {

/// std::mt19937_64 is fixed by the standard, its distributions are not: these are.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in 0 .. n - 1, without bias (Lemire, "Fast random integer generation in an interval", 2019). Precondition:
  /// n > 0.
  std::uint32_t below(std::uint32_t n) {
    std::uint64_t product = (engine_() >> 32) * n;
    if (static_cast<std::uint32_t>(product) < n) {
      const std::uint32_t threshold = -n % n;
      while (static_cast<std::uint32_t>(product) < threshold) product = (engine_() >> 32) * n;
    }
    return static_cast<std::uint32_t>(product >> 32);
  }

  /// Uniform in [0, 1), a multiple of 2^-53.
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace taut
