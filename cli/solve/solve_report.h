// What `taut solve` says about its answer: a line, a picture, the stages.
#pragma once

#include <string>
#include <vector>

#include <taut/cli/input.h>
#include <taut/cli/solve/roadmap_kinds.h>
#include <taut/cli/solve/solve_options.h>
#include <taut/geometry/free_space.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/results/result_json.h>

namespace taut::cli {

/// An answer, and the roadmap it was found in.
struct SolveAnswer {
  PlanResult result;
  const RoadmapKind* kind = roadmap_kind("visibility");
  PlannedRoadmap planned;
  std::vector<Segment> narrow;  ///< when there is none for a disc: across the gates that are too narrow
};

/// `length 77.262691, 34 corners, 0.004 s`, or the walls that separate, or why it was stopped. For standard output.
std::string solve_line(const SolveAnswer& answer);

/// The path in the roadmap, or the walls that separate. It points into the answer. Roadmaps of more than 20 000 edges
/// are left out.
SvgPicture solve_picture(const SolveAnswer& answer);

/// --stats: a line on stderr for each stage, with its seconds and what came of it.
void note_stages(const SolveAnswer& answer, const SolveOptions& options, const FreeSpace& space, const Input& input);

}  // namespace taut::cli
