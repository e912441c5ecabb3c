// taut batch: many queries on one world, streamed.
#include <fmt/format.h>

#include <algorithm>
#include <array>
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
#include <taut/cli/progress.h>
#include <taut/cli/run.h>
#include <taut/cli/shards.h>
#include <taut/cli/solve/batch_answers.h>
#include <taut/cli/solve/batch_discs.h>
#include <taut/cli/solve/batch_ground.h>
#include <taut/cli/solve/batch_options.h>
#include <taut/cli/solve/batch_proofs.h>
#include <taut/cli/solve/index_option.h>
#include <taut/cli/solve/packed_answer.h>
#include <taut/cli/solve/query_blocks.h>
#include <taut/cli/world/snap_ends.h>
#include <taut/geometry/errors.h>
#include <taut/io/saved/packed.h>
#include <taut/io/saved/roadmap_file.h>
#include <taut/io/saved/shard_file.h>
#include <taut/io/worlds/query_lines.h>

namespace taut::cli {

namespace {

constexpr std::size_t kQueriesAnItem = 256;  // of shards

void require_certificate_options(const BatchOptions& options) {
  if (options.query.robot.kind() == Footprint::Kind::disc || options.world.read.project)
    throw UsageError("--certificate does not go with --robot disc:R and --project");
  if (options.shards.is_shared()) throw UsageError("--certificate goes with a run of its own, not with what is shared");
}

void add_options(CommandLine& app, BatchOptions& options) {
  add_world_options(app, options.world);
  app.add_option(
         "QUERIES", options.queries,
         "Lines `sx sy gx gy [length]`, `#` starts a comment; - is standard input. Where a length is given, or "
         "`none`, it is compared to 1e-6. `+wall x1 y1 x2 y2` adds a wall for the queries after it, `-wall x1 y1 x2 "
         "y2` "
         "takes a wall, or a stretch of one, away. Or a MovingAI scenario file between corners of cells, as the "
         "any-angle sets have it; compared as far as its digits go")
      .required();
  add_robot_option(app, options.query.robot);
  add_snap_ends_option(app, options.query.snap_ends);
  add_index_options(app, options.index);
  app.add_flag("--json-lines", options.json_lines, "Print one JSON object a line instead").group("Output");
  app.add_flag("--path", options.path,
               "The points of each path as well: ` x y x y ...` after the length, `path` in JSON")
      .group("Output");
  app.add_flag("--widest", options.widest,
               "The radius of the largest disc that gets from start to goal, instead of the path's length");
  app.add_flag("--arcs", options.arcs,
               "The shortest paths of discs, with arcs around corners: lines `sx sy gx gy r [length]`")
      .excludes("--widest");
  app.add_option("--certificate", options.certificate, "Write a proof of every answer, in one file for `taut verify`")
      .type_name("FILE")
      .group("Output");
  add_jobs_option(app, options.common.limits);
  add_shard_options(app, options.shards, options.common);
  app.callback([&options] {
    if (options.widest || options.arcs) require_disc_options(options);
    if (!options.certificate.empty()) require_certificate_options(options);
    if (options.queries == "-" && options.world.file == "-")
      throw UsageError("FILE and QUERIES cannot both come from standard input");
    if (options.shards.is_shared() && !options.index.save.empty())
      throw UsageError("--save-index goes with a run of its own, not with what is shared");
  });
  app.example("taut batch maze.txt queries.txt");
  app.example("taut batch maze.txt queries.txt --json-lines --path");
  app.example("taut batch maze.txt queries.txt --save-index maze.index");
  app.example("taut batch maze.txt queries.txt --widest");
}

class Batch {
 public:
  Batch(const BatchOptions& options, Run& run)
      : options_(options),
        run_(run),
        answers_({run.is_talkative(), options.json_lines, options.path, run.wants_json()}) {
    run.promise(options.index.save);
    run.promise(options.certificate);
    run.when_stopped(answers_.last_words());
  }

  int work() {
    std::ios::sync_with_stdio(false);
    QuerySource source(options_.queries);
    const Input input = read_input(options_.world, run_);
    if (options_.shards.is_shared()) return share(source, input);
    BatchGround ground(options_, input, run_);
    if (!options_.certificate.empty()) proofs_.emplace(ground.space());
    answers_.prepared_in(run_.seconds());
    run_.stage("search", [&] { answer_all(source, input, ground); });
    return end(ground.index());
  }

 private:
  void answer_all(QuerySource& source, const Input& input, BatchGround& ground) {
    QueryBlocks blocks(source, input, ground.shown(), options_.common.limits.jobs);
    const TellProgress show = shown_progress(options_.common);
    const std::size_t lines = show ? source.line_count() : 0;
    if (show) show({"lines", 0, lines});
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
        if (proofs_) prove(query, answer);
        if (show) show({"lines", static_cast<std::size_t>(query.line), lines});
      });
      if (!wrong && blocks.wall()) wrong = changed(ground, *blocks.wall(), source.name(), blocks.line());
      answers_.prepared_in(ground.prepared());
      answers_.flush(!more || wrong || source.may_wait());
      if (wrong) std::rethrow_exception(wrong);
    }
  }

  std::exception_ptr changed(BatchGround& ground, const WallLine& wall, const std::string& source, int line) const {
    try {
      if (proofs_) throw InputError(source, line, "--certificate is of a world whose walls stay as they are");
      ground.change(wall, source, line);
      return nullptr;
    } catch (const InputError&) {
      return std::current_exception();
    }
  }

  void prove(const QueryLine& query, const QueryAnswer& answer) {
    Point from = query.from, to = query.to;
    for (const EndMove& move : answer.moves) (std::string_view(move.role) == "start" ? from : to) = move.place.point;
    if (answer.status == QueryAnswer::Status::found)
      proofs_->add(query.line, Path{answer.points, Length(answer.points)}, from, to);
    else if (answer.status == QueryAnswer::Status::none)
      proofs_->add(query.line, std::nullopt, from, to);
  }

  void add_proofs(Answer& answer) const {
    answer.files.push_back({options_.certificate, proofs_->text()});
    if (proofs_->missing() == 0 || exit_code(answer.outcome) != 0) return;
    answer.outcome = Outcome::unproven;
    answer.reason = count_text(proofs_->missing(), "answer") + " without a certificate";
  }

  int end(const std::optional<Index>& index = {}) {
    note(answers_.totals());
    Answer answer;
    answer.outcome = answers_.outcome();
    answer.reason = answers_.reason();
    if (run_.wants_json()) answer.result = answers_.json();
    if (index) add_index(options_.index, *index, answer);
    if (proofs_) add_proofs(answer);
    return run_.end(std::move(answer));
  }

  int share(QuerySource& source, const Input& input) {
    const Shown shown(input.notes);
    QueryBlocks blocks(source, input, shown, 1);
    std::vector<QueryLine> queries;
    for (bool more = true; more;) {
      more = blocks.next(queries);
      if (blocks.wall())
        throw InputError(source.name(), blocks.line(), "walls change in a run of its own only, not in what is shared");
    }
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
  std::optional<BatchProofs> proofs_;
  std::optional<BatchGround> ground_;  // of shards
};

int run(const BatchOptions& options, Run& run) {
  run.sources({options.world.file, options.queries});
  if (options.widest || options.arcs) return answer_disc_queries(options, run);
  return Batch(options, run).work();
}

}  // namespace

Command batch_command(CommandLine& app) {
  return command<BatchOptions>(app, "batch", "Answer many queries on one world, one a line", add_options, run);
}

}  // namespace taut::cli
