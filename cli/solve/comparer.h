// The work of `taut compare`: planners on one world.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <taut/cli/input.h>
#include <taut/cli/options.h>
#include <taut/cli/report_files.h>
#include <taut/cli/run.h>
#include <taut/cli/shards.h>
#include <taut/search/planners.h>

namespace taut::cli {

struct CompareOptions {
  WorldOptions world;
  std::vector<std::string> more;  ///< worlds beside world.file
  QueryOptions query;
  CommonOptions common;
  std::vector<const Planner*> chosen;
  std::size_t runs = 1;
  PrmRequest prm;
  std::string svg;
  ReportOptions report;
  ShardOptions shards;
};

/// Told after each planner what there is so far.
using NoteComparison = std::function<void(const Comparison&)>;

/// All runs of all planners that are wished for, and the optimum. Throws InputError when one that was asked for by name
/// cannot run there.
Comparison compare_planners(const CompareOptions& options, Run& run, const Input& input, const FreeSpace& space,
                            const NoteComparison& note);

/// The part of that which is this shard's; an item is one run of one planner. Gives the exit code.
int compare_shard(const CompareOptions& options, Run& run, const Input& input, const FreeSpace& space);

}  // namespace taut::cli
