#include <taut/cli/solve/solve_options.h>

#include <fmt/format.h>

#include <taut/cli/solve/certify.h>
#include <taut/cli/solve/roadmap_option.h>

namespace taut::cli {

namespace {

void add_clearance_options(CommandLine& app, std::optional<ClearanceQuery>& query) {
  using Kind = ClearanceQuery::Kind;
  const auto choose = [&query](Kind kind, double clearance) {
    if (query) throw UsageError("only one of --clearance, --widest and --tradeoff");
    query = ClearanceQuery{kind, clearance};
  };
  app.add_option_function(
         "--clearance",
         [choose](const std::string& text) {
           const double clearance = number_of(text, "--clearance");
           if (clearance < 0) throw UsageError("--clearance: '" + text + "' is negative");
           choose(Kind::at_least, clearance);
         },
         "The shortest way along the Voronoi diagram that keeps this far from walls and from the limits of the world")
      .type_name("C")
      .group("Clearance");
  const auto flag = [&](const char* name, Kind kind, const char* what) {
    app.add_flag_callback(
           name, [choose, kind] { choose(kind, 0); }, what)
        .group("Clearance");
  };
  flag("--widest", Kind::widest, "The largest disc that gets through, its way, and the two walls that pinch it");
  flag("--tradeoff", Kind::tradeoff,
       "What room costs: the shortest way of discs of every radius, with arcs, and each radius at which it changes");
}

void add_keep_option(CommandLine& app, std::optional<double>& keep) {
  app.add_option_function(
         "--keep", [&keep](const std::string& text) { keep = positive_of(text, "--keep"); },
         "The shortest path that keeps this far from walls, with arcs; an end nearer to walls is left, and "
         "entered, by the shortest way to where that can be kept")
      .type_name("C")
      .group("Clearance");
}

void add_alternatives_option(CommandLine& app, SolveOptions& options) {
  app.add_option_function(
         "--alternatives",
         [&options](const std::string& text) {
           options.wider = text == "wider";
           options.alternatives = options.wider ? 0 : count_of(text);
           if (!options.wider && (options.alternatives == 0 || options.alternatives > 1000))
             throw UsageError("--alternatives: '" + text + "' is neither `wider` nor one of 1 to 1000");
         },
         "The shortest path of each of the K shortest ways around the obstacles, its width and the gate that makes it "
         "narrow; wider: of all ways those that no shorter one is as wide as")
      .type_name("K")
      .group("Clearance");
}

// What does not go with searches that have no roadmap, method or proof to choose.
void require_alone(const SolveOptions& options, const std::string& which) {
  if (options.kind || !options.save.empty() || !options.load.empty() || options.shorten || options.clearance ||
      options.arcs || options.method_given() || options.anytime.wanted || options.contours > 0 ||
      !options.certificate.empty() || (options.keep && options.ways_given()))
    throw UsageError(which +
                     " has a search of its own: not with --roadmap, --algorithm, --anytime, --arcs, "
                     "--clearance and their like, nor with --contours and --certificate");
  if (options.query.robot.kind() != Footprint::Kind::point)
    throw UsageError("--robot does not go with " + which + (options.keep ? "; a disc of radius R is --keep R" : ""));
  if (options.world.read.project) throw UsageError("--project does not go with " + which);
  if (options.path && options.ways_given())
    throw UsageError("--path prints one path, --alternatives has several; --json - writes them all");
}

// What does not go with questions of clearance.
void require_suitable(const SolveOptions& options) {
  if (options.query.robot.kind() != Footprint::Kind::point)
    throw UsageError(
        "--robot does not go with --clearance, --widest and --tradeoff; a disc of radius R is --clearance R");
  if (options.path && options.clearance->kind == ClearanceQuery::Kind::tradeoff)
    throw UsageError("--path prints one path, --tradeoff has several; --json - writes them all");
}

const std::vector<Choice> kAlgorithms{{"astar", "the shortest path of the graph, unless the heuristic overestimates"},
                                      {"dijkstra", "the shortest path of the graph, without a heuristic"},
                                      {"bfs", "a path with the fewest legs"},
                                      {"dfs", "some path: on along the first leg, back where it ends"},
                                      {"greedy", "some path: always to what looks nearest the goal"}};

const std::vector<Choice> kHeuristics{
    {"euclidean", "the straight distance"},
    {"manhattan", "dx + dy; overestimates where legs do not follow the axes"},
    {"octile", "dx + dy less (2 - sqrt 2) min(dx, dy); where they are not at 45 degrees either"},
    {"chebyshev", "max(dx, dy)"},
    {"zero", "0: astar is dijkstra then"}};

void add_method_options(CommandLine& app, SolveOptions& options) {
  app.add_option_function(
         "--algorithm",
         [&options](const std::string& text) {
           options.algorithm = graph_algorithm_named(text);
           if (!options.algorithm) throw not_one_of(text, kAlgorithms);
         },
         "How a graph is searched, see below (default: astar)")
      .type_name("NAME")
      .group("Query");
  app.add_option_function(
         "--heuristic",
         [&options](const std::string& text) {
           options.heuristic = graph_heuristic_named(text);
           if (!options.heuristic) throw not_one_of(text, kHeuristics);
         },
         "What astar and greedy believe is left, see below (default: euclidean)")
      .type_name("NAME")
      .group("Query");
  app.explain("Algorithms", kAlgorithms);
  app.explain("Heuristics", kHeuristics);
}

// --algorithm and --heuristic, with what they do not go with.
void require_method_fits(const SolveOptions& options) {
  if (!options.method_given()) return;
  const std::string given =
      options.algorithm ? fmt::format("--algorithm {}", name(*options.algorithm)) : std::string("--heuristic");
  if (options.heuristic && !uses_heuristic(options.method().algorithm))
    throw UsageError(fmt::format("--heuristic makes no sense with {}, which has none", given));
  if (options.kind && !options.kind->graph)
    throw UsageError(fmt::format("--roadmap {} makes no graph for {}", options.kind->name, given));
  if (options.arcs) throw UsageError(fmt::format("--arcs makes no sense with {}: it has its own search", given));
  const bool diagram = options.clearance || options.kind == roadmap_kind("voronoi");
  if (diagram && options.algorithm != GraphAlgorithm::dijkstra)
    throw UsageError(fmt::format("the Voronoi diagram is searched with dijkstra alone, not with {}", given));
}

// Options that exclude each other. Throws UsageError.
void require_consistent(const SolveOptions& options) {
  if (options.keep) require_alone(options, "--keep");
  if (options.ways_given()) require_alone(options, "--alternatives");
  if (options.clearance) {
    if ((options.kind && options.kind != roadmap_kind("voronoi")) || !options.save.empty() || !options.load.empty() ||
        options.shorten)
      throw UsageError("--clearance, --widest and --tradeoff go along the Voronoi diagram, not another roadmap");
    require_suitable(options);
  }
  if (options.kind && !options.kind->graph && !options.save.empty())
    throw UsageError(fmt::format("--roadmap {} makes no graph that --save could keep", options.kind->name));
  if (options.kind && !options.save.empty()) require_savable(*options.kind);
  const RoadmapKind& kind = options.kind ? *options.kind : *roadmap_kind("visibility");
  if (!options.load.empty() && !first_option(options.prm).empty())
    throw UsageError(first_option(options.prm) + " makes no sense with --load: that roadmap is built already");
  require_prm_options_fit(options.prm, kind);
  if (options.shorten && kind.optimal && options.load.empty() && optimal_everywhere(options.method()))
    throw UsageError(
        fmt::format("--shorten makes no sense with the roadmap {}: its paths are the shortest", kind.name));
  if (options.shorten && options.prm.clearance.value_or(0) > 0)
    throw UsageError("--shorten makes no sense with --prm-clearance: a taut path touches corners");
  require_one_stdout({{"--svg", options.svg},
                      {"--json", options.common.json},
                      {"--save", options.save},
                      {"--certificate", options.certificate}});
  if (options.arcs &&
      (options.kind || !options.save.empty() || !options.load.empty() || options.shorten || options.clearance))
    throw UsageError("--arcs has a roadmap of its own: not with --roadmap, --save, --load or --clearance");
  if (options.arcs && options.query.robot.kind() != Footprint::Kind::disc)
    throw UsageError("--arcs needs --robot disc:R");
  if (options.world.read.project && (options.arcs || options.clearance))
    throw UsageError("--project does not go with --arcs, --clearance, --widest and --tradeoff");
  require_method_fits(options);
  require_anytime_fits(options.anytime, options.kind, options.method_given());
  if (options.anytime.wanted && (options.shorten || options.arcs || options.clearance))
    throw UsageError("--anytime makes no sense with --shorten, --arcs, --clearance, --widest or --tradeoff");
  if (options.contours > 0 && options.svg.empty()) throw UsageError("--contours needs --svg");
  if (options.contours > 0 && (options.clearance || options.arcs))
    throw UsageError("--contours does not go with --clearance, --widest, --tradeoff and --arcs");
  if (options.load == "-" && options.world.file == "-")
    throw UsageError("FILE and --load cannot both come from standard input");
  require_certifiable(options);
}

}  // namespace

void add_solve_options(CommandLine& app, SolveOptions& options) {
  add_world_options(app, options.world);
  add_query_options(app, options.query);
  add_method_options(app, options);
  add_roadmap_kind(app, "--roadmap", options.kind, "Roadmap",
                   "polyanya; visibility with --algorithm, --heuristic, --save or --load");
  app.add_option("--save", options.save, "Keep the roadmap for --load; - is standard output")
      .type_name("FILE")
      .group("Roadmap");
  app.add_option("--load", options.load, "Take the roadmap from here instead of building it; - is standard input")
      .type_name("FILE")
      .group("Roadmap");
  app.add_flag("--shorten", options.shorten,
               "Pull the path found in the roadmap taut: the shortest of its homotopy class")
      .group("Roadmap");
  add_prm_options(app, options.prm, true);
  app.add_flag("--arcs", options.arcs,
               "With --robot disc:R: the disc itself, not a polygon around it; the path bends in arcs")
      .group("Query");
  app.add_flag("--no-verify", options.no_verify, "Do not check the answer independently, nor --certificate's file")
      .group("Query");
  app.add_flag(
         "--path", options.path,
         "Print the points of the path, one `x y` a line; of arcs and curves a `#` line first says how near they are")
      .group("Output");
  add_path_file_options(app, options.files);
  add_certificate_option(app, options.certificate);
  add_anytime_options(app, options.anytime);
  add_clearance_options(app, options.clearance);
  add_keep_option(app, options.keep);
  add_alternatives_option(app, options);
  add_svg_option(app, options.svg);
  add_animate_option(app, options.animation, "With --tradeoff: a film of the disc that grows");
  app.add_option_function(
         "--contours",
         [&options](const std::string& text) {
           options.contours = count_of(text);
           if (options.contours == 0 || options.contours > 1000)
             throw UsageError("--contours: '" + text + "' is not one of 1 to 1000");
         },
         "With --svg: draw so many lines on which all places are equally far from the start")
      .type_name("N")
      .group("Output");
  app.callback([&app, &options] {
    settle_animation(app, options.animation, options.svg, options.common.json);
    if (!options.animation.empty() && !options.tradeoff()) throw UsageError("--animate needs --tradeoff");
    require_consistent(options);
  });
  app.example("taut solve maze.txt --svg maze.svg");
  app.example("taut solve maze.txt --from 0.5,0.5 --to 3.5,6.5 --json result.json");
  app.example("taut solve maze.txt --robot disc:0.2 --arcs --svg disc.svg");
  app.example("taut solve maze.txt --tradeoff --animate room.svg");
  app.example("taut solve maze.txt --alternatives 4 --svg ways.svg");
  app.example("taut solve maze.txt --keep 0.3 --svg away.svg");
  app.example("taut solve maze.txt --certificate maze.proof");
}

}  // namespace taut::cli
