#include <taut/robots/micromouse/mms.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include <taut/geometry/errors.h>
#include <taut/robots/micromouse/line_words.h>

namespace taut::micromouse {

namespace {

constexpr double kResetPenalty = 15;  // of mms, on the next run's effective distance
constexpr std::size_t kLongestText = 10;

std::optional<int> number_of(std::string_view word) {
  int value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

std::string words(bool value) { return value ? "true" : "false"; }

double effective(int cells) { return cells > 2 ? cells / 2.0 + 1 : cells; }

std::string printable_text(std::string_view rest) {
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
  std::string text(rest.substr(0, std::min(rest.find('\r'), kLongestText)));
  std::ranges::replace_if(
      text, [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

std::optional<int> quarters_of_wall(std::string_view command) {
  if (command == "wallFront") return 0;
  if (command == "wallRight") return 1;
  if (command == "wallBack") return 2;
  if (command == "wallLeft") return 3;
  return std::nullopt;
}

}  // namespace

MmsMouse::MmsMouse(const GridMaze& maze, Trial& trial, bool button) : maze_(maze), trial_(trial), button_(button) {}

std::string MmsMouse::answer(std::string_view line) {
  const std::string_view command = word_of(line);
  std::string_view rest = line;
  const std::string_view argument = word_of(rest);
  if (const auto quarters = quarters_of_wall(command)) return wall(*quarters, argument);
  if (command == "mazeWidth") return std::to_string(maze_.width());
  if (command == "mazeHeight") return std::to_string(maze_.height());
  if (command == "moveForward") return move(argument.empty() ? 1 : number_of(argument).value_or(0));
  if (command == "turnRight" || command == "turnRight90") return turn(1), "ack";
  if (command == "turnLeft" || command == "turnLeft90") return turn(3), "ack";
  if (command == "wasReset") return words(button_ && trial_.record().goal_at && trial_.run() == 1);
  if (command == "ackReset") return reset();
  if (command == "getStat") return stat(argument);
  if (command == "moveForwardHalf" || command.starts_with("turnRight45") || command.starts_with("turnLeft45") ||
      command.starts_with("wallFrontL") || command.starts_with("wallFrontR") || command.starts_with("wallBackL") ||
      command.starts_with("wallBackR"))
    throw InputError("", 0, fmt::format("`{}`: these rules know whole cells and quarter turns only", command));
  mark(command, line);
  return "";
}

std::string MmsMouse::wall(int quarters, std::string_view steps) const {
  if (!steps.empty() && number_of(steps) != 1)
    throw InputError("", 0, "a wall further off than its own cell's: a mouse here asks for those alone");
  return words(maze_.wall(trial_.pose().cell, turned(facing_, quarters)));
}

void MmsMouse::turn(int quarters) {
  facing_ = turned(facing_, quarters);
  ++total_.turns;
  if (is_running_) ++current_.turns;
}

std::string MmsMouse::move(int cells) {
  if (cells < 1) return "crash";
  if (!is_running_ && trial_.pose().cell == trial_.task().start) note_run();
  const Cell before = trial_.pose().cell;
  const bool whole = advance(cells);
  const Cell after = trial_.pose().cell;
  const int moved = std::abs(after.x - before.x) + std::abs(after.y - before.y);
  for (Count* count : {&total_, &current_}) {
    if (count == &current_ && !is_running_) continue;
    count->distance += moved;
    count->effective += effective(moved);
  }
  if (is_running_ && trial_.task().in_goal(after)) {
    is_running_ = false;
    if (!solved_ || current_.score() < best_.score()) best_ = current_;
    solved_ = true;
  }
  if (!trial_.over() && trial_.run() == 1 && trial_.record().goal_at && after == trial_.task().start) begin_run2();
  return whole ? "ack" : "crash";
}

// Did it come all the way?
bool MmsMouse::advance(int cells) {
  while (cells > 0 && !trial_.over()) {
    const int quarters = (static_cast<int>(facing_) - static_cast<int>(trial_.pose().heading) + 4) % 4;
    if (quarters == 2) {
      trial_.act({90, 0});
      continue;
    }
    const int stretch = std::min(cells, kLongestMove);
    const Step& step = trial_.act({quarters == 3 ? -90 : 90 * quarters, stretch});
    if (step.blocked) return false;
    cells -= stretch;
  }
  return cells == 0;
}

void MmsMouse::begin_run2() { trial_.act(kReset); }

void MmsMouse::note_run() {
  current_ = {};
  current_.effective = penalty_;
  total_.effective += penalty_;
  penalty_ = 0;
  is_running_ = true;
}

std::string MmsMouse::reset() {
  if (trial_.run() != 1 || !trial_.record().goal_at)
    throw InputError("", 0, "`ackReset`: these rules put a mouse back once, after it has reached the goal");
  begin_run2();
  facing_ = Side::north;
  penalty_ = kResetPenalty;
  is_running_ = false;
  return "ack";
}

std::string MmsMouse::stat(std::string_view what) const {
  const auto of = [&](const Count& count, std::string_view of_what, bool known) -> std::optional<std::string> {
    if (!known) return "-1";
    if (of_what == "distance") return std::to_string(count.distance);
    if (of_what == "turns") return std::to_string(count.turns);
    if (of_what == "effective-distance") return fmt::format("{:g}", count.effective);
    return std::nullopt;
  };
  if (what == "score") return fmt::format("{:g}", solved_ ? best_.score() + 0.1 * total_.score() : 2000.0);
  std::optional<std::string> found;
  if (what.starts_with("total-")) found = of(total_, what.substr(6), true);
  if (what.starts_with("best-run-")) found = of(best_, what.substr(9), solved_);
  if (what.starts_with("current-run-")) found = of(current_, what.substr(12), true);
  return found.value_or("");
}

void MmsMouse::mark(std::string_view command, std::string_view rest) {
  if (command == "clearAllText")
    for (auto& [cell, mark] : marks_) mark.text.clear();
  if (command == "clearAllColor")
    for (auto& [cell, mark] : marks_) mark.colour = 0;
  if (command != "setText" && command != "clearText" && command != "setColor" && command != "clearColor") return;
  const auto x = number_of(word_of(rest)), y = number_of(word_of(rest));
  if (!x || !y || !trial_.task().contains({*x, *y})) return;
  CellMark& mark = marks_[{*x, *y}];
  const std::string text = printable_text(rest);
  if (command.ends_with("Text")) mark.text = command == "setText" ? text : "";
  if (command.ends_with("Color")) mark.colour = command == "setColor" && !text.empty() ? text[0] : '\0';
}

}  // namespace taut::micromouse
