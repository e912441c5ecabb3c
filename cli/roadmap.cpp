// taut roadmap: builds a roadmap and says what it is made of.
#include <fmt/format.h>

#include <taut/cli/command.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/timing.h>
#include <taut/io/roadmap_json.h>
#include <taut/io/svg.h>
#include <taut/roadmaps/visibility_graph.h>

namespace taut::cli {

namespace {

struct RoadmapOptions {
  WorldOptions world;
  QueryOptions query;
  OutputOptions output;
  CommonOptions common;
  bool full = false;
};

void add_options(CLI::App& app, RoadmapOptions& options) {
  add_world_options(app, options.world);
  add_query_options(app, options.query);
  app.add_option_function<std::string>(
         "--kind",
         [](const std::string& text) {
           if (text != "visibility") throw CLI::ValidationError("--kind: '" + text + "' is not visibility");
         },
         "visibility (default)")
      ->type_name("NAME")
      ->group("Roadmap");
  app.add_flag("--full", options.full, "All pairs that see each other, not only those a shortest path can use")
      ->group("Roadmap");
  add_output_options(app, options.output);
}

int run(const RoadmapOptions& options) {
  require_writable(options.output.svg);
  require_writable(options.output.json);
  double read = 0, build = 0, roadmap_seconds = 0;
  const Input input = timed("read", read, [&] { return read_input(options.world, options.query); });
  const FreeSpace space = timed("space", build, [&] { return FreeSpace(input.world, options.query.robot); });
  const VisibilityGraph graph = timed("roadmap", roadmap_seconds, [&] {
    return VisibilityGraph(space, options.full ? VisibilityKind::full : VisibilityKind::reduced);
  });
  begin_stage("write");
  const Roadmap& roadmap = graph.roadmap();
  const std::string kind = options.full ? "full visibility graph" : "reduced visibility graph";
  const std::vector<std::string> facts{kind, count_text(roadmap.vertex_count(), "vertex", "vertices"),
                                       count_text(roadmap.edge_count(), "edge"), seconds_text(roadmap_seconds)};
  SvgPicture picture{title_of(input.name), facts, &roadmap, nullptr, {}, input.world.start(), input.world.goal()};
  const std::string drawing = options.output.svg.empty() ? "" : svg(space, picture);
  const std::string json = options.output.json.empty() ? "" : roadmap_json(roadmap, kind, input.name, roadmap_seconds);
  finish();
  write_file(options.output.svg, drawing);
  write_file(options.output.json, json);
  if (!options.output.quiet && !options.output.stdout_taken())
    print(fmt::format("{}: {}\n", input.name, fmt::join(facts, ", ")));
  if (options.output.stats)
    note(fmt::format("read {:.4f} s, free space {:.4f} s, roadmap {:.4f} s, peak memory {}", read, build,
                     roadmap_seconds, peak_memory_text()));
  return kFound;
}

}  // namespace

Command roadmap_command(CLI::App& app) {
  return command<RoadmapOptions>(app, "roadmap", "Build a roadmap and say what it is made of", add_options, run);
}

}  // namespace taut::cli
