// --snap-ends: ends that are no places for the robot move to the nearest ones.
#pragma once

#include <optional>

#include <taut/cli/command_line.h>
#include <taut/cli/input.h>
#include <taut/cli/run.h>

namespace taut::cli {

/// `--snap-ends D`, for subcommands without the other query options.
void add_snap_ends_option(CommandLine& app, std::optional<double>& snap_ends);

/// What a place is to --snap-ends.
struct EndPlaces {
  double radius = 0;              ///< above 0: of a disc, by its true distance; else of the query's robot
  bool limits_are_walls = false;  ///< with a radius: see walled_world.h
};

/// Reads as read_input does, in a stage `read`, and with --snap-ends moves start and goal point, in a stage `ends`: it
/// says so on stderr and in the result (`moved_ends`). What has no place near enough stays, to be refused.
Input read_input(const WorldOptions& options, const QueryOptions& query, Run& run, const EndPlaces& places = {});

}  // namespace taut::cli
