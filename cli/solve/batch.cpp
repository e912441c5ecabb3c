// taut batch: many queries on one world, streamed.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <exception>
#include <functional>
#include <iostream>
#include <memory>
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
#include <taut/cli/shards.h>
#include <taut/cli/solve/batch_answers.h>
#include <taut/cli/solve/ends_on_walls.h>
#include <taut/cli/solve/index_option.h>
#include <taut/cli/solve/packed_answer.h>
#include <taut/cli/solve/query_asker.h>
#include <taut/cli/solve/query_blocks.h>
#include <taut/cli/solve/search_stages.h>
#include <taut/cli/world/geographic.h>
#include <taut/cli/world/snap_ends.h>
#include <taut/geometry/errors.h>
#include <taut/geometry/parallel.h>
#include <taut/io/saved/packed.h>
#include <taut/io/saved/roadmap_file.h>
#include <taut/io/saved/shard_file.h>
#include <taut/io/worlds/query_lines.h>
#include <taut/search/index.h>
#include <taut/search/polyanya.h>

namespace taut::cli {

namespace {

constexpr std::size_t kQueriesAnItem = 256;  // of shards

struct BatchOptions {
  WorldOptions world;
  QueryOptions query;
  CommonOptions common;
  IndexOptions index;
  std::string queries;
  bool json_lines = false;
  bool path = false;
  ShardOptions shards;
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
  add_jobs_option(app, options.common.limits);
  add_shard_options(app, options.shards, options.common);
  app.callback([&options] {
    if (options.queries == "-" && options.world.file == "-")
      throw UsageError("FILE and QUERIES cannot both come from standard input");
    if (options.shards.is_shared() && !options.index.save.empty())
      throw UsageError("--save-index goes with a run of its own, not with what is shared");
  });
  app.example("taut batch maze.txt queries.txt");
  app.example("taut batch maze.txt queries.txt --json-lines --path");
  app.example("taut batch maze.txt queries.txt --save-index maze.index");
}

/// What queries are asked about, and who asks.
class Ground {
 public:
  Ground(const BatchOptions& options, const Input& input, Run& run)
      : options_(options),
        shown_(input.notes),
        space_(run.stage("space", [&] { return FreeSpace(input.world, options.query.robot); })),
        walls_(input, options.world.read.snap, space_),
        no_path_(space_),
        ground_{space_, walls_, shown_, options.query.snap_ends, wants_nearest(run), options.path},
        index_(index_of(options.index, space_, run)) {
    if (!index_) stages_.emplace(run.stage("mesh", [&] { return Polyanya(space_); }), options.common.limits.jobs);
  }

  /// Answers in order, `take`n as soon as each and all before it are there. After each the stages may want to go on to
  /// the next one: the rest is asked again.
  template <typename Take>
  void answer(std::span<const QueryLine> block, Take take) {
    while (!block.empty()) {
      std::vector<QueryAnswer> answers(block.size());
      std::size_t done = 0;
      std::atomic<bool> is_due{false};
      Parallel how{options_.common.limits.jobs, [&] { return is_due.load(); }, {}};
      how.finished = [&](std::size_t over) {
        for (; done < over && !is_due; ++done) {
          is_due = stages_ && stages_->weigh(answers[done]);
          take(block[done], answers[done]);
        }
      };
      each_in_parallel(block.size(), how, [&] {
        return [&, asker = lend(stages_ ? stages_->stage() : 0)](std::size_t i) { answers[i] = asker->ask(block[i]); };
      });
      block = block.subspan(done);
      if (is_due) prepared_ += stages_->go_on();
    }
  }

  std::shared_ptr<QueryAsker> lend(std::size_t stage) {
    return index_ ? askers_[0].lend(*index_) : askers_[stage].lend((*stages_)[stage]);
  }
  bool is_settled() const { return !stages_ || stages_->is_settled(); }
  std::size_t stage_of(std::size_t number) const { return stages_ ? stages_->stage_of(number) : 0; }
  const std::optional<Index>& index() const { return index_; }
  const Shown& shown() const { return shown_; }
  Seconds prepared() { return std::exchange(prepared_, {}); }  ///< since the last call

 private:
  /// Whoever joins shards may want it though this one does not.
  bool wants_nearest(const Run& run) const {
    return options_.query.snap_ends || options_.json_lines || run.wants_json() || options_.shards.is_shared();
  }

  const BatchOptions& options_;
  const Shown shown_;
  const FreeSpace space_;
  const EndsOnWalls walls_;
  SharedNoPath no_path_;
  const QueryGround ground_;
  const std::optional<Index> index_;
  std::optional<SearchStages> stages_;  // without an index
  std::array<QueryAskers, 3> askers_{QueryAskers{ground_, no_path_}, QueryAskers{ground_, no_path_},
                                     QueryAskers{ground_, no_path_}};
  Seconds prepared_;
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
    if (options_.shards.is_shared()) return share(source, input);
    Ground ground(options_, input, run_);
    answers_.prepared_in(run_.seconds());
    run_.stage("search", [&] { answer_all(source, input, ground); });
    return end(ground.index());
  }

 private:
  void answer_all(QuerySource& source, const Input& input, Ground& ground) {
    QueryBlocks blocks(source, input, ground.shown(), options_.common.limits.jobs);
    for (bool more = true; more;) {
      std::vector<QueryLine> block;
      std::exception_ptr wrong;
      try {
        more = blocks.next(block);
      } catch (const InputError&) {  // a line that is wrong does not take the answers before it along
        wrong = std::current_exception();
      }
      ground.answer(block, [&](const QueryLine& query, const QueryAnswer& answer) {
        answers_.add(query, answer, source.name());
        answers_.flush(false);
      });
      answers_.prepared_in(ground.prepared());
      answers_.flush(!more || wrong || source.may_wait());
      if (wrong) std::rethrow_exception(wrong);
    }
  }

  int end(const std::optional<Index>& index = {}) {
    note(answers_.totals());
    Answer answer;
    answer.outcome = answers_.outcome();
    answer.reason = answers_.reason();
    if (run_.wants_json()) answer.result = answers_.json();
    if (index) add_index(options_.index, *index, answer);
    return run_.end(std::move(answer));
  }

  int share(QuerySource& source, const Input& input) {
    const Shown shown(input.notes);
    QueryBlocks blocks(source, input, shown, 1);
    std::vector<QueryLine> queries;
    while (blocks.next(queries)) continue;
    const Items items = items_of(queries, input);
    if (options_.shards.shard > 0)
      return run_.end(run_.stage("search", [&] { return do_shard(options_.shards, items, run_); }));
    take_all(options_.shards, items, run_, [&](std::size_t item, std::string_view bytes) {
      Unpacker unpacker(bytes, fmt::format("item {} of the shards", item));
      for (const QueryLine& query : queries_of(queries, item))
        answers_.add(query, unpacked_answer(unpacker), source.name());
      answers_.flush(false);
    });
    answers_.flush(true);
    return end();
  }

  Items items_of(std::span<const QueryLine> queries, const Input& input) {
    const std::string texts[] = {TAUT_VERSION, options_.shards.how, fingerprint(input.world), text_of(queries)};
    return {mark_of(texts), (queries.size() + kQueriesAnItem - 1) / kQueriesAnItem,
            [this, queries, &input] { prepare(queries, input); }, [this, queries] { return worker(queries); }};
  }

  /// The first answers are looked for by everybody: they say what the others are searched on.
  void prepare(std::span<const QueryLine> queries, const Input& input) {
    ground_.emplace(options_, input, run_);
    for (std::size_t done = 0; done < queries.size() && !ground_->is_settled(); done += kQueriesAnItem)
      ground_->answer(queries.subspan(done, std::min(kQueriesAnItem, queries.size() - done)), [](auto&&...) {});
  }

  std::function<std::string(std::size_t)> worker(std::span<const QueryLine> queries) {
    return [this, queries, askers = std::array<std::shared_ptr<QueryAsker>, 3>()](std::size_t item) mutable {
      Packer packer;
      std::size_t number = item * kQueriesAnItem;
      for (const QueryLine& query : queries_of(queries, item)) {
        const std::size_t stage = ground_->stage_of(number++);
        if (!askers[stage]) askers[stage] = ground_->lend(stage);
        pack(askers[stage]->ask(query), packer);
      }
      return std::move(packer).bytes();
    };
  }

  static std::span<const QueryLine> queries_of(std::span<const QueryLine> queries, std::size_t item) {
    const std::size_t first = item * kQueriesAnItem;
    return queries.subspan(first, std::min(kQueriesAnItem, queries.size() - first));
  }

  const BatchOptions& options_;
  Run& run_;
  BatchAnswers answers_;
  std::optional<Ground> ground_;  // of shards
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
