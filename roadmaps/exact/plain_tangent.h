// Tangents whose freedom doubles can tell.
#pragma once

#include <optional>

#include <taut/roadmaps/exact/tangent_parts.h>

namespace taut {

/// is_free_tangent() of two sites, one of which may be an end of a query, with nothing but doubles: nothing where they
/// cannot tell, or openings are near.
std::optional<bool> plainly_free(const TangentWalls& walls, double r, const TangentSite& from, int from_side,
                                 const TangentSite& to, int to_side);

}  // namespace taut
