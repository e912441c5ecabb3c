// A signed sum of square roots, exactly: its sign, its nearest double, its decimals.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <taut/geometry/exact/twofold.h>
#include <taut/geometry/point.h>

namespace taut {
struct SignedRoot;
}

namespace taut::detail {

/// count * sqrt(square). Where the square is exact as a double, dx and dy are dropped: 3-4-5 and 5-0-5 are one term.
struct RootTerm {
  twofold::Square square;
  std::int64_t count = 0;
};

/// The sum of its terms. Legs of equal length are one term, their counts added; terms whose count is 0 are gone.
///
/// sign() asks, in this order, and stops at the first that knows:
///  1. is nothing left (chains of equal legs in any order),
///  2. the double-double sum, with its error bound, or exactly where nothing was rounded (rational lengths),
///  3. classes of rationally dependent roots in 64-bit integers, where all squares are exact doubles,
///  4. the same in rationals; if a class is left, the sum is not 0 and roots of ever more digits find its sign.
class RootSum {
 public:
  /// The sum of the lengths of `plus` less that of `minus`.
  explicit RootSum(std::span<const Segment> plus, std::span<const Segment> minus = {});

  std::span<const RootTerm> terms() const { return {data(), size_}; }
  int sign() const;

  /// The double nearest to the sum, ties to even. Precondition: no negative terms.
  double nearest() const;
  /// Rounded to `places` >= 0 digits after the point, ties to even. Precondition: no negative terms.
  std::string decimals(int places) const;

 private:
  static constexpr std::size_t kInline = 24;
  static constexpr std::size_t kScanned = 8;  // worlds on a grid have few lengths: most legs find theirs here

  const RootTerm* data() const { return spilled_.empty() ? &inline_[0] : spilled_.data(); }
  RootTerm* data() { return spilled_.empty() ? &inline_[0] : spilled_.data(); }
  void add(const Segment& leg, int sign);
  std::size_t find_or_append(const twofold::Square& square);
  void append(const RootTerm& term);
  void merge();

  std::size_t size_ = 0;
  union {
    RootTerm inline_[kInline];  // the first size_, while nothing is spilled; the others are not initialised
  };
  std::vector<RootTerm> spilled_;
  twofold::Pair last_dx_, last_dy_;
  std::size_t last_ = 0;
};

/// By double-double arithmetic, where that is proof.
std::optional<int> sign_by_pairs(std::span<const RootTerm> terms);
std::optional<double> nearest_by_pairs(std::span<const RootTerm> terms);

/// The sign by classes in 64-bit integers: 0 when all cancel, +1 or -1 when all that are left agree. Nothing when
/// squares are not exact, numbers grow too large, or classes of both signs are left.
std::optional<int> sign_by_small_classes(std::span<const RootTerm> terms);

/// Integers of any length, always decided.
int sign_of_roots(const std::vector<SignedRoot>& terms);
int sign_by_big_numbers(std::span<const RootTerm> terms);
double nearest_by_big_numbers(std::span<const RootTerm> terms);
std::string decimals_by_big_numbers(std::span<const RootTerm> terms, int places);

}  // namespace taut::detail
