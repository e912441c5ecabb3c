// The reader of cost maps with a moving target.
#pragma once

#include <string>
#include <string_view>

#include <taut/robots/pursuit/chase_map.h>

namespace taut::pursuit {

/// Reads sections `N` (x_size, y_size), `C` (threshold), `R` (start), `T` (trajectory) and `M` (costs); see ChaseMap
/// for their meaning.
///
///  1. Tokens, not lines: numbers are separated by blanks, line ends, one comma, or a comma among blanks; commas may
///     end a line. Letters of sections may be lower case. A byte order mark and CRLF are accepted. Each section comes
///     once, M last, N and C before it, in any other order.
///  2. Strict otherwise: M has exactly x_size * y_size costs, none negative; positions are whole numbers on the map;
///     the start is free; nothing follows.
///  3. Costs and C are decimal numbers, with an exponent if need be, and kept exactly: the unit becomes the smallest
///     decimal place that occurs in a free cell's cost. Where that exceeds ChaseMap's limits (about nine significant
///     digits; fewer beyond 16 000 seconds) costs are rounded to the smallest unit that fits, and ChaseMap::rounded()
///     says so. Which cell is an obstacle is decided before rounding.
/// Throws InputError with line and culprit. One pass; some hundred MB/s; needs 8 bytes a cell besides the text.
ChaseMap read_chase_map(std::string_view bytes, const std::string& source = {});

}  // namespace taut::pursuit
