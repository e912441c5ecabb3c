#include <taut/cli/run.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <tuple>
#include <utility>

#include <taut/cli/messages.h>
#include <taut/cli/output.h>
#include <taut/cli/report.h>
#include <taut/cli/stop.h>

namespace taut::cli {

namespace {

std::string shown(const std::string& file) { return file == "-" ? "<stdin>" : file; }

}  // namespace

struct Run::Shared {
  std::timed_mutex mutex;
  Envelope envelope;
  std::string line;
  std::function<std::pair<Json, std::string>()> tell;
  std::string json;    // the file, once promised
  bool prints = true;  // the line, when stopped
  taut::Stopwatch watch;

  // Whole or not at all: without the mutex there is only what never changes.
  void say(Outcome outcome, const std::string& reason, const std::string& stage) {
    if (json.empty()) return;
    envelope.outcome = outcome;
    envelope.reason = reason;
    envelope.stage = stage;
    envelope.total = watch.seconds();
    write_file(json, envelope_text(envelope));
  }
};

Run::StageClock::StageClock(Run& run, const char* name) : run_(run), name_(name) { begin_stage(name); }

Run::StageClock::~StageClock() {
  const Seconds took = watch_.seconds();
  const std::lock_guard lock(run_.shared_->mutex);
  std::vector<StageTime>& stages = run_.shared_->envelope.stages;
  for (StageTime& known : stages)
    if (known.stage == name_) {
      known.seconds += took;
      return;
    }
  stages.push_back({name_, took});
}

Run::Run(std::string command, const CommonOptions& options) : options_(options), shared_(std::make_shared<Shared>()) {
  shared_->envelope.version = TAUT_VERSION;
  shared_->envelope.command = std::move(command);
  on_stop([shared = shared_](const Stop& why) {
    const std::unique_lock lock(shared->mutex, std::chrono::milliseconds(200));
    if (!lock.owns_lock()) return;  // memory ran out in the thread that holds it
    if (shared->tell) std::tie(shared->envelope.result, shared->line) = shared->tell();
    if (shared->prints && !shared->line.empty()) print(shared->line);
    shared->say(Outcome::stopped, why.reason, why.stage);
  });
  promise(options.json);
  shared_->json = options.json;
}

Run::~Run() = default;

void Run::promise(const std::string& file) {
  require_writable(file);
  if (file == "-") is_stdout_taken_ = true;
  const std::lock_guard lock(shared_->mutex);
  shared_->prints = is_talkative();
}

void Run::source(const std::string& file) {
  const std::lock_guard lock(shared_->mutex);
  shared_->envelope.source = shown(file);
}

void Run::sources(const std::vector<std::string>& files) {
  std::string all;
  for (const std::string& file : files) all += (all.empty() ? "" : " ") + shown(file);
  source(all);
}

Seconds Run::seconds(const char* stage) const {
  const std::lock_guard lock(shared_->mutex);
  for (const StageTime& known : shared_->envelope.stages)
    if (known.stage == stage) return known.seconds;
  return {};
}

Seconds Run::seconds() const { return shared_->watch.seconds(); }

bool Run::is_talkative() const { return !options_.quiet && !is_stdout_taken_; }

void Run::so_far(Json result, std::string line) {
  const std::lock_guard lock(shared_->mutex);
  std::swap(shared_->envelope.result, result);
  std::swap(shared_->line, line);
}

void Run::when_stopped(std::function<std::pair<Json, std::string>()> tell) {
  const std::lock_guard lock(shared_->mutex);
  shared_->tell = std::move(tell);
}

// A line a stage, then what is none, then all of it.
void Run::note_stages(const Answer& answer) const {
  const auto line = [](const std::string& name, const Seconds& s, const std::string& what) {
    note(fmt::format("{:<12} cpu {:.4f} s, wall {:.4f} s{}{}", name, s.cpu, s.wall, what.empty() ? "" : "  ", what));
  };
  const std::lock_guard lock(shared_->mutex);
  std::vector<std::pair<std::string, std::string>> rest = answer.stats;
  for (const StageTime& stage : shared_->envelope.stages) {
    const auto said = std::ranges::find(rest, stage.stage, &std::pair<std::string, std::string>::first);
    line(stage.stage, stage.seconds, said == rest.end() ? "" : said->second);
    if (said != rest.end()) rest.erase(said);
  }
  for (const auto& [name, what] : rest) note(fmt::format("{:<12} {}", name, what));
  line("total", seconds(), "peak memory " + peak_memory_text());
}

int Run::end(Answer answer) {
  begin_stage("write");
  finish();
  for (const OutputFile& file : answer.files) write_file(file.name, file.bytes);
  if (wants_json()) {
    so_far(std::move(answer.result));
    const std::lock_guard lock(shared_->mutex);
    shared_->say(answer.outcome, answer.reason, {});
  }
  if (is_talkative()) print(answer.line);
  if (!is_stdout_taken_) print(answer.listing);
  if (options_.stats) note_stages(answer);
  return exit_code(answer.outcome);
}

int Run::refuse(const std::string& reason) noexcept {
  finish();
  try {
    const std::lock_guard lock(shared_->mutex);
    shared_->envelope.result = nullptr;
    shared_->say(Outcome::refused, reason, {});
  } catch (...) {
    complain("and could not write the result that says so");
  }
  return exit_code(Outcome::refused);
}

}  // namespace taut::cli
