// What was found about clearance: as lines, as JSON, as a picture.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

#include <taut/cli/solve/barrier.h>
#include <taut/cli/solve/clearance.h>
#include <taut/io/results/result_json.h>

namespace taut::cli {

struct ClearanceAnswer {
  std::string source;
  ClearanceQuery query;
  SearchStatus status = SearchStatus::none;
  std::string reason{};  ///< when stopped, and in words when none
  std::string stage{};   ///< when stopped
  std::optional<Point> start{};
  std::optional<Point> goal{};           ///< the point that was gone to
  std::vector<ClearanceTrade> found{};   ///< one, of a tradeoff several
  std::optional<WidestPassage> limit{};  ///< of --widest, by the gates
  Barrier barrier{};                     ///< why there is none, or of --widest: why no larger disc gets through
  std::optional<std::string> width{};    ///< of the widest's gate, exact where short
  bool verified = false;
  std::vector<std::size_t> places{};  ///< vertices and edges of the diagram
  double max_error = 0;
  StageSeconds seconds{};
};

/// {walls, gates} as below.
nlohmann::ordered_json barrier_json(const Barrier& barrier);

/// For standard output: a line; of a tradeoff a table.
std::string clearance_text(const ClearanceAnswer& answer, const FreeSpace& space);

/// One JSON object; keys are stable:
///  program, version, source
///  query      "clearance", "widest" or "tradeoff"; with "clearance" also `asked`
///  status     "found", "none" (proven) or "stopped"
/// when found, of the path, and in `tradeoff` an array of objects of each:
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
///  reason     in words
/// always: start, goal, vertices, edges, max_error, seconds
std::string clearance_json(const ClearanceAnswer& answer, const FreeSpace& space);

/// The maze with the path; a tradeoff beside its step chart. `map` is drawn below it when there is one path.
std::string clearance_svg(const ClearanceAnswer& answer, const FreeSpace& space, const VoronoiRoadmap& map);

/// Length and radius for people.
std::string plain_length(double length);

}  // namespace taut::cli
