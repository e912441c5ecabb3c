#include <taut/io/worlds/free_space_text.h>

#include <utility>

#include <taut/geometry/cgal.h>
#include <taut/io/worlds/write_world.h>

namespace taut {

World free_space_world(const FreeSpace& space) {
  WorldParts parts;
  parts.source = space.world().source();
  parts.boundary = Boundary::walled;
  for (const auto& polygon : cgal_polygons(space)) parts.areas.push_back({from_cgal(polygon)});
  for (const Constraint& piece : space.constraints())
    if (piece.is_wall()) parts.walls.push_back({piece.a, piece.b});
  parts.y_down = space.world().y_down();
  return World(std::move(parts));
}

std::string write_free_space(const FreeSpace& space, Format format) {
  if (!space.polygons().empty()) return write_world(free_space_world(space), format);
  return format == Format::wkt ? "POLYGON EMPTY\n" : "{\"type\": \"FeatureCollection\", \"features\": []}\n";
}

FreeSpaceSize size_of(const FreeSpace& space) {
  const auto polygons = cgal_polygons(space);
  FreeSpaceSize size{.polygons = polygons.size(), .area = CGAL::to_double(cgal_area(polygons))};
  for (const auto& polygon : polygons) {
    size.holes += polygon.number_of_holes();
    size.corners += polygon.outer_boundary().size();
    for (const auto& hole : polygon.holes()) size.corners += hole.size();
  }
  for (const Constraint& piece : space.constraints()) size.walls += piece.is_wall();
  return size;
}

}  // namespace taut
