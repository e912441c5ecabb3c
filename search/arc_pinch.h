// Where a disc's way is narrowest.
#pragma once

#include <cstdint>
#include <optional>

#include <taut/roadmaps/gates.h>
#include <taut/search/arc_path.h>
#include <taut/search/barrier.h>

namespace taut {

/// The narrowest gate that a path passes.
struct ArcPinch {
  Point at;  ///< where it does, to within a thousandth of the disc's radius
  NamedGate gate;
  std::uint32_t index = kNone;  ///< of the gate
};

/// Of several equally narrow gates the first of Gates::gates() that is passed. Nothing where none is: a way in the
/// open. A gate that the path starts or ends on is not passed there.
/// For pictures and people: the path is followed along chords of its arcs. O(gates times pieces) at worst.
std::optional<ArcPinch> narrowest_gate(const Gates& gates, const ArcPath& path);

}  // namespace taut
