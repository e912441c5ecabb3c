// What libc++ 13, emscripten's in Debian 12, lacks of C++20. Every source is compiled with this in front.
#pragma once

#include <__config>

#if _LIBCPP_VERSION < 14000

#include <algorithm>
#include <bit>
#include <charconv>
#include <functional>
#include <iterator>
#include <ranges>
#include <type_traits>
#include <utility>

// NOLINTBEGIN(cert-dcl58-cpp): it is the standard library that is mended here
namespace std {

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From) && is_trivially_copyable_v<To> && is_trivially_copyable_v<From>);
  return __builtin_bit_cast(To, from);
}

/// Of all these there is what taut asks for: no bounds of a precision but %g's.
to_chars_result to_chars(char* first, char* last, double value);
to_chars_result to_chars(char* first, char* last, double value, chars_format format);
to_chars_result to_chars(char* first, char* last, double value, chars_format format, int precision);
from_chars_result from_chars(const char* first, const char* last, double& value);

namespace ranges {

template <class Range, class Holds, class Of = identity>
constexpr auto find_if(Range&& range, Holds holds, Of of = {}) {
  auto at = begin(range);
  while (at != end(range) && !std::invoke(holds, std::invoke(of, *at))) ++at;
  return at;
}
template <class Range, class Holds, class Of = identity>
constexpr auto find_if_not(Range&& range, Holds holds, Of of = {}) {
  return ranges::find_if(range, std::not_fn(holds), of);
}
template <class Range, class Value, class Of = identity>
constexpr auto find(Range&& range, const Value& value, Of of = {}) {
  return ranges::find_if(
      range, [&](const auto& one) { return one == value; }, of);
}
template <class Range, class Holds, class Of = identity>
constexpr bool any_of(Range&& range, Holds holds, Of of = {}) {
  return ranges::find_if(range, holds, of) != end(range);
}
template <class Range, class Holds, class Of = identity>
constexpr bool none_of(Range&& range, Holds holds, Of of = {}) {
  return !ranges::any_of(range, holds, of);
}
template <class Range, class Holds, class Of = identity>
constexpr bool all_of(Range&& range, Holds holds, Of of = {}) {
  return !ranges::any_of(range, std::not_fn(holds), of);
}
template <class Range, class Holds, class Of = identity>
constexpr auto count_if(Range&& range, Holds holds, Of of = {}) {
  return std::count_if(begin(range), end(range),
                       [&](const auto& one) { return std::invoke(holds, std::invoke(of, one)); });
}
template <class Range, class Work>
constexpr void for_each(Range&& range, Work work) {
  for (auto&& one : range) std::invoke(work, one);
}
template <class Range, class Holds, class Value>
constexpr void replace_if(Range&& range, Holds holds, const Value& value) {
  std::replace_if(begin(range), end(range), holds, value);
}
template <class Range, class Less = std::less<>, class Of = identity>
constexpr auto max_element(Range&& range, Less less = {}, Of of = {}) {
  return std::max_element(begin(range), end(range), [&](const auto& a, const auto& b) {
    return std::invoke(less, std::invoke(of, a), std::invoke(of, b));
  });
}

}  // namespace ranges
}  // namespace std
// NOLINTEND(cert-dcl58-cpp)

#endif
