// Sorting by integer keys in linear time. Private.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace taut::detail {

/// Sorts `items` by `key(item)`, a std::uint64_t below 2^bits; equal ones keep their order. O(n * bits / 11): a pass
/// for eleven bits, a glance where all have the same ones.
template <class Item, class Key>
void radix_sort(std::vector<Item>& items, int bits, const Key& key) {
  constexpr int kDigit = 11;
  if (items.empty()) return;
  std::uint64_t varying = 0;
  for (const Item& item : items) varying |= key(item) ^ key(items.front());
  std::vector<Item> other(items.size());
  for (int shift = 0; shift < bits; shift += kDigit) {
    if (((varying >> shift) & ((1U << kDigit) - 1)) == 0) continue;
    std::array<std::uint32_t, 1 << kDigit> next{};
    const auto digit = [&](const Item& item) { return (key(item) >> shift) & ((1U << kDigit) - 1); };
    for (const Item& item : items) ++next[digit(item)];
    std::uint32_t sum = 0;
    for (std::uint32_t& n : next) sum += std::exchange(n, sum);
    for (const Item& item : items) other[next[digit(item)]++] = item;
    items.swap(other);
  }
}

/// A key in the order of finite numbers; 0 and -0 are one.
inline std::uint64_t sort_key(double v) {
  const auto bits = std::bit_cast<std::uint64_t>(v == 0 ? 0.0 : v);
  return bits >> 63 ? ~bits : bits | 0x8000000000000000;
}

/// How many bits numbers up to `largest` need.
inline int bits_of(std::uint64_t largest) { return static_cast<int>(std::bit_width(largest)); }

}  // namespace taut::detail
