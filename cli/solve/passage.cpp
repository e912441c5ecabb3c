// taut passage: can a disc get from start to goal, and how large may it be? By the gates, without building a path.
#include <fmt/format.h>

#include <utility>
#include <vector>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/run.h>
#include <taut/cli/solve/point_ends.h>
#include <taut/cli/world/snap_ends.h>
#include <taut/geometry/errors.h>
#include <taut/io/pictures/clearance_svg.h>
#include <taut/io/results/barrier_words.h>
#include <taut/io/results/clearance_json.h>
#include <taut/io/results/matrix_file.h>
#include <taut/io/results/passage_map_text.h>
#include <taut/io/worlds/read_points.h>
#include <taut/search/passage.h>
#include <taut/search/passage_map.h>
#include <taut/search/query_ends.h>
#include <taut/search/voronoi_search.h>

namespace taut::cli {

namespace {

struct PassageOptions {
  WorldOptions world;
  QueryOptions query;
  CommonOptions common;
  std::string svg;
  std::string matrix;  ///< a file of points
  std::string map;
  std::string cells = "512";

  std::optional<double> radius() const {
    if (query.robot.kind() != Footprint::Kind::disc) return std::nullopt;
    return query.robot.radius();
  }
};

/// How a map is written, by its file's name.
enum class MapKind : std::uint8_t { svg, geojson, pgm, csv };

MapKind map_kind(const std::string& file) {
  const auto ends = [&](std::string_view ending) { return file.ends_with(ending); };
  if (ends(".svg") || ends(".png")) return MapKind::svg;
  if (ends(".geojson") || ends(".json")) return MapKind::geojson;
  if (ends(".pgm")) return MapKind::pgm;
  if (ends(".csv")) return MapKind::csv;
  throw UsageError(fmt::format("--map {}: name it .svg, .png, .geojson, .pgm or .csv", file));
}

void require_map_options(const PassageOptions& options) {
  const std::size_t cells = count_of(options.cells);
  if (cells == 0 || cells > 8192) throw UsageError("--map-cells " + options.cells + ": 1 to 8192");
  if (options.radius()) throw UsageError("--robot: --map and --matrix are of all discs");
  if (!options.svg.empty()) throw UsageError("--svg: of one passage; a map is drawn by --map map.svg");
  if (!options.map.empty()) map_kind(options.map);
}

void add_options(CommandLine& app, PassageOptions& options) {
  add_world_options(app, options.world);
  add_query_options(app, options.query);
  add_svg_option(app, options.svg);
  app.add_option("--matrix", options.matrix,
                 "Between all pairs of these points instead (as `taut matrix` reads them): CSV of the radii of the "
                 "largest discs, 0 where none gets through, on the diagonal of that which can be there")
      .type_name("POINTS");
  app.add_option(
         "--map", options.map,
         "From the start to everywhere instead: how large a disc gets there. A picture (.svg, .png) or polygons "
         "(.geojson) of the parts between gates; a raster (.pgm, .csv) of how large one can stand there")
      .type_name("FILE")
      .excludes("--matrix")
      .group("Output");
  app.add_option("--map-cells", options.cells, "Cells of the raster along the longer side (512)")
      .type_name("N")
      .group("Output");
  app.callback([&options] {
    if (!options.map.empty() || !options.matrix.empty()) require_map_options(options);
    if (options.query.robot.kind() == Footprint::Kind::polygon)
      throw UsageError("--robot: passages are for discs; `taut solve --robot square:R` knows squares");
    require_one_stdout({{"--svg", options.svg}, {"--json", options.common.json}});
  });
  app.example("taut passage maze.txt");
  app.example("taut passage maze.txt --robot disc:0.3 --svg gates.svg");
  app.example("taut passage maze.txt --matrix points.txt");
  app.example("taut passage maze.txt --from 0.5,0.5 --map map.svg");
}

std::string widest_text(const Passage& passage, const Gates& gates) {
  const std::string limit = limit_text(gates, *passage.widest, passage.start, passage.goal);
  if (passage.widest->limit == WidestPassage::Limit::none) return "a disc of any radius gets through: " + limit;
  const bool is_gate = passage.widest->limit == WidestPassage::Limit::gate;
  return fmt::format("the largest disc that gets through has radius {}{} {}", number_text(passage.widest->radius),
                     is_gate ? ", diameter" : ":", limit);
}

std::string why_not(const Passage& passage, const Gates& gates) {
  if (!passage.is_proven()) return "no way found, but no walls and gates that prove that there is none";
  return passage.asked
             ? blocked_text(gates, *passage.asked, passage.barrier, passage.start, passage.goal, *passage.radius)
             : separation_text(passage.barrier);
}

std::string line(const Passage& passage, const Gates& gates, const std::string& reason, const Seconds& total) {
  if (passage.gets_through()) {
    const std::string asked =
        passage.radius ? fmt::format("a disc of radius {} gets through; ", number_text(*passage.radius)) : "";
    return asked + widest_text(passage, gates) + ", " + cpu_text(total);
  }
  if (!passage.is_proven()) return reason;
  return passage.radius ? fmt::format("no disc of radius {} gets through: {}", number_text(*passage.radius), reason)
                        : "no path: " + reason;
}

std::string map_bytes(const PassageIndex& index, const PassageOptions& options, const Input& input) {
  const Point start = *input.world.start();
  switch (map_kind(options.map)) {
    case MapKind::svg: return passage_map_svg(index, start, title_of(input.name), input.moves);
    case MapKind::geojson: return passage_map_geojson(passage_map(index, start), index.gates());
    case MapKind::pgm: return passage_raster_pgm(passage_raster(index, start, count_of(options.cells)));
    case MapKind::csv: return passage_raster_csv(passage_raster(index, start, count_of(options.cells)));
  }
  return {};
}

int run_map(const PassageOptions& options, Run& run) {
  run.promise(options.map);
  const Input input = read_input(options.world, options.query, run, {0});
  if (!input.world.start()) throw InputError(input.name, 0, "has no start; give --from X,Y");
  const FreeSpace space = run.stage("space", [&] { return triangulated(FreeSpace(input.world)); });
  require_free(space, *input.world.start(), "start");
  const PassageIndex index = run.stage("index", [&] { return PassageIndex(space); });
  const std::vector<PassageFace> faces = passage_map(index, *input.world.start());
  Answer answer;
  answer.files = {{options.map, run.stage("map", [&] { return map_bytes(index, options, input); })}};
  const double most = faces.empty() ? 0 : faces.front().radius, least = faces.empty() ? 0 : faces.back().radius;
  answer.result = {{"start", *input.world.start()},
                   {"faces", faces.size()},
                   {"gates", index.gates().gates().size()},
                   {"largest_radius", most},
                   {"least_radius", least}};
  answer.line =
      fmt::format("{}: {}, from the start discs of radius {} to {} get into them, {}\n", input.name,
                  count_text(faces.size(), "face"), number_text(least), number_text(most), cpu_text(run.seconds()));
  return run.end(std::move(answer));
}

int run_matrix(const PassageOptions& options, Run& run) {
  const Input input = read_input(options.world, run);
  const std::vector<ReadPoint> points = read_points(read_bytes(options.matrix), options.matrix);
  if (points.empty()) throw InputError(options.matrix, 0, "holds no points");
  const FreeSpace space = run.stage("space", [&] { return triangulated(FreeSpace(input.world)); });
  std::vector<Point> places;
  for (const ReadPoint& point : points) {
    if (space.locate(point.point).kind == Location::Kind::outside)
      throw InputError(options.matrix, point.line, "the point " + point_text(point.point) + " is no free place");
    places.push_back(point.point);
  }
  const PassageIndex index = run.stage("index", [&] { return PassageIndex(space); });
  const std::vector<double> radii = run.stage("search", [&] { return passage_matrix(index, places); });
  const std::size_t n = places.size();
  Answer answer;
  Json rows = Json::array();
  for (std::size_t i = 0; i < n && run.wants_json(); ++i)
    rows.push_back(std::vector<double>(radii.begin() + static_cast<std::ptrdiff_t>(i * n),
                                       radii.begin() + static_cast<std::ptrdiff_t>((i + 1) * n)));
  answer.result = {{"points", n}, {"gates", index.gates().gates().size()}, {"radii", rows}};
  answer.line = matrix_bytes(radii, n, MatrixFormat::csv);
  note(fmt::format("{}: {}, {:.3f} us CPU a pair, {}", input.name, count_text(n, "point"),
                   1e6 * run.seconds("search").cpu / static_cast<double>(n * n), cpu_text(run.seconds())));
  return run.end(std::move(answer));
}

int run(const PassageOptions& options, Run& run) {
  run.source(options.world.file);
  if (!options.map.empty()) return run_map(options, run);
  if (!options.matrix.empty()) return run_matrix(options, run);
  run.promise(options.svg);
  const Input input = read_input(options.world, options.query, run, {options.radius().value_or(0)});
  require_ends(input);
  const FreeSpace space = run.stage("space", [&] { return triangulated(FreeSpace(input.world)); });
  const std::vector<Point> goals = free_goals(space, input);
  const PassageIndex index = run.stage("gates", [&] { return PassageIndex(space); });
  const Gates& gates = index.gates();
  const Passage found =
      run.stage("search", [&] { return passage(index, *input.world.start(), goals, options.radius()); });
  Answer answer;
  answer.outcome = found.gets_through() ? Outcome::found : found.is_proven() ? Outcome::none : Outcome::unproven;
  if (answer.outcome != Outcome::found) answer.reason = why_not(found, gates);
  answer.result = passage_json(found, gates);
  answer.line = input.name + ": " + line(found, gates, answer.reason, run.seconds()) + "\n";
  answer.stats = {{"gates", count_text(gates.gates().size(), "gate")}};
  if (!options.svg.empty())
    answer.files = {{options.svg, passage_svg(found, space, title_of(input.name), input.moves)}};
  return run.end(std::move(answer));
}

}  // namespace

Command passage_command(CommandLine& app) {
  return command<PassageOptions>(app, "passage",
                                 "Say whether --robot disc:R gets from start to goal, or how large a disc may be",
                                 add_options, run);
}

}  // namespace taut::cli
