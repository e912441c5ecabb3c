// Points and polygons to and from CGAL, for users who live there. Optional: this header includes CGAL.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_2.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/Segment_2.h>

#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/geometry/point.h>

namespace taut {

/// Exact in every CGAL kernel: a coordinate means the double it is.
template <class Kernel>
CGAL::Point_2<Kernel> to_cgal(Point p) {
  return {p.x, p.y};
}

template <class Kernel>
CGAL::Segment_2<Kernel> to_cgal(const Segment& s) {
  return {to_cgal<Kernel>(s.a), to_cgal<Kernel>(s.b)};
}

template <class Kernel>
CGAL::Polygon_2<Kernel> to_cgal(const Ring& ring) {
  CGAL::Polygon_2<Kernel> polygon;
  for (const Point p : ring) polygon.push_back(to_cgal<Kernel>(p));
  return polygon;
}

/// The orientation of the rings is kept as it is.
template <class Kernel>
CGAL::Polygon_with_holes_2<Kernel> to_cgal(const Polygon& polygon) {
  CGAL::Polygon_with_holes_2<Kernel> result(to_cgal<Kernel>(polygon.outer));
  for (const Ring& hole : polygon.holes) result.add_hole(to_cgal<Kernel>(hole));
  return result;
}

/// The nearest doubles, or nearly, where the kernel's numbers are finer than doubles (CGAL::to_double).
template <class Kernel>
Point from_cgal(const CGAL::Point_2<Kernel>& p) {
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
}

template <class Kernel>
Segment from_cgal(const CGAL::Segment_2<Kernel>& s) {
  return {from_cgal(s.source()), from_cgal(s.target())};
}

template <class Kernel, class Container>
Ring from_cgal(const CGAL::Polygon_2<Kernel, Container>& polygon) {
  Ring ring;
  ring.reserve(polygon.size());
  for (auto v = polygon.vertices_begin(); v != polygon.vertices_end(); ++v) ring.push_back(from_cgal(*v));
  return ring;
}

/// Precondition: it has an outer boundary.
template <class Kernel, class Container>
Polygon from_cgal(const CGAL::Polygon_with_holes_2<Kernel, Container>& polygon) {
  Polygon result{from_cgal(polygon.outer_boundary()), {}};
  for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) result.holes.push_back(from_cgal(*hole));
  return result;
}

/// The free space as CGAL's polygons with holes: FreeSpace::polygons(), in their order, outer boundaries
/// counter-clockwise, holes clockwise, every coordinate the double it is. Walls of zero thickness are in none of them
/// (FreeSpace::constraints). Their area is what the free triangles of FreeSpace::triangulation() have together,
/// but for corners that are in line as written (written.h) and left out, though their doubles are not quite.
template <class Kernel = CGAL::Exact_predicates_inexact_constructions_kernel>
std::vector<CGAL::Polygon_with_holes_2<Kernel>> cgal_polygons(const FreeSpace& space) {
  std::vector<CGAL::Polygon_with_holes_2<Kernel>> polygons;
  polygons.reserve(space.polygons().size());
  for (const Polygon& polygon : space.polygons()) polygons.push_back(to_cgal<Kernel>(polygon));
  return polygons;
}

/// Outer boundaries minus holes, in the kernel's numbers: exact where those are.
template <class Kernel>
typename Kernel::FT cgal_area(const std::vector<CGAL::Polygon_with_holes_2<Kernel>>& polygons) {
  typename Kernel::FT area = 0;
  for (const auto& polygon : polygons) {
    area += polygon.outer_boundary().area();
    for (const auto& hole : polygon.holes()) area += hole.area();  // clockwise: negative
  }
  return area;
}

}  // namespace taut
