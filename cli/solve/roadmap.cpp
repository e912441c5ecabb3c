// taut roadmap: builds a roadmap and says what it is made of.
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/solve/roadmap_kinds.h>
#include <taut/cli/timing.h>
#include <taut/geometry/corridor_width.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/results/roadmap_export.h>
#include <taut/io/results/roadmap_json.h>
#include <taut/io/results/voronoi_export.h>

namespace taut::cli {

namespace {

struct RoadmapOptions {
  WorldOptions world;
  QueryOptions query;
  OutputOptions output;
  CommonOptions common;
  const RoadmapKind* kind = roadmap_kind("visibility");
  bool full = false;
  PrmRequest prm;
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

void add_options(CommandLine& app, RoadmapOptions& options) {
  add_world_options(app, options.world);
  add_query_options(app, options.query);
  add_roadmap_kind(app, "--kind", options.kind, "Roadmap");
  app.add_flag("--full", options.full,
               "Of a visibility graph all pairs that see each other, not only those a shortest path can use")
      .group("Roadmap");
  add_prm_options(app, options.prm, false);
  add_output_options(app, options.output);
  app.add_option("--graphml", options.graphml, "Write it as GraphML; - is standard output")
      .type_name("FILE")
      .group("Output");
  app.add_option("--geojson", options.geojson, "Write it as GeoJSON; - is standard output")
      .type_name("FILE")
      .group("Output");
  app.add_option("--save", options.save, "Keep it for `taut solve --load`").type_name("FILE").group("Output");
  app.callback([&options] {
    if (!options.chosen().graph) throw UsageError(fmt::format("--kind {} makes no graph", options.chosen().name));
    if (!options.save.empty()) require_savable(options.chosen());
    require_prm_options_fit(options.prm, options.chosen());
    const auto files = options.files();
    if (std::count(files.begin(), files.end(), "-") > 1)
      throw UsageError("only one of --svg, --json, --graphml, --geojson and --save can have standard output");
  });
}

// What goes to a file that nobody asked for is not made.
std::string made_for(const std::string& file, const std::function<std::string()>& make) {
  return file.empty() ? std::string() : make();
}

std::vector<std::string> facts_of(const PlannedRoadmap& planned, const RoadmapKind& kind, double seconds) {
  const auto facts = [&](std::size_t vertices, std::size_t edges) {
    return std::vector<std::string>{kind.title, count_text(vertices, "vertex", "vertices"), count_text(edges, "edge")};
  };
  if (!planned.diagram) {
    std::vector<std::string> all = facts(planned.roadmap->vertex_count(), planned.roadmap->edge_count());
    all.push_back(seconds_text(seconds));
    return all;
  }
  const VoronoiRoadmap& map = *planned.diagram;
  std::vector<std::string> all = facts(map.vertices().size(), map.edges().size());
  const auto arcs = std::count_if(map.edges().begin(), map.edges().end(),
                                  [](const VoronoiEdge& e) { return e.kind == VoronoiEdge::Kind::parabola; });
  all.push_back(count_text(static_cast<std::size_t>(arcs), "arc"));
  all.push_back(fmt::format("vertices within {:.2g}", map.max_error()));
  all.push_back(seconds_text(seconds));
  return all;
}

std::string drawn(const PlannedRoadmap& planned, const FreeSpace& space, const std::string& title,
                  const std::vector<std::string>& facts) {
  SvgPicture picture;
  picture.title = title;
  picture.facts = facts;
  if (planned.diagram)
    picture.diagram = planned.diagram.get();
  else
    picture.roadmap = planned.roadmap.get();
  picture.start = space.world().start();
  picture.goal = space.world().goal();
  return svg(space, picture);
}

std::string json_of(const PlannedRoadmap& planned, const RoadmapKind& kind, const std::string& source, double seconds) {
  return planned.diagram ? voronoi_json(*planned.diagram, source, seconds)
                         : roadmap_json(*planned.roadmap, kind.title, source, seconds, planned.prm);
}

std::string geojson_of(const PlannedRoadmap& planned, const FreeSpace& space) {
  return planned.diagram ? voronoi_geojson(*planned.diagram, corridor_width(space) * kArcTolerance)
                         : roadmap_geojson(*planned.roadmap);
}

int run(const RoadmapOptions& options) {
  const std::vector<std::string> files = options.files();
  for (const std::string& file : files) require_writable(file);
  double read = 0, build = 0, roadmap_seconds = 0;
  const RoadmapKind& kind = options.chosen();
  const Input input = timed("read", read, [&] { return read_input(options.world, options.query); });
  const FreeSpace space = timed("space", build, [&] { return FreeSpace(input.world, options.query.robot); });
  const PlannedRoadmap planned = timed("roadmap", roadmap_seconds, [&] {
    return kind.build(space, {options.common.seed, input.world.start(), input.world.goal(), options.prm,
                              options.common.limits.seconds.has_value(), prm_progress(options.output.quiet)});
  });
  end_progress();
  begin_stage("write");
  const std::vector<std::string> facts = facts_of(planned, kind, roadmap_seconds);
  const std::string texts[] = {
      made_for(options.output.svg, [&] { return drawn(planned, space, title_of(input.name), facts); }),
      made_for(options.output.json, [&] { return json_of(planned, kind, input.name, roadmap_seconds); }),
      made_for(options.graphml,
               [&] { return planned.diagram ? voronoi_graphml(*planned.diagram) : roadmap_graphml(*planned.roadmap); }),
      made_for(options.geojson, [&] { return geojson_of(planned, space); }),
      made_for(options.save, [&] { return saved_text(kind, planned, space); })};
  finish();
  for (std::size_t i = 0; i < files.size(); ++i) write_file(files[i], texts[i]);
  if (!options.output.quiet && !options.stdout_taken())
    print(fmt::format("{}: {}\n", input.name, fmt::join(facts, ", ")));
  if (options.output.stats)
    note(fmt::format("read {:.4f} s, free space {:.4f} s, roadmap {:.4f} s, peak memory {}", read, build,
                     roadmap_seconds, peak_memory_text()));
  if (options.output.stats && planned.prm) note(connectivity_text(*planned.prm));
  return kFound;
}

}  // namespace

Command roadmap_command(CommandLine& app) {
  return command<RoadmapOptions>(app, "roadmap", "Build a roadmap and say what it is made of", add_options, run);
}

}  // namespace taut::cli
