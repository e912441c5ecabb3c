// Several pictures on one page.
#pragma once

#include <span>
#include <string>

namespace taut {

/// Pictures made by svg() side by side, row by row, `columns` in a row, in one SVG 1.1 document: each in a frame of the
/// same size, the page at most 1920 pixels wide. Pictures of one free space share their style; of several, the last
/// one's strokes hold for all. Same input, same bytes. Precondition: columns > 0.
std::string svg_sheet(std::span<const std::string> pictures, std::size_t columns);

}  // namespace taut
