// Costs as they are read: whole multiples of a unit that becomes finer when a cost needs it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <taut/io/worlds/detail/decimal.h>
#include <taut/robots/pursuit/chase_map.h>

namespace taut::pursuit::detail {

/// Keeps costs exactly as long as none exceeds `limit` units, then rounds to the nearest multiple of the finest unit
/// that fits.
class CostStore {
 public:
  CostStore(const Decimal& threshold, std::uint32_t limit, std::size_t room);

  void add(const Decimal& cost) {
    const std::uint32_t value = value_of(cost);  // may change what is stored
    values_.push_back(value);
  }
  /// A cost that is a small whole number.
  void add(std::uint32_t whole) {
    if (whole >= small_.size()) return add(decimal_of(whole));
    std::uint64_t value = small_[whole];
    if (value == kUnknown) {
      value = value_of(decimal_of(whole));  // may forget all of small_
      small_[whole] = value;
    }
    values_.push_back(static_cast<std::uint32_t>(value));
  }

  std::size_t size() const { return values_.size(); }
  int decimals() const { return decimals_; }
  bool rounded() const { return rounded_; }
  std::vector<std::uint32_t> take() { return std::move(values_); }

 private:
  static constexpr std::uint64_t kUnknown = ~std::uint64_t{0};
  static Decimal decimal_of(std::uint32_t whole);

  std::uint32_t value_of(const Decimal& cost) {
    return is_at_least(cost, threshold_) ? ChaseMap::kObstacle : units_of(cost);
  }
  std::uint32_t units_of(const Decimal& cost);
  void refine(int decimals);
  void coarsen();

  Decimal threshold_;
  std::uint32_t limit_;
  int decimals_ = 0;
  int finest_ = 1000;  // never beyond
  bool rounded_ = false;
  std::uint32_t dearest_ = 0;
  std::vector<std::uint32_t> values_;
  std::vector<std::uint64_t> small_;  // of the whole numbers that occur, at the present unit
};

}  // namespace taut::pursuit::detail
