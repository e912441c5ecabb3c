#include <taut/cli/solve/batch_answers.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>

#include <taut/cli/messages.h>
#include <taut/cli/output.h>
#include <taut/io/results/words.h>

namespace taut::cli {

namespace {

constexpr std::size_t kBlock = 1 << 16;  // of results, where nobody waits for each

using Status = QueryAnswer::Status;

const char* name(Status status) {
  static constexpr const char* kNames[] = {"found", "none", "blocked", "unproven"};
  return kNames[static_cast<int>(status)];
}

bool matches(const QueryLine& query, const QueryAnswer& answer) {
  if (!query.expects || answer.status == Status::unproven) return true;
  const bool found = answer.status == Status::found;
  return query.expected ? found && std::abs(answer.length - *query.expected) <= query.tolerance : !found;
}

std::string line_of(const QueryLine& query, const QueryAnswer& answer) {
  std::string line = fmt::format("{} {}", query.line,
                                 answer.status == Status::found ? number_text(answer.length) : name(answer.status));
  for (const Point& p : answer.points) line += " " + number_text(p.x) + " " + number_text(p.y);
  return line + "\n";
}

Json json_of(const QueryLine& query, const QueryAnswer& answer, bool with_path) {
  Json row{{"line", query.line}, {"status", name(answer.status)}};
  if (answer.status == Status::blocked) row["blocked"] = answer.blocked;
  if (answer.nearest) {
    row["nearest"] = answer.nearest->point;
    row["distance"] = answer.nearest->distance;
  }
  if (answer.status == Status::found) row[answer.measure] = answer.length;
  if (!answer.limit.empty()) row["limit"] = answer.limit;
  if (query.expects && answer.status != Status::unproven) {
    row["expected"] = query.expected ? Json(*query.expected) : Json("none");
    row["matches"] = matches(query, answer);
  }
  if (with_path && answer.status == Status::found) row["path"] = answer.points;
  if (!answer.moves.empty()) row["moved_ends"] = end_moves_json(answer.moves);
  return row;
}

}  // namespace

struct BatchAnswers::State {
  explicit State(const AnswerForm& f) : form(f) {}

  const AnswerForm form;
  std::timed_mutex mutex;
  std::string out;
  Json rows = Json::array();
  std::size_t queries = 0, unanswered = 0, unproven = 0, compared = 0, mismatches = 0, moved = 0;
  double farthest = 0;  // that an end was moved
  double cpu = 0, prepared = 0;

  double cpu_a_query() const { return queries == 0 ? 0 : cpu / static_cast<double>(queries); }

  void count(const QueryLine& query, const QueryAnswer& answer) {
    const bool is_unproven = answer.status == Status::unproven;
    ++queries;
    moved += answer.moves.size();
    for (const EndMove& move : answer.moves) farthest = std::max(farthest, move.place.distance);
    cpu += answer.cpu;
    compared += query.expects && !is_unproven;
    unproven += is_unproven;
    unanswered += answer.status != Status::found && !is_unproven && !(query.expects && !query.expected);
    mismatches += !matches(query, answer);
  }

  std::string totals() const {
    return fmt::format(
        "{}, {} without an answer, {}{}{} compared, {}; {:.1f} us CPU a query, {} CPU to prepare",
        count_text(queries, "query", "queries"), unanswered,
        unproven == 0 ? "" : fmt::format("{} unproven, ", unproven),
        moved == 0 ? "" : fmt::format("{} moved by {:.6g} at most, ", count_text(moved, "end"), farthest), compared,
        count_text(mismatches, "mismatch", "mismatches"), 1e6 * cpu_a_query(), seconds_text(prepared));
  }

  Json json() const {
    return {{"queries", queries},
            {"unanswered", unanswered},
            {"unproven", unproven},
            {"compared", compared},
            {"mismatches", mismatches},
            {"seconds_a_query", cpu_a_query()},
            {"seconds_to_prepare", prepared},
            {"answers", rows}};
  }
};

BatchAnswers::BatchAnswers(const AnswerForm& form) : state_(std::make_shared<State>(form)) {}
BatchAnswers::~BatchAnswers() = default;

void BatchAnswers::add(const QueryLine& query, const QueryAnswer& answer, const std::string& source) {
  if (!matches(query, answer))
    complain(fmt::format("{}:{}: expected {}, found {}", source, query.line,
                         query.expected ? number_text(*query.expected) : "none",
                         answer.status == Status::found ? number_text(answer.length) : name(answer.status)));
  const std::lock_guard lock(state_->mutex);
  state_->count(query, answer);
  const AnswerForm& form = state_->form;
  if (form.keeps) state_->rows.push_back(json_of(query, answer, form.path));
  if (form.prints)
    state_->out += form.json ? json_line(json_of(query, answer, form.path)) + "\n" : line_of(query, answer);
}

// Printed with the lock held: who stops the program waits until the block is out.
void BatchAnswers::flush(bool now) {
  const std::lock_guard lock(state_->mutex);
  if (state_->out.empty() || (!now && state_->out.size() < kBlock)) return;
  print(std::exchange(state_->out, {}));
}

void BatchAnswers::prepared_in(const Seconds& seconds) {
  const std::lock_guard lock(state_->mutex);
  state_->prepared += seconds.cpu;
}

Outcome BatchAnswers::outcome() const {
  return state_->unproven > 0     ? Outcome::unproven
         : state_->mismatches > 0 ? Outcome::differs
         : state_->unanswered > 0 ? Outcome::none
                                  : Outcome::done;
}

std::string BatchAnswers::reason() const {
  switch (outcome()) {
    case Outcome::unproven: return fmt::format("{} unproven", count_text(state_->unproven, "query", "queries"));
    case Outcome::differs: return count_text(state_->mismatches, "mismatch", "mismatches");
    case Outcome::none: return fmt::format("{} without an answer", count_text(state_->unanswered, "query", "queries"));
    default: return {};
  }
}

std::string BatchAnswers::totals() const { return state_->totals(); }

Json BatchAnswers::json() const { return state_->json(); }

std::function<std::pair<Json, std::string>()> BatchAnswers::last_words() const {
  return [state = state_]() -> std::pair<Json, std::string> {
    const std::unique_lock lock(state->mutex, std::chrono::seconds(1));
    if (!lock.owns_lock()) return {};
    note(state->totals());
    return {state->json(), std::exchange(state->out, {})};
  };
}

}  // namespace taut::cli
