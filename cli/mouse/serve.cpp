// taut mouse serve: a program in any language is the robot, one line a step.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <csignal>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include <taut/cli/command_line.h>
#include <taut/cli/messages.h>
#include <taut/cli/mouse/mouse.h>
#include <taut/cli/mouse/report.h>
#include <taut/cli/mouse/robot_lines.h>
#include <taut/cli/run.h>
#include <taut/geometry/errors.h>
#include <taut/io/results/mouse_json.h>
#include <taut/robots/micromouse/line_words.h>
#include <taut/robots/micromouse/mms.h>

namespace taut::cli {

namespace {

using micromouse::Action;
using micromouse::Record;
using micromouse::SensorReading;
using micromouse::Trial;
using micromouse::TrialStatus;

constexpr const char* kFooter =
    "The robot reads `left front right` (open cells up to the next wall), answers `rotation movement` (-90, 0 or 90;\n"
    "-3 to 3, negative backwards) or `reset`, and so on. Lines of its own that begin with # are skipped. In the end it "
    "reads\n`score S run1 N run2 M`, or `failed REASON`. Other numbers are taken as the rules say, with a note on "
    "standard error;\nanything else ends the trial with exit code 3.\n";

constexpr int kMostQuestions = 100'000;  // of mms's protocol, without a step

struct ServeOptions {
  MazeOptions maze;
  CommonOptions common;
  int max_steps = micromouse::kMaxSteps;
  bool hello = false;
  std::string robot;
  bool mms = false;
  bool no_button = false;
  int answer_ms = 30'000;
  MouseReport report;
};

bool takes_standard_output(const ServeOptions& o) {
  for (const std::string* file :
       {&o.common.json, &o.report.svg, &o.report.animation, &o.report.values, &o.report.certificate})
    if (*file == "-") return true;
  return false;
}

void add_options(CommandLine& app, ServeOptions& options) {
  add_maze_options(app, options.maze);
  add_max_steps_option(app, options.max_steps);
  app.add_option("--robot", options.robot,
                 "Start this command of the shell as the robot; report the trial as `run` does")
      .type_name("COMMAND")
      .group("Robot");
  app.add_option("--answer-ms", options.answer_ms, "How long to wait for a line of --robot (default: 30000)")
      .type_name("MS")
      .range(1, 86'400'000)
      .group("Robot");
  app.add_flag("--mms", options.mms, "It speaks the text protocol of the simulator mms: `wallFront`, `moveForward` ...")
      .group("Robot");
  app.add_flag("--no-button", options.no_button,
               "With --mms: `wasReset` is never true; run 2 begins with `ackReset` or back at the start")
      .group("Robot");
  app.add_flag("--hello", options.hello,
               "First write a line `maze WIDTH HEIGHT START-X START-Y MAX-STEPS`, then `goal X Y X Y ...`");
  add_report_options(app, options.report, options.common);
  app.callback([&options] {
    if (options.robot.empty() && takes_standard_output(options))
      throw UsageError("standard output is the robot's: no output can have it");
    if (options.mms && options.hello) throw UsageError("--hello is no line of mms's protocol");
    if (options.no_button && !options.mms) throw UsageError("--no-button needs --mms");
  });
  app.footer(kFooter);
  app.example("mkfifo back; taut mouse serve maze.txt < back | robot > back");
  app.example("taut mouse serve maze.txt --robot 'python3 robot.py' --svg runs.svg");
  app.example("taut mouse serve maze.txt --mms --robot './a.out' --animate film.svg");
}

bool is_number(std::string_view word, int& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc{} && end == word.data() + word.size();
}

/// The robot at the other end.
class ServedRobot : public micromouse::Robot {
 public:
  explicit ServedRobot(RobotLines& lines) : lines_(lines) {}

  Action next(const SensorReading& sight) override {
    lines_.say(fmt::format("{} {} {}\n", sight.left, sight.front, sight.right));
    std::string line;
    while (true) {
      if (!lines_.next(line))
        lines_.refuse(fmt::format("{} after step {} of a trial that is not over", lines_.ended(), steps_));
      std::string_view rest = line;
      const std::string_view first = micromouse::word_of(rest);
      if (first.empty() || first.starts_with('#')) continue;
      ++steps_;
      return action_of(first, rest);
    }
  }

 private:
  Action action_of(std::string_view first, std::string_view rest) const {
    const std::string_view second = micromouse::word_of(rest), third = micromouse::word_of(rest);
    if (first == "reset" && second.empty()) return micromouse::kReset;
    Action action;
    if (!is_number(first, action.rotation) || !is_number(second, action.movement) || !third.empty())
      lines_.refuse("this is neither `rotation movement` nor `reset`");
    return action;
  }

  RobotLines& lines_;
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

/// How a trial went.
struct Served {
  Record record;
  std::string missing{};  // why it is not over
  std::map<Cell, micromouse::CellMark> marks{};
};

Served serve(const GridMaze& maze, const ServeOptions& options, RobotLines& lines, Run& run) {
  Trial trial(maze, options.max_steps);
  const micromouse::Task& task = trial.task();
  if (options.hello && !trial.over())
    lines.say(
        fmt::format("maze {} {} {} {} {}\n", task.width, task.height, task.start.x, task.start.y, task.max_steps) +
        goal_line(task));
  ServedRobot robot(lines);
  while (!trial.over()) {
    const micromouse::Step& step = trial.act(robot.next(trial.sight()));
    if (step.offence != micromouse::Offence::none)
      note(fmt::format("taut: {}:{}: {}; it counts as a step", lines.name(), lines.number(), name(step.offence)));
    run.so_far(counts_of(trial.record()));
  }
  return {trial.record()};
}

// Once it has seen the goal a mms robot may end by itself: it was never told that there is a second run.
Served serve_mms(const GridMaze& maze, const ServeOptions& options, RobotLines& lines, Run& run) {
  Trial trial(maze, options.max_steps);
  micromouse::MmsMouse mouse(maze, trial, !options.no_button);
  std::string line;
  std::size_t steps = 0;
  int questions = 0;
  while (!trial.over()) {
    if (!lines.next(line)) {
      const std::string how = lines.ended();
      const Record& record = trial.record();
      if (!record.goal_at)
        lines.refuse(fmt::format("{} after step {}, before it reached the goal", how, record.steps.size()));
      return {record,
              fmt::format("the robot {} after step {}, with the goal reached after {}, without a second run", how,
                          record.steps.size(), *record.goal_at),
              mouse.marks()};
    }
    std::string answer;
    try {
      answer = mouse.answer(line);
    } catch (const InputError& error) {
      lines.refuse(error.what());
    }
    if (!answer.empty()) lines.say(answer + "\n");
    questions = std::exchange(steps, trial.record().steps.size()) == trial.record().steps.size() ? questions + 1 : 0;
    if (questions > kMostQuestions) lines.refuse(fmt::format("writes {} lines without a step", kMostQuestions));
    run.so_far(counts_of(trial.record()));
  }
  return {trial.record(), "", mouse.marks()};
}

std::string last_line(const Record& record) {
  if (record.status != TrialStatus::finished) return fmt::format("failed {}\n", name(record.status));
  return fmt::format("score {:.3f} run1 {} run2 {}\n", *record.score(), record.run1, record.run2);
}

int report(const ServeOptions& options, Run& run, const GridMazeInput& read, MouseTrial trial, const Served& served) {
  if (!options.robot.empty()) return options.report.end(run, read, std::move(trial), served.missing, "", served.marks);
  // Its pipe has the line that ends it, and nothing but lines: the table would be one more.
  MouseReport quiet = options.report;
  quiet.quick = true;
  return quiet.end(run, read, std::move(trial), served.missing, last_line(served.record), served.marks);
}

int run(const ServeOptions& options, Run& run) {
  if (options.maze.file == "-" && options.robot.empty())
    throw InputError("<stdin>", 0, "cannot be the maze, it is the robot");
  std::signal(SIGPIPE, SIG_IGN);  // a robot that has gone is a line and an exit code
  options.report.promise(run);
  run.source(options.maze.file);
  const GridMazeInput read = run.stage("read", [&] { return read_mouse_maze(options.maze.file, options.maze.format); });
  const auto yardsticks = run.stage("optimum", [&] { return micromouse::yardsticks(read.maze); });
  if (!yardsticks) return no_route(read.name, run);
  const std::unique_ptr<RobotLines> lines =
      options.robot.empty() ? standard_lines() : program_lines(options.robot, options.answer_ms / 1000.0);
  const Served served = run.stage("serve", [&] {
    Served all = options.mms ? serve_mms(read.maze, options, *lines, run) : serve(read.maze, options, *lines, run);
    lines->close(options.mms || options.robot.empty() ? "" : last_line(all.record));
    return all;
  });
  return report(options, run, read, {served.record, *yardsticks}, served);
}

}  // namespace

Command mouse_serve_command(CommandLine& group) {
  return command<ServeOptions>(group, "serve", "Let a program be the robot: started, or at the other end of a pipe",
                               add_options, run);
}

}  // namespace taut::cli
