// A path that keeps a clearance but near its ends, as JSON.
#pragma once

#include <optional>

#include <taut/io/results/json.h>
#include <taut/search/barrier.h>
#include <taut/search/kept_path.h>

namespace taut {

/// What there is to say of it.
struct KeptAnswer {
  Point start, goal;
  KeptPath path{};
  bool verified = false;
  std::optional<double> within{};  ///< rounding_bound, where crossings were rounded
  Barrier barrier{};               ///< why there is none
};

/// One JSON object. Keys, in this order: query "keep", asked (the clearance); when found: length, length_interval
/// [lo, hi], optimal (true: no path by these rules is shorter, docs/definitions.md) or in its place within, as in
/// result_json.h, corners (how many bends), verified, parts [{radius, length, leaves "start" | "goal" | null, bends,
/// arcs, points}, ...] (bends, arcs and points as in arc_json.h, of a disc of that radius; `leaves` null: keeps the
/// clearance), points (of all parts), place_rounding (no place of the disc is nearer to an end by more); when none:
/// barrier {walls, gates}; always: start, goal, robot.
Json kept_json(const KeptAnswer& answer);

/// Adds the bends, arcs and points of a path, as in arc_json.h.
void add_arc_path(Json& json, const ArcPath& path);

}  // namespace taut
