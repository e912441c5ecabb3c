#include <taut/io/results/mouse_json.h>

#include <cstdlib>
#include <set>

#include <taut/robots/micromouse/speed_facts.h>

namespace taut {

namespace {

using micromouse::Contest;
using micromouse::Record;
using micromouse::Score;
using micromouse::Step;

constexpr const char* kSides[] = {"north", "east", "south", "west"};

Json json_of(Cell c) { return Json::array({c.x, c.y}); }

Json json_of(const std::vector<Cell>& cells) {
  Json all = Json::array();
  for (const Cell c : cells) all.push_back(json_of(c));
  return all;
}

Json json_of(const Step& s) {
  const auto& [cell, heading] = s.before;
  Json json{{"run", s.run},
            {"at", Json::array({cell.x, cell.y, kSides[static_cast<std::size_t>(heading)]})},
            {"sight", Json::array({s.sight.left, s.sight.front, s.sight.right})}};
  if (s.action.reset)
    json["reset"] = true;
  else
    json["action"] = Json::array({s.action.rotation, s.action.movement});
  json["moved"] = s.moved;
  if (s.offence != micromouse::Offence::none) json["offence"] = name(s.offence);
  return json;
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

Json json_of(const Score& s, const std::string& maze, const micromouse::Yardsticks& y) {
  Json json{{"maze", maze}};
  json["score"] = s.thirtieths ? Json(Score::value_of(*s.thirtieths)) : Json();
  json["run1"] = s.run1;
  json["run2"] = s.run2;
  json["proven"] = s.proven;
  json["optimum"] = y.optimum;
  json["floor"] = y.floor;
  if (!s.reason.empty()) json["reason"] = s.reason;
  return json;
}

Json json_of(const Contest& contest, std::size_t explorer) {
  const Contest::Summary s = contest.summary(explorer);
  Json json{{"explorer", name(contest.explorers[explorer])}};
  json["mean"] = s.worst ? Json(s.mean) : Json();
  json["mean_floor"] = s.worst ? Json(s.mean_floor) : Json();
  json["worst"] = s.worst ? Json(s.worst_score) : Json();
  json["worst_maze"] = s.worst ? Json(contest.mazes[*s.worst]) : Json();
  json["failures"] = s.failures;
  json["proven"] = s.proven;
  json["seconds"] = contest.seconds[explorer];
  if (const auto spread = contest.spread(explorer)) {
    json["seeds"] = spread->means.size();
    json["seed_means"] = spread->means;
    json["spread"] = spread->of_means;
    json["maze_spread"] = spread->of_a_maze;
  }
  Json runs = Json::array();
  const std::vector<Score>& row = contest.scores[explorer];
  for (std::size_t k = 0; k < row.size(); ++k) runs.push_back(json_of(row[k], contest.mazes[k], contest.yardsticks[k]));
  json["runs"] = std::move(runs);
  return json;
}

Json json_of(const micromouse::Drive& d) {
  Json json{{"kind", name(d)}};
  json["from"] = Json::array({d.from.x / 2.0, d.from.y / 2.0});
  json["to"] = Json::array({d.to.x / 2.0, d.to.y / 2.0});
  json["heading"] = micromouse::heading_name(d.heading);
  json["after"] = micromouse::heading_name(d.after);
  json["speed_in"] = d.speed_in;
  json["speed_out"] = d.speed_out;
  json["metres"] = d.metres;
  json["seconds"] = d.seconds;
  return json;
}

Json json_of(const micromouse::SpeedRun& run) {
  Json drives = Json::array();
  for (const micromouse::Drive& d : run.drives) drives.push_back(json_of(d));
  return {{"seconds", run.seconds}, {"metres", run.metres},        {"cells", run.cells.size() - 1},
          {"turns", turns_of(run)}, {"route", json_of(run.cells)}, {"drives", std::move(drives)}};
}

}  // namespace

int MouseTrial::cells_of(int run) const {
  int cells = 0;
  for (const Step& s : record.steps)
    if (s.run == run) cells += std::abs(s.moved);
  return cells;
}

int MouseTrial::visited() const {
  std::set<Cell> cells;
  for (const Step& s : record.steps)
    if (s.run == 1) cells.insert({s.before.cell, s.after.cell});
  return static_cast<int>(cells.size());
}

Json mouse_trial_json(const MouseTrial& trial) {
  const Record& record = trial.record;
  const micromouse::Yardsticks& y = trial.yardsticks;
  const micromouse::WallMap map = known_after_run1(record);
  const bool is_known = !trial.explorer.empty();
  Json json{{"explorer", is_known ? Json(trial.explorer) : Json()}, {"seed", is_known ? Json(trial.seed) : Json()}};
  json["score"] = record.score();
  json["run1"] = record.run1;
  json["run2"] = record.run2;
  json["optimum"] = y.optimum;
  json["proven"] = trial.certificate.has_value();
  json["floor"] = y.floor;
  json["width"] = record.task.width;
  json["height"] = record.task.height;
  json["start"] = json_of(record.task.start);
  json["goal"] = json_of(record.task.goal);
  json["goal_at"] = record.goal_at;
  json["walls_seen"] = map.seen();
  json["walls"] = map.seen() + map.unknown();
  if (y.with_proof)
    json["floor_with_proof"] = {
        {"score", y.with_proof->score()}, {"run1", y.with_proof->run1}, {"exact", y.with_proof->exact}};
  json["benchmarks"] = {{"every_cell", y.every_cell}, {"random_walkers", y.random_walkers}};
  if (const auto& i = trial.insurance)
    json["insurance"] = {{"steps", i->paid},
                         {"known", i->known},
                         {"expected", i->expected},
                         {"back", i->back},
                         {"balance", i->balance()}};
  json["route"] = json_of(racing_cells(record));
  Json steps = Json::array();
  for (const Step& s : record.steps) steps.push_back(json_of(s));
  json["steps"] = std::move(steps);
  return json;
}

Json mouse_contest_json(const Contest& contest, std::uint64_t seed) {
  Json explorers = Json::array();
  for (std::size_t i = 0; i < contest.scores.size(); ++i) explorers.push_back(json_of(contest, i));
  return {{"seed", seed},
          {"mazes", contest.mazes.size()},
          {"without_route", contest.without_route},
          {"explorers", std::move(explorers)}};
}

Json mouse_speed_json(const micromouse::SpeedRuns& runs) {
  Json differences = Json::array();
  for (const micromouse::Parting& p : micromouse::partings(runs.fastest.cells, runs.shortest.cells))
    differences.push_back(
        {{"from", json_of(p.from)}, {"to", json_of(p.to)}, {"fastest", p.fastest}, {"shortest", p.shortest}});
  return {{"fastest", json_of(runs.fastest)},
          {"steady", json_of(runs.steady)},
          {"shortest", json_of(runs.shortest)},
          {"differences", std::move(differences)},
          {"bound", {{"seconds", runs.bound}}},
          {"any_curve", {{"seconds", runs.any_curve.seconds}, {"metres", runs.any_curve.metres}}}};
}

}  // namespace taut
