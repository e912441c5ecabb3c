// The verifier. On purpose it uses nothing of the robots, the map, the trial or the searches.
#include <algorithm>
#include <array>
#include <deque>
#include <set>

#include <taut/robots/micromouse/certificate.h>

namespace taut::micromouse {

namespace {

constexpr std::array<int, 4> kDx{0, 1, 0, -1};
constexpr std::array<int, 4> kDy{1, 0, -1, 0};

std::string text(Cell c) { return "(" + std::to_string(c.x) + "," + std::to_string(c.y) + ")"; }

std::string text(const CellSide& wall) {
  constexpr std::array words{"north", "east", "south", "west"};
  return text(wall.cell) + " " + words[static_cast<std::size_t>(wall.side)];
}

Finding fault(std::string reason) { return {false, std::move(reason)}; }

/// Both names of a wall.
using Walls = std::set<CellSide>;

CellSide other_name(const CellSide& wall) {
  const auto k = static_cast<std::size_t>(wall.side);
  return {{wall.cell.x + kDx[k], wall.cell.y + kDy[k]}, static_cast<Side>((k + 2) % 4)};
}

bool goal_holds(const Task& task, Cell c) {
  return std::find(task.goal.begin(), task.goal.end(), c) != task.goal.end();
}

/// The fewest steps from start to goal where only the border and these walls stand; -1: no way.
int fewest_steps(const Task& task, const Walls& walls) {
  std::vector<int> steps(static_cast<std::size_t>(task.width * task.height), -1);
  const auto at = [&](Cell c) -> int& { return steps[static_cast<std::size_t>(c.x * task.height + c.y)]; };
  std::deque<Cell> queue{task.start};
  at(task.start) = 0;
  while (!queue.empty()) {
    const Cell c = queue.front();
    queue.pop_front();
    if (goal_holds(task, c)) return std::max(1, at(c));
    for (std::size_t k = 0; k < 4; ++k) {
      Cell n = c;
      for (int count = 0; count < 3 && !walls.contains({n, static_cast<Side>(k)}); ++count) {
        n = {n.x + kDx[k], n.y + kDy[k]};
        if (n.x < 0 || n.y < 0 || n.x >= task.width || n.y >= task.height) break;
        if (at(n) != -1) continue;
        at(n) = at(c) + 1;
        queue.push_back(n);
      }
    }
  }
  return -1;
}

Finding check_witnesses(const Certificate& c, const GridMaze& maze) {
  for (const auto* list : {&c.openings, &c.walls})
    for (const Witness& w : *list) {
      if (!maze.contains(w.wall.cell)) return fault("no such wall: " + text(w.wall));
      if (w.closed != (list == &c.walls)) return fault("wall in the wrong list: " + text(w.wall));
      if (maze.wall(w.wall.cell, w.wall.side) != w.closed) return fault("the maze says otherwise of " + text(w.wall));
    }
  return {};
}

Finding check_route(const Certificate& c) {
  if (c.route.size() != static_cast<std::size_t>(c.steps) + 1)
    return fault("the route has not the number of steps claimed");
  if (c.route.front() != c.task.start) return fault("the route does not begin at the start");
  if (!goal_holds(c.task, c.route.back())) return fault("the route does not end in the goal");
  std::size_t used = 0;
  for (std::size_t i = 1; i < c.route.size(); ++i) {
    const int dx = c.route[i].x - c.route[i - 1].x, dy = c.route[i].y - c.route[i - 1].y;
    const int count = std::abs(dx) + std::abs(dy);
    const bool stands = count == 0 && c.steps == 1;  // the start lies in the goal
    if ((dx != 0 && dy != 0) || count > 3 || (count == 0 && !stands))
      return fault("step " + std::to_string(i) + " of the route is no step");
    const std::size_t k = dy > 0 ? 0 : dx > 0 ? 1 : dy < 0 ? 2 : 3;
    Cell at = c.route[i - 1];
    for (int j = 0; j < count; ++j) {
      const CellSide side{at, static_cast<Side>(k)};
      if (used >= c.openings.size() || (c.openings[used].wall != side && c.openings[used].wall != other_name(side)))
        return fault("the route crosses " + text(side) + ", which is not named as open");
      ++used;
      at = {at.x + kDx[k], at.y + kDy[k]};
    }
  }
  return used == c.openings.size() ? Finding{} : fault("openings are named that the route does not cross");
}

Finding check_cut(const Certificate& c) {
  Walls walls;
  for (const Witness& w : c.walls) {
    walls.insert(w.wall);
    walls.insert(other_name(w.wall));
  }
  const int least = fewest_steps(c.task, walls);
  if (least != c.steps)
    return fault("with the named walls alone the best plan has " + std::to_string(least) + " steps, not " +
                 std::to_string(c.steps));
  for (const Witness& w : c.walls) {
    Walls fewer = walls;
    fewer.erase(w.wall);
    fewer.erase(other_name(w.wall));
    if (fewest_steps(c.task, fewer) == c.steps) return fault("wall " + text(w.wall) + " is not needed");
  }
  return {};
}

/// Whether this step told of the wall, by its sensors or its move.
bool told(const Step& step, const Witness& w) {
  const auto names = std::array{w.wall, other_name(w.wall)};
  const auto along = [&](Cell from, std::size_t k, int open, bool ends) {
    Cell c = from;
    for (int i = 0; i <= open; ++i) {
      const CellSide side{c, static_cast<Side>(k)};
      const bool closed = i == open;
      if ((!closed || ends) && closed == w.closed && std::find(names.begin(), names.end(), side) != names.end())
        return true;
      c = {c.x + kDx[k], c.y + kDy[k]};
    }
    return false;
  };
  const auto heading = static_cast<std::size_t>(step.before.heading);
  if (along(step.before.cell, (heading + 3) % 4, step.sight.left, true)) return true;
  if (along(step.before.cell, heading, step.sight.front, true)) return true;
  if (along(step.before.cell, (heading + 1) % 4, step.sight.right, true)) return true;
  if (step.action.reset) return false;
  const std::size_t way = (static_cast<std::size_t>(step.after.heading) + (step.action.movement < 0 ? 2 : 0)) % 4;
  return along(step.before.cell, way, std::abs(step.moved), step.blocked);
}

}  // namespace

Finding verify_certificate(const Certificate& certificate, const GridMaze& maze) {
  Task task{maze.width(), maze.height(), maze.start, maze.goal, certificate.task.max_steps};
  if (task.goal.empty()) task.goal = centre_room(maze.width(), maze.height());
  std::sort(task.goal.begin(), task.goal.end());
  task.goal.erase(std::unique(task.goal.begin(), task.goal.end()), task.goal.end());
  if (task != certificate.task) return fault("the certificate is for another task");
  if (certificate.steps < 1 || certificate.route.empty()) return fault("no route");
  for (const Finding& finding : {check_witnesses(certificate, maze), check_route(certificate)})
    if (!finding) return finding;
  return check_cut(certificate);
}

Finding verify_certificate(const Certificate& certificate, const GridMaze& maze, const Record& record) {
  if (Finding finding = verify_certificate(certificate, maze); !finding) return finding;
  if (Finding finding = verify_record(record, maze); !finding) return finding;
  if (record.task != certificate.task) return fault("the record is of another task");
  for (const auto* list : {&certificate.openings, &certificate.walls})
    for (const Witness& w : *list) {
      const bool exists = w.step >= 0 && static_cast<std::size_t>(w.step) < record.steps.size();
      if (!exists || record.steps[static_cast<std::size_t>(w.step)].run != 1)
        return fault("no step " + std::to_string(w.step) + " in run 1");
      if (!told(record.steps[static_cast<std::size_t>(w.step)], w))
        return fault("step " + std::to_string(w.step) + " did not show " + text(w.wall));
    }
  return {};
}

namespace {

/// The rules once more, written from the text alone.
class Replay {
 public:
  Replay(const GridMaze& maze, const Task& task) : maze_(maze), task_(task), cell_(task.start) {}

  Finding step(const Step& s) {
    if (over_) return fault("the trial was over");
    const auto& [rotation, movement, reset] = s.action;
    if (s.run != run_ || s.before.cell != cell_ || static_cast<int>(s.before.heading) != heading_)
      return fault("pose or run before the step");
    if (s.sight != SensorReading{look(3), look(0), look(1)}) return fault("sight");
    ++count_[static_cast<std::size_t>(run_ - 1)];
    Offence offence = Offence::none;
    int moved = 0;
    bool blocked = false, ended = false;
    if (reset) {
      offence = run_ == 2 ? Offence::late_reset : goal_at_ == 0 ? Offence::early_reset : Offence::none;
      if (offence == Offence::none) run_ = 2, cell_ = task_.start, heading_ = 0;
    } else {
      if (rotation == 90) heading_ = (heading_ + 1) % 4;
      if (rotation == -90) heading_ = (heading_ + 3) % 4;
      if (movement > 3 || movement < -3) offence = Offence::movement;
      if (rotation != 0 && rotation != 90 && rotation != -90) offence = Offence::rotation;
      const int way = movement >= 0 ? heading_ : (heading_ + 2) % 4;
      const int wanted = movement > 3 || movement < -3 ? 3 : std::abs(movement);
      for (int i = 0; i < wanted && !blocked; ++i) {
        blocked = maze_.wall(cell_, static_cast<Side>(way));
        if (blocked) break;
        cell_ = {cell_.x + kDx[static_cast<std::size_t>(way)], cell_.y + kDy[static_cast<std::size_t>(way)]};
        moved += movement >= 0 ? 1 : -1;
      }
      ended = goal_holds(task_, cell_);
      if (ended && run_ == 2) over_ = true;
      if (ended && run_ == 1 && goal_at_ == 0) goal_at_ = count_[0];
    }
    if (s.offence != offence) return fault("offence");
    if (s.after.cell != cell_ || static_cast<int>(s.after.heading) != heading_) return fault("pose after the step");
    if (s.moved != moved || s.blocked != blocked) return fault("movement");
    if (s.in_goal != goal_holds(task_, cell_)) return fault("goal");
    finished_ = over_;
    over_ = over_ || count_[0] + count_[1] >= task_.max_steps;
    return {};
  }

  Finding end(const Record& r) const {
    if (r.run1 != count_[0] || r.run2 != count_[1]) return fault("number of steps");
    if (r.goal_at.value_or(0) != goal_at_) return fault("first step in the goal");
    const TrialStatus status = finished_      ? TrialStatus::finished
                               : !over_       ? TrialStatus::running
                               : run_ == 2    ? TrialStatus::no_second_run
                               : goal_at_ > 0 ? TrialStatus::no_reset
                                              : TrialStatus::no_goal;
    return r.status == status ? Finding{} : fault("status");
  }

 private:
  int look(int quarters) const {
    const auto k = static_cast<std::size_t>((heading_ + quarters) % 4);
    int open = 0;
    for (Cell c = cell_; !maze_.wall(c, static_cast<Side>(k)); c = {c.x + kDx[k], c.y + kDy[k]}) ++open;
    return open;
  }

  const GridMaze& maze_;
  const Task& task_;
  Cell cell_;
  int heading_ = 0;
  int run_ = 1;
  int goal_at_ = 0;
  std::array<int, 2> count_{};
  bool over_ = false;
  bool finished_ = false;
};

/// News may only be what this step told, and only once.
Finding check_news(const Step& step, Walls& known) {
  for (const auto* news : {&step.seen, &step.felt})
    for (const WallSeen& seen : *news) {
      if (!told(step, {seen.wall, seen.closed, 0})) return fault("news of a wall that the step did not show");
      if (!known.insert(seen.wall).second || known.contains(other_name(seen.wall))) return fault("old news");
    }
  return {};
}

}  // namespace

Finding verify_record(const Record& record, const GridMaze& maze) {
  const Task& task = record.task;
  if (task.width != maze.width() || task.height != maze.height() || task.start != maze.start)
    return fault("another maze");
  if (record.status == TrialStatus::no_route || (record.steps.empty() && task.max_steps <= 0))
    return record.steps.empty() ? Finding{} : fault("steps in a maze without a route");
  Replay replay(maze, task);
  Walls known;
  for (std::size_t i = 0; i < record.steps.size(); ++i)
    for (const Finding& finding : {replay.step(record.steps[i]), check_news(record.steps[i], known)})
      if (!finding) return fault("step " + std::to_string(i) + ": " + finding.reason);
  return replay.end(record);
}

}  // namespace taut::micromouse
