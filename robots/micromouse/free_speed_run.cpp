#include <taut/robots/micromouse/free_speed_run.h>

#include <algorithm>
#include <functional>
#include <queue>
#include <unordered_map>
#include <utility>

#include <taut/robots/micromouse/detail/speed_lines.h>

namespace taut::micromouse {

namespace {

using detail::ahead_of;
using detail::cell_at;
using detail::is_middle_of_cell;
using detail::kNever;
using detail::middle_of;
using detail::SpeedEdge;
using detail::SpeedLines;
using detail::SpeedNode;
using detail::turned_by;

constexpr double kRoundedDown = 1 - 1e-12;  // far more than the roundings of a sum of times

using Entry = std::pair<double, std::size_t>;
using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

/// The least seconds from each node to an end, by Dijkstra from the ends.
std::vector<double> seconds_to_end(const SpeedLines& lines) {
  std::vector<double> best(lines.nodes(), kNever);
  Queue queue;
  const auto reach = [&](const SpeedNode& n, double seconds) {
    const std::size_t index = lines.index(n);
    if (seconds < best[index]) best[index] = seconds, queue.emplace(seconds, index);
  };
  for (const Cell c : lines.task().goal)
    for (Eighth heading = 0; heading < 8; ++heading) reach({middle_of(c), heading, 0}, 0);
  while (!queue.empty()) {
    const auto [seconds, index] = queue.top();
    queue.pop();
    if (seconds > best[index]) continue;
    const SpeedNode to = lines.node(index);
    for (const int eighths : {2, 4, 6})
      if (lines.may_pivot(to))
        reach({to.at, turned_by(to.heading, -eighths), 0}, seconds + lines.pivot_seconds(eighths));
    lines.behind(to, [&, so_far = seconds](const SpeedEdge& edge) {
      for (std::size_t in = 0; in < lines.classes(); ++in)
        reach({edge.other, edge.heading, in}, so_far + lines.seconds(edge, in, to.speed));
    });
  }
  return best;
}

/// A* over the nodes of fine classes. What is left is estimated by those of coarse ones, which are never above.
class Search {
 public:
  Search(const SpeedLines& coarse, const SpeedLines& fine)
      : coarse_(coarse), fine_(fine), left_(seconds_to_end(coarse)) {}

  std::optional<FreeSpeedRun> run() {
    reach({middle_of(fine_.task().start), 0, 0}, 0, 0);
    while (!queue_.empty()) {
      const auto [sum, index] = queue_.top();
      queue_.pop();
      const SpeedNode from = fine_.node(index);
      const double seconds = labels_.at(index).seconds;
      if (sum > seconds + left(from)) continue;
      if (fine_.is_end(from)) return FreeSpeedRun{run_to(from), seconds * kRoundedDown};
      expand(from, seconds);
    }
    return std::nullopt;
  }

 private:
  struct Label {
    double seconds = 0;
    std::size_t parent = 0;
  };

  double left(const SpeedNode& n) const {
    return left_[coarse_.index({n.at, n.heading, std::min<std::size_t>(n.speed, 1)})];
  }

  void reach(const SpeedNode& to, double seconds, std::size_t parent) {
    const double sum = seconds + left(to);
    if (sum == kNever) return;
    const std::size_t index = fine_.index(to);
    const auto [at, fresh] = labels_.try_emplace(index, Label{seconds, parent});
    if (!fresh && at->second.seconds <= seconds) return;
    at->second = {seconds, parent};
    queue_.emplace(sum, index);
  }

  void expand(const SpeedNode& from, double seconds) {
    const std::size_t parent = fine_.index(from);
    for (const int eighths : {2, 4, 6})
      if (fine_.may_pivot(from))
        reach({from.at, turned_by(from.heading, eighths), 0}, seconds + fine_.pivot_seconds(eighths), parent);
    fine_.ahead(from, [&](const SpeedEdge& edge) {
      for (std::size_t out = 0; out < fine_.classes(); ++out)
        reach({edge.other, edge.heading, out}, seconds + fine_.seconds(edge, from.speed, out), parent);
    });
  }

  SpeedRun run_to(SpeedNode end) const {
    const std::size_t begin = fine_.index({middle_of(fine_.task().start), 0, 0});
    std::vector<SpeedNode> nodes{end};
    while (fine_.index(nodes.back()) != begin)
      nodes.push_back(fine_.node(labels_.at(fine_.index(nodes.back())).parent));
    std::reverse(nodes.begin(), nodes.end());
    SpeedRun run;
    run.cells.push_back(fine_.task().start);
    for (std::size_t i = 1; i < nodes.size(); ++i) append(run, nodes[i - 1], nodes[i]);
    for (const Drive& d : run.drives) run.metres += d.metres;
    return at_full_speed(run, fine_.model());
  }

  void append(SpeedRun& run, const SpeedNode& from, const SpeedNode& to) const {
    const SpeedModel& model = fine_.model();
    if (from.at == to.at) {
      const double seconds = fine_.pivot_seconds((to.heading - from.heading) & 7);
      run.drives.push_back({Drive::Kind::pivot, {}, from.at, to.at, from.heading, to.heading, 0, 0, seconds, 0});
      return;
    }
    double least = kNever;
    SpeedEdge best;
    fine_.ahead(from, [&](const SpeedEdge& edge) {
      if (edge.other != to.at || edge.heading != to.heading) return;
      const double seconds = fine_.seconds(edge, from.speed, to.speed);
      if (seconds < least) least = seconds, best = edge;
    });
    const Spot at = ahead_of(from.at, from.heading, best.count);
    if (best.count > 0) {
      const double metres = detail::straight_piece(model, from.heading, best.count).metres;
      run.drives.push_back({Drive::Kind::straight, {}, from.at, at, from.heading, from.heading, 0, 0, 0, metres});
      for (int i = 1; i <= best.count; ++i) cross(run, ahead_of(from.at, from.heading, i));
    }
    if (best.turn == nullptr) return;
    const Turn turn = best.turn->turn;
    run.drives.push_back(
        {Drive::Kind::turn, turn, at, to.at, from.heading, to.heading, 0, 0, 0, length(turn) * model.cell / 2});
    for (std::size_t i = 1; i < best.turn->way.size(); ++i)
      cross(run, {at.x + best.turn->way[i].x, at.y + best.turn->way[i].y});
  }

  /// Into the other cell of this wall.
  static void cross(SpeedRun& run, Spot wall) {
    if (is_middle_of_cell(wall)) return;
    const Spot now = middle_of(run.cells.back());
    run.cells.push_back(cell_at({2 * wall.x - now.x, 2 * wall.y - now.y}));
  }

  const SpeedLines& coarse_;
  const SpeedLines& fine_;
  std::vector<double> left_;
  std::unordered_map<std::size_t, Label> labels_;
  Queue queue_;
};

}  // namespace

std::optional<FreeSpeedRun> free_speed_run(const GridMaze& maze, const SpeedModel& model) {
  constexpr std::size_t kCoarse = 1, kFine = 32;
  const GridMaze closed = detail::with_closed_border(maze);
  const Task task = task_of(closed);
  const SpeedLines coarse(closed, task, model, kCoarse), fine(closed, task, model, kFine);
  auto found = Search(coarse, fine).run();
  if (!found) return std::nullopt;
  for (const Aim aim : {Aim::fastest, Aim::fewest_cells}) {
    SpeedRun other = at_full_speed(*speed_run(maze, model, aim), model);
    if (other.seconds < found->run.seconds) found->run = std::move(other);
  }
  return found;
}

}  // namespace taut::micromouse
