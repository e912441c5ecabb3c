// From shapes as they are written to a World.
#pragma once

#include <taut/geometry/world.h>
#include <taut/io/worlds/read_world.h>

namespace taut::detail {

/// Rings of one meaning are taken for it (mend_rings), then what nearly touches is joined as the options say. A ring of
/// no one meaning may have one when what nearly touches is joined first: by rounding, what touched itself crosses
/// itself. With ReadOptions::project all is in metres then. `seen` gets a remark for each kind of flaw; `notes`, where
/// given, what joining did. Throws InputError.
World read_shapes(WorldParts parts, const ReadOptions& options, ReadNotes& seen, ReadNotes* notes);

/// The same of shapes that need no mending.
World joined(WorldParts parts, const ReadOptions& options, ReadNotes* notes);

}  // namespace taut::detail
