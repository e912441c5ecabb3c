// A queue for searches whose keys never fall below the last one taken.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

namespace taut::pursuit::detail {

/// Monotone priority queue (Ahuja, Mehlhorn, Orlin, Tarjan, "Faster algorithms for the shortest path problem", 1990).
/// Items of equal key leave in an order that depends on the calls alone. Amortised 64 moves an item at worst, a few in
/// practice.
template <typename Value>
class RadixHeap {
 public:
  using Item = std::pair<std::uint64_t, Value>;

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }

  void clear() {
    for (auto& bucket : buckets_) bucket.clear();
    size_ = 0;
    last_ = 0;
  }

  /// Precondition: key is not below the last key taken.
  void push(std::uint64_t key, Value value) {
    buckets_[bucket(key)].push_back({key, value});
    ++size_;
  }

  /// Precondition: not empty.
  Item pop() {
    if (buckets_[0].empty()) refill();
    const Item item = buckets_[0].back();
    buckets_[0].pop_back();
    --size_;
    return item;
  }

 private:
  std::size_t bucket(std::uint64_t key) const { return static_cast<std::size_t>(std::bit_width(key ^ last_)); }

  void refill() {
    std::size_t i = 1;
    while (buckets_[i].empty()) ++i;
    last_ = buckets_[i].front().first;
    for (const Item& item : buckets_[i]) last_ = item.first < last_ ? item.first : last_;
    for (const Item& item : buckets_[i]) buckets_[bucket(item.first)].push_back(item);
    buckets_[i].clear();
    if (buckets_[i].capacity() > kKept) buckets_[i].shrink_to_fit();
  }

  static constexpr std::size_t kKept = std::size_t{1} << 16;

  std::array<std::vector<Item>, 65> buckets_;
  std::uint64_t last_ = 0;
  std::size_t size_ = 0;
};

}  // namespace taut::pursuit::detail
