#include <taut/cli/command_line.h>
#include <taut/cli/options.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include <taut/cli/spelling.h>
#include <taut/cli/world/snap_ends.h>
#include <taut/geometry/errors.h>
#include <taut/geometry/world.h>

namespace taut::cli {

namespace {

[[noreturn]] void refuse(const std::string& text, const char* wanted, const char* option = nullptr) {
  throw UsageError((option ? std::string(option) + ": '" : "'") + text + "' is not " + wanted);
}

std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !(std::abs(value) <= World::kLargest))
    return std::nullopt;
  return value;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

// The option's value goes through `parse`.
template <typename Value, typename Parse>
Option add(CommandLine& app, const std::string& name, Value& value, Parse parse, const std::string& description) {
  return app.add_option_function(
      name, [&value, parse](const std::string& text) { value = parse(text); }, description);
}

ReadOptions::Polygons polygons_of(const std::string& text) {
  if (text == "free") return ReadOptions::Polygons::free;
  if (text == "obstacles") return ReadOptions::Polygons::obstacles;
  if (text == "nested") return ReadOptions::Polygons::nested;
  refuse(text, "free, obstacles or nested");
}

double thickness_of(const std::string& text) {
  const double value = number_of(text);
  if (value < 0) refuse(text, "a thickness of 0 or more");
  return value;
}

Snap snap_of(const std::string& text) {
  if (text == "auto") return {Snap::What::automatic, 0};
  const std::optional<double> value = number_in(text);
  if (!value || *value < 0) refuse(text, "a distance of 0 or more, or auto");
  return {*value > 0 ? Snap::What::within : Snap::What::nothing, *value};
}

template <typename Number>
Number whole_of(const std::string& text, const char* wanted) {
  Number value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) refuse(text, wanted);
  return value;
}

std::uint64_t seed_of(const std::string& text) {
  return whole_of<std::uint64_t>(text, "a whole number from 0 to 18446744073709551615");
}

double seconds_of(const std::string& text) {
  const double value = number_of(text);
  if (value < 0) refuse(text, "a time of 0 or more");
  return value;
}

}  // namespace

UsageError not_one_of(const std::string& text, const std::vector<Choice>& choices) {
  std::vector<std::string_view> names;
  names.reserve(choices.size());
  for (const Choice& choice : choices) names.push_back(choice.first);
  return UsageError(fmt::format("'{}' is not one of {}{}", text, fmt::join(names, ", "), meant(text, names)));
}

std::size_t count_of(const std::string& text) { return whole_of<std::size_t>(text, "a whole number"); }

double number_of(const std::string& text, const char* option) {
  const std::optional<double> value = number_in(text);
  if (!value) refuse(text, "a number", option);
  return *value;
}

double positive_of(const std::string& text, const char* option) {
  const double value = number_of(text, option);
  if (!(value > 0)) refuse(text, "above 0", option);
  return value;
}

Point point_of(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) refuse(text, "a point X,Y");
  const auto x = number_in(trimmed(text.substr(0, comma))), y = number_in(trimmed(text.substr(comma + 1)));
  if (!x || !y) refuse(text, "a point X,Y");
  return {*x, *y};
}

Footprint footprint_of(const std::string& text) {
  static constexpr const char* kWanted = "point, disc:R or square:R with R > 0";
  if (text == "point") return Footprint::point();
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  if (colon == std::string::npos || (kind != "disc" && kind != "square")) refuse(text, kWanted);
  const std::optional<double> radius = number_in(text.substr(colon + 1));
  if (!radius || *radius <= 0) refuse(text, kWanted);
  return kind == "disc" ? Footprint::disc(*radius) : Footprint::square(*radius);
}

Format format_of(const std::string& text) {
  const std::optional<Format> format = format_named(text);
  if (!format)
    refuse(text,
           "one of segments, cells, drawing, maz, num, wkt, geojson, movingai, ros, picture, blocks, svg, integers");
  return *format;
}

std::size_t memory_of(const std::string& text) {
  double unit = 1 << 20;
  std::string number = text;
  if (!number.empty()) {
    const std::size_t which = std::string_view("KMGkmg").find(number.back());
    if (which != std::string_view::npos) {
      unit = std::pow(1024, static_cast<double>(which % 3 + 1));
      number.pop_back();
    }
  }
  const std::optional<double> value = number_in(number);
  if (!value || !(*value > 0) || *value * unit > 1e18) refuse(text, "an amount of memory, such as 500M or 2G");
  return static_cast<std::size_t>(*value * unit);
}

void add_reading_options(CommandLine& app, WorldOptions& options) {
  const auto parse_format = [](const std::string& text) { return std::optional(format_of(text)); };
  add(app, "--format", options.read.format, parse_format,
      "What FILE is written in: segments, cells, drawing, maz, num, wkt, geojson, movingai, ros, picture, blocks, svg "
      "(default: found out from its content)")
      .type_name("NAME")
      .group("World");
  add(app, "--polygons", options.read.polygons, polygons_of,
      "What polygons without a role are: free (default), obstacles, or nested: free, but one inside "
      "another is a hole")
      .type_name("WHAT")
      .group("World");
  const auto parse_thickness = [](const std::string& text) { return std::optional(thickness_of(text)); };
  add(app, "--wall-thickness", options.read.wall_thickness, parse_thickness,
      "Give every wall this thickness, half of it on each side")
      .type_name("T")
      .group("World");
  const auto parse_resolution = [](const std::string& text) {
    return std::optional(positive_of(text, "--resolution"));
  };
  add(app, "--resolution", options.read.resolution, parse_resolution,
      "Metres a pixel: of a PNG or PGM picture, or instead of what a ROS map says")
      .type_name("R")
      .group("World");
  add(app, "--snap", options.read.snap, snap_of,
      "Join ends and walls that are no farther apart than T, or than the greatest gap among small distances (auto); 0: "
      "not even those that only rounding keeps apart")
      .type_name("T|auto|0")
      .group("World");
  app.add_flag_callback(
         "--project",
         [app, &read = options.read] {
           const std::string name = app.full_name();
           if (name != "taut solve" && name != "taut check" && name != "taut batch" && name != "taut matrix")
             throw UsageError("--project goes with solve, check, batch and matrix, not with '" + name + "'");
           read.project = true;
         },
         "Of solve, check, batch, matrix: coordinates are longitude,latitude; plan in metres")
      .group("World");
  app.add_flag("--unknown-free", options.read.unknown_is_free, "Cells of a ROS map that nobody knows are free")
      .group("World");
  app.add_flag_callback(
         "--repair", [&read = options.read] { read.crossings = Crossings::even_odd; },
         "Read what has no one meaning, too: rings that cross themselves by the even-odd rule, holes over an outline "
         "as the outline without them, rings that are not closed as if they were")
      .group("World");
}

Option add_world_options(CommandLine& app, WorldOptions& options) {
  Option file = app.add_option("FILE", options.file, "The world to read; - is standard input").required();
  add_reading_options(app, options);
  return file;
}

void add_query_options(CommandLine& app, QueryOptions& options) {
  const auto parse_point = [](const std::string& text) { return std::optional(point_of(text)); };
  add(app, "--from", options.from, parse_point, "Start here instead of where FILE says")
      .type_name("X,Y")
      .group("Query");
  add(app, "--to", options.to, parse_point, "Go here instead of where FILE says").type_name("X,Y").group("Query");
  add_snap_ends_option(app, options.snap_ends);
  app.renamed("--start", "--from");
  app.renamed("--goal", "--to");
  add_robot_option(app, options.robot);
}

void add_robot_option(CommandLine& app, Footprint& robot) {
  add(app, "--robot", robot, footprint_of, "Who moves: point (default), disc:R, or square:R of half side R")
      .type_name("SHAPE")
      .group("Query");
}

Option add_svg_option(CommandLine& app, std::string& file, const std::string& description) {
  return app
      .add_option_function(
          "--svg",
          [&file](const std::string& name) {
            for (const char* ending : {".jpg", ".jpeg", ".gif", ".pdf", ".webp"})
              if (name.ends_with(ending))
                throw UsageError("'" + name + "': pictures are written as SVG or, .png, pixels");
            file = name;
          },
          description + "; NAME.png gets pixels, - is standard output")
      .type_name("FILE")
      .group("Output");
}

void require_one_stdout(const std::vector<std::pair<const char*, std::string>>& files) {
  std::string names;
  std::size_t count = 0;
  for (const auto& [option, file] : files) {
    if (file != "-") continue;
    names.append(count++ == 0 ? "" : ", ").append(option);
  }
  if (count > 1) throw UsageError("only one of " + names + " can have standard output");
}

void add_animate_option(CommandLine& app, std::string& animation, const std::string& description) {
  app.add_option("--animate", animation, description + "; NAME.html: as a page; without FILE, --svg's moves")
      .type_name("[FILE]")
      .values(0, 1)
      .group("Output");
}

void settle_animation(const CommandLine& app, std::string& animation, std::string& svg, const std::string& json) {
  if (app.count("--animate") > 0 && animation.empty()) {
    if (svg.empty()) throw UsageError("--animate needs a FILE, or --svg");
    std::swap(animation, svg);
  }
  if (animation.ends_with(".png")) throw UsageError("--animate: '" + animation + "': a PNG does not move, an SVG does");
  if ((svg == "-") + (animation == "-") + (json == "-") > 1)
    throw UsageError("only one of --svg, --animate and --json can have standard output");
}

void add_result_options(CommandLine& app, CommonOptions& options) {
  app.add_option("--json", options.json, "Write the result as JSON; - is standard output")
      .type_name("FILE")
      .group("Output");
  app.add_flag("--stats", options.stats, "Say on stderr what each stage took").group("Output");
  app.add_flag("--quiet,-q", options.quiet, "No line on standard output").group("Output");
}

void add_common_options(CommandLine& app, CommonOptions& options) {
  add(
      app, "--max-seconds", options.limits.seconds,
      [](const std::string& text) { return std::optional(seconds_of(text)); }, "Stop after this time, with exit code 4")
      .type_name("S")
      .group("Limits");
  add(
      app, "--max-memory", options.limits.memory,
      [](const std::string& text) { return std::optional(memory_of(text)); },
      "Stop when more is needed, with exit code 4: 500M, 2G")
      .type_name("SIZE")
      .group("Limits");
  add(app, "--seed", options.seed, seed_of, "Seed of whatever is random (default: 1)").type_name("N").group("Limits");
}

}  // namespace taut::cli
