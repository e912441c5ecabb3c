// Polygons as people and programs write them, read for what they mean.
#pragma once

#include <string>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/geometry/world.h>

namespace taut {

/// What a ring that crosses itself means, or winds around a place twice, and a hole that reaches over its outer ring or
/// over another hole.
enum class Crossings {
  refuse,    ///< nobody knows
  even_odd,  ///< the inside of a ring is what one leaves by crossing it an odd number of times; holes are taken away
};

/// A ring or hole means nothing as long as Crossings::refuse holds.
class AmbiguousRing : public InputError {
 public:
  AmbiguousRing(const std::string& source, int line, const std::string& message, std::string even_odd)
      : InputError(source, line, message), even_odd_(std::move(even_odd)) {}

  /// How Crossings::even_odd would take it, in words: `taken by the even-odd rule`.
  const std::string& even_odd() const { return even_odd_; }

 private:
  std::string even_odd_;
};

/// Replaces the areas and solids of `parts` by polygons as World guarantees them. What has one meaning is taken so:
///
///  - a ring that touches itself, or that runs along itself: the closure of its inside; what has no width goes;
///  - holes that touch or run along the outer ring or each other: the outer ring without the holes, in as many polygons
///    as it falls into;
///  - points that repeat: once; rings without area: not at all.
///
/// Says what it met, a line for each kind: the first place and how many more polygons have it. Of crossings everything
/// else means what `crossings` says; they are rounded to 15 digits. Regular polygons stay as they are. World does the
/// same with Crossings::refuse. Throws AmbiguousRing naming source, line and place where it refuses; InputError where
/// areas are given but none has an area, and where a ring meets itself at angles too sharp for doubles. O(n log n).
std::vector<std::string> mend_rings(WorldParts& parts, Crossings crossings = Crossings::refuse);

/// The places that lie in an odd number of these polygons, as World guarantees polygons: one within another is a hole,
/// one within that an island, and what two of them share is out. Rings may be broken and cross. Throws InputError as
/// World does for numbers that it does not take, and where rings meet at angles too sharp for doubles. O(n log n).
std::vector<Area> even_odd_areas(const std::vector<Area>& areas, const std::string& source = {});

}  // namespace taut
