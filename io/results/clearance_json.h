// What was found about clearance, as JSON.
#pragma once

#include <taut/io/results/json.h>
#include <taut/search/clearance_planner.h>
#include <taut/search/passage.h>

namespace taut {

/// One JSON object; keys are stable:
///  query      "clearance", "widest" or "tradeoff"; with "clearance" also `asked`
/// when found, of the path, and in `tradeoff` an array of objects of each (when stopped: of those found by then):
///  radius     the largest disc the path serves: its least clearance, to the nearest double
///  length     along the diagram; `shortest_in` is "diagram": not in the plane
///  pinch      {at: "gate" | "start" | "goal", clearance, posts: [[x, y], [x, y]], walls: [[[x, y], [x, y]], ...]}
///  curves     [[[x, y], [x, y], [x, y]], ...] quadratic Bezier curves, chained
///  verified   true when the path was checked against the walls and its width against the gates
/// with "widest" also:
///  width      the exact width of the narrowest place as text, a fraction where short; null when an end is as narrow
///  radius_below  the largest double that is no larger than the exact radius
/// when none, and with "widest" for what keeps larger discs out:
///  barrier    {walls: [[[x, y], [x, y]], ...], gates: [{posts, width, width_text}, ...]}, a closed chain around an end
/// always: start, goal, robot, roadmap "voronoi", vertices, edges, max_error; where crossings of walls were rounded
/// `within`: radii and clearances are right within so much, and "none" means no disc larger by that
/// `walled` is the space that the diagram was made of.
Json clearance_json(const ClearanceAnswer& answer, const FreeSpace& walled);

/// One way of the above: what `tradeoff` holds.
Json clearance_way_json(const ClearanceTrade& way, const FreeSpace& walled);

/// One JSON object; keys are stable: start, goal; `radius` where one was asked about; largest null or {radius (null
/// when unbounded), limit "gate" | "start" | "goal" | "none", reason in words}; barrier {walls, gates}: against that
/// radius, or against any larger disc; gates: how many the world has; where crossings of walls
/// had to be rounded `within`: radii are right within so much, and what a barrier keeps out are discs larger by that.
Json passage_json(const Passage& passage, const Gates& gates);

}  // namespace taut
