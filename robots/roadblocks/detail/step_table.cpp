#include <taut/robots/roadblocks/detail/step_table.h>

#include <algorithm>
#include <bit>

namespace taut::roadblocks::detail {

StepTable::StepTable(const std::vector<std::uint16_t>& cost, int columns) {
  const auto bits_of = [&](std::size_t cell) {
    std::uint32_t bits = 0;
    for (std::size_t h = 0; h < kHeadings; ++h)
      if (cost[cell * kHeadings + h] != kNever) bits |= 1U << h;
    return bits;
  };
  const int rows = static_cast<int>(cost.size() / kHeadings) / columns;
  std::vector<std::uint32_t> headings(cost.size() / kHeadings);
  int right = 0, bottom = 0;
  left_ = columns, top_ = rows;
  std::size_t values = 0;
  for (std::size_t cell = 0; cell < headings.size(); ++cell) {
    headings[cell] = bits_of(cell);
    if (headings[cell] == 0) continue;
    values += static_cast<std::size_t>(std::popcount(headings[cell]));
    const int i = static_cast<int>(cell) % columns, j = static_cast<int>(cell) / columns;
    left_ = std::min(left_, i), right = std::max(right, i + 1);
    top_ = std::min(top_, j), bottom = std::max(bottom, j + 1);
  }
  columns_ = std::max(0, right - left_), rows_ = std::max(0, bottom - top_);
  cells_.reserve(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  cost_.reserve(values);
  for (int j = top_; j < bottom; ++j)
    for (int i = left_; i < right; ++i) {
      const auto cell = static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i);
      cells_.push_back({headings[cell], static_cast<std::uint32_t>(cost_.size())});
      for (std::size_t h = 0; h < kHeadings; ++h)
        if (const std::uint16_t value = cost[cell * kHeadings + h]; value != kNever) cost_.push_back(value);
    }
}

std::uint16_t StepTable::cost(const Cell& cell, int heading) const {
  if (((cell.headings >> heading) & 1) == 0) return kNever;
  return cost_[cell.first + static_cast<std::size_t>(std::popcount(cell.headings & ((1U << heading) - 1)))];
}

double StepTable::steps_from(const Pose& pose) const {
  const int i = raster(pose.x) - left_, j = raster(pose.y) - top_;
  if (i < 0 || j < 0 || i >= columns_ || j >= rows_) return kFar;
  const Cell& cell =
      cells_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i)];
  return steps_between(pose.heading, [&](int heading) { return cost(cell, heading); });
}

}  // namespace taut::roadblocks::detail
