// What a way on a grid costs: a + b * sqrt(2), as one integer whose order is exact.
#pragma once

#include <compare>
#include <cstdint>

namespace taut {

/// The cost of `straight` unit moves and `diagonal` moves of length sqrt(2), kept as the integer straight * Q +
/// diagonal * P with P^2 - 2 Q^2 = 1 (a solution of Pell's equation, so P / Q is sqrt(2) to 18 digits).
///
///  1. Costs add by adding integers.
///  2. The order of the integers is the order of the numbers, ties included, while no count exceeds 5 * 10^8. Proof:
///     for different counts, x = da + db sqrt(2) is not 0 and |x| >= 1 / (|da| + sqrt(2) |db|) >= 1 / (2.4143 M), since
///     |da^2 - 2 db^2| >= 1. The integers differ by Q x + db (P - Q sqrt(2)), and |db| (P - Q sqrt(2)) = |db| / (P + Q
///     sqrt(2)) < M / (2.8284 Q), which is less than Q |x| as long as M < 1.08 Q.
///  3. The counts can be had back: P is its own inverse modulo Q.
class GridCost {
 public:
  static constexpr std::int64_t kStraight = 543'339'720;  ///< Q
  static constexpr std::int64_t kDiagonal = 768'398'401;  ///< P

  constexpr GridCost() = default;
  constexpr GridCost(std::int64_t straight, std::int64_t diagonal)
      : key_(straight * kStraight + diagonal * kDiagonal) {}
  static constexpr GridCost of_key(std::int64_t key) {
    GridCost cost;
    cost.key_ = key;
    return cost;
  }

  constexpr std::int64_t key() const { return key_; }
  constexpr std::int64_t diagonal() const { return key_ % kStraight * (kDiagonal - kStraight) % kStraight; }
  constexpr std::int64_t straight() const { return (key_ - diagonal() * kDiagonal) / kStraight; }
  /// The nearest double but for two roundings.
  double value() const {
    return static_cast<double>(straight()) + static_cast<double>(diagonal()) * 1.4142135623730951;
  }

  friend constexpr GridCost operator+(GridCost a, GridCost b) { return of_key(a.key_ + b.key_); }
  friend constexpr auto operator<=>(GridCost, GridCost) = default;

 private:
  std::int64_t key_ = 0;
};

}  // namespace taut
