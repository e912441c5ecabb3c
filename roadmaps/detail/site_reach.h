// How large the circles are around a corner that legs can touch. Private.
#pragma once

#include <taut/roadmaps/exact/all_radii_parts.h>

namespace taut::detail {

/// A leg touches the circle where a disc of its radius keeps clear of all walls: it touches the corner and leads away
/// from its walls. So any point of a wall bounds the discs that touch the corner from within a narrow angle. In
/// doubles, rounded up; at most four times the extent of the world.
double site_reach(const TangentGround& ground, const TangentSite& site, double extent);

/// The walls that forbid directions on circles up to that size.
SiteRadii site_radii(const TangentGround& ground, const TangentSite& site, double reach);

}  // namespace taut::detail
