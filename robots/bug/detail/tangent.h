// Tangent Bug among exact polygons: the rules, what they cost at most, and why they end.
#pragma once

#include <taut/robots/bug/bug.h>
#include <taut/robots/bug/detail/place.h>

namespace taut::bug::detail {

/// One journey from `stand`. The robot decides only where it stands, so its path is a chain of straight legs and pieces
/// of contours; in the paper it senses all along, and where its range ends its way is a curve.
/// Rules, why they end, and what they cost at most: docs/bug-algorithms.md; the numbers in the bodies are those of the
/// rules there.
Journey tangent_journey(const ContourPlaces& places, const Stand& stand, Point from, Point goal,
                        const Options& options);

}  // namespace taut::bug::detail
