#include <taut/io/worlds/detail/cost_store.h>

#include <algorithm>

namespace taut::pursuit::detail {

namespace {

constexpr std::size_t kSmall = 10'000;

// Rounds to nearest.
std::uint64_t divided(std::uint64_t value, int places, bool& rounded) {
  if (places > 19) {
    rounded = rounded || value != 0;
    return 0;
  }
  const std::uint64_t unit = power_of_ten(places), rest = value % unit;
  rounded = rounded || rest != 0;
  return value / unit + (rest >= unit - rest && rest != 0);
}

}  // namespace

CostStore::CostStore(const Decimal& threshold, std::uint32_t limit, std::size_t room)
    : threshold_(threshold), limit_(limit), small_(kSmall, kUnknown) {
  values_.reserve(room);
}

Decimal CostStore::decimal_of(std::uint32_t whole) {
  Decimal value{whole, 0, false};
  while (value.mantissa != 0 && value.mantissa % 10 == 0) {
    value.mantissa /= 10;
    --value.places;
  }
  return value;
}

void CostStore::refine(int decimals) {
  int steps = 0;
  for (std::uint64_t grown = std::max<std::uint64_t>(dearest_, 1); decimals_ + steps < std::min(decimals, finest_);
       ++steps)
    if ((grown *= 10) > limit_) break;
  if (steps == 0) return;
  const auto factor = static_cast<std::uint32_t>(power_of_ten(steps));
  for (std::uint32_t& value : values_)
    if (value != ChaseMap::kObstacle) value *= factor;
  dearest_ *= factor;
  decimals_ += steps;
  std::fill(small_.begin(), small_.end(), kUnknown);
}

void CostStore::coarsen() {
  for (std::uint32_t& value : values_)
    if (value != ChaseMap::kObstacle) value = static_cast<std::uint32_t>(divided(value, 1, rounded_));
  bool ignored = false;
  dearest_ = static_cast<std::uint32_t>(divided(dearest_, 1, ignored));
  finest_ = --decimals_;
  std::fill(small_.begin(), small_.end(), kUnknown);
}

std::uint32_t CostStore::units_of(const Decimal& cost) {
  if (cost.mantissa == 0) return 0;
  if (cost.places > decimals_ && cost.mantissa <= limit_) refine(cost.places);
  if (cost.places > decimals_ && cost.places - decimals_ < 30) {
    // As fine as this cost allows, should it have to be rounded.
    int places = cost.places;
    std::uint64_t mantissa = cost.mantissa;
    for (; mantissa > limit_; mantissa /= 10) --places;
    refine(places);
  }
  rounded_ = rounded_ || cost.cut;
  for (;; coarsen()) {
    const int shift = decimals_ - cost.places;
    std::uint64_t units = 0;
    if (shift < 0)
      units = divided(cost.mantissa, -shift, rounded_);
    else if (shift > 19 || Wide{cost.mantissa} * power_of_ten(shift) > limit_)
      continue;
    else
      units = cost.mantissa * power_of_ten(shift);
    if (units > limit_) continue;
    dearest_ = std::max(dearest_, static_cast<std::uint32_t>(units));
    return static_cast<std::uint32_t>(units);
  }
}

}  // namespace taut::pursuit::detail
