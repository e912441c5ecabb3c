// How a search ended.
#pragma once

#include <cstdint>
#include <string_view>

namespace taut {

/// How a search ended.
enum class SearchStatus : std::uint8_t {
  found,    ///< there is an answer; that it is the best is proven where `optimal` says so
  none,     ///< all that can be reached was looked at: there is none
  stopped,  ///< a limit was reached first: nothing is known
};

/// `found`, `none`, `stopped`
constexpr std::string_view name(SearchStatus status) {
  return status == SearchStatus::found ? "found" : status == SearchStatus::none ? "none" : "stopped";
}

/// Where a disc can go.
enum class DiscStatus : std::uint8_t {
  found,          ///< there is a path
  none,           ///< there is none, proven
  start_blocked,  ///< the disc cannot be at the start: outside, or too near a wall
  goal_blocked,   ///< likewise at the goal; the start is sound
};

}  // namespace taut
