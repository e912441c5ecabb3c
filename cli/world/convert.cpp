// taut convert: the same world in another format.
#include <CLI/Option.hpp>

#include <taut/cli/command.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/input.h>
#include <taut/cli/output.h>
#include <taut/io/worlds/write_world.h>

namespace taut::cli {

namespace {

struct ConvertOptions {
  WorldOptions world;
  CommonOptions common;
  std::string target = "-";
  Format format = Format::segments;
};

void add_options(CLI::App& app, ConvertOptions& options) {
  add_world_options(app, options.world);
  app.add_option("OUT", options.target, "The file to write; - is standard output (default)");
  app.add_option_function<std::string>(
         "--to",
         [&options](const std::string& text) {
           try {
             options.format = format_of(text);
           } catch (const CLI::ValidationError& error) {
             throw CLI::ValidationError(std::string("--to: ").append(error.what()), CLI::ExitCodes::ValidationError);
           }
         },
         "The format to write: segments, cells, drawing, maz, num, wkt, geojson")
      ->type_name("NAME")
      ->required()
      ->group("World");
}

int run(const ConvertOptions& options) {
  require_writable(options.target);
  begin_stage("read");
  const Input input = read_input(options.world);
  begin_stage("write");
  const std::string bytes = write_world(input.world, options.format);
  finish();
  write_file(options.target, bytes);
  return kFound;
}

}  // namespace

Command convert_command(CLI::App& app) {
  return command<ConvertOptions>(app, "convert", "Write a world in another format", add_options, run);
}

}  // namespace taut::cli
