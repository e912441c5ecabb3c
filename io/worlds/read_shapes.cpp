#include <taut/io/worlds/detail/read_shapes.h>

#include <memory>
#include <optional>
#include <utility>

#include <taut/geometry/mend_rings.h>
#include <taut/geometry/nested_areas.h>
#include <taut/io/worlds/detail/text_input.h>
#include <taut/io/worlds/geographic_world.h>

namespace taut::detail {

namespace {

void say_nested(const std::vector<Area>& areas, ReadNotes& notes) {
  const std::vector<NestedArea> nested = nested_areas(areas);
  if (nested.empty()) return;
  const auto line = [&](std::size_t i) { return "line " + std::to_string(areas[i].line); };
  notes.remarks.push_back(line(nested[0].inner) + ": polygon lies wholly in that of " + line(nested[0].outer) +
                          ", which is free already, and changes nothing (--polygons nested makes it a hole)" +
                          more_like_it(nested.size() - 1));
}

// Where people know it: in longitude and latitude.
void show(std::vector<NearContact>& contacts, const ReadNotes& notes) {
  if (!notes.geographic) return;
  for (NearContact& contact : contacts) {
    contact.end = notes.geographic->lon_lat(contact.end);
    contact.wall = notes.geographic->lon_lat(contact.wall);
  }
}

std::vector<Point> ends_of(const ReadOptions& options) {
  std::vector<Point> ends;
  for (const std::optional<Point>& end : {options.start, options.goal})
    if (end) ends.push_back(*end);
  return ends;
}

void thicken(WorldParts& parts, const ReadOptions& options) {
  if (!options.wall_thickness) return;
  for (Wall& wall : parts.walls) wall.thickness = *options.wall_thickness;
}

// As written: in degrees where --project is given, and there only what lies within rounding.
Snap snap_as_written(const ReadOptions& options) {
  if (!options.project) return options.snap;
  return {options.snap.what == Snap::What::nothing ? Snap::What::nothing : Snap::What::rounding, 0};
}

// Nothing where that gives the rings no meaning either.
std::optional<SnappedParts> joined_and_mended(WorldParts parts, const ReadOptions& options, ReadNotes& seen) try {
  const Snap snap = snap_as_written(options);
  SnappedParts result = snapped(std::move(parts), snap, ends_of(options));
  if (result.report.joined == 0) return std::nullopt;
  if (snap.what == Snap::What::within && !result.report.remaining.empty()) return std::nullopt;
  for (std::string& remark : mend_rings(result.parts, options.crossings)) seen.remarks.push_back(std::move(remark));
  return result;
} catch (const InputError&) {
  return std::nullopt;
}

// What was joined to do it, if anything had to be.
std::optional<SnapReport> mend(WorldParts& parts, const ReadOptions& options, ReadNotes& seen) {
  std::vector<Area> areas = parts.areas, solids = parts.solids;
  try {
    for (std::string& remark : mend_rings(parts, options.crossings)) seen.remarks.push_back(std::move(remark));
    return std::nullopt;
  } catch (const AmbiguousRing&) {
    parts.areas = std::move(areas);
    parts.solids = std::move(solids);
    std::optional<SnappedParts> joined = joined_and_mended(parts, options, seen);
    if (!joined) throw;
    parts = std::move(joined->parts);
    return std::move(joined->report);
  }
}

bool names_degrees(const std::string& crs) {
  return crs.find("CRS84") != std::string::npos || crs.find("4326") != std::string::npos;
}

void say_degrees(const WorldParts& parts, ReadNotes& notes) {
  if (notes.format != Format::geojson) return;
  if (notes.crs ? !names_degrees(*notes.crs) : !looks_like_degrees(parts)) return;
  notes.remarks.emplace_back("longitude and latitude: lengths are in degrees (--project plans in metres)");
}

// What lies within rounding is joined in degrees, where it was computed; --snap T joins in metres.
World in_metres(WorldParts parts, const ReadOptions& options, ReadNotes& seen, ReadNotes* notes) {
  if (seen.crs && !names_degrees(*seen.crs))
    throw InputError(options.source, 0,
                     "says that its coordinates are " + *seen.crs + ", not longitude and latitude as --project needs");
  require_lon_lat(parts);
  const std::vector<Point> ends = ends_of(options);
  Snapped snapped = snapped_world(std::move(parts), snap_as_written(options), ends);
  if (const std::string remark = text(snapped.report); !remark.empty()) seen.remarks.push_back(remark + " degrees");
  const auto geographic = std::make_shared<const GeographicWorld>(snapped.world.parts());
  ReadOptions plane = options;
  if (options.start)
    plane.start = (geographic->require_end(*options.start, "start"), geographic->metres(*options.start));
  if (options.goal) plane.goal = (geographic->require_end(*options.goal, "goal"), geographic->metres(*options.goal));
  seen.geographic = geographic;
  seen.remarks.push_back(geographic->text());
  return joined(geographic->in_metres(ends), plane, notes);
}

// As the options say, unless all that is near was joined already.
World joined(WorldParts parts, const ReadOptions& options, ReadNotes* notes, std::optional<SnapReport> done) {
  const std::vector<Point> ends = ends_of(options);
  Snapped snapped =
      done ? Snapped{World(std::move(parts)), std::move(*done)} : snapped_world(std::move(parts), options.snap, ends);
  if (!ends.empty()) snapped.world = snapped.world.with_ends(options.start, options.goal);
  if (!notes) return std::move(snapped.world);
  notes->near = near_contacts(snapped.world);
  show(notes->near, *notes);
  show(snapped.report.remaining, *notes);
  for (const std::string& remark : {text(snapped.report), text(notes->near)})
    if (!remark.empty()) notes->remarks.push_back(remark);
  notes->snap = std::move(snapped.report);
  return std::move(snapped.world);
}

}  // namespace

World joined(WorldParts parts, const ReadOptions& options, ReadNotes* notes) {
  thicken(parts, options);
  return joined(std::move(parts), options, notes, std::nullopt);
}

World read_shapes(WorldParts parts, const ReadOptions& options, ReadNotes& seen, ReadNotes* notes) try {
  thicken(parts, options);
  std::optional<SnapReport> done = mend(parts, options, seen);
  say_nested(parts.areas, seen);
  if (options.project) return in_metres(std::move(parts), options, seen, notes);
  say_degrees(parts, seen);
  return joined(std::move(parts), options, notes, std::move(done));
} catch (const AmbiguousRing& ring) {
  throw InputError({}, 0, ring.what() + (" (--repair: " + ring.even_odd() + ")"));
}

}  // namespace taut::detail
