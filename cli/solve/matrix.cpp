// taut matrix: the lengths of the shortest paths between all pairs of points.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/input.h>
#include <taut/cli/jobs.h>
#include <taut/cli/messages.h>
#include <taut/cli/progress.h>
#include <taut/cli/ranks.h>
#include <taut/cli/run.h>
#include <taut/cli/shards.h>
#include <taut/cli/solve/ends_on_walls.h>
#include <taut/cli/solve/matrix_lengths.h>
#include <taut/cli/solve/matrix_shards.h>
#include <taut/cli/world/geographic.h>
#include <taut/cli/world/snap_ends.h>
#include <taut/geometry/errors.h>
#include <taut/geometry/rounding.h>
#include <taut/io/results/matrix_file.h>
#include <taut/io/saved/packed.h>
#include <taut/io/saved/roadmap_file.h>
#include <taut/io/saved/shard_file.h>
#include <taut/io/worlds/read_points.h>
#include <taut/search/distance_matrix.h>
#include <taut/search/no_path.h>

namespace taut::cli {

namespace {

struct MatrixOptions {
  WorldOptions world;
  QueryOptions query;
  CommonOptions common;
  std::string points;
  std::string output;
  std::optional<MatrixFormat> format;
  ShardOptions shards;
};

void add_options(CommandLine& app, MatrixOptions& options) {
  add_world_options(app, options.world);
  app.add_option("POINTS", options.points,
                 "Points: lines `x y`, CSV below a heading with x and y (or lon and lat), a JSON list [[x, y], ...] or "
                 "GeoJSON points; - is standard input")
      .required();
  add_robot_option(app, options.query.robot);
  add_snap_ends_option(app, options.query.snap_ends);
  app.add_option(
         "-o,--output", options.output,
         "The file to write, its name ending in .npy (NumPy), .f64, .bin or .raw (bare 64-bit numbers), .csv or "
         ".txt; without it CSV on standard output")
      .type_name("FILE")
      .group("Output");
  app.add_option_function(
         "--as",
         [&options](const std::string& text) {
           options.format = matrix_format_named(text);
           if (!options.format) throw UsageError("'" + text + "' is not csv, npy or raw");
         },
         "What to write, whatever the file's name: csv, npy, raw")
      .type_name("NAME")
      .group("Output");
  add_jobs_option(app, options.common.limits);
  add_shard_options(app, options.shards, options.common);
  app.callback([&options] {
    if (options.points == "-" && options.world.file == "-")
      throw UsageError("FILE and POINTS cannot both come from standard input");
    if (options.output.empty() && options.format) throw UsageError("--as goes with -o FILE; -o - is standard output");
    if (options.output.empty()) return;
    if (!options.format) options.format = matrix_format_of_file(options.output);
    if (!options.format)
      throw UsageError(fmt::format("-o {}: name it .npy, .f64, .csv or the like, or say --as", options.output));
    require_one_stdout({{"-o", options.output}, {"--json", options.common.json}});
  });
  app.example("taut matrix maze.txt points.txt");
  app.example("taut matrix maze.txt points.txt -o lengths.npy");
}

class Matrix {
 public:
  Matrix(const MatrixOptions& options, Run& run) : options_(options), run_(run) {}

  int work() {
    const Input input = read_input(options_.world, run_);
    shown_ = Shown(input.notes);
    read_places();
    FreeSpace space = run_.stage("space", [&] { return triangulated(space_of(input)); });
    settle(space);
    if (options_.shards.shard > 0) return run_.end(do_shard(options_.shards, items(input, space), run_));
    const auto lengths = std::make_shared<Lengths>(places_.size());
    run_.when_stopped([lengths, json = run_.wants_json(), csv = prints()]() -> std::pair<Json, std::string> {
      const std::size_t rows = lengths->rows;
      return {json ? matrix_json(*lengths, rows, true) : Json(),
              csv ? matrix_bytes(lengths->first(rows), lengths->size, MatrixFormat::csv) : ""};
    });
    measure(input, space, *lengths);
    return end(input, *lengths);
  }

 private:
  bool prints() const { return options_.output.empty() && run_.is_talkative(); }

  void read_places() {
    run_.stage("read", [&] {
      const std::string name = options_.points == "-" ? "<stdin>" : options_.points;
      for (const ReadPoint& point : read_points(bytes_for_all(options_.points), name)) {
        if (shown_) shown_.geographic()->require_end(point.point, fmt::format("{}:{}: point", name, point.line));
        points_.push_back(point);
        given_.push_back(point.point);
        places_.push_back(shown_ ? shown_.geographic()->metres(point.point) : point.point);
      }
      if (points_.empty()) throw InputError(name, 0, "holds no points");
    });
  }

  FreeSpace space_of(const Input& input) const {
    FreeSpace space(input.world, options_.query.robot, places_);
    const EndsOnWalls walls(input, options_.world.read.snap, space);
    if (std::none_of(places_.begin(), places_.end(), [&](Point p) { return walls.concern(p); })) return space;
    return walls.space_with(given_);
  }

  /// Points that are no places for the robot: moved by --snap-ends, or refused.
  void settle(const FreeSpace& space) {
    std::vector<EndMove> moves;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (space.locate(places_[i]).kind != Location::Kind::outside) continue;
      const std::optional<FreePlace> nearest = nearest_free(space, places_[i]);
      const std::string why = blocked_text(space.world(), places_[i], "point", nearest, shown_);
      const std::string name = options_.points == "-" ? "<stdin>" : options_.points;
      if (!nearest || !options_.query.snap_ends || nearest->distance > *options_.query.snap_ends)
        throw InputError(name, points_[i].line, why);
      note(fmt::format("taut: {}:{}: {}; moved there", name, points_[i].line, why));
      moves.push_back({fmt::format("point {}", i + 1), places_[i], *nearest});
      places_[i] = nearest->point;
    }
    if (!moves.empty()) run_.add_to_result("moved_ends", end_moves_json(shown_(moves)));
  }

  /// What results depend on.
  std::string work_mark(const Input& input) const {
    Packer packer;
    for (const Point p : given_) packer.put(p);
    const std::string texts[] = {TAUT_VERSION, options_.shards.how, fingerprint(input.world),
                                 std::move(packer).bytes()};
    return mark_of(texts);
  }

  /// The graph is made by who measures.
  Items items(const Input& input, const FreeSpace& space) {
    return matrix_items(places_.size(), work_mark(input), [this, &space] {
      graph_.emplace(graph_of(space));
      return DistanceRows(*graph_, places_, options_.common.limits.jobs);
    });
  }

  void measure(const Input& input, const FreeSpace& space, Lengths& lengths) {
    const bool is_doubted = space.footprint().kind() == Footprint::Kind::disc || rounding_bound(space) > 0;
    if (options_.shards.is_shared()) {
      take_matrix(options_.shards, items(input, space), run_, lengths.values, lengths.size);
    } else {
      const VisibilityGraph graph = graph_of(space);
      const TellProgress show = shown_progress(options_.common);
      if (show) show({"rows", 0, lengths.size});
      const auto finished = [&](std::size_t rows) {
        lengths.rows = is_doubted ? 0 : rows;
        if (show) show({"rows", rows, lengths.size});
      };
      run_.stage("search",
                 [&] { distance_matrix(graph, places_, lengths.values, finished, options_.common.limits.jobs); });
    }
    if (is_doubted) run_.stage("search", [&] { doubt(lengths, space); });
    lengths.rows = lengths.size;
  }

  VisibilityGraph graph_of(const FreeSpace& space) {
    return run_.stage("graph", [&] {
      return VisibilityGraph(space, VisibilityKind::reduced, options_.common.limits.jobs,
                             shown_progress(options_.common));
    });
  }

  /// Where nothing proves that there is no path the length is no number.
  void doubt(Lengths& lengths, const FreeSpace& space) const {
    const bool is_disc = space.footprint().kind() == Footprint::Kind::disc;
    const NoPath no_path(space);
    std::vector<bool> sure(lengths.size, true);
    if (!is_disc)
      for (std::size_t i = 0; i < lengths.size; ++i) sure[i] = is_sure(space, places_[i]);
    for (std::size_t i = 0; i < lengths.size; ++i)
      for (std::size_t j = i + 1; j < lengths.size; ++j) {
        if (std::isfinite(lengths(i, j))) continue;
        if (is_disc ? no_path.holds(places_[i], {places_[j], {}}) : sure[i] && sure[j]) continue;
        lengths.values[i * lengths.size + j] = lengths.values[j * lengths.size + i] =
            std::numeric_limits<double>::quiet_NaN();
      }
  }

  int end(const Input& input, const Lengths& lengths) {
    const Totals totals(lengths, lengths.size);
    Answer answer;
    answer.outcome = totals.unproven > 0 ? Outcome::unproven : totals.none > 0 ? Outcome::none : Outcome::done;
    if (totals.unproven > 0)
      answer.reason = fmt::format("{} unproven", count_text(totals.unproven, "pair", "pairs"));
    else if (totals.none > 0)
      answer.reason = fmt::format("{} without a path", count_text(totals.none, "pair", "pairs"));
    if (run_.wants_json()) answer.result = matrix_json(lengths, lengths.size, options_.output.empty());
    const std::string line = text(input, lengths, totals, answer.reason);
    if (options_.output.empty()) {
      note(line);
      answer.line = matrix_bytes(lengths.values, lengths.size, MatrixFormat::csv);
    } else {
      answer.line = line + "\n";
      answer.files = {{options_.output, matrix_bytes(lengths.values, lengths.size, *options_.format)}};
    }
    return run_.end(std::move(answer));
  }

  std::string text(const Input& input, const Lengths& lengths, const Totals& totals, const std::string& reason) const {
    const double pairs = static_cast<double>(lengths.size) * static_cast<double>(lengths.size);
    return fmt::format("{}: {}{}{}, longest {}, {:.3f} us CPU a pair, {}", input.name,
                       count_text(lengths.size, "point", "points"), reason.empty() ? "" : ", ", reason,
                       number_text(totals.longest), 1e6 * run_.seconds("search").cpu / pairs, cpu_text(run_.seconds()));
  }

  const MatrixOptions& options_;
  Run& run_;
  Shown shown_{ReadNotes{}};
  std::vector<ReadPoint> points_;
  std::vector<Point> given_;              // as they are written
  std::optional<VisibilityGraph> graph_;  // of shards
  std::vector<Point> places_;             // of the plane, where --snap-ends put them
};

int run(const MatrixOptions& options, Run& run) {
  run.sources({options.world.file, options.points});
  run.promise(options.output);
  return Matrix(options, run).work();
}

}  // namespace

Command matrix_command(CommandLine& app) {
  return command<MatrixOptions>(app, "matrix", "The lengths of the shortest paths between all pairs of points",
                                add_options, run);
}

}  // namespace taut::cli
