// taut batch: many queries on one world, streamed.
#include <fmt/format.h>

#include <atomic>
#include <exception>
#include <iostream>
#include <new>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/input.h>
#include <taut/cli/jobs.h>
#include <taut/cli/messages.h>
#include <taut/cli/run.h>
#include <taut/cli/solve/batch_answers.h>
#include <taut/cli/solve/ends_on_walls.h>
#include <taut/cli/solve/query_asker.h>
#include <taut/cli/solve/query_blocks.h>
#include <taut/cli/world/geographic.h>
#include <taut/cli/world/snap_ends.h>
#include <taut/geometry/errors.h>
#include <taut/geometry/parallel.h>
#include <taut/io/worlds/query_lines.h>
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
  app.add_flag("--json-lines", options.json_lines, "Print one JSON object a line instead").group("Output");
  app.add_flag("--path", options.path,
               "The points of each path as well: ` x y x y ...` after the length, `path` in JSON")
      .group("Output");
  add_jobs_option(app, options.common.limits);
  app.callback([&options] {
    if (options.queries == "-" && options.world.file == "-")
      throw UsageError("FILE and QUERIES cannot both come from standard input");
  });
  app.example("taut batch maze.txt queries.txt");
  app.example("taut batch maze.txt queries.txt --json-lines --path");
}

class Batch {
 public:
  Batch(const BatchOptions& options, Run& run)
      : options_(options),
        run_(run),
        answers_({run.is_talkative(), options.json_lines, options.path, run.wants_json()}) {
    run.when_stopped(answers_.last_words());
  }

  int work() {
    std::ios::sync_with_stdio(false);
    QuerySource source(options_.queries);
    const Input input = read_input(options_.world, run_);
    const Shown shown(input.notes);
    const FreeSpace space = run_.stage("space", [&] { return FreeSpace(input.world, options_.query.robot); });
    polyanya_.emplace(run_.stage("mesh", [&] { return Polyanya(space); }));
    const EndsOnWalls walls(input, options_.world.read.snap, space);
    SharedNoPath no_path(space);
    const QueryGround ground{space,
                             walls,
                             shown,
                             options_.query.snap_ends,
                             options_.query.snap_ends || options_.json_lines || run_.wants_json(),
                             options_.path};
    QueryAskers askers(ground, no_path);
    answers_.prepared_in(run_.seconds());
    run_.stage("search", [&] { answer_all(source, input, shown, askers); });
    note(answers_.totals());
    Answer answer;
    answer.outcome = answers_.outcome();
    answer.reason = answers_.reason();
    if (run_.wants_json()) answer.result = answers_.json();
    return run_.end(std::move(answer));
  }

 private:
  void answer_all(QuerySource& source, const Input& input, const Shown& shown, QueryAskers& askers) {
    QueryBlocks blocks(source, input, shown, options_.common.limits.jobs);
    for (bool more = true; more;) {
      std::vector<QueryLine> block;
      std::exception_ptr wrong;
      try {
        more = blocks.next(block);
      } catch (const InputError&) {  // a line that is wrong does not take the answers before it along
        wrong = std::current_exception();
      }
      answer_block(block, source.name(), askers);
      answers_.flush(!more || wrong || source.may_wait());
      if (wrong) std::rethrow_exception(wrong);
    }
  }

  /// After each answer, in their order, the batch may want to prepare for what is to come: the rest is asked again.
  void answer_block(std::span<const QueryLine> block, const std::string& source, QueryAskers& askers) {
    while (!block.empty()) {
      std::vector<QueryAnswer> answers(block.size());
      std::size_t done = 0;
      std::atomic<bool> is_due{false};
      Parallel how{options_.common.limits.jobs, [&] { return is_due.load(); }, {}};
      how.finished = [&](std::size_t over) {
        for (; done < over && !is_due; ++done) {
          answers_.add(block[done], answers[done], source);
          answers_.flush(false);
          is_due = weigh(answers[done]);
        }
      };
      each_in_parallel(block.size(), how, [&] {
        return [&, asker = askers.lend(*polyanya_)](std::size_t i) { answers[i] = asker->ask(block[i]); };
      });
      block = block.subspan(done);
      if (is_due) prepare(askers);
    }
  }

  /// Has so much been looked at that it is time to prepare?
  bool weigh(const QueryAnswer& answer) {
    if (answer.status != QueryAnswer::Status::found) return false;
    nodes_ += answer.nodes;
    lengths_ += answer.length;
    straight_ += answer.straight;
    const std::size_t bends = polyanya_->mesh().bends.size();
    const bool graph = !polyanya_->has_graph() && nodes_ > kConesABend * bends;
    const bool landmarks = polyanya_->has_graph() && !polyanya_->has_landmarks() && nodes_ > kNodesABend * bends;
    return !is_full_ && (graph || landmarks) && lengths_ > kWinding * straight_;
  }

  /// Where there is no memory for it, go on as before.
  void prepare(QueryAskers& askers) {
    const Stopwatch watch;
    const std::size_t bends = polyanya_->mesh().bends.size();
    try {
      polyanya_ = polyanya_->has_graph() ? polyanya_->with_landmarks(bends > kManyBends ? 16 : 8)
                                         : polyanya_->with_graph(options_.common.limits.jobs);
      askers.forget();
    } catch (const std::bad_alloc&) {
      is_full_ = true;
    }
    nodes_ = 0;
    answers_.prepared_in(watch.seconds());
  }

  const BatchOptions& options_;
  Run& run_;
  BatchAnswers answers_;
  std::optional<Polyanya> polyanya_;
  bool is_full_ = false;  // there was no memory
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
