// Mazes with roadblocks as files.
#pragma once

#include <string>
#include <string_view>

#include <taut/robots/roadblocks/roadblock_map.h>

namespace taut {

/// Reads
///
///     start X Y
///     goal X Y
///     roadblock LETTER X Y P_OPEN     any number; without P_OPEN 1/2
///     grid WIDTH HEIGHT
///     HEIGHT rows of WIDTH characters: # wall, . open, a LETTER A..Z: a cell of that roadblock
///     samples K                       optional, what follows on the line is a remark
///     I BITS                          K lines; a character per roadblock in the order of letters, 1 = open
///
///  1. `start`, `goal` and `roadblock` come before `grid`, in any order, start and goal once. A line that begins with #
///     is a comment unless it is one of the grid's rows; empty lines outside the grid are skipped; CRLF and a byte
///     order mark are accepted.
///  2. Strict otherwise. X Y of a roadblock lie within the box around its cells; sides are at most kLargestSide; start
///     and goal lie within the grid.
/// Throws InputError with the line.
roadblocks::RoadblockMap read_roadblock_map(std::string_view bytes, const std::string& source = {});

/// The file of a map, as read_roadblock_map takes it; `remark` becomes its first line.
std::string roadblock_map_text(const roadblocks::RoadblockMap& map, const std::string& remark = {});

/// The set that the bits, as in a file, name. Throws InputError for a wrong number of bits or another character.
roadblocks::RoadblockSet roadblocks_of(std::string_view bits, const roadblocks::Course& course,
                                       const std::string& source = {}, int line = 0);

/// The reverse.
std::string bits_of(roadblocks::RoadblockSet open, const roadblocks::Course& course);

}  // namespace taut
