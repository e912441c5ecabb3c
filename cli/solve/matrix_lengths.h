// What `taut matrix` has measured so far.
#pragma once

#include <atomic>
#include <cstddef>
#include <span>
#include <vector>

#include <taut/io/results/json.h>

namespace taut::cli {

/// The matrix, and how much of it is final: for the thread that stops the program, too.
struct Lengths {
  explicit Lengths(std::size_t points) : size(points), values(points * points) {}

  const std::size_t size;
  std::vector<double> values;
  std::atomic<std::size_t> rows{0};

  std::span<const double> first(std::size_t count) const { return {values.data(), count * size}; }
  double operator()(std::size_t i, std::size_t j) const { return values[i * size + j]; }
};

/// Of the pairs that are finished, each once. A length that is no number is unproven.
struct Totals {
  std::size_t found = 0, none = 0, unproven = 0;
  double longest = 0;

  Totals(const Lengths& lengths, std::size_t rows);
};

/// {points, rows, found, none, unproven, longest, lengths: null where there is no path}
Json matrix_json(const Lengths& lengths, std::size_t rows, bool with_lengths);

}  // namespace taut::cli
