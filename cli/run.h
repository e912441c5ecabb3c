// One run of a subcommand, from its promises to its exit code: what each would otherwise do by itself.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <taut/cli/options.h>
#include <taut/io/results/envelope.h>
#include <taut/search/stopwatch.h>

namespace taut::cli {

/// A file to be written: `-` is standard output, an empty name is nothing at all.
struct OutputFile {
  std::string name;
  std::string bytes;
};

/// What came of it.
struct Answer {
  Outcome outcome = Outcome::done;
  std::string reason{};   ///< why it is not found or done
  Json result{};          ///< goes into the envelope
  std::string line{};     ///< for people, with its line end; none with --quiet. Printed as printable()
  std::string listing{};  ///< asked for by an option of its own, as --path: printed with --quiet, too
  /// What to say of stages with --stats: `read`, `segments, 914 walls`. Names that were no stage go below them.
  std::vector<std::pair<std::string, std::string>> stats{};
  std::vector<OutputFile> files{};  ///< pictures and the like; --json's is written by end()
};

/// How a run goes: promise() what will be written, do the work in stages, tell what is so_far() done, end().
///
///  1. --json gets an envelope however the run ends: found, none, refused, stopped by a limit or an interrupt.
///  2. Other files are written at the end alone, when nothing can go wrong any more but writing itself. Of a picture a
///     name in .png gets pixels, one in .html a page (web/page.h). Pipes come first and limits still hold for them.
///  3. Of a run that is stopped what so_far() was told last is written and printed, with status `stopped`.
class Run {
 public:
  /// `command` as in the envelope. `options` must outlive the run. Promises --json's file: throws InputError.
  Run(std::string command, const CommonOptions& options);
  ~Run();

  /// Throws InputError where no file of that name can be made. `-` is standard output: then no line is printed; a
  /// second one is a UsageError.
  void promise(const std::string& file);
  /// The input's name for the envelope, `-` being <stdin>.
  void source(const std::string& file);
  void sources(const std::vector<std::string>& files);

  /// What `work` gives; named for messages and the envelope, and timed.
  template <typename Work>
  auto stage(const char* name, Work work) {
    const StageClock clock(*this, name);
    return work();
  }

  /// The stage's time, all of that name together.
  Seconds seconds(const char* stage) const;
  Seconds seconds() const;  ///< since the run began

  const std::string& command() const;  ///< as in the envelope
  const CommonOptions& options() const { return options_; }
  bool wants_json() const { return !options_.json.empty(); }
  /// Does the line go to standard output?
  bool is_talkative() const;

  /// What to write if the run is stopped now: a copy is kept. Cheap to call when something is finished, not in loops.
  void so_far(Json result, std::string line = {});
  /// A member of the result, however the run ends, after its own; the items of an array go behind those that are there.
  /// Not when it is refused.
  void add_to_result(std::string_view name, Json value);
  /// For what grows with every item: `tell` is asked once the run is stopped, for the result and the line. It runs in
  /// the thread that stops the program, beside the work: it needs a lock of its own, and must not wait for it for long.
  void when_stopped(std::function<std::pair<Json, std::string>()> tell);

  /// Writes it all, prints, and gives the exit code. Called once, last.
  int end(Answer answer);
  /// The input was wrong: the envelope says so, nothing else is written. Gives the exit code.
  int refuse(const std::string& reason) noexcept;

 private:
  // Begins a stage and adds what it took.
  class StageClock {
   public:
    StageClock(Run& run, const char* name);
    ~StageClock();
    StageClock(const StageClock&) = delete;
    StageClock& operator=(const StageClock&) = delete;

   private:
    Run& run_;
    const char* name_;
    taut::Stopwatch watch_;
  };
  struct Shared;

  void note_stages(const Answer& answer) const;
  void rasterise(std::vector<OutputFile>& files);
  void write_streams(const Answer& answer);
  void say(const Answer& answer);

  const CommonOptions& options_;
  bool is_stdout_taken_ = false;
  std::shared_ptr<Shared> shared_;  // with the thread that stops the program
};

/// Of many small results each telling costs as much as all that came before. So after the first a telling is left out
/// while they have taken more than a tenth of the time: what a stop then loses took next to nothing.
class Keeping {
 public:
  template <typename Tell>
  void tell(Tell tell) {
    if (spent_ > kShare * whole_.seconds().wall) return;
    const taut::Stopwatch watch;
    tell();
    spent_ += watch.seconds().wall;
  }

 private:
  static constexpr double kShare = 0.1;

  taut::Stopwatch whole_;
  double spent_ = 0;
};

}  // namespace taut::cli
