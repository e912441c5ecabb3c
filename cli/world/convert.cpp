// taut convert: the same world in another format.

#include <fmt/format.h>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/run.h>
#include <taut/io/worlds/write_world.h>

namespace taut::cli {

namespace {

struct ConvertOptions {
  WorldOptions world;
  CommonOptions common;
  std::string target = "-";
  Format format = Format::segments;
};

void add_options(CommandLine& app, ConvertOptions& options) {
  options.world.read.snap.what = Snap::What::nothing;  // a copy, unless told otherwise
  add_world_options(app, options.world);
  app.add_option("OUT", options.target, "The file to write; - is standard output (default)");
  app.add_option_function(
         "--as", [&options](const std::string& text) { options.format = format_of(text); },
         "The format to write: segments, cells, drawing, maz, num, wkt, geojson, movingai, blocks, integers (for "
         "judges of certificates); what it cannot hold is refused, never left out")
      .type_name("NAME")
      .required()
      .group("World");
  app.renamed("--to", "--as");
  app.example("taut convert maze.maz maze.wkt --as wkt");
}

int run(const ConvertOptions& options, Run& run) {
  run.source(options.world.file);
  run.promise(options.target);
  const Input input = read_input(options.world, run);
  std::string bytes = run.stage("convert", [&] { return write_world(input.world, options.format); });
  if (options.format == Format::wkt && !input.world.solids().empty())
    note(fmt::format("taut: {}: its polygons are obstacles; read it with --polygons obstacles",
                     options.target == "-" ? "<stdout>" : options.target));
  Json result{{"from", name(input.notes.format)}, {"as", name(options.format)}, {"bytes", bytes.size()}};
  return run.end({.result = std::move(result), .files = {{options.target, std::move(bytes)}}});
}

}  // namespace

Command convert_command(CommandLine& app) {
  return command<ConvertOptions>(app, "convert", "Write a world in another format", add_options, run);
}

}  // namespace taut::cli
