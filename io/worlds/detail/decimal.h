// Decimal numbers as files write them.
#pragma once

#include <cstdint>

namespace taut::pursuit::detail {

__extension__ using Wide = unsigned __int128;

/// mantissa * 10^-places, no trailing zeros; zero is {0, 0}. `cut`: further digits than the mantissa holds were not
/// zero.
struct Decimal {
  std::uint64_t mantissa = 0;
  int places = 0;
  bool cut = false;
};

/// 10^n, 0 <= n <= 19.
std::uint64_t power_of_ten(int n);

/// a >= b. Exact but for what was cut off.
bool is_at_least(const Decimal& a, const Decimal& b);

/// Scans an unsigned decimal number at `at` and moves `at` behind it; false, and `at` unchanged, where there is none.
bool scan(const char*& at, const char* end, Decimal& value);

}  // namespace taut::pursuit::detail
