// A set of small integers in order. Private.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace taut::detail {

/// A set of integers below a size, as bits with bits above them that say which words are not zero. All calls
/// O(log64 size).
class RankSet {
 public:
  explicit RankSet(std::size_t size) {
    do {
      size = size / 64 + 1;
      levels_.emplace_back(size, 0);
    } while (size > 1);
  }

  void insert(std::uint32_t i) {
    for (auto& level : levels_) {
      level[i / 64] |= bit(i);
      i /= 64;
    }
  }

  void erase(std::uint32_t i) {
    for (auto& level : levels_) {
      if ((level[i / 64] &= ~bit(i)) != 0) return;
      i /= 64;
    }
  }

  bool contains(std::uint32_t i) const { return levels_[0][i / 64] & bit(i); }

  /// Calls visit(i) for the members from `first` to `last`, in order. O(members + words between).
  template <class Visit>
  void each(std::uint32_t first, std::uint32_t last, const Visit& visit) const {
    for (std::uint32_t word = first / 64; word <= last / 64; ++word) {
      std::uint64_t bits = levels_[0][word];
      if (word == first / 64) bits &= ~std::uint64_t{0} << (first % 64);
      if (word == last / 64) bits &= ~std::uint64_t{0} >> (63 - last % 64);
      for (; bits != 0; bits &= bits - 1) visit(word * 64 + static_cast<std::uint32_t>(std::countr_zero(bits)));
    }
  }

  /// The largest member below i. Precondition: there is one.
  std::uint32_t before(std::uint32_t i) const {
    std::size_t height = 0;
    std::uint64_t below = levels_[0][i / 64] & (bit(i) - 1);
    while (below == 0) {
      i /= 64;
      ++height;
      below = levels_[height][i / 64] & (bit(i) - 1);
    }
    for (;;) {
      i = i / 64 * 64 + 63 - static_cast<std::uint32_t>(std::countl_zero(below));
      if (height == 0) return i;
      i *= 64;
      below = levels_[--height][i / 64];
    }
  }

 private:
  static std::uint64_t bit(std::uint32_t i) { return std::uint64_t{1} << (i % 64); }

  std::vector<std::vector<std::uint64_t>> levels_;  // from the members up
};

}  // namespace taut::detail
