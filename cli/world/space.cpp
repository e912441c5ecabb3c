// taut space: where a robot's reference point may be, as polygons with holes.
#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string_view>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/run.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/worlds/free_space_text.h>

namespace taut::cli {

namespace {

enum class Target : std::uint8_t { wkt, geojson, svg };

struct SpaceOptions {
  WorldOptions world;
  Footprint robot;
  CommonOptions common;
  std::string output;
  std::optional<Target> target;
};

std::optional<Target> target_named(std::string_view word) {
  if (word == "wkt") return Target::wkt;
  if (word == "geojson" || word == "json") return Target::geojson;
  if (word == "svg") return Target::svg;
  return std::nullopt;
}

const char* name(Target target) {
  return target == Target::wkt ? "wkt" : target == Target::geojson ? "geojson" : "svg";
}

// Of `maps.d/floor` there is none.
std::string_view ending(std::string_view file) {
  const std::size_t dot = file.find_last_of("./");
  return dot == std::string_view::npos || file[dot] == '/' ? "" : file.substr(dot + 1);
}

void add_options(CommandLine& app, SpaceOptions& options) {
  add_world_options(app, options.world);
  add_robot_option(app, options.robot);
  app.add_option("-o,--output", options.output,
                 "The file to write, its name ending in .wkt, .geojson or .svg; - is standard output")
      .type_name("FILE")
      .required()
      .group("Output");
  app.add_option_function(
         "--as",
         [&options](const std::string& text) {
           options.target = target_named(text);
           if (!options.target) throw UsageError("'" + text + "' is not wkt, geojson or svg");
         },
         "What to write, whatever the file's name: wkt, geojson, svg")
      .type_name("NAME")
      .group("Output");
  app.callback([&options] {
    if (!options.target) options.target = target_named(ending(options.output));
    if (!options.target)
      throw UsageError(fmt::format("-o {}: name it .wkt, .geojson or .svg, or say --as", options.output));
  });
  app.example("taut space maze.txt --wall-thickness 0.1 --robot disc:0.2 -o space.wkt");
}

std::string facts(const FreeSpaceSize& size) {
  if (size.polygons == 0) return "nothing is free";
  std::string text = fmt::format("{}, {}, {}, area {:.10g}", count_text(size.polygons, "polygon"),
                                 count_text(size.holes, "hole"), count_text(size.corners, "corner"), size.area);
  if (size.walls > 0) text += fmt::format(", {} of zero thickness", count_text(size.walls, "wall"));
  return text;
}

std::string bytes_of(const FreeSpace& space, Target target, const std::string& title, const FreeSpaceSize& size) {
  if (target != Target::svg) return write_free_space(space, target == Target::wkt ? Format::wkt : Format::geojson);
  SvgPicture picture;
  picture.title = title;
  picture.facts = {facts(size)};
  return svg(space, picture);
}

int run(const SpaceOptions& options, Run& run) {
  run.source(options.world.file);
  run.promise(options.output);
  const Input input = read_input(options.world, run);
  const FreeSpace space = run.stage("space", [&] { return triangulated(FreeSpace(input.world, options.robot)); });
  const FreeSpaceSize size = size_of(space);
  std::string bytes = run.stage("write", [&] { return bytes_of(space, *options.target, title_of(input.name), size); });
  Json result{{"as", name(*options.target)},
              {"polygons", size.polygons},
              {"holes", size.holes},
              {"corners", size.corners},
              {"walls", size.walls},
              {"area", size.area},
              {"displacement", space.report().displacement}};
  return run.end({.result = std::move(result),
                  .line = fmt::format("{}: {}\n", input.name, facts(size)),
                  .files = {{options.output, std::move(bytes)}}});
}

}  // namespace

Command space_command(CommandLine& app) {
  return command<SpaceOptions>(app, "space", "Write where a robot may be, as polygons with holes", add_options, run);
}

}  // namespace taut::cli
