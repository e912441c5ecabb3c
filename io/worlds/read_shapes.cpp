#include <taut/io/worlds/detail/read_shapes.h>

#include <optional>
#include <utility>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/geometry/mend_rings.h>
#include <taut/geometry/nested_areas.h>
#include <taut/geometry/snap.h>
#include <taut/io/worlds/detail/text_input.h>

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

void thicken(WorldParts& parts, const ReadOptions& options) {
  if (!options.wall_thickness) return;
  for (Wall& wall : parts.walls) wall.thickness = *options.wall_thickness;
}

std::vector<Point> given_ends(const ReadOptions& options) {
  std::vector<Point> ends;
  for (const std::optional<Point>& end : {options.start, options.goal})
    if (end) ends.push_back(*end);
  return ends;
}

// Nothing where that gives the rings no meaning either.
std::optional<SnappedParts> joined_and_mended(WorldParts parts, const ReadOptions& options, ReadNotes& seen) try {
  SnappedParts result = snapped(std::move(parts), options.snap, given_ends(options));
  if (result.report.joined == 0) return std::nullopt;
  if (options.snap.what == Snap::What::within && !result.report.remaining.empty()) return std::nullopt;
  for (std::string& remark : mend_rings(result.parts, options.crossings)) seen.remarks.push_back(std::move(remark));
  return result;
} catch (const InputError&) {
  return std::nullopt;
}

// What was joined to do it, if anything had to be.
std::optional<SnapReport> mend(WorldParts& parts, const ReadOptions& options, ReadNotes& seen) {
  WorldParts written = parts;
  try {
    for (std::string& remark : mend_rings(parts, options.crossings)) seen.remarks.push_back(std::move(remark));
    return std::nullopt;
  } catch (const AmbiguousRing&) {
    std::optional<SnappedParts> joined = joined_and_mended(std::move(written), options, seen);
    if (!joined) throw;
    parts = std::move(joined->parts);
    return std::move(joined->report);
  }
}

// As the options say, unless all that is near was joined already.
World joined(WorldParts parts, const ReadOptions& options, ReadNotes* notes, std::optional<SnapReport> done) {
  const std::vector<Point> ends = given_ends(options);
  Snapped snapped =
      done ? Snapped{World(std::move(parts)), std::move(*done)} : snapped_world(parts, options.snap, ends);
  if (!ends.empty()) snapped.world = snapped.world.with_ends(options.start, options.goal);
  if (!notes) return std::move(snapped.world);
  notes->near = near_contacts(snapped.world);
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
  return joined(std::move(parts), options, notes, std::move(done));
} catch (const AmbiguousRing& ring) {
  throw InputError({}, 0, ring.what() + (" (--repair: " + ring.even_odd() + ")"));
}

}  // namespace taut::detail
