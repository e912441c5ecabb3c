#include <taut/geometry/errors.h>
#include <taut/geometry/text.h>
#include <taut/io/worlds/detail/implied.h>
#include <taut/io/worlds/write_world.h>

namespace taut {

namespace {

void append(std::string& out, Point p) {
  taut::append(out, p.x);
  out += ' ';
  taut::append(out, p.y);
}

void append(std::string& out, const Ring& ring) {
  out += '(';
  for (Point p : ring) {
    append(out, p);
    out += ", ";
  }
  append(out, ring.front());
  out += ')';
}

void append(std::string& out, const Polygon& polygon) {
  out += "POLYGON (";
  append(out, polygon.outer);
  for (const Ring& hole : polygon.holes) {
    out += ", ";
    append(out, hole);
  }
  out += ")\n";
}

void append_point(std::string& out, Point p) {
  out += "POINT (";
  append(out, p);
  out += ")\n";
}

[[noreturn]] void fail(const char* what) {
  throw InputError("", 0, std::string("wkt cannot hold ") + what + "; use geojson");
}

void check(const World& world) {
  const bool walled = world.boundary() == Boundary::walled;
  if (walled && !world.solids().empty()) fail("solid polygons beside floor plans");
  if (!walled && !detail::area_is_implied(world)) fail("a limit that is no floor plan");
  for (const Wall& wall : world.walls())
    if (wall.thickness > 0) fail("walls with a thickness");
  if (!world.goal().room.empty()) fail("a goal room");
  if (world.goal().point && !world.start()) fail("a goal without a start");
}

}  // namespace

std::string write_wkt(const World& world) {
  check(world);
  std::string out;
  for (const Area& area : world.boundary() == Boundary::walled ? world.areas() : world.solids())
    append(out, area.polygon);
  for (const Wall& wall : world.walls()) {
    out += "LINESTRING (";
    append(out, wall.a);
    out += ", ";
    append(out, wall.b);
    out += ")\n";
  }
  if (detail::ends_are_implied(world)) return out;
  if (world.start()) append_point(out, *world.start());
  if (world.goal().point) append_point(out, *world.goal().point);
  return out;
}

}  // namespace taut
