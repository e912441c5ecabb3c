// taut roadmap: builds a roadmap and says what it is made of.
#include <fmt/format.h>

#include <functional>
#include <utility>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/growing_file.h>
#include <taut/cli/input.h>
#include <taut/cli/jobs.h>
#include <taut/cli/messages.h>
#include <taut/cli/progress.h>
#include <taut/cli/run.h>
#include <taut/cli/solve/prm_options.h>
#include <taut/cli/solve/roadmap_option.h>
#include <taut/cli/world/snap_ends.h>
#include <taut/geometry/corridor_width.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/results/roadmap_export.h>
#include <taut/io/results/roadmap_json.h>
#include <taut/io/results/visibility_stream.h>
#include <taut/io/results/voronoi_export.h>
#include <taut/io/saved/planned_roadmap.h>

namespace taut::cli {

namespace {

struct RoadmapOptions {
  WorldOptions world;
  QueryOptions query;
  CommonOptions common;
  const RoadmapKind* kind = roadmap_kind("visibility");
  PrmRequest prm;
  std::string svg;
  std::string graphml;
  std::string geojson;
  std::string save;
  std::string stream;
};

void require_streamable(const RoadmapOptions& options) {
  if (options.stream.empty()) return;
  if (!options.kind->rows) throw UsageError("--stream needs --kind visibility or full");
  for (const std::string& file : {options.svg, options.graphml, options.geojson, options.save})
    if (!file.empty())
      throw UsageError("--stream keeps no roadmap that --svg, --graphml, --geojson, --save could show");
}

void check(const RoadmapOptions& options) {
  if (!options.kind->graph) throw UsageError(fmt::format("--kind {} makes no graph", options.kind->name));
  if (!options.save.empty()) require_savable(*options.kind);
  require_prm_options_fit(options.prm, *options.kind);
  require_streamable(options);
  require_one_stdout({{"--svg", options.svg},
                      {"--json", options.common.json},
                      {"--graphml", options.graphml},
                      {"--geojson", options.geojson},
                      {"--save", options.save},
                      {"--stream", options.stream}});
}

void add_options(CommandLine& app, RoadmapOptions& options) {
  add_world_options(app, options.world);
  add_query_options(app, options.query);
  add_roadmap_kind(app, "--kind", options.kind, "Roadmap");
  app.add_flag_callback(
         "--full", [] { throw UsageError("--full is --kind full now"); }, "")
      .group("");
  app.renamed("--roadmap", "--kind");
  add_prm_options(app, options.prm, false);
  add_jobs_option(app, options.common.limits);
  add_svg_option(app, options.svg);
  app.add_option("--graphml", options.graphml, "Write it as GraphML; - is standard output")
      .type_name("FILE")
      .group("Output");
  app.add_option("--geojson", options.geojson, "Write it as GeoJSON; - is standard output")
      .type_name("FILE")
      .group("Output");
  app.add_option("--save", options.save, "Keep it for `taut solve --load`").type_name("FILE").group("Output");
  app.add_option(
         "--stream", options.stream,
         "Write vertices and edges while they are found, in memory that does not grow with them: lines `v X Y`, "
         "`e U V`; - is standard output")
      .type_name("FILE")
      .group("Output");
  app.callback([&options] { check(options); });
  app.example("taut roadmap maze.txt --kind voronoi --svg diagram.svg");
  app.example("taut roadmap maze.txt --kind full --stream edges.txt");
  app.example("taut roadmap maze.txt --kind prm --sampler bridge --samples 2000 --json roadmap.json");
}

// What goes to a file that nobody asked for is not made.
OutputFile made(const std::string& file, const std::function<std::string()>& make) {
  return {file, file.empty() ? std::string() : make()};
}

std::string drawn(const PlannedRoadmap& planned, const RoadmapKind& kind, const FreeSpace& space,
                  const std::string& title) {
  SvgPicture picture;
  picture.title = title;
  picture.facts = roadmap_facts(kind, planned);
  picture.milestones = kind.samples;
  if (planned.diagram)
    picture.diagram = planned.diagram.get();
  else
    picture.roadmap = planned.roadmap.get();
  picture.start = space.world().start();
  picture.goal = space.world().goal();
  return svg(space, picture);
}

Json json_of(const PlannedRoadmap& planned, const RoadmapKind& kind) {
  return planned.diagram ? voronoi_json(*planned.diagram) : roadmap_json(*planned.roadmap, kind.title, planned.prm);
}

std::string geojson_of(const PlannedRoadmap& planned, const FreeSpace& space) {
  return planned.diagram ? voronoi_geojson(*planned.diagram, corridor_width(space) * kArcTolerance)
                         : roadmap_geojson(*planned.roadmap);
}

std::string graphml_of(const PlannedRoadmap& planned) {
  return planned.diagram ? voronoi_graphml(*planned.diagram) : roadmap_graphml(*planned.roadmap);
}

int stream(const RoadmapOptions& options, const Input& input, const FreeSpace& space, Run& run) {
  const RoadmapKind& kind = *options.kind;
  GrowingFile file(options.stream);
  std::size_t vertices = 0;
  const std::uint64_t edges = run.stage("roadmap", [&] {
    const VisibilityRows rows(space, *kind.rows);
    vertices = rows.vertices().sectors.size();
    return stream_visibility(
        rows, [&](std::string_view piece) { file.add(piece); }, shown_progress(options.common));
  });
  file.finish();
  Answer answer;
  answer.line = fmt::format("{}: {}, {}, {}, {}\n", input.name, kind.title, count_text(vertices, "vertex", "vertices"),
                            count_text(edges, "edge"), cpu_text(run.seconds("roadmap")));
  answer.result = Json{{"kind", kind.title}, {"vertex_count", vertices}, {"edge_count", edges}};
  return run.end(std::move(answer));
}

int run(const RoadmapOptions& options, Run& run) {
  run.source(options.world.file);
  for (const std::string& file : {options.svg, options.graphml, options.geojson, options.save, options.stream})
    run.promise(file);
  const RoadmapKind& kind = *options.kind;
  const Input input = read_input(options.world, options.query, run);
  const FreeSpace space = run.stage("space", [&] { return triangulated(FreeSpace(input.world, options.query.robot)); });
  if (!options.stream.empty()) return stream(options, input, space, run);
  const PlannedRoadmap planned = run.stage("roadmap", [&] {
    return kind.build(
        space, {options.common.seed, input.world.start(), input.world.goal(), options.prm,
                options.common.limits.seconds.has_value(), shown_progress(options.common), options.common.limits.jobs});
  });
  progress_over();
  Answer answer;
  answer.line = fmt::format("{}: {}, {}\n", input.name, fmt::join(roadmap_facts(kind, planned), ", "),
                            cpu_text(run.seconds("roadmap")));
  if (run.wants_json()) answer.result = json_of(planned, kind);
  answer.files = {
      made(options.svg, [&] { return drawn(planned, kind, space, title_of(input.name)); }),
      made(options.graphml, [&] { return graphml_of(planned); }),
      made(options.geojson, [&] { return geojson_of(planned, space); }),
      made(options.save, [&] { return saved_text(kind, planned, space); }),
  };
  if (planned.prm) answer.stats.emplace_back("roadmap", connectivity_text(*planned.prm));
  return run.end(std::move(answer));
}

}  // namespace

Command roadmap_command(CommandLine& app) {
  return command<RoadmapOptions>(app, "roadmap", "Build a roadmap and say what it is made of", add_options, run);
}

}  // namespace taut::cli
