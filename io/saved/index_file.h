// Indexes kept in files, and mapped from them.
#pragma once

#include <string>

#include <taut/search/index.h>

namespace taut {

/// The file: lines that tell what it is of, blanks up to a multiple of 64 bytes, then Index::bytes().
///
///     taut index 1
///     source data/maze_25x25.txt
///     world 0d3f...               fingerprint(world)
///     robot disc 0.2              or `point`, `square R`, `polygon x y x y ...`
///     end
///
/// Same index, same bytes.
std::string index_file(const Index& index);

/// Maps what index_file wrote; all of it is read once and checked. For a space of the same world and robot, whose
/// triangulation the same version of this library made. The file may be removed or replaced as a whole while the index
/// lives, not be written to. Throws InputError, in one line: it cannot be read, is no such file, of another version,
/// cut off, damaged, of another world (naming both) or for another robot. O(bytes).
Index load_index(const std::string& path, const FreeSpace& space);

}  // namespace taut
