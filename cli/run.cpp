#include <taut/cli/run.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <mutex>
#include <tuple>
#include <utility>

#include <taut/cli/messages.h>
#include <taut/cli/output.h>
#include <taut/cli/progress.h>
#include <taut/cli/stop.h>
#include <taut/geometry/errors.h>
#include <taut/io/pictures/rasterised.h>
#include <taut/web/page.h>

namespace taut::cli {

namespace {

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  return !b.empty() && b != "-" &&
         std::filesystem::weakly_canonical(a, error) == std::filesystem::weakly_canonical(b, error);
}

bool is_png(std::string_view name) { return name.ends_with(".png") || name.ends_with(".PNG"); }

std::string png_of(const OutputFile& file) {
  try {
    return rasterised(file.bytes);
  } catch (const RasterError& error) {
    throw WriteError(file.name + ": cannot write a PNG: " + error.what());
  }
}

/// A film is played there, and any picture looked at from near.
void make_pages(std::vector<OutputFile>& files) {
  for (OutputFile& file : files)
    if (file.name.ends_with(".html") && file.bytes.starts_with("<svg"))
      file.bytes = web::page(json_line(Json{{"name", title_of(file.name)}, {"film", file.bytes}}), {});
}

std::string shown(const std::string& file) { return file == "-" ? "<stdin>" : file; }

}  // namespace

struct Run::Shared {
  std::timed_mutex mutex;
  Envelope envelope;
  std::vector<std::string> names;  // of inputs, with and without their folders
  std::vector<std::string> read, promised;
  std::string line;
  Json further = Json::object();  // members of the result
  std::function<std::pair<Json, std::string>()> tell;
  std::string json;    // the file, once promised
  bool prints = true;  // the line, when stopped
  taut::Stopwatch watch;

  std::string text(Outcome outcome, const std::string& reason, const std::string& stage) {
    envelope.outcome = outcome;
    envelope.reason = reason;
    envelope.stage = stage;
    envelope.total = watch.seconds();
    if (outcome != Outcome::refused)
      for (const auto& [key, value] : *further.members()) envelope.result[key] = value;
    return envelope_text(envelope);
  }

  // Only `convert` may replace what it reads.
  void refuse_replacement() {
    if (envelope.command == "convert") return;
    for (const std::string& input : read)
      for (const std::string& output : promised) {
        std::error_code error;  // a terminal may be both
        if (!is_same_file(input, output) || !std::filesystem::is_regular_file(output, error)) continue;
        if (is_same_file(output, json)) json.clear();
        throw InputError(output, 0, "cannot write: it is read");
      }
  }

  // When stopped or refused.
  void say(Outcome outcome, const std::string& reason, const std::string& stage) {
    if (!json.empty()) write_file(json, text(outcome, reason, stage), Patience::a_second);
  }

  // Also of names with line ends, which printable() would leave alone.
  void print_line(std::string text) const {
    for (const std::string& name : names) {
      if (name.find_first_of("\n\t") == std::string::npos) continue;
      std::string tame = name;
      std::ranges::replace_if(
          tame, [](char c) { return c == '\n' || c == '\t'; }, '?');
      for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos; at += tame.size())
        text.replace(at, name.size(), tame);
    }
    print(printable(text));
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
    if (shared->prints && !shared->line.empty()) shared->print_line(shared->line);
    shared->say(Outcome::stopped, why.reason, why.stage);
  });
  promise(options.json);
  shared_->json = options.json;
}

Run::~Run() = default;

void Run::promise(const std::string& file) {
  if (is_png(file) && !why_not_rasterised().empty())
    throw InputError(file, 0, "cannot write a PNG: " + why_not_rasterised());
  if (file == "-" && is_stdout_taken_) throw UsageError("only one output can have standard output");
  try {
    require_writable(file);
  } catch (const InputError&) {
    if (is_same_file(file, shared_->json)) shared_->json.clear();  // it is another output's: not to be touched
    throw;
  }
  if (file == "-") is_stdout_taken_ = true;
  const std::lock_guard lock(shared_->mutex);
  shared_->prints = is_talkative();
  shared_->promised.push_back(file);
  shared_->refuse_replacement();
}

void Run::source(const std::string& file) { sources({file}); }

void Run::sources(const std::vector<std::string>& files) {
  const std::lock_guard lock(shared_->mutex);
  std::string& all = shared_->envelope.source;
  all.clear();
  for (const std::string& file : files) {
    all += (all.empty() ? "" : " ") + shown(file);
    shared_->names.push_back(file);
    shared_->names.push_back(title_of(file));
    shared_->read.push_back(file);
  }
  shared_->refuse_replacement();
}

Seconds Run::seconds(const char* stage) const {
  const std::lock_guard lock(shared_->mutex);
  for (const StageTime& known : shared_->envelope.stages)
    if (known.stage == stage) return known.seconds;
  return {};
}

const std::string& Run::command() const { return shared_->envelope.command; }

Seconds Run::seconds() const { return shared_->watch.seconds(); }

bool Run::is_talkative() const { return !options_.quiet && !is_stdout_taken_; }

void Run::so_far(Json result, std::string line) {
  const std::lock_guard lock(shared_->mutex);
  std::swap(shared_->envelope.result, result);
  std::swap(shared_->line, line);
}

void Run::add_to_result(std::string_view name, Json value) {
  const std::lock_guard lock(shared_->mutex);
  Json& member = shared_->further[name];
  if (member.is_null() || !value.items()) {
    member = std::move(value);
    return;
  }
  for (const Json& item : *value.items()) member.push_back(item);
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

// Pixels where the name asks for them. Limits still count: drawing may take a second.
void Run::rasterise(std::vector<OutputFile>& files) {
  for (OutputFile& file : files)
    if (is_png(file.name) && file.bytes.starts_with("<svg")) file.bytes = stage("draw", [&] { return png_of(file); });
}

// A stream may wait for its reader for ever, so limits count while it is written; what is stopped then tells all of it.
void Run::write_streams(const Answer& answer) {
  begin_stage("write");
  for (const OutputFile& file : answer.files)
    if (is_stream(file.name)) write_file(file.name, file.bytes);
  if (is_stream(options_.json)) say(answer);
}

int Run::end(Answer answer) {
  progress_over();
  rasterise(answer.files);
  make_pages(answer.files);
  const bool to_stream = is_stream(options_.json) || std::ranges::any_of(answer.files, is_stream, &OutputFile::name);
  if (!to_stream) finish();
  when_stopped({});
  so_far(std::move(answer.result), answer.line);
  if (to_stream) {
    write_streams(answer);
    finish();
  }
  for (const OutputFile& file : answer.files)
    if (!is_stream(file.name)) write_file(file.name, file.bytes);
  if (!is_stream(options_.json)) say(answer);
  if (is_talkative()) shared_->print_line(answer.line);
  if (!is_stdout_taken_) print(answer.listing);
  if (options_.stats) note_stages(answer);
  return exit_code(answer.outcome);
}

void Run::say(const Answer& answer) {
  // A copy: the thread that stops the program may want the original while this one waits for a reader.
  std::string text;
  {
    const std::lock_guard lock(shared_->mutex);
    text = shared_->text(answer.outcome, answer.reason, {});
  }
  if (wants_json()) write_file(options_.json, text);
}

int Run::refuse(const std::string& reason) noexcept {
  progress_over();
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
