// taut batch: many queries on one world, streamed.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/exit_code.h>
#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/timing.h>
#include <taut/geometry/errors.h>
#include <taut/geometry/written_places.h>
#include <taut/io/worlds/gzip.h>
#include <taut/io/worlds/query_lines.h>
#include <taut/search/no_path.h>
#include <taut/search/polyanya.h>

namespace taut::cli {

namespace {

// Landmarks are made once the searches have taken about as many nodes as making them takes, if paths wind: where they
// are hardly longer than straight lines landmarks say nothing that those do not.
constexpr std::size_t kNodesABend = 32;
constexpr double kWinding = 1.1;
constexpr std::size_t kBlock = 1 << 16;  // of results, where nobody waits for each

struct BatchOptions {
  WorldOptions world;
  QueryOptions query;
  CommonOptions common;
  std::string queries;
  bool json = false;
  bool path = false;
  bool quiet = false;
};

void add_options(CommandLine& app, BatchOptions& options) {
  add_world_options(app, options.world);
  app.add_option(
         "QUERIES", options.queries,
         "Lines `sx sy gx gy [length]`, `#` starts a comment; - is standard input. Where a length is given, or "
         "`none`, it is compared to 1e-6. Or a MovingAI scenario file between corners of cells, as the any-angle "
         "sets have it; compared as far as its digits go")
      .required();
  app.add_option_function(
         "--robot", [&options](const std::string& text) { options.query.robot = footprint_of(text); },
         "point (default), disc:R, or square:R (half its side)")
      .type_name("SHAPE")
      .group("Query");
  app.add_flag("--json", options.json, "Print one JSON object a line instead").group("Output");
  app.add_flag("--path", options.path,
               "Print the points of each path as well: ` x y x y ...` after the length, `path` in JSON")
      .group("Output");
  app.add_flag("--quiet,-q", options.quiet, "Print no results; mismatches and totals go to stderr all the same")
      .group("Output");
  app.callback([&options] {
    if (options.queries == "-" && options.world.file == "-")
      throw UsageError("FILE and QUERIES cannot both come from standard input");
  });
}

/// Where the lines come from.
class Source {
 public:
  explicit Source(const std::string& path) : name_(path == "-" ? "<stdin>" : path) {
    if (path != "-") {
      require_file(path);
      file_.open(path, std::ios::binary);
      if (!file_) throw InputError(name_, 0, std::string("cannot be opened: ") + std::strerror(errno));
      in_ = &file_;
    }
    if (in_->peek() == 0x1f) unpack();
  }

  const std::string& name() const { return name_; }
  bool next(std::string& line) {
    if (std::getline(*in_, line)) return true;
    if (in_->bad()) throw InputError(name_, 0, "cannot be read");
    return false;
  }
  /// Is there a whole line already, or does the next one have to be waited for?
  bool may_wait() const { return in_->rdbuf()->in_avail() <= 0; }

 private:
  static void require_file(const std::string& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) throw InputError(path, 0, "is a directory, not a file");
    if (!std::filesystem::exists(path, error)) throw InputError(path, 0, "no such file");
  }

  void unpack() {
    std::ostringstream all;
    all << in_->rdbuf();
    unpacked_.str(gunzip(all.str(), name_));
    in_ = &unpacked_;
  }

  std::string name_;
  std::ifstream file_;
  std::istringstream unpacked_;
  std::istream* in_ = &std::cin;
};

struct Answer {
  const char* status = "none";  // proven, or found, blocked, unproven
  double length = 0;
  double seconds = 0;
  std::string blocked{};  // by what
};

class Batch {
 public:
  explicit Batch(const BatchOptions& options) : options_(options) {}

  int run() {
    begin_stage("read");
    std::ios::sync_with_stdio(false);
    Source source(options_.queries);
    const Input input = read_input(options_.world);
    begin_stage("space");
    const FreeSpace space(input.world, options_.query.robot);
    begin_stage("mesh");
    Polyanya polyanya(space);
    PolyanyaSearch search(polyanya);
    const NoPath no_path(space);
    const WrittenPlaces places(space);
    prepared_ = total_.seconds();
    begin_stage("search");
    QueryReader reader(source.name());
    const Box box = input.world.box();
    std::string line;
    for (int number = 1; source.next(line); ++number) {
      const std::optional<QueryLine> query = reader.read(line, number);
      if (!query) continue;
      if (query->map != Point{} && query->map != box.max)
        throw InputError(source.name(), number,
                         fmt::format("is for a map of {} x {} cells, {} has {} x {}", query->map.x, query->map.y,
                                     input.name, box.max.x, box.max.y));
      if (places.is_moved(query->from) || places.is_moved(query->to))
        answer_on_walls(input.world, *query, source.name());
      else
        answer(space, search, no_path, *query, source.name());
      if (out_.size() >= kBlock || source.may_wait()) flush();
      if (!is_worth_landmarks(polyanya)) continue;
      const Stopwatch watch;
      search = PolyanyaSearch(polyanya = polyanya.with_landmarks());
      prepared_ += watch.seconds();
    }
    flush();
    finish();
    totals();
    return unproven_ > 0 ? kStopped : mismatches_ > 0 || unanswered_ > 0 ? kNone : kFound;
  }

 private:
  void answer(const FreeSpace& space, PolyanyaSearch& search, const NoPath& no_path, const QueryLine& query,
              const std::string& source) {
    Answer answer = ask(space, search, query);
    if (answer.status[0] == 'n' && !no_path.holds(query.from, {query.to, {}})) answer.status = "unproven";
    ++queries_;
    seconds_ += answer.seconds;
    const bool found = answer.status[0] == 'f', unproven = answer.status[0] == 'u';
    const bool matches =
        !query.expects || unproven ||
        (query.expected ? found && std::abs(answer.length - *query.expected) <= query.tolerance : !found);
    compared_ += query.expects && !unproven;
    unproven_ += unproven;
    unanswered_ += !found && !unproven && !(query.expects && !query.expected);
    if (!matches) {
      ++mismatches_;
      complain(fmt::format("{}:{}: expected {}, found {}", source, query.line,
                           query.expected ? number_text(*query.expected) : "none",
                           found ? number_text(answer.length) : answer.status));
    }
    if (options_.quiet) return;
    options_.json ? put_json(query, answer, search, matches) : put_line(query, answer, search);
  }

  /// Ends on sloped walls that bend nearby: a space of their own keeps them there.
  void answer_on_walls(const World& world, const QueryLine& query, const std::string& source) {
    const Point ends[] = {query.from, query.to};
    const FreeSpace space(world, options_.query.robot, ends);
    PolyanyaSearch search{Polyanya(space)};
    answer(space, search, NoPath(space), query, source);
  }

  bool is_worth_landmarks(const Polyanya& polyanya) const {
    return polyanya.landmarks() == nullptr && nodes_ > kNodesABend * polyanya.mesh().bends.size() &&
           lengths_ > kWinding * straight_;
  }

  /// A start or goal in a wall is an answer here, no reason to stop.
  Answer ask(const FreeSpace& space, PolyanyaSearch& search, const QueryLine& query) {
    Answer answer;
    for (const Point p : {query.from, query.to})
      if (space.locate(p).kind == Location::Kind::outside) {
        answer.status = "blocked";
        answer.blocked = p == query.from ? "start" : "goal";
        return answer;
      }
    const Stopwatch watch;
    const SearchStatus status = search.find(query.from, query.to);
    answer.seconds = watch.seconds();
    if (status != SearchStatus::found) return answer;
    answer.status = "found";
    answer.length = Length(search.points()).value();
    nodes_ += search.expanded();
    lengths_ += answer.length;
    straight_ += std::hypot(query.to.x - query.from.x, query.to.y - query.from.y);
    return answer;
  }

  void put_line(const QueryLine& query, const Answer& answer, const PolyanyaSearch& search) {
    const bool found = answer.status[0] == 'f';
    out_ += fmt::format("{} {}", query.line, found ? number_text(answer.length) : answer.status);
    if (found && options_.path)
      for (const Point p : search.points()) out_ += " " + number_text(p.x) + " " + number_text(p.y);
    out_ += '\n';
  }

  void put_json(const QueryLine& query, const Answer& answer, const PolyanyaSearch& search, bool matches) {
    nlohmann::ordered_json row{{"line", query.line}, {"status", answer.status}};
    if (!answer.blocked.empty()) row["blocked"] = answer.blocked;
    const bool found = answer.status[0] == 'f';
    if (found) row["length"] = answer.length;
    if (query.expects && answer.status[0] != 'u') {
      row["expected"] = query.expected ? nlohmann::ordered_json(*query.expected) : nlohmann::ordered_json("none");
      row["matches"] = matches;
    }
    if (found && options_.path) {
      row["path"] = nlohmann::ordered_json::array();
      for (const Point p : search.points()) row["path"].push_back({p.x, p.y});
    }
    out_ += row.dump() + "\n";
  }

  void flush() {
    if (!out_.empty()) print(out_);
    out_.clear();
  }

  void totals() const {
    note(fmt::format("{}, {} without an answer, {}{} compared, {}; {:.1f} us a query, {} to prepare",
                     queries_ == 1 ? "1 query" : fmt::format("{} queries", queries_), unanswered_,
                     unproven_ == 0 ? "" : fmt::format("{} unproven, ", unproven_), compared_,
                     count_text(mismatches_, "mismatch", "mismatches"),
                     queries_ == 0 ? 0 : 1e6 * seconds_ / static_cast<double>(queries_), seconds_text(prepared_)));
  }

  const BatchOptions& options_;
  Stopwatch total_;
  std::string out_;
  std::size_t queries_ = 0, unanswered_ = 0, unproven_ = 0, compared_ = 0, mismatches_ = 0;
  double seconds_ = 0, prepared_ = 0;
  std::size_t nodes_ = 0;
  double lengths_ = 0, straight_ = 0;
};

int run(const BatchOptions& options) { return Batch(options).run(); }

}  // namespace

Command batch_command(CommandLine& app) {
  return command<BatchOptions>(app, "batch", "Answer many queries on one world, one a line", add_options, run);
}

}  // namespace taut::cli
