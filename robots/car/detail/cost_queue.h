// A priority queue for small whole costs.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace taut::car::detail {

/// Numbered states by cost, in a ring of buckets: a push is at most kRing - 1 above what is visited.
class CostQueue {
 public:
  using State = std::uint32_t;

  void push(std::int32_t cost, State s) {
    ring_[static_cast<std::size_t>(cost) % kRing].push_back(s);
    ++in_ring_;
  }

  /// Within run(): it ends.
  void stop() {
    for (std::vector<State>& states : ring_) states.clear();
    seeds_.clear();
    in_ring_ = 0;
  }

  /// Before run(): at any cost.
  void seed(std::int32_t cost, State s) { seeds_.push_back(static_cast<std::uint64_t>(cost) << 32 | s); }

  template <typename Visit>
  void each_seed(Visit visit) const {
    for (const std::uint64_t seed : seeds_) visit(static_cast<std::int32_t>(seed >> 32), static_cast<State>(seed));
  }

  /// Calls visit(cost, state) by rising cost; it may push what is dearer, by one move.
  template <typename Visit>
  void run(Visit visit) {
    std::ranges::sort(seeds_, std::greater<>());
    std::vector<State> states;
    for (std::int32_t cost = 0; in_ring_ != 0 || !seeds_.empty(); ++cost) {
      if (in_ring_ == 0) cost = static_cast<std::int32_t>(seeds_.back() >> 32);
      for (; !seeds_.empty() && static_cast<std::int32_t>(seeds_.back() >> 32) <= cost; seeds_.pop_back())
        push(cost, static_cast<State>(seeds_.back()));
      states.clear();
      states.swap(ring_[static_cast<std::size_t>(cost) % kRing]);
      in_ring_ -= states.size();
      for (const State s : states) visit(cost, s);
    }
  }

 private:
  static constexpr std::size_t kRing = 512;
  std::array<std::vector<State>, kRing> ring_;
  std::size_t in_ring_ = 0;
  std::vector<std::uint64_t> seeds_;  ///< the cost in the upper half
};

}  // namespace taut::car::detail
