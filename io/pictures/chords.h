// Two chords a bend: why a path in a world without holes is the shortest, to be seen.
#pragma once

#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/io/pictures/svg.h>
#include <taut/search/path.h>

namespace taut {

/// At each bend, straight across the leg that comes and across the one that goes, from the corner over to the other
/// side. Where no obstacle stands free, each such chord has start and goal on different sides, so every path crosses
/// all of them; of the two chords across one leg each is as far from the other as that leg is long, so no path is
/// shorter than all legs together. Empty where some obstacle stands free of the others: one may pass beside a chord
/// then. For pictures: far ends are rounded. Precondition: the path is the shortest between two points of the space.
/// O(bends * pieces).
std::vector<Segment> chords(const FreeSpace& space, const Path& path);

/// As guides, with a key that says what they are.
void add_chords(SvgPicture& picture, const FreeSpace& space, const Path& path);

}  // namespace taut
