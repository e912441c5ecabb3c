#include <taut/cli/mouse/report.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <set>

#include <taut/cli/mouse/mouse.h>
#include <taut/cli/report.h>
#include <taut/io/results/detail/result_values.h>
#include <taut/robots/micromouse/steps.h>

namespace taut::cli {

namespace {

using micromouse::Record;
using micromouse::Step;
using micromouse::TrialStatus;
using Json = nlohmann::ordered_json;

Json json_of(Cell c) { return {c.x, c.y}; }

Json json_of(const std::vector<Cell>& cells) {
  Json array = Json::array();
  for (const Cell c : cells) array.push_back(json_of(c));
  return array;
}

template <typename Value>
Json json_of(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json json_of(const micromouse::Pose& pose) { return {pose.cell.x, pose.cell.y, side_name(pose.heading)}; }

Json json_of(const Step& s) {
  Json json{{"run", s.run}, {"at", json_of(s.before)}, {"sight", {s.sight.left, s.sight.front, s.sight.right}}};
  if (s.action.reset)
    json["reset"] = true;
  else
    json["action"] = {s.action.rotation, s.action.movement};
  json["moved"] = s.moved;
  if (s.offence != micromouse::Offence::none) json["offence"] = name(s.offence);
  return json;
}

Json steps_of(const Record& record) {
  Json array = Json::array();
  for (const Step& s : record.steps) array.push_back(json_of(s));
  return array;
}

std::vector<Cell> racing_cells(const Record& record) {
  std::vector<Cell> cells;
  for (const Step& s : record.steps) {
    if (s.run != 2) continue;
    if (cells.empty()) cells.push_back(s.before.cell);
    cells.push_back(s.after.cell);
  }
  return cells;
}

std::string row(const char* what, const std::string& value, const std::string& remark) {
  const std::string line = fmt::format("{:<18}{:>9}  {}", what, value, remark);
  return "  " + line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

std::string score_of(double value) { return fmt::format("{:.3f}", value); }

std::string run1_remark(const MouseReport& r) {
  if (!r.record.goal_at) return "the goal was not reached";
  return fmt::format("{} cells moved, {} of {} cells visited, goal after {}", r.cells_of(1), r.visited(),
                     r.record.task.width * r.record.task.height,
                     count_text(static_cast<std::size_t>(*r.record.goal_at), "step"));
}

std::string run2_remark(const MouseReport& r) {
  if (r.record.status != TrialStatus::finished) return "";
  const int over = r.record.run2 - r.yardsticks.optimum;
  return fmt::format("{} cells moved, {}", r.cells_of(2),
                     over == 0 ? "optimal" : fmt::format("{} more than needed", over));
}

std::string goal_text(const std::vector<Cell>& goal) {
  std::string out;
  for (std::size_t i = 0; i < goal.size() && i < 4; ++i) out += (i > 0 ? " " : "") + cell_text(goal[i]);
  return goal.size() > 4 ? out + fmt::format(" and {} more", goal.size() - 4) : out;
}

}  // namespace

bool fit_for_proof_bound(const GridMaze& maze) {
  constexpr int kMostCells = 64 * 64;  // beyond it the search for a proof takes minutes
  return maze.width() * maze.height() <= kMostCells;
}

std::optional<MouseYardsticks> yardsticks(const GridMaze& maze, bool all) {
  const auto optimum = micromouse::optimum(micromouse::passages_of(maze), micromouse::task_of(maze));
  if (!optimum) return std::nullopt;
  MouseYardsticks y;
  y.optimum = *optimum;
  y.floor = *micromouse::absolute_floor(maze);
  y.every_cell = *micromouse::benchmark_every_cell(maze);
  if (!all) return y;
  if (fit_for_proof_bound(maze)) y.with_proof = micromouse::proof_bound(maze);
  y.random_walkers = micromouse::benchmark_random_walkers(maze);
  y.walked = true;
  return y;
}

int MouseReport::cells_of(int run) const {
  int cells = 0;
  for (const Step& s : record.steps)
    if (s.run == run) cells += std::abs(s.moved);
  return cells;
}

int MouseReport::visited() const {
  std::set<Cell> cells;
  for (const Step& s : record.steps)
    if (s.run == 1) cells.insert({s.before.cell, s.after.cell});
  return static_cast<int>(cells.size());
}

micromouse::WallMap map_after_run1(const Record& record) {
  micromouse::WallMap map(record.task);
  for (const Step& s : record.steps)
    for (const auto* news : {&s.seen, &s.felt})
      for (const micromouse::WallSeen& w : *news)
        if (s.run == 1) map.learn(w.wall.cell, w.wall.side, w.closed);
  return map;
}

std::string mouse_table(const MouseReport& r) {
  const MouseYardsticks& y = r.yardsticks;
  const Record& record = r.record;
  std::string out = fmt::format("{}: {} x {}, goal {}, explorer {}\n", r.source, record.task.width, record.task.height,
                                goal_text(record.task.goal), r.explorer);
  out += row("run 1", std::to_string(record.run1), run1_remark(r));
  out += row("run 2", std::to_string(record.run2), run2_remark(r));
  out += row("score", record.score() ? score_of(*record.score()) : "-",
             record.score() ? "run 2 + run 1 / 30" : std::string(name(record.status)));
  out += row("optimum", std::to_string(y.optimum), "fewest steps of run 2");
  out += row("proven", r.certificate ? "yes" : "no",
             fmt::format("by what run 1 saw ({} of {} walls)", r.walls_seen, r.walls));
  out += row("floor", score_of(y.floor), "of a robot that knows the maze");
  if (y.with_proof)
    out += row(
        "floor with proof", score_of(y.with_proof->score()),
        y.with_proof->exact ? "of one that has to see a proof" : "of one that has to see a proof; it may be higher");
  out += row("benchmark 1", score_of(y.every_cell), "run 1 sees every cell once");
  if (y.walked)
    out += row("benchmark 2", y.random_walkers ? score_of(*y.random_walkers) : "-",
               y.random_walkers ? "mean of ten random walkers" : "not ten of 1000 random walkers finish");
  return out;
}

std::string mouse_json(const MouseReport& r) {
  const Record& record = r.record;
  const MouseYardsticks& y = r.yardsticks;
  Json json{{"program", "taut"},
            {"version", TAUT_VERSION},
            {"source", r.source},
            {"status", record.status == TrialStatus::finished ? "finished" : "failed"},
            {"reason", record.status == TrialStatus::finished ? Json(nullptr) : Json(name(record.status))},
            {"explorer", r.explorer},
            {"seed", r.seed},
            {"score", json_of(record.score())},
            {"run1", record.run1},
            {"run2", record.run2},
            {"optimum", y.optimum},
            {"proven", r.certificate.has_value()},
            {"floor", y.floor},
            {"width", record.task.width},
            {"height", record.task.height},
            {"start", json_of(record.task.start)},
            {"goal", json_of(record.task.goal)},
            {"goal_at", json_of(record.goal_at)},
            {"walls_seen", r.walls_seen},
            {"walls", r.walls}};
  if (y.with_proof)
    json["floor_with_proof"] = {
        {"score", y.with_proof->score()}, {"run1", y.with_proof->run1}, {"exact", y.with_proof->exact}};
  json["benchmarks"] = {{"every_cell", y.every_cell}, {"random_walkers", json_of(y.random_walkers)}};
  json["route"] = json_of(racing_cells(record));
  json["steps"] = steps_of(record);
  json["seconds"] = r.seconds;
  return detail::json_text(json);
}

}  // namespace taut::cli
