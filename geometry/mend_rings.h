// Polygons as people and programs write them, read for what they mean.
#pragma once

#include <string>
#include <vector>

namespace taut {

struct WorldParts;

/// What a ring that crosses itself means, or winds around a place twice, and a hole that reaches over its outer ring or
/// over another hole.
enum class Crossings {
  refuse,    ///< nobody knows
  even_odd,  ///< the inside of a ring is what one leaves by crossing it an odd number of times; holes are taken away
};

/// Replaces the areas and solids of `parts` by polygons as World guarantees them. What has one meaning is taken so:
///
///  - a ring that touches itself, or that runs along itself: the closure of its inside; what has no width goes;
///  - holes that touch or run along the outer ring or each other: the outer ring without the holes, in as many polygons
///    as it falls into;
///  - points that repeat: once; rings without area: not at all.
///
/// Says what it met, a line for each kind: the first place and how many more polygons have it. Of crossings everything
/// else means what `crossings` says. Regular polygons stay as they are. World does the same with Crossings::refuse.
/// Throws InputError naming source, line and place where it refuses, and where areas are given but none has an area.
/// O(n log n).
std::vector<std::string> mend_rings(WorldParts& parts, Crossings crossings = Crossings::refuse);

}  // namespace taut
