// taut audit: what all kinds of plans have in common.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <taut/cli/input.h>
#include <taut/cli/options.h>
#include <taut/cli/run.h>
#include <taut/geometry/nearest_free.h>
#include <taut/robots/car/leg.h>

namespace taut::cli {

struct AuditOptions {
  WorldOptions world;
  CommonOptions common;
  std::string plans;
  Footprint robot;
  std::optional<car::CarShape> car;
  bool ends = false;
  bool no_gap = false;
  bool prove = false;
  bool vanish = false;
  std::string svg;
};

/// Beyond so many, lines for people name only those that are not valid, and lists in JSON end.
inline constexpr std::size_t kPlansNamed = 20;
inline constexpr std::size_t kCollisionsListed = 1000;

/// Paths of a point, a disc or a square; a car's drive; robots with times. Each reads `bytes` from `name`, judges, ends
/// the run and gives the exit code.
int audit_paths(const AuditOptions& options, const Input& input, std::string_view bytes, const std::string& name,
                Run& run);
int audit_drive(const AuditOptions& options, const Input& input, std::string_view bytes, const std::string& name,
                Run& run);
int audit_fleet(const AuditOptions& options, const Input& input, std::string_view bytes, const std::string& name,
                Run& run);

/// {"from": [x, y], "to": [x, y], "line": n or null, "kind": "wall" | "obstacle" | "outline"}
Json wall_json(const NearObstacle& wall);

}  // namespace taut::cli
