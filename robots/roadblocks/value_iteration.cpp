#include <taut/robots/roadblocks/value_iteration.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace taut::roadblocks {

namespace {

using Array = Eigen::ArrayXd;
using Eigen::Index;

/// A plane of values for each heading, row by row with a border of kNever all around, so that a step is an offset.
class Sweeps {
 public:
  Sweeps(const ValueGrid& grid, Sweeping sweeping)
      : grid_(grid), columns_(grid.columns()), rows_(grid.rows()), stride_(columns_ + 2), line_(columns_) {
    const Array never = Array::Constant(stride_ * (rows_ + 2), ValueGrid::kNever);
    values_.assign(ValueGrid::kHeadings, never);
    for (int k = 0; k < ValueGrid::kHeadings; ++k)
      for (int j = 0; j < grid.rows(); ++j)
        for (int i = 0; i < grid.columns(); ++i)
          if (grid.is_goal(grid.index(i, j, k))) value(k)(row(j) + i) = 0;
    if (sweeping == Sweeping::at_once) widen(never);
  }

  bool at_once() {
    bool changed = false;
    const Index begin = row(0), size = stride_ * rows_ - 2;  // from the first point to the last
    for (int k = 0; k < ValueGrid::kHeadings; ++k) {
      auto fresh = fresh_[static_cast<std::size_t>(k)].segment(begin, size);
      const auto on = [&](const Array& plane, Index offset) { return plane.segment(begin + offset, size); };
      fresh = on(value(k), 0)
                  .min(on(cost(k, Action::straight), 0) + on(value(k), step(k)))
                  .min(on(cost(k, Action::turn_plus), 0) + on(value(k + 1), 0))
                  .min(on(cost(k, Action::turn_minus), 0) + on(value(k - 1), 0));
      if (grid_.backs()) fresh = fresh.min(on(cost(k, Action::back), 0) + on(value(k), -step(k)));
      changed = changed || differ(fresh.data(), value(k).data() + begin, size);
    }
    values_.swap(fresh_);
    return changed;
  }

  bool in_place(bool upwards) {
    bool changed = false;
    for (int n = 0; n < ValueGrid::kHeadings; ++n) {
      const int k = upwards ? n : ValueGrid::kHeadings - 1 - n;
      const bool down = ValueGrid::kSteps[static_cast<std::size_t>(k)][1] > 0;
      for (Index m = 0; m < rows_; ++m) changed |= row_in_place(k, down ? rows_ - 1 - m : m);
    }
    return changed;
  }

  std::vector<double> result() const {
    std::vector<double> all(grid_.size());
    for (int k = 0; k < ValueGrid::kHeadings; ++k)
      for (int j = 0; j < grid_.rows(); ++j)
        std::copy_n(values_[static_cast<std::size_t>(k)].data() + row(j), columns_, all.data() + grid_.index(0, j, k));
    return all;
  }

 private:
  static std::size_t wrapped(int k) {
    return static_cast<std::size_t>((k + ValueGrid::kHeadings) % ValueGrid::kHeadings);
  }
  static bool differ(const double* a, const double* b, Index size) {
    return std::memcmp(a, b, static_cast<std::size_t>(size) * sizeof(double)) != 0;
  }

  /// Costs in the same layout: then a whole plane is updated as one array, borders and all.
  void widen(const Array& never) {
    fresh_ = values_;
    costs_.assign(kActions.size() * ValueGrid::kHeadings, never);
    for (int k = 0; k < ValueGrid::kHeadings; ++k)
      for (const Action action : kActions)
        for (int j = 0; j < grid_.rows(); ++j)
          std::copy_n(cost_row(k, action, j).data(), columns_, cost(k, action).data() + row(j));
  }

  Eigen::Map<const Array> cost_row(int k, Action action, Index j) const {
    return {grid_.costs(action).data() + grid_.index(0, static_cast<int>(j), static_cast<int>(wrapped(k))), columns_};
  }
  Array& value(int k) { return values_[wrapped(k)]; }
  Array& cost(int k, Action action) { return costs_[wrapped(k) * kActions.size() + static_cast<std::size_t>(action)]; }
  Index row(Index j) const { return (j + 1) * stride_ + 1; }
  Index step(int k) const {
    const auto [dx, dy] = ValueGrid::kSteps[static_cast<std::size_t>(k)];
    return dy * stride_ + dx;
  }

  bool row_in_place(int k, Index j) {
    const Index at = row(j);
    auto values = value(k).segment(at, columns_);
    line_ = values.min(cost_row(k, Action::turn_plus, j) + value(k + 1).segment(at, columns_))
                .min(cost_row(k, Action::turn_minus, j) + value(k - 1).segment(at, columns_));
    straight_in_place(k, j, Action::straight, step(k));
    if (grid_.backs()) straight_in_place(k, j, Action::back, -step(k));
    if (!differ(line_.data(), values.data(), columns_)) return false;
    values = line_;
    return true;
  }

  void straight_in_place(int k, Index j, Action action, Index by) {
    if (std::abs(by) == 1)
      along(cost_row(k, action, j).data(), by > 0);
    else
      line_ = line_.min(cost_row(k, action, j) + value(k).segment(row(j) + by, columns_));
  }

  /// Within a row each value waits for the one ahead of it.
  void along(const double* costs, bool rightwards) {
    double ahead = ValueGrid::kNever;
    for (Index m = 0; m < columns_; ++m) {
      const Index i = rightwards ? columns_ - 1 - m : m;
      line_(i) = ahead = std::min(line_(i), costs[i] + ahead);
    }
  }

  const ValueGrid& grid_;
  Index columns_, rows_, stride_;
  std::vector<Array> values_;
  std::vector<Array> fresh_, costs_;  ///< for at_once()
  Array line_;
};

}  // namespace

Values value_iteration(const ValueGrid& grid, Sweeping sweeping) {
  Sweeps sweeps(grid, sweeping);
  Values values;
  bool changed = true;
  while (changed) {
    changed = sweeping == Sweeping::at_once ? sweeps.at_once() : sweeps.in_place(values.sweeps % 2 == 0);
    ++values.sweeps;
  }
  values.of = sweeps.result();
  return values;
}

std::optional<Action> best_action(const ValueGrid& grid, const Values& values, std::size_t state) {
  std::optional<Action> best;
  if (grid.is_goal(state)) return best;
  double least = ValueGrid::kNever;
  for (const Action action : kActions)
    if (grid.cost(state, action) != ValueGrid::kNever)
      if (const double by = grid.cost(state, action) + values.of[grid.after(state, action)]; by < least)
        least = by, best = action;
  return best;
}

}  // namespace taut::roadblocks
