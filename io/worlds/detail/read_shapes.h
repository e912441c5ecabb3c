// From walls and polygons as they were written to a World.
#pragma once

#include <taut/geometry/world.h>
#include <taut/io/worlds/read_world.h>

namespace taut::detail {

/// Ends and thickness as the options have them; what nearly touches is joined.
World joined(WorldParts parts, const ReadOptions& options, ReadNotes* notes);

/// The same after rings of one meaning are taken for it and, with ReadOptions::project, all is in metres. A ring of no
/// one meaning may have one when what nearly touches is joined first: by rounding, what touched itself crosses itself.
/// `seen` gets remarks in any case.
World read_shapes(WorldParts parts, const ReadOptions& options, ReadNotes& seen, ReadNotes* notes);

}  // namespace taut::detail
