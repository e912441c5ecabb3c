// Which triangles a navigation mesh is made of.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <taut/geometry/triangulation.h>

namespace taut::detail {

/// Both in ascending order.
std::vector<std::uint32_t> free_triangles(const Triangulation& tri);

/// The free triangles without dead ends: as long as one of them is joined to at most one other and meets no end, it is
/// left out. The triangles whose own box meets one of `ends` count as meeting it. O(n).
std::vector<std::uint32_t> triangles_between(const Triangulation& tri, std::span<const Box> ends);

}  // namespace taut::detail
