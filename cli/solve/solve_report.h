// What `taut solve` says about its answer: a line, a picture, the stages.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <taut/cli/input.h>
#include <taut/cli/run.h>
#include <taut/cli/solve/solve_options.h>
#include <taut/geometry/free_space.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/results/envelope.h>
#include <taut/io/results/result_json.h>

namespace taut::cli {

/// An answer, and the roadmap it was found in.
struct SolveAnswer {
  std::string source;
  PlanResult result;
  Outcome outcome = Outcome::found;
  std::string reason;  ///< why it is not found
  std::vector<EndMove> moves;
  const RoadmapKind* kind = roadmap_kind("visibility");
  PlannedRoadmap planned;
  std::vector<Segment> narrow;  ///< when there is none for a disc: across the gates that are too narrow
};

/// `these 2 walls separate start and goal: ...`
std::string walls_text(const std::vector<Segment>& separation);

/// Why it is not known whether there is a path: none was found, which proves nothing.
std::string unproven_text(const SolveAnswer& answer, const Footprint& robot);

/// `maze.txt: length 77.262691, 34 corners, 0.004 s CPU`, or why there is none. With a line end.
std::string solve_line(const SolveAnswer& answer, const Seconds& total);

/// The path in the roadmap, or the walls that separate. It points into the answer. Roadmaps of more than 20 000 edges
/// are left out.
SvgPicture solve_picture(const SolveAnswer& answer);

/// --stats: what came of each stage.
std::vector<std::pair<std::string, std::string>> solve_stats(const SolveAnswer& answer, const SolveOptions& options,
                                                             const FreeSpace& space, const Input& input);

}  // namespace taut::cli
