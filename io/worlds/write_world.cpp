#include <taut/io/worlds/write_world.h>

#include <taut/geometry/errors.h>

namespace taut {

namespace {

const GridMaze& grid_of(const World& world, Format format) {
  if (world.grid()) return *world.grid();
  throw InputError("", 0, std::string(name(format)) + " can only hold grid mazes, and this world comes from no grid");
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
    case Format::movingai:
    case Format::ros_map:
    case Format::picture:
    case Format::blocks:
    case Format::svg: throw InputError("", 0, std::string(name(format)) + " can be read, not written");
  }
  return {};
}

}  // namespace taut
