// --certificate: a proof of the answer that anybody can check.
#pragma once

#include <string>

#include <taut/cli/run.h>
#include <taut/cli/solve/solve_options.h>
#include <taut/geometry/free_space.h>
#include <taut/io/results/arc_proof.h>
#include <taut/io/results/result_json.h>
#include <taut/search/clearance_planner.h>

namespace taut::cli {

void add_certificate_option(CommandLine& app, std::string& file);

/// Throws UsageError where nothing could be proven of what is asked for.
void require_certifiable(const SolveOptions& options);

/// The certificate, judged already unless that was not wanted.
struct Certified {
  std::string text;   ///< the file; empty where there is none
  std::string words;  ///< what it proves, or why there is none
  double bound = 0;   ///< of a shortest path, judged: no path is shorter
};

/// Of the widest disc between the ends of `answer`, of Kind::widest and found; `gates` are the planner's.
Certified certified(const ClearanceAnswer& answer, const Gates& gates, bool is_judged, Run& run);

/// That no disc of that radius gets from start to goal, the world's limits being walls.
Certified certified_narrow(const World& world, Point start, Point goal, double radius, bool is_judged, Run& run);

/// Of the arcs found in `world`: what no path of the disc is shorter than, and a path of legs beside them that keeps
/// its radius.
Certified certified(const ArcPath& path, const World& world, bool is_judged, Run& run);

/// Does it prove what it says? By verify/judge.h; throws InputError, which names `source`, where it cannot be read.
ArcJudgement judged_arcs(const ArcClaim& claim, const ArcTexts& texts, const std::string& source = {});

/// Of what was found in a space of a point, or that nothing was. Throws InputError where the world's numbers or its
/// goal do not allow one.
Certified certified(const FreeSpace& space, const PlanResult& result, bool is_judged, Run& run);

}  // namespace taut::cli
