// One reader a format. Each throws InputError; the formats themselves are specified in read_world.h.
#pragma once

#include <string>
#include <string_view>

#include <taut/geometry/grid_maze.h>
#include <taut/geometry/world.h>
#include <taut/io/worlds/read_world.h>

namespace taut::detail {

WorldParts read_segments(std::string_view bytes, const std::string& source);
/// `x1,y1,x2,y2`, with `thickness` behind or not: how tables name the columns of segments.
bool is_header_of_segments(std::string_view line);
WorldParts read_wkt(std::string_view bytes, const ReadOptions& options, ReadNotes& notes);
WorldParts read_geojson(std::string_view bytes, const ReadOptions& options, ReadNotes& notes);

WorldParts read_svg(std::string_view bytes, const ReadOptions& options, ReadNotes& notes);

WorldParts read_blocks(std::string_view bytes, const std::string& source);
/// A drawing in blocks, or a matrix of 0 and 1?
bool looks_like_blocks(std::string_view bytes);

GridMaze read_cell_values(std::string_view bytes, const std::string& source);
GridMaze read_drawing(std::string_view bytes, const std::string& source, std::size_t& unknown_walls);
GridMaze read_maz(std::string_view bytes, const std::string& source);
GridMaze read_num(std::string_view bytes, const std::string& source);

/// Can this be the first line of a drawing?
bool is_row_of_posts(std::string_view line);

/// The files maz reads have one of these sizes.
inline bool is_maz_size(std::size_t bytes) { return bytes == 256 || bytes == 1024; }

}  // namespace taut::detail
