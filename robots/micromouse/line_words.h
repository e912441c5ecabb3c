// The words of a line that a robot's program says.
#pragma once

#include <algorithm>
#include <string_view>

namespace taut::micromouse {

/// Takes the first word off the line; empty where there is none.
inline std::string_view word_of(std::string_view& rest) {
  constexpr std::string_view kBlank = " \t\r";
  const std::size_t from = std::min(rest.find_first_not_of(kBlank), rest.size());
  const std::size_t to = std::min(rest.find_first_of(kBlank, from), rest.size());
  const std::string_view word = rest.substr(from, to - from);
  rest.remove_prefix(to);
  return word;
}

}  // namespace taut::micromouse
