#include <taut/io/worlds/write_world.h>

#include <taut/geometry/errors.h>
#include <taut/io/worlds/detail/cells_of_world.h>

namespace taut {

namespace {

GridMaze grid_of(const World& world, Format format) {
  return world.grid() ? *world.grid() : detail::maze_of(world, name(format));
}

}  // namespace

std::string write_world(const World& world, Format format) {
  switch (format) {
    case Format::segments: return write_segments(world);
    case Format::cell_values: return write_cell_values(grid_of(world, format));
    case Format::drawing: return write_drawing(grid_of(world, format));
    case Format::maz: return write_maz(grid_of(world, format));
    case Format::num: return write_num(grid_of(world, format));
    case Format::wkt: return write_wkt(world);
    case Format::geojson: return write_geojson(world);
    case Format::movingai: return write_movingai(world);
    case Format::blocks: return write_blocks(world);
    case Format::integers: return write_integers(world);
    case Format::ros_map:
    case Format::picture:
    case Format::svg:
      throw InputError("", 0,
                       std::string(name(format)) +
                           " can be read, not written: of cells, movingai and blocks are; geojson holds every world");
  }
  return {};
}

}  // namespace taut
