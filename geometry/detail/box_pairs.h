// Which boxes meet one another? Private.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <vector>

#include <taut/geometry/box.h>
#include <taut/geometry/box_index.h>

namespace taut::detail {

/// Small boxes in a grid whose cells are about as large as they: each in all cells that it touches.
class BoxGrid {
 public:
  /// Nothing when boxes are so unlike one another that they would touch more than kCells cells on average.
  static std::optional<BoxGrid> of(const std::vector<Box>& boxes) {
    if (boxes.size() < 64) return std::nullopt;
    BoxGrid grid(boxes);
    if (!grid.count(boxes)) return std::nullopt;
    grid.fill(boxes);
    return grid;
  }

  /// Each pair in the cell where what they share begins.
  template <class Visit>
  void each_pair(const std::vector<Box>& boxes, Visit&& visit) const {
    for (std::size_t cell = 0; cell + 1 < first_.size(); ++cell)
      for (std::size_t k = first_[cell]; k < first_[cell + 1]; ++k)
        for (std::size_t l = k + 1; l < first_[cell + 1]; ++l) {
          const std::uint32_t i = items_[k], j = items_[l];
          const Box &a = boxes[i], &b = boxes[j];
          const double x = std::max(a.min.x, b.min.x), y = std::max(a.min.y, b.min.y);
          if (x <= std::min(a.max.x, b.max.x) && y <= std::min(a.max.y, b.max.y) && cell_of(column(x), row(y)) == cell)
            visit(i, j);
        }
  }

 private:
  static constexpr std::size_t kCells = 8;

  explicit BoxGrid(const std::vector<Box>& boxes) : all_(boxes.front()) {
    double width = 0, height = 0;
    for (const Box& b : boxes) {
      all_.min = {std::min(all_.min.x, b.min.x), std::min(all_.min.y, b.min.y)};
      all_.max = {std::max(all_.max.x, b.max.x), std::max(all_.max.y, b.max.y)};
      width += b.max.x - b.min.x;
      height += b.max.y - b.min.y;
    }
    const auto n = static_cast<double>(boxes.size());
    const auto lines = [n](double whole, double mean) {
      return mean > 0 && whole > 0 ? std::clamp(whole / mean, 1.0, std::sqrt(4 * n)) : 1.0;
    };
    columns_ = static_cast<std::size_t>(lines(all_.max.x - all_.min.x, width / n));
    rows_ = static_cast<std::size_t>(lines(all_.max.y - all_.min.y, height / n));
    first_.assign(columns_ * rows_ + 1, 0);
  }

  static std::size_t along(double v, double least, double greatest, std::size_t count) {
    const double part = greatest > least ? (v - least) / (greatest - least) * static_cast<double>(count) : 0;
    return std::min(static_cast<std::size_t>(std::max(part, 0.0)), count - 1);
  }
  std::size_t column(double x) const { return along(x, all_.min.x, all_.max.x, columns_); }
  std::size_t row(double y) const { return along(y, all_.min.y, all_.max.y, rows_); }
  std::size_t cell_of(std::size_t column, std::size_t row) const { return row * columns_ + column; }

  template <class Visit>
  void each_cell(const Box& b, Visit&& visit) const {
    const std::size_t left = column(b.min.x), right = column(b.max.x), top = row(b.max.y);
    for (std::size_t r = row(b.min.y); r <= top; ++r)
      for (std::size_t c = left; c <= right; ++c) visit(cell_of(c, r));
  }

  bool count(const std::vector<Box>& boxes) {
    std::size_t total = 0;
    for (const Box& b : boxes) {
      total += (column(b.max.x) - column(b.min.x) + 1) * (row(b.max.y) - row(b.min.y) + 1);
      if (total > kCells * boxes.size()) return false;
      each_cell(b, [&](std::size_t cell) { ++first_[cell + 1]; });
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    items_.resize(total);
    return true;
  }

  void fill(const std::vector<Box>& boxes) {
    std::vector<std::size_t> next = first_;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
      each_cell(boxes[i], [&](std::size_t cell) { items_[next[cell]++] = i; });
  }

  Box all_;
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<std::size_t> first_;  // cell -> its first item
  std::vector<std::uint32_t> items_;
};

/// Calls visit(i, j), i < j, once for each pair of closed boxes that share a point, in a reproducible order. O(n +
/// pairs) for small boxes that are spread evenly, else by an R-tree.
template <class Visit>
void each_meeting_pair(const std::vector<Box>& boxes, Visit&& visit) {
  if (const auto grid = BoxGrid::of(boxes)) return grid->each_pair(boxes, visit);
  const BoxIndex index(boxes);
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    index.meeting(boxes[i], [&](std::uint32_t j) {
      if (j > i) visit(i, j);
    });
}

}  // namespace taut::detail
