// taut drive --car: a general car in a world of walls and polygons.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <taut/cli/command_line.h>
#include <taut/cli/options.h>
#include <taut/cli/path_files.h>
#include <taut/cli/run.h>
#include <taut/robots/car/car_planner.h>

namespace taut::cli {

/// A place, and a heading in degrees where one is given.
struct DriveEnd {
  Point at;
  std::optional<double> degrees;
};

struct WorldDriveOptions {
  WorldOptions world;
  std::optional<car::CarShape> car;  ///< --car: without it FILE is a roadblock map
  std::optional<DriveEnd> from;
  std::optional<DriveEnd> to;
  double weight = 1.05;
};

/// A value of --car. Throws UsageError.
car::CarShape car_shape_of(const std::string& text);

/// FILE, --car, --from, --to, --weight and those of a world.
void add_world_drive_options(CommandLine& app, WorldDriveOptions& options);

/// The pictures of `taut drive`, whatever it drives in.
struct DriveOutput {
  std::string svg, animation;
  PathFiles files;  ///< of a drive with --car

  bool draws() const { return !svg.empty() || !animation.empty(); }
};

/// Throws InputError, with what helps, when these bytes are no roadblock map but a world that a general car could drive
/// in. What is neither is left to the reader. A roadblock map has a line that begins with the word `grid` or
/// `roadblock`.
void require_roadblock_map(std::string_view bytes, const std::string& name);

/// Plans, checks independently, ends the run. Gives the exit code.
int drive_in_world(const WorldDriveOptions& options, const DriveOutput& output, std::string_view bytes,
                   const std::string& name, Run& run);

}  // namespace taut::cli
