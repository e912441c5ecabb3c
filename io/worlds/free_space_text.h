// A free space as a file: where the robot's reference point may be.
#pragma once

#include <cstddef>
#include <string>

#include <taut/geometry/free_space.h>
#include <taut/io/worlds/read_world.h>

namespace taut {

/// A free space as a world of its own: its polygons with holes as floor plans, by way of CGAL's
/// (cgal_polygons), and its walls of zero thickness. No start, no goal. A point finds in it what the footprint finds in
/// the world that it was made of. Precondition: there is any free space.
World free_space_world(const FreeSpace& space);

/// That world as wkt or geojson, which read_world reads back; where nothing is free `POLYGON EMPTY` or a collection
/// without features. Precondition: `format` is one of the two.
std::string write_free_space(const FreeSpace& space, Format format);

/// What there is of it.
struct FreeSpaceSize {
  std::size_t polygons = 0;
  std::size_t holes = 0;
  std::size_t corners = 0;  ///< of polygons and holes
  std::size_t walls = 0;    ///< pieces of zero thickness
  double area = 0;          ///< as CGAL adds it up, in doubles
};

FreeSpaceSize size_of(const FreeSpace& space);

}  // namespace taut
