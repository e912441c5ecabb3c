// taut roadmap: builds a roadmap and says what it is made of.
#include <fmt/format.h>
#include <CLI/Error.hpp>
#include <CLI/Option.hpp>

#include <algorithm>
#include <functional>

#include <taut/cli/command.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/roadmap_kinds.h>
#include <taut/cli/timing.h>
#include <taut/io/roadmap_export.h>
#include <taut/io/roadmap_json.h>
#include <taut/io/svg.h>

namespace taut::cli {

namespace {

struct RoadmapOptions {
  WorldOptions world;
  QueryOptions query;
  OutputOptions output;
  CommonOptions common;
  const RoadmapKind* kind = roadmap_kind("visibility");
  bool full = false;
  std::string graphml;
  std::string geojson;
  std::string save;

  /// --full is an older name of --kind full.
  const RoadmapKind& chosen() const {
    return full && kind == roadmap_kind("visibility") ? *roadmap_kind("full") : *kind;
  }
  /// Everything that is written, in this order.
  std::vector<std::string> files() const { return {output.svg, output.json, graphml, geojson, save}; }
  bool stdout_taken() const {
    const auto all = files();
    return std::find(all.begin(), all.end(), "-") != all.end();
  }
};

void add_options(CLI::App& app, RoadmapOptions& options) {
  add_world_options(app, options.world);
  add_query_options(app, options.query);
  add_roadmap_kind(app, "--kind", options.kind, "Roadmap");
  app.add_flag("--full", options.full,
               "Of a visibility graph all pairs that see each other, not only those a shortest path can use")
      ->group("Roadmap");
  add_output_options(app, options.output);
  app.add_option("--graphml", options.graphml, "Write it as GraphML; - is standard output")
      ->type_name("FILE")
      ->group("Output");
  app.add_option("--geojson", options.geojson, "Write it as GeoJSON; - is standard output")
      ->type_name("FILE")
      ->group("Output");
  app.add_option("--save", options.save, "Keep it for `taut solve --load`")->type_name("FILE")->group("Output");
  app.callback([&options] {
    const auto files = options.files();
    if (std::count(files.begin(), files.end(), "-") > 1)
      throw CLI::ValidationError("only one of --svg, --json, --graphml, --geojson and --save can have standard output");
    if (!options.kind->graph) throw CLI::ValidationError(fmt::format("--kind {} makes no graph", options.kind->name));
  });
}

// What goes to a file that nobody asked for is not made.
std::string made_for(const std::string& file, const std::function<std::string()>& make) {
  return file.empty() ? std::string() : make();
}

int run(const RoadmapOptions& options) {
  const std::vector<std::string> files = options.files();
  for (const std::string& file : files) require_writable(file);
  double read = 0, build = 0, roadmap_seconds = 0;
  const RoadmapKind& kind = options.chosen();
  const Input input = timed("read", read, [&] { return read_input(options.world, options.query); });
  const FreeSpace space = timed("space", build, [&] { return FreeSpace(input.world, options.query.robot); });
  const PlannedRoadmap planned = timed("roadmap", roadmap_seconds, [&] {
    return kind.build(space, {options.common.seed, input.world.start(), input.world.goal()});
  });
  begin_stage("write");
  const Roadmap& roadmap = *planned.roadmap;
  const std::vector<std::string> facts{kind.title, count_text(roadmap.vertex_count(), "vertex", "vertices"),
                                       count_text(roadmap.edge_count(), "edge"), seconds_text(roadmap_seconds)};
  SvgPicture picture{title_of(input.name), facts, &roadmap, nullptr, {}, input.world.start(), input.world.goal()};
  const std::string texts[] = {
      made_for(options.output.svg, [&] { return svg(space, picture); }),
      made_for(options.output.json, [&] { return roadmap_json(roadmap, kind.title, input.name, roadmap_seconds); }),
      made_for(options.graphml, [&] { return roadmap_graphml(roadmap); }),
      made_for(options.geojson, [&] { return roadmap_geojson(roadmap); }),
      made_for(options.save, [&] { return saved_text(kind, planned, space); })};
  finish();
  for (std::size_t i = 0; i < files.size(); ++i) write_file(files[i], texts[i]);
  if (!options.output.quiet && !options.stdout_taken())
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
