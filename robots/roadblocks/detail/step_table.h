// What remains of a PoseDistance that is only asked: its values, without the poses that have none.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <taut/robots/roadblocks/detail/disc_distance.h>

namespace taut::roadblocks::detail {

/// Costs of poses by raster cell and heading. Cells outside the box of those that have a value take no memory, and in
/// it a cell takes 8 bytes and 2 for each heading with a value: with all doors closed a table covers the rooms between.
class StepTable {
 public:
  static constexpr int kHeadings = 32;
  static constexpr int kParts = 4;  ///< of a step, in costs
  static constexpr std::uint16_t kNever = 0xFFFF;
  static constexpr double kFar = 1e9;

  StepTable() = default;
  /// `cost`: kHeadings values a cell, row by row; kNever for none.
  StepTable(const std::vector<std::uint16_t>& cost, int columns);

  /// Steps, between the nearest headings; kFar where neither has a value.
  double steps_from(const Pose& pose) const;

  std::size_t bytes() const { return cells_.size() * sizeof(cells_[0]) + cost_.size() * sizeof(cost_[0]); }

 private:
  struct Cell {
    std::uint32_t headings = 0;  ///< a bit for each that has a value
    std::uint32_t first = 0;     ///< its first value in cost_
  };
  std::uint16_t cost(const Cell& cell, int heading) const;

  int left_ = 0, top_ = 0, columns_ = 0, rows_ = 0;
  std::vector<Cell> cells_;
  std::vector<std::uint16_t> cost_;
};

/// Steps of a heading between two of the table; `cost_of` tells a heading's cost.
template <typename CostOf>
double steps_between(double heading, CostOf cost_of) {
  constexpr double kUnit = 6.283185307179586 / StepTable::kHeadings;
  const double turns = heading / kUnit, whole = std::floor(turns), part = turns - whole;
  const int n = StepTable::kHeadings, h = ((static_cast<int>(whole) % n) + n) % n;
  const std::int32_t a = cost_of(h), b = cost_of((h + 1) % n);
  if (a == StepTable::kNever && b == StepTable::kNever) return StepTable::kFar;
  if (a == StepTable::kNever) return static_cast<double>(b) / StepTable::kParts;
  if (b == StepTable::kNever) return static_cast<double>(a) / StepTable::kParts;
  return (a + part * (b - a)) / StepTable::kParts;
}

}  // namespace taut::roadblocks::detail
