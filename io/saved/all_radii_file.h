// The legs of all radii, kept in files.
#pragma once

#include <string>
#include <string_view>

#include <taut/roadmaps/all_radii.h>

namespace taut {

/// The file: lines that tell what it is of, then values as Packer writes them: for each leg its corners, its sides and
/// its spans.
///
///     taut radii 1
///     source data/maze_100x100.txt
///     world 0d3f...               fingerprint(world)
///     mark 8a01...                of the bytes behind the head
///     end
///
/// Same index, same bytes.
std::string all_radii_file(const AllRadii& all);

/// What all_radii_file wrote, for a space of the same world, whose triangulation the same version of this library made.
/// All of it is checked for being whole and in order; what stands around corners is looked up anew. Throws InputError,
/// in one line: no such file, of another version, cut off, damaged, of another world (naming both).
/// Precondition: the space's footprint is Footprint::point().
AllRadii read_all_radii(std::string_view bytes, const std::string& name, const FreeSpace& space);

}  // namespace taut
