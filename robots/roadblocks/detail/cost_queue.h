// A priority queue for small whole costs.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace taut::roadblocks::detail {

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
  void seed(std::int32_t cost, State s) { seeds_.push_back({cost, s}); }

  template <typename Visit>
  void each_seed(Visit visit) const {
    for (const Seed& seed : seeds_) visit(seed.cost, seed.state);
  }

  /// Calls visit(cost, state) by rising cost; it may push what is dearer, by one move.
  template <typename Visit>
  void run(Visit visit) {
    sort_seeds();
    std::vector<State> states;
    for (std::int32_t cost = 0; in_ring_ != 0 || !seeds_.empty(); ++cost) {
      if (in_ring_ == 0) cost = seeds_.back().cost;
      for (; !seeds_.empty() && seeds_.back().cost <= cost; seeds_.pop_back()) push(cost, seeds_.back().state);
      states.clear();
      states.swap(ring_[static_cast<std::size_t>(cost) % kRing]);
      in_ring_ -= states.size();
      for (const State s : states) visit(cost, s);
    }
  }

 private:
  static constexpr std::size_t kRing = 512;
  struct Seed {
    std::int32_t cost;
    State state;
  };

  /// The dearest first, by counting.
  void sort_seeds() {
    if (seeds_.empty()) return;
    const auto dearest = static_cast<std::size_t>(std::ranges::max_element(seeds_, {}, &Seed::cost)->cost);
    std::vector<std::size_t> place(dearest + 2);
    for (const Seed& seed : seeds_) ++place[dearest - static_cast<std::size_t>(seed.cost) + 1];
    std::partial_sum(place.begin(), place.end(), place.begin());
    std::vector<Seed> sorted(seeds_.size());
    for (const Seed& seed : seeds_) sorted[place[dearest - static_cast<std::size_t>(seed.cost)]++] = seed;
    seeds_.swap(sorted);
  }

  std::array<std::vector<State>, kRing> ring_;
  std::size_t in_ring_ = 0;
  std::vector<Seed> seeds_;
};

}  // namespace taut::roadblocks::detail
