// Which gates a taut string passes. Private.
#pragma once

#include <cstdint>
#include <optional>

#include <taut/roadmaps/gates.h>
#include <taut/search/path.h>

namespace taut::detail {

/// The narrowest gate that a string passes, a little to the free side of each of its corners (Alternatives, guarantee
/// 4); the first of equals. Nothing where it passes none.
std::optional<std::uint32_t> narrowest_gate_of(const Gates& gates, const Path& path);

}  // namespace taut::detail
