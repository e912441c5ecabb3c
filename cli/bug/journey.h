// What taut bug and taut bug compare do with a world: let a bug travel in it, check the journey, say what came of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <taut/cli/options.h>
#include <taut/cli/run.h>
#include <taut/geometry/free_space.h>
#include <taut/geometry/length.h>
#include <taut/io/results/end_moves.h>
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
  std::vector<EndMove> moves{};    ///< --snap-ends
};

/// Throws InputError.
BugWorld read_bug_world(const WorldOptions& world, const QueryOptions& query, Run& run);

/// Throws std::logic_error when the journey does not pass verify(), is longer than its bound, or is wrong about whether
/// there is a path.
bug::Journey checked_journey(const BugWorld& world, const bug::Options& options, Run& run);

/// found, none where walls prove it, else unproven.
Outcome outcome_of(const BugWorld& world);
std::string reason_of(const BugWorld& world);

/// A number >= 0 or `inf`. Throws UsageError.
double bug_range_of(const std::string& text);
std::string range_text(double range);
/// --turn.
void add_turn_option(CommandLine& app, bug::Options& options);
/// A line for each algorithm, for --help.
void explain_bugs(CommandLine& app);

/// `tangent bug`, `range 2`, `length 12`, ...; `all`: what pictures say by labels, too.
std::vector<std::string> bug_facts(const BugWorld& world, const bug::Options& options, const bug::Journey& journey,
                                   bool all);

}  // namespace taut::cli
