// taut batch: many queries on one world, streamed.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <new>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/run.h>
#include <taut/cli/solve/batch_answers.h>
#include <taut/cli/solve/ends_on_walls.h>
#include <taut/cli/solve/index_option.h>
#include <taut/cli/solve/query_source.h>
#include <taut/cli/world/geographic.h>
#include <taut/cli/world/snap_ends.h>
#include <taut/geometry/errors.h>
#include <taut/io/worlds/query_lines.h>
#include <taut/search/index.h>
#include <taut/search/no_path.h>
#include <taut/search/polyanya.h>
#include <taut/search/stopwatch.h>

namespace taut::cli {

namespace {

// The graph, and then landmarks, are made once the searches have looked at about as much as making them takes, if paths
// wind: where they are hardly longer than straight lines a corner has many legs, and landmarks say nothing that
// those lines do not.
constexpr std::size_t kConesABend = 16;
constexpr std::size_t kNodesABend = 16;
constexpr double kWinding = 1.1;
constexpr std::size_t kManyBends = 20000;

struct BatchOptions {
  WorldOptions world;
  QueryOptions query;
  CommonOptions common;
  IndexOptions index;
  std::string queries;
  bool json_lines = false;
  bool path = false;
};

void add_options(CommandLine& app, BatchOptions& options) {
  add_world_options(app, options.world);
  app.add_option(
         "QUERIES", options.queries,
         "Lines `sx sy gx gy [length]`, `#` starts a comment; - is standard input. Where a length is given, or "
         "`none`, it is compared to 1e-6. Or a MovingAI scenario file between corners of cells, as the any-angle "
         "sets have it; compared as far as its digits go")
      .required();
  add_robot_option(app, options.query.robot);
  add_snap_ends_option(app, options.query.snap_ends);
  add_index_options(app, options.index);
  app.add_flag("--json-lines", options.json_lines, "Print one JSON object a line instead").group("Output");
  app.add_flag("--path", options.path,
               "The points of each path as well: ` x y x y ...` after the length, `path` in JSON")
      .group("Output");
  app.callback([&options] {
    if (options.queries == "-" && options.world.file == "-")
      throw UsageError("FILE and QUERIES cannot both come from standard input");
  });
  app.example("taut batch maze.txt queries.txt");
  app.example("taut batch maze.txt queries.txt --json-lines --path");
  app.example("taut batch maze.txt queries.txt --save-index maze.index");
}

/// One query after the other, by cones and bends or by an index.
class Finder {
 public:
  explicit Finder(const Polyanya& polyanya) : search_(PolyanyaSearch(polyanya)) {}
  explicit Finder(const Index& index) : search_(IndexSearch(index)) {}

  SearchStatus find(Point from, Point to) {
    return std::visit([&](auto& search) { return search.find(from, to); }, search_);
  }
  const std::vector<Point>& points() const {
    return std::visit([](const auto& search) -> const std::vector<Point>& { return search.points(); }, search_);
  }
  /// 0 of an index.
  std::size_t expanded() const {
    const auto* const cones = std::get_if<PolyanyaSearch>(&search_);
    return cones ? cones->expanded() : 0;
  }

 private:
  std::variant<PolyanyaSearch, IndexSearch> search_;
};

class Batch {
 public:
  Batch(const BatchOptions& options, Run& run)
      : options_(options),
        run_(run),
        answers_({run.is_talkative(), options.json_lines, options.path, run.wants_json()}) {
    run.promise(options.index.save);
    run.when_stopped(answers_.last_words());
  }

  int work() {
    std::ios::sync_with_stdio(false);
    QuerySource source(options_.queries);
    const Input input = read_input(options_.world, run_);
    shown_ = Shown(input.notes);
    const FreeSpace space =
        run_.stage("space", [&] { return triangulated(FreeSpace(input.world, options_.query.robot)); });
    const std::optional<Index> index = index_of(options_.index, space, run_);
    if (!index) polyanya_ = run_.stage("mesh", [&] { return Polyanya(space); });
    const NoPath no_path(space);
    answers_.prepared_in(run_.seconds());
    Finder search = index ? Finder(*index) : Finder(*polyanya_);
    run_.stage("search", [&] { answer_all(source, input, space, search, no_path); });
    note(answers_.totals());
    Answer answer;
    answer.outcome = answers_.outcome();
    answer.reason = answers_.reason();
    if (run_.wants_json()) answer.result = answers_.json();
    if (index) add_index(options_.index, *index, answer);
    return run_.end(std::move(answer));
  }

 private:
  void answer_all(QuerySource& source, const Input& input, const FreeSpace& space, Finder& search,
                  const NoPath& no_path) {
    const EndsOnWalls walls(input, options_.world.read.snap, space);
    QueryReader reader(source.name());
    std::string line;
    for (int number = 1; source.next(line); ++number) {
      const std::optional<QueryLine> query = read(reader, line, number, source, input);
      if (!query) continue;
      const bool on_walls = walls.concern(plane(query->from)) || walls.concern(plane(query->to));
      answers_.add(*query, on_walls ? ask_on_walls(walls, *query) : ask(space, search, no_path, *query), source.name());
      answers_.flush(source.may_wait());
      if (polyanya_) prepare(*polyanya_, search);
    }
    answers_.flush(true);
  }

  /// --project: queries are longitude and latitude.
  Point plane(Point p) const { return shown_ ? shown_.geographic()->metres(p) : p; }

  void show(QueryAnswer& answer) const {
    if (!shown_) return;
    answer.points = shown_(std::move(answer.points));
    answer.moves = shown_(std::move(answer.moves));
    if (answer.nearest) answer.nearest = shown_(*answer.nearest);
  }

  // A line that is wrong does not take the answers before it along.
  std::optional<QueryLine> read(QueryReader& reader, const std::string& line, int number, const QuerySource& source,
                                const Input& input) {
    try {
      const std::optional<QueryLine> query = reader.read(line, number);
      const Box box = input.world.box();
      if (query && query->map != Point{} && query->map != box.max)
        throw InputError(source.name(), number,
                         fmt::format("is for a map of {} x {} cells, {} has {} x {}", query->map.x, query->map.y,
                                     input.name, box.max.x, box.max.y));
      if (query && shown_)
        for (const Point p : {query->from, query->to})
          shown_.geographic()->require_end(p, fmt::format("line {} of the queries: end", number));
      return query;
    } catch (const InputError&) {
      answers_.flush(true);
      throw;
    }
  }

  /// A space of their own has the ends where they are.
  QueryAnswer ask_on_walls(const EndsOnWalls& walls, const QueryLine& query) {
    const FreeSpace space = walls.space_with(std::vector{query.from, query.to});
    Finder search{Polyanya(space)};
    return ask(space, search, NoPath(space), query);
  }

  /// Where there is no memory for it, go on as before.
  void prepare(Polyanya& polyanya, Finder& search) {
    const std::size_t bends = polyanya.mesh().bends.size();
    const bool graph = !polyanya.has_graph() && nodes_ > kConesABend * bends;
    const bool landmarks = polyanya.has_graph() && !polyanya.has_landmarks() && nodes_ > kNodesABend * bends;
    if (is_full_ || (!graph && !landmarks) || !(lengths_ > kWinding * straight_)) return;
    const Stopwatch watch;
    try {
      Polyanya made = graph ? polyanya.with_graph() : polyanya.with_landmarks(bends > kManyBends ? 16 : 8);
      search = Finder(made);
      polyanya = std::move(made);
    } catch (const std::bad_alloc&) {
      is_full_ = true;
    }
    nodes_ = 0;
    answers_.prepared_in(watch.seconds());
  }

  /// Is p a place for the robot, or moved to one by --snap-ends?
  bool settle(const FreeSpace& space, const char* role, Point& p, QueryAnswer& answer) const {
    if (space.locate(p).kind != Location::Kind::outside) return true;
    std::optional<FreePlace> nearest;
    if (options_.query.snap_ends || options_.json_lines || run_.wants_json()) nearest = nearest_free(space, p);
    if (nearest && options_.query.snap_ends && nearest->distance <= *options_.query.snap_ends) {
      answer.moves.push_back({role, p, *nearest});
      p = nearest->point;
      return true;
    }
    answer.status = QueryAnswer::Status::blocked;
    answer.blocked = role;
    answer.nearest = nearest;
    return false;
  }

  /// A start or goal in a wall is an answer here, no reason to stop.
  QueryAnswer ask(const FreeSpace& space, Finder& search, const NoPath& no_path, QueryLine query) {
    query.from = plane(query.from);
    query.to = plane(query.to);
    QueryAnswer answer = ask_in_plane(space, search, no_path, query);
    show(answer);
    return answer;
  }

  QueryAnswer ask_in_plane(const FreeSpace& space, Finder& search, const NoPath& no_path, QueryLine query) {
    QueryAnswer answer;
    if (!settle(space, "start", query.from, answer) || !settle(space, "goal", query.to, answer)) return answer;
    const Stopwatch watch;
    const SearchStatus status = search.find(query.from, query.to);
    answer.cpu = watch.seconds().cpu;
    if (status != SearchStatus::found) {
      if (!no_path.holds(query.from, {query.to, {}})) answer.status = QueryAnswer::Status::unproven;
      return answer;
    }
    answer.status = QueryAnswer::Status::found;
    answer.length = Length(search.points()).value();
    if (options_.path) answer.points.assign(search.points().begin(), search.points().end());
    nodes_ += search.expanded();
    lengths_ += answer.length;
    straight_ += std::hypot(query.to.x - query.from.x, query.to.y - query.from.y);
    return answer;
  }

  const BatchOptions& options_;
  Run& run_;
  BatchAnswers answers_;
  Shown shown_{ReadNotes{}};
  std::optional<Polyanya> polyanya_;  // without an index
  bool is_full_ = false;              // there was no memory
  std::size_t nodes_ = 0;
  double lengths_ = 0, straight_ = 0;
};

int run(const BatchOptions& options, Run& run) {
  run.sources({options.world.file, options.queries});
  return Batch(options, run).work();
}

}  // namespace

Command batch_command(CommandLine& app) {
  return command<BatchOptions>(app, "batch", "Answer many queries on one world, one a line", add_options, run);
}

}  // namespace taut::cli
