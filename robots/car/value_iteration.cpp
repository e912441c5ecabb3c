#include <taut/robots/car/value_iteration.h>

#include <Eigen/Core>

#include <cstring>

namespace taut::car {

namespace {

using Plane = Eigen::ArrayXXd;
using Costs = Eigen::Map<const Plane>;

/// A plane of values a heading, column by column along x, with a border of kNever; and the same of costs, without.
class Sweeps {
 public:
  explicit Sweeps(const ValueGrid& grid) : grid_(grid), columns_(grid.columns()), rows_(grid.rows()) {
    for (int k = 0; k < ValueGrid::kHeadings; ++k) {
      values_.push_back(Plane::Constant(columns_ + 2, rows_ + 2, ValueGrid::kNever));
      for (int j = 0; j < rows_; ++j)
        for (int i = 0; i < columns_; ++i)
          if (grid.is_goal(grid.index(i, j, k))) values_.back()(i + 1, j + 1) = 0;
      for (const Action action : kActions)
        costs_.emplace_back(grid.costs(action).data() + grid.index(0, 0, k), columns_, rows_);
    }
    fresh_ = values_;
    line_.resize(columns_);
  }

  bool at_once() {
    bool changed = false;
    for (int k = 0; k < ValueGrid::kHeadings; ++k) {
      const auto [dx, dy] = step(k);
      fresh(k).block(1, 1, columns_, rows_) =
          inner(k)
              .min(cost(k, Action::straight) + values(k).block(1 + dx, 1 + dy, columns_, rows_))
              .min(cost(k, Action::turn_plus) + inner(k + 1))
              .min(cost(k, Action::turn_minus) + inner(k - 1));
      if (grid_.backs())
        fresh(k).block(1, 1, columns_, rows_) =
            fresh(k)
                .block(1, 1, columns_, rows_)
                .min(cost(k, Action::back) + values(k).block(1 - dx, 1 - dy, columns_, rows_));
      changed = changed || differ(fresh(k), values(k));
    }
    values_.swap(fresh_);
    return changed;
  }

  bool in_place(bool upwards) {
    bool changed = false;
    for (int n = 0; n < ValueGrid::kHeadings; ++n) {
      const int k = upwards ? n : ValueGrid::kHeadings - 1 - n;
      const Eigen::Index dy = step(k)[1];
      for (Eigen::Index m = 0; m < rows_; ++m) changed |= row_in_place(k, dy > 0 ? rows_ - 1 - m : m);
    }
    return changed;
  }

  std::vector<double> result() const {
    std::vector<double> all(grid_.size());
    for (int k = 0; k < ValueGrid::kHeadings; ++k)
      Eigen::Map<Plane>(all.data() + grid_.index(0, 0, k), columns_, rows_) =
          values_[static_cast<std::size_t>(k)].block(1, 1, columns_, rows_);
    return all;
  }

 private:
  static std::array<int, 2> step(int k) { return ValueGrid::kSteps[static_cast<std::size_t>(k)]; }
  static std::size_t wrapped(int k) {
    return static_cast<std::size_t>((k + ValueGrid::kHeadings) % ValueGrid::kHeadings);
  }
  static bool differ(const Plane& a, const Plane& b) {
    return std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(double)) != 0;
  }

  Plane& values(int k) { return values_[wrapped(k)]; }
  Plane& fresh(int k) { return fresh_[wrapped(k)]; }
  Eigen::Block<Plane> inner(int k) { return values(k).block(1, 1, columns_, rows_); }
  const Costs& cost(int k, Action action) const {
    return costs_[wrapped(k) * kActions.size() + static_cast<std::size_t>(action)];
  }

  bool row_in_place(int k, Eigen::Index j) {
    const auto [dx, dy] = step(k);
    auto row = values(k).col(j + 1).segment(1, columns_);
    line_ = row.min(cost(k, Action::turn_plus).col(j) + values(k + 1).col(j + 1).segment(1, columns_))
                .min(cost(k, Action::turn_minus).col(j) + values(k - 1).col(j + 1).segment(1, columns_));
    straight_in_place(k, j, Action::straight, dx, dy);
    if (grid_.backs()) straight_in_place(k, j, Action::back, -dx, -dy);
    if (std::memcmp(line_.data(), row.data(), static_cast<std::size_t>(columns_) * sizeof(double)) == 0) return false;
    row = line_;
    return true;
  }

  void straight_in_place(int k, Eigen::Index j, Action action, int dx, int dy) {
    if (dy != 0)
      line_ = line_.min(cost(k, action).col(j) + values(k).col(j + 1 + dy).segment(1 + dx, columns_));
    else
      along(cost(k, action).col(j).data(), dx);
  }

  /// Within a row each value waits for the one ahead of it.
  void along(const double* costs, int dx) {
    double ahead = ValueGrid::kNever;
    for (Eigen::Index m = 0; m < columns_; ++m) {
      const Eigen::Index i = dx > 0 ? columns_ - 1 - m : m;
      line_(i) = ahead = std::min(line_(i), costs[i] + ahead);
    }
  }

  const ValueGrid& grid_;
  Eigen::Index columns_, rows_;
  std::vector<Plane> values_, fresh_;
  std::vector<Costs> costs_;
  Eigen::ArrayXd line_;
};

}  // namespace

Values value_iteration(const ValueGrid& grid, Sweeping sweeping) {
  Sweeps sweeps(grid);
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

}  // namespace taut::car
