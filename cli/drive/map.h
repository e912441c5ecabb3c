// taut drive on a roadblock map.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <taut/cli/drive/world.h>
#include <taut/cli/report_files.h>
#include <taut/robots/roadblocks/drivers.h>
#include <taut/robots/roadblocks/peers.h>

namespace taut::cli {

/// What stands on the command line, for maps and for worlds.
struct DriveOptions {
  std::string file;
  std::optional<int> sample;
  bool all = false;
  std::string bits;
  roadblocks::DriverKind planner = roadblocks::DriverKind::policy;
  const roadblocks::Peer* peer = nullptr;  ///< instead
  roadblocks::Aim aim = roadblocks::Aim::expected;
  roadblocks::WallReading walls = roadblocks::WallReading::points;
  DriveOutput output;
  ReportOptions report;  ///< its page, of --all
  bool show_values = false;
  bool controls = false;
  WorldDriveOptions world;
  CommonOptions common;
};

std::string planner_name(const DriveOptions& options);

/// Drives the samples that are chosen and ends the run. Gives the exit code. Throws InputError.
int drive_on_map(const DriveOptions& options, std::string_view bytes, const std::string& source, Run& run);

}  // namespace taut::cli
