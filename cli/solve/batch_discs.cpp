#include <taut/cli/solve/batch_discs.h>

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <optional>
#include <utility>
#include <vector>

#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/progress.h>
#include <taut/cli/solve/batch_answers.h>
#include <taut/cli/solve/batch_proofs.h>
#include <taut/cli/solve/query_source.h>
#include <taut/cli/world/geographic.h>
#include <taut/geometry/errors.h>
#include <taut/io/results/barrier_words.h>
#include <taut/io/worlds/query_lines.h>
#include <taut/search/passage_index.h>
#include <taut/search/radius_queries.h>
#include <taut/search/stopwatch.h>

namespace taut::cli {

namespace {

using Status = QueryAnswer::Status;

class DiscBatch {
 public:
  DiscBatch(const BatchOptions& options, Run& run)
      : options_(options), run_(run), answers_({run.is_talkative(), options.json_lines, false, run.wants_json()}) {
    run.when_stopped(answers_.last_words());
    run.promise(options.certificate);
  }

  int work() {
    std::ios::sync_with_stdio(false);
    QuerySource source(options_.queries);
    const Input input = read_input(options_.world, run_);
    shown_ = Shown(input.notes);
    const FreeSpace space = run_.stage("space", [&] { return triangulated(FreeSpace(input.world)); });
    if (!options_.certificate.empty()) proofs_.emplace(input.world);
    options_.widest ? answer_widest(space, source) : answer_arcs(space, source);
    note(answers_.totals());
    Answer answer;
    answer.outcome = answers_.outcome();
    answer.reason = answers_.reason();
    if (run_.wants_json()) answer.result = answers_.json();
    if (proofs_) add_proofs(answer);
    return run_.end(std::move(answer));
  }

 private:
  void answer_widest(const FreeSpace& space, QuerySource& source) {
    const PassageIndex index = run_.stage("index", [&] { return PassageIndex(space); });
    answers_.prepared_in(run_.seconds());
    run_.stage("search", [&] { answer_all(source, [&](const QueryLine& query) { return widest(index, query); }); });
  }

  void answer_arcs(const FreeSpace& space, QuerySource& source) {
    RadiusQueries graphs =
        run_.stage("index", [&] { return RadiusQueries(AllRadii(space, shown_progress(options_.common))); });
    answers_.prepared_in(run_.seconds());
    run_.stage("search", [&] { answer_all(source, [&](const QueryLine& query) { return arcs(graphs, query); }); });
  }

  void answer_all(QuerySource& source, const std::function<QueryAnswer(const QueryLine&)>& ask) {
    std::string line;
    const TellProgress show = shown_progress(options_.common);
    ProgressCount done("lines", show ? source.line_count() : 0, show);
    for (int number = 1; source.next(line); ++number, done.add()) {
      std::optional<QueryLine> query = read(line, source.name(), number);
      if (!query) continue;
      query->from = plane(query->from);
      query->to = plane(query->to);
      path_.reset();
      const QueryAnswer answer = ask(*query);
      answers_.add(*query, answer, source.name());
      if (proofs_) prove(*query, answer);
      answers_.flush(source.may_wait());
    }
    answers_.flush(true);
  }

  // A line that is wrong does not take the answers before it along.
  std::optional<QueryLine> read(const std::string& line, const std::string& name, int number) {
    try {
      return options_.arcs ? disc_query_line(line, name, number) : query_line(line, name, number);
    } catch (const InputError&) {
      answers_.flush(true);
      throw;
    }
  }

  Point plane(Point p) const { return shown_ ? shown_.geographic()->metres(p) : p; }

  static QueryAnswer blocked(const char* end) {
    QueryAnswer answer;
    answer.status = Status::blocked;
    answer.blocked = end;
    return answer;
  }

  QueryAnswer widest(const PassageIndex& index, const QueryLine& query) const {
    const Stopwatch watch;
    const PassagePlace s = index.place(query.from), g = index.place(query.to);
    if (s.outside || g.outside) return blocked(s.outside ? "start" : "goal");
    const auto found = index.widest(s, g);
    QueryAnswer answer;
    answer.measure = "radius";
    answer.cpu = watch.seconds().cpu;
    if (!found) return answer;
    answer.status = Status::found;
    answer.length = found->radius;
    if (options_.json_lines || run_.wants_json())
      answer.limit = limit_text(index.gates(), *found, query.from, query.to);
    return answer;
  }

  QueryAnswer arcs(RadiusQueries& graphs, const QueryLine& query) {
    Stopwatch watch;
    const std::size_t made = graphs.graphs_made();
    ArcQueries* graph = graphs.graph(query.radius);
    if (graphs.graphs_made() > made) {
      answers_.prepared_in(watch.seconds());
      watch = Stopwatch();
    }
    ArcSearchResult result =
        graph ? graph->find(query.from, query.to) : arc_search(graphs.all(), query.radius, query.from, query.to);
    if (result.status == DiscStatus::start_blocked) return blocked("start");
    if (result.status == DiscStatus::goal_blocked) return blocked("goal");
    QueryAnswer answer;
    answer.cpu = watch.seconds().cpu;
    if (result.status == DiscStatus::none) return answer;
    answer.status = Status::found;
    answer.length = result.path.value();
    path_ = std::move(result.path);
    return answer;
  }

  void prove(const QueryLine& query, const QueryAnswer& answer) {
    if (path_)
      proofs_->add_arcs(query.line, *path_);
    else if (answer.status == Status::none)
      proofs_->add_none(query.line, query.from, query.to, query.radius);
  }

  void add_proofs(Answer& answer) const {
    answer.files.push_back({options_.certificate, proofs_->text()});
    if (proofs_->missing() == 0 || exit_code(answer.outcome) != 0) return;
    answer.outcome = Outcome::unproven;
    answer.reason = count_text(proofs_->missing(), "answer") + " without a certificate";
  }

  const BatchOptions& options_;
  Run& run_;
  BatchAnswers answers_;
  Shown shown_{ReadNotes{}};
  std::optional<DiscProofs> proofs_;
  std::optional<ArcPath> path_;  // of the query answered last
};

}  // namespace

void require_disc_options(const BatchOptions& options) {
  const char* mode = options.widest ? "--widest" : "--arcs";
  if (options.query.robot.kind() != Footprint::Kind::point)
    throw UsageError(fmt::format("--robot: {}",
                                 options.widest ? "--widest is of all discs" : "with --arcs each line has its radius"));
  if (options.query.snap_ends) throw UsageError(fmt::format("--snap-ends does not go with {}", mode));
  if (options.index.wanted() || !options.index.save.empty())
    throw UsageError(fmt::format("--index does not go with {}: it has one of its own", mode));
  if (options.shards.is_shared()) throw UsageError(fmt::format("--shard does not go with {}", mode));
  if (options.widest && !options.certificate.empty()) throw UsageError("--certificate does not go with --widest");
  if (options.path) throw UsageError(fmt::format("--path does not go with {}", mode));
}

int answer_disc_queries(const BatchOptions& options, Run& run) { return DiscBatch(options, run).work(); }

}  // namespace taut::cli
