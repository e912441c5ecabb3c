// Options that several subcommands share.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <taut/cli/command_line.h>
#include <taut/cli/stop.h>
#include <taut/geometry/footprint.h>
#include <taut/geometry/point.h>
#include <taut/io/worlds/read_world.h>

namespace taut::cli {

/// Where a world comes from and what is changed in it.
struct WorldOptions {
  std::string file;
  ReadOptions read;
};

/// Who goes where.
struct QueryOptions {
  std::optional<Point> from;
  std::optional<Point> to;
  Footprint robot;
  std::optional<double> snap_ends;  ///< how far an end may be moved to a place for the robot
};

/// On every subcommand.
struct CommonOptions {
  Limits limits;
  std::uint64_t seed = 1;
  std::string json;    ///< the envelope's file; `-` is stdout, empty is nothing
  bool stats = false;  ///< what each stage took, on stderr
  bool quiet = false;  ///< no line on stdout
  bool ranks = false;  ///< --mpi
};

// Each adds its options, in a group of their own in --help. A value that cannot be read is a UsageError
// (exit 2). The struct must outlive the parsing.
/// What FILE is written in and how it is meant.
void add_reading_options(CommandLine& app, WorldOptions& options);
/// With FILE, which is given back.
Option add_world_options(CommandLine& app, WorldOptions& options);
void add_query_options(CommandLine& app, QueryOptions& options);
void add_robot_option(CommandLine& app, Footprint& robot);  ///< that one of the query options alone
void add_result_options(CommandLine& app, CommonOptions& options);
void add_common_options(CommandLine& app, CommonOptions& options);

/// `--svg FILE`. A name in .png gets pixels.
Option add_svg_option(CommandLine& app, std::string& file, const std::string& description = "Write a picture");
/// Throws UsageError when more than one of these files, with the options they were given by, is standard output.
void require_one_stdout(const std::vector<std::pair<const char*, std::string>>& files);

/// `--animate [FILE]`: a picture that moves, into FILE or, where none is named, in the place of --svg's.
void add_animate_option(CommandLine& app, std::string& animation, const std::string& description);
/// To be called when all is parsed: gives a nameless --animate the file of --svg, which then is not written otherwise.
/// Throws UsageError when there is none, or when more than one of the three files is standard output.
void settle_animation(const CommandLine& app, std::string& animation, std::string& svg, const std::string& json);

// Values of options. Throw UsageError.
/// That it is none of the choices, which it names, and which of them may have been meant. To be thrown.
UsageError not_one_of(const std::string& text, const std::vector<Choice>& choices);
Point point_of(const std::string& text);  ///< `1.5,-2`
double number_of(
    const std::string& text,
    const char* option = nullptr);  ///< finite, of magnitude <= World::kLargest; `option` is named in the error
double positive_of(const std::string& text, const char* option);  ///< as number_of, and above 0
std::size_t count_of(const std::string& text);                    ///< a whole number of 0 or more
Footprint footprint_of(const std::string& text);                  ///< `point`, `disc:R`, `square:R`
Format format_of(const std::string& text);                        ///< a name of format_named
std::size_t memory_of(const std::string& text);                   ///< `500M`, `2G`; a bare number counts megabytes

}  // namespace taut::cli
