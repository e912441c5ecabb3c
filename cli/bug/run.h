// What taut bug and taut bug compare do with a world: let a bug travel in it, check the journey, say what came of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <taut/cli/command_line.h>
#include <taut/cli/options.h>
#include <taut/geometry/free_space.h>
#include <taut/geometry/length.h>
#include <taut/robots/bug/bug.h>

namespace taut::cli {

/// Where bugs travel.
struct BugWorld {
  std::string name;  ///< of the file, for messages
  FreeSpace space;
  Point start;
  Point goal;                      ///< of a goal room the middle of its first box that is free
  std::optional<Length> shortest;  ///< of all paths; nothing when there is none
  bool is_shut = false;            ///< walls prove that there is none
};

/// Throws InputError.
BugWorld read_bug_world(const WorldOptions& world, const QueryOptions& query);

/// Throws std::logic_error when the journey does not pass verify(), is longer than its bound, or is wrong about whether
/// there is a path.
bug::Journey checked_journey(const BugWorld& world, const bug::Options& options);

/// `bug1`, `bug2`, `tangent`
std::string name_of(bug::Algorithm algorithm);
/// Of these names, or `1`, `2`. Throws UsageError.
bug::Algorithm bug_algorithm_of(const std::string& text);
/// A number >= 0 or `inf`. Throws UsageError.
double bug_range_of(const std::string& text);
bug::Turn bug_turn_of(const std::string& text);
std::string range_text(double range);
/// The journey's length by the shortest; nothing without a path or when both are 0.
std::optional<double> ratio_of(const BugWorld& world, const bug::Journey& journey);

/// `bug tangent`, `range 2`, `length 12`, ...
std::vector<std::string> bug_facts(const BugWorld& world, const bug::Options& options, const bug::Journey& journey);
std::string bug_svg(const BugWorld& world, const bug::Options& options, const bug::Journey& journey, bool animated);
std::string bug_json(const BugWorld& world, const bug::Options& options, const bug::Journey& journey);

}  // namespace taut::cli
