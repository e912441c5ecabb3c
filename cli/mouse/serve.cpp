// taut mouse serve: a program in any language is the robot, one line a step.
#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <string>
#include <string_view>

#include <taut/cli/command_line.h>
#include <taut/cli/messages.h>
#include <taut/cli/mouse/mouse.h>
#include <taut/cli/output.h>
#include <taut/cli/run.h>
#include <taut/geometry/errors.h>
#include <taut/io/results/mouse_json.h>

namespace taut::cli {

namespace {

using micromouse::Action;
using micromouse::Record;
using micromouse::SensorReading;
using micromouse::TrialStatus;

constexpr const char* kFooter =
    "The robot reads `left front right` (open cells up to the next wall), answers `rotation movement` (-90, 0 or 90;\n"
    "-3 to 3, negative backwards) or `reset`, and so on. Lines of its own that begin with # are skipped. In the end it "
    "reads\n`score S run1 N run2 M`, or `failed REASON`. Other numbers are taken as the rules say, with a note on "
    "standard error;\nanything else ends the trial with exit code 3.\n";

struct ServeOptions {
  MazeOptions maze;
  CommonOptions common;
  int max_steps = micromouse::kMaxSteps;
  bool hello = false;
};

void add_options(CommandLine& app, ServeOptions& options) {
  add_maze_options(app, options.maze);
  add_max_steps_option(app, options.max_steps);
  app.add_flag("--hello", options.hello,
               "First write a line `maze WIDTH HEIGHT START-X START-Y MAX-STEPS`, then `goal X Y X Y ...`");
  app.callback([&options] {
    if (options.common.json == "-") throw UsageError("--json: standard output is the robot's");
  });
  app.footer(kFooter);
  app.example("mkfifo back; taut mouse serve maze.txt < back | robot > back");
}

/// Standard input line by line, read as it comes.
class Lines {
 public:
  /// False at the end.
  bool next(std::string& line) {
    ++number_;
    std::size_t end = 0;
    while ((end = buffer_.find('\n')) == std::string::npos) {
      if (buffer_.size() > kLongest) throw InputError("<stdin>", number_, "the line is too long");
      if (!more()) break;
    }
    if (end == std::string::npos && buffer_.empty()) return false;
    line = buffer_.substr(0, end);
    buffer_.erase(0, end == std::string::npos ? end : end + 1);
    return true;
  }
  int number() const { return number_; }

 private:
  static constexpr std::size_t kLongest = 1000;

  bool more() {
    char bytes[512];
    ssize_t n = 0;
    do n = ::read(STDIN_FILENO, bytes, sizeof bytes);
    while (n < 0 && errno == EINTR);
    if (n < 0) throw InputError("<stdin>", number_, "cannot be read");
    buffer_.append(bytes, static_cast<std::size_t>(n));
    return n > 0;
  }

  std::string buffer_;
  int number_ = 0;
};

std::string_view word_of(std::string_view& rest) {
  constexpr std::string_view kBlank = " \t\r";
  const std::size_t from = std::min(rest.find_first_not_of(kBlank), rest.size());
  const std::size_t to = std::min(rest.find_first_of(kBlank, from), rest.size());
  const std::string_view word = rest.substr(from, to - from);
  rest.remove_prefix(to);
  return word;
}

bool is_number(std::string_view word, int& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc{} && end == word.data() + word.size();
}

/// The robot at the other end of standard input and output.
class ServedRobot : public micromouse::Robot {
 public:
  Action next(const SensorReading& sight) override {
    print(fmt::format("{} {} {}\n", sight.left, sight.front, sight.right));
    std::string line;
    while (true) {
      if (!lines_.next(line))
        throw InputError("<stdin>", lines_.number(),
                         fmt::format("ends after step {} of a trial that is not over", steps_));
      std::string_view rest = line;
      const std::string_view first = word_of(rest);
      if (first.empty() || first.starts_with('#')) continue;
      ++steps_;
      return action_of(first, rest);
    }
  }

  int line() const { return lines_.number(); }

 private:
  Action action_of(std::string_view first, std::string_view rest) const {
    const std::string_view second = word_of(rest), third = word_of(rest);
    if (first == "reset" && second.empty()) return micromouse::kReset;
    Action action;
    if (!is_number(first, action.rotation) || !is_number(second, action.movement) || !third.empty())
      throw InputError("<stdin>", lines_.number(), "this is neither `rotation movement` nor `reset`");
    return action;
  }

  Lines lines_;
  int steps_ = 0;
};

std::string goal_line(const micromouse::Task& task) {
  std::string out = "goal";
  for (const Cell c : task.goal) out += fmt::format(" {} {}", c.x, c.y);
  return out + "\n";
}

/// What is known of a trial that is not over.
Json counts_of(const Record& record) {
  return {{"run1", record.run1}, {"run2", record.run2}, {"goal_at", record.goal_at}};
}

Record serve(const GridMazeInput& read, const ServeOptions& options, Run& run) {
  micromouse::Trial trial(read.maze, options.max_steps);
  const micromouse::Task& task = trial.task();
  if (options.hello && !trial.over())
    print(fmt::format("maze {} {} {} {} {}\n", task.width, task.height, task.start.x, task.start.y, task.max_steps) +
          goal_line(task));
  ServedRobot robot;
  while (!trial.over()) {
    const micromouse::Step& step = trial.act(robot.next(trial.sight()));
    if (step.offence != micromouse::Offence::none)
      note(fmt::format("taut: <stdin>:{}: {}; it counts as a step", robot.line(), name(step.offence)));
    run.so_far(counts_of(trial.record()));
  }
  return trial.record();
}

int run(const ServeOptions& options, Run& run) {
  if (options.maze.file == "-") throw InputError("<stdin>", 0, "cannot be the maze, it is the robot");
  std::signal(SIGPIPE, SIG_IGN);  // a robot that has gone is a line and an exit code
  run.source(options.maze.file);
  const GridMazeInput read = run.stage("read", [&] { return read_mouse_maze(options.maze.file, options.maze.format); });
  const auto yardsticks = run.stage("optimum", [&] { return micromouse::yardsticks(read.maze); });
  if (!yardsticks) return no_route(read.name, run);
  MouseTrial trial{run.stage("serve", [&] { return serve(read, options, run); }), *yardsticks};
  const Record& record = trial.record;
  trial.certificate = micromouse::certificate(record);
  const bool finished = record.status == TrialStatus::finished;
  const std::string last =
      finished ? fmt::format("score {:.3f} run1 {} run2 {}\n", *record.score(), record.run1, record.run2)
               : fmt::format("failed {}\n", name(record.status));
  return run.end({.outcome = finished ? Outcome::found : Outcome::unproven,
                  .reason = finished ? "" : std::string(name(record.status)),
                  .result = mouse_trial_json(trial),
                  .listing = last});
}

}  // namespace

Command mouse_serve_command(CommandLine& group) {
  return command<ServeOptions>(group, "serve", "Let a program be the robot, by lines on standard input and output",
                               add_options, run);
}

}  // namespace taut::cli
