// Worlds as files that read_world reads back.
#pragma once

#include <string>

#include <taut/geometry/grid_maze.h>
#include <taut/geometry/point.h>
#include <taut/geometry/world.h>
#include <taut/io/worlds/read_world.h>

namespace taut {

// Every function returns the whole file. Numbers are the shortest decimals that read back as the same double, lines end
// in \n. What a format cannot hold is an InputError, never left out; what is read back equals what was written, but for
// the file's name and line numbers and, in segments, wkt and geojson, the grid.

/// How a segments file is written.
struct SegmentsStyle {
  std::string comment{};  ///< lines that go in front, each behind `# `
  Point shift{};          ///< added to every coordinate: {0.5, 0.5} puts the cells of a grid at whole numbers
};

/// Walls, start, goal, boundary. A boundary or ends that World would imply anyway are left out, so that a maze from
/// opening to opening is nothing but walls. Cannot hold solids, floor plans (Boundary::walled), several areas or holes.
std::string write_segments(const World& world, const SegmentsStyle& style = {});

/// Goal cells are read back in order. Cannot hold a maze without goal, unless its border has exactly two openings and
/// it starts at the bottom left.
std::string write_drawing(const GridMaze& maze);

/// Square mazes of 2 to 256 a side with a closed border, start (0,0), goal the room in the middle.
std::string write_cell_values(const GridMaze& maze);

/// 16 x 16 and 32 x 32; start (0,0); goal the room in the middle, or none and exactly two openings.
std::string write_maz(const GridMaze& maze);

/// Any size; start and goal as for maz.
std::string write_num(const GridMaze& maze);

/// Cannot hold solids beside floor plans, thickness, a room, a goal without start, and a limit other than the one its
/// walls imply. Solids alone are read back with ReadOptions::Polygons::obstacles.
std::string write_wkt(const World& world);

/// Everything; one feature an area, solid, run of walls of one thickness, start and goal.
std::string write_geojson(const World& world);

/// Worlds that are nothing but unit cells from (0, 0) on, free or blocked, with a walled border; row 0 is at y = 0,
/// as in what is read. No ends.
std::string write_movingai(const World& world);

/// The same with `#` and `.`, the last row at y = 0; start and goal in the middles of free cells.
std::string write_blocks(const World& world);

/// For judges of certificates (docs/certificates.md): walls, areas and solids as integers over one unit, with the
/// boundary's kind; start and goal as they are. Walls of one line that touch are written as one. What is not plain
/// (plain_world.h) is written as the polygons of its free space. Cannot hold worlds whose numbers lie on no lattice
/// (number_lattice.h). Nothing reads it back.
std::string write_integers(const World& world);
/// Of a world of any number of areas that do not overlap, walls without thickness.
std::string write_plain_integers(const World& world);

/// Any of these. For cell_values, drawing, maz and num the world must come from a grid whose walls are thin, or have
/// walls along the sides of unit cells from (0, 0) on.
std::string write_world(const World& world, Format format);

}  // namespace taut
