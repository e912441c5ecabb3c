// Options that several subcommands share.
#pragma once

#include <CLI/App.hpp>

#include <cstdint>
#include <optional>
#include <string>

#include <taut/cli/stop.h>
#include <taut/geometry/footprint.h>
#include <taut/geometry/point.h>
#include <taut/io/worlds/read_world.h>

namespace taut::cli {

/// Where a world comes from and what is changed in it.
struct WorldOptions {
  std::string file;
  ReadOptions read;
  std::optional<double> wall_thickness;
};

/// Who goes where.
struct QueryOptions {
  std::optional<Point> from;
  std::optional<Point> to;
  Footprint robot;
};

/// What is written besides the line on stdout; `-` is stdout, empty is nothing.
struct OutputOptions {
  std::string svg;
  std::string json;
  bool stats = false;
  bool quiet = false;

  /// Something else goes to stdout, so the line must not.
  bool stdout_taken() const { return svg == "-" || json == "-"; }
};

/// On every subcommand.
struct CommonOptions {
  Limits limits;
  std::uint64_t seed = 1;
};

// Each adds its options, in a group of their own in --help. A value that cannot be read is a CLI::ValidationError
// (exit 2). The struct must outlive the parsing.
void add_world_options(CLI::App& app, WorldOptions& options);
void add_query_options(CLI::App& app, QueryOptions& options);
void add_output_options(CLI::App& app, OutputOptions& options);
void add_common_options(CLI::App& app, CommonOptions& options);

/// `--animate [FILE]`: a picture that moves, into FILE or, where none is named, in the place of --svg's.
void add_animate_option(CLI::App& app, std::string& animation, const std::string& description);
/// To be called when all is parsed: gives a nameless --animate the file of --svg, which then is not written otherwise.
/// Throws CLI::ValidationError when there is none, or when more than one of the three files is standard output.
void settle_animation(const CLI::App& app, std::string& animation, std::string& svg, const std::string& json);

// Values of options. Throw CLI::ValidationError.
Point point_of(const std::string& text);  ///< `1.5,-2`
double number_of(
    const std::string& text,
    const char* option = nullptr);  ///< finite, of magnitude <= World::kLargest; `option` is named in the error
Footprint footprint_of(const std::string& text);  ///< `point`, `disc:R`, `square:R`
Format format_of(const std::string& text);        ///< a name of format_named
std::size_t memory_of(const std::string& text);   ///< `500M`, `2G`; a bare number counts megabytes

}  // namespace taut::cli
