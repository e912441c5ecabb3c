#include <taut/robots/micromouse/speed_run.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>
#include <unordered_map>

#include <taut/robots/micromouse/detail/turn_shapes.h>
#include <taut/robots/micromouse/rules.h>

namespace taut::micromouse {

namespace {

using detail::ahead_of;
using detail::cell_at;
using detail::fits;
using detail::is_diagonal;
using detail::is_middle_of_cell;
using detail::middle_of;
using detail::turned_by;
using detail::TurnShape;

/// What a route costs: the aim first.
struct Cost {
  double first = 0;
  double second = 0;
  friend auto operator<=>(const Cost&, const Cost&) = default;
};

/// The kinds of state: standing, or just out of a turn.
constexpr unsigned kStanding = 0;
constexpr unsigned kKinds = 1 + kTurns;
using State = std::uint64_t;
constexpr State kNoState = ~State{0};

struct Label {
  Cost cost;
  State parent = kNoState;
  bool settled = false;
};

class Search {
 public:
  Search(const GridMaze& maze, const Task& task, const SpeedModel& model, Aim aim)
      : maze_(maze), task_(task), model_(model), aim_(aim), shapes_(detail::turn_shapes()) {}

  std::optional<SpeedRun> run() {
    reach(state(middle_of(task_.start), 0, kStanding), {}, kNoState);
    while (!queue_.empty()) {
      const auto [cost, at] = queue_.top();
      queue_.pop();
      Label& label = labels_.at(at);
      if (label.settled) continue;
      label.settled = true;
      if (is_end(at)) return run_to(at);
      expand(at, cost);
    }
    return std::nullopt;
  }

 private:
  using Entry = std::pair<Cost, State>;

  State state(Spot s, Eighth heading, unsigned kind) const {
    const auto row = static_cast<State>(2 * maze_.width() + 1);
    return ((static_cast<State>(s.y) * row + static_cast<State>(s.x)) * 8 + heading) * kKinds + kind;
  }
  unsigned kind_of(State s) const { return static_cast<unsigned>(s % kKinds); }
  Eighth heading_of(State s) const { return static_cast<Eighth>(s / kKinds % 8); }
  Spot spot_of(State s) const {
    const State cell = s / kKinds / 8, row = static_cast<State>(2 * maze_.width() + 1);
    return {static_cast<int>(cell % row), static_cast<int>(cell / row)};
  }
  double speed_of(State s) const {
    const unsigned kind = kind_of(s);
    return kind == kStanding ? 0 : model_.turns[kind - 1].speed;
  }
  bool is_end(State s) const {
    return kind_of(s) == kStanding && is_middle_of_cell(spot_of(s)) && task_.in_goal(cell_at(spot_of(s)));
  }

  bool open(Spot s) const { return detail::is_open(maze_, s); }
  static int crossing(Spot s) { return is_middle_of_cell(s) ? 0 : 1; }

  /// Walls crossed after the begin; -1: one of them stands.
  int crossings(const TurnShape& shape, Spot at) const {
    int count = 0;
    for (std::size_t i = 1; i < shape.way.size(); ++i) {
      const Spot s{at.x + shape.way[i].x, at.y + shape.way[i].y};
      if (!open(s)) return -1;
      count += crossing(s);
    }
    return count;
  }

  double unit(Eighth heading) const { return model_.cell / 2 * (is_diagonal(heading) ? std::numbers::sqrt2 : 1); }
  const Ramp& ramp(Eighth heading) const { return is_diagonal(heading) ? model_.diagonal : model_.straight; }

  Cost plus(const Cost& cost, double seconds, int crossed) const {
    const double cells = crossed;
    return aim_ == Aim::fastest ? Cost{cost.first + seconds, cost.second + cells}
                                : Cost{cost.first + cells, cost.second + seconds};
  }

  void reach(State to, const Cost& cost, State parent) {
    const auto [at, fresh] = labels_.try_emplace(to, Label{cost, parent, false});
    if (!fresh) {
      if (at->second.settled || !(cost < at->second.cost)) return;
      at->second = {cost, parent, false};
    }
    queue_.push({cost, to});
  }

  void expand(State from, const Cost& cost) {
    const Eighth heading = heading_of(from);
    if (kind_of(from) == kStanding) pivots(from, cost);
    Spot at = spot_of(from);
    int crossed = 0;
    for (int count = 0;; ++count) {
      const double metres = unit(heading) * count;
      if (count > 0 && is_middle_of_cell(at)) stop(from, cost, at, metres, crossed);
      for (const TurnShape& shape : shapes_[heading])
        if (fits(shape, at)) turn(from, cost, at, metres, crossed, shape);
      at = ahead_of(at, heading);
      if (!open(at)) return;
      crossed += crossing(at);
    }
  }

  void pivots(State from, const Cost& cost) {
    for (const int eighths : {2, 4, 6})
      reach(state(spot_of(from), turned_by(heading_of(from), eighths), kStanding),
            plus(cost, eighths == 4 ? model_.pivot_180 : model_.pivot_90, 0), from);
  }

  void stop(State from, const Cost& cost, Spot at, double metres, int crossed) {
    const Eighth heading = heading_of(from);
    const auto seconds = straight_seconds(ramp(heading), speed_of(from), 0, metres);
    if (seconds) reach(state(at, heading, kStanding), plus(cost, *seconds, crossed), from);
  }

  void turn(State from, const Cost& cost, Spot at, double metres, int crossed, const TurnShape& shape) {
    const auto seconds = straight_seconds(ramp(shape.heading), speed_of(from), model_.pace(shape.turn).speed, metres);
    if (!seconds) return;
    const int more = crossings(shape, at);
    if (more < 0) return;
    const Spot end{at.x + shape.way.back().x, at.y + shape.way.back().y};
    reach(state(end, shape.after, 1 + static_cast<unsigned>(shape.turn)),
          plus(cost, *seconds + model_.seconds(shape.turn), crossed + more), from);
  }

  SpeedRun run_to(State end) const {
    std::vector<State> chain;
    for (State s = end; s != kNoState; s = labels_.at(s).parent) chain.push_back(s);
    std::reverse(chain.begin(), chain.end());
    SpeedRun run;
    run.cells.push_back(task_.start);
    for (std::size_t i = 1; i < chain.size(); ++i) append(run, chain[i - 1], chain[i]);
    for (const Drive& d : run.drives) run.seconds += d.seconds, run.metres += d.metres;
    return run;
  }

  /// The straight and the turn between two states of the chain.
  void append(SpeedRun& run, State from, State to) const {
    const Eighth heading = heading_of(from);
    const Spot begin = spot_of(from);
    if (kind_of(to) == kStanding) {
      if (spot_of(to) == begin)
        run.drives.push_back({Drive::Kind::pivot,
                              {},
                              begin,
                              begin,
                              heading,
                              heading_of(to),
                              0,
                              0,
                              heading_of(to) == turned_by(heading, 4) ? model_.pivot_180 : model_.pivot_90,
                              0});
      else
        straight(run, begin, spot_of(to), heading, speed_of(from), 0);
      return;
    }
    const auto kind = static_cast<Turn>(kind_of(to) - 1);
    const double speed = model_.pace(kind).speed;
    const auto& [shape, at] = begin_of_turn(from, to, kind);
    if (at != begin) straight(run, begin, at, heading, speed_of(from), speed);
    run.drives.push_back({Drive::Kind::turn, kind, at, spot_of(to), heading, heading_of(to), speed, speed,
                          model_.seconds(kind), length(kind) * model_.cell / 2});
    for (std::size_t i = 1; i < shape->way.size(); ++i) cross(run, {at.x + shape->way[i].x, at.y + shape->way[i].y});
  }

  std::pair<const TurnShape*, Spot> begin_of_turn(State from, State to, Turn kind) const {
    const Eighth heading = heading_of(from);
    for (Spot at = spot_of(from);; at = ahead_of(at, heading))
      for (const TurnShape& shape : shapes_[heading])
        if (shape.turn == kind && shape.after == heading_of(to) && fits(shape, at) &&
            Spot{at.x + shape.way.back().x, at.y + shape.way.back().y} == spot_of(to))
          return {&shape, at};
  }

  void straight(SpeedRun& run, Spot from, Spot to, Eighth heading, double speed_in, double speed_out) const {
    const int count = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
    const double metres = unit(heading) * count;
    run.drives.push_back({Drive::Kind::straight,
                          {},
                          from,
                          to,
                          heading,
                          heading,
                          speed_in,
                          speed_out,
                          *straight_seconds(ramp(heading), speed_in, speed_out, metres),
                          metres});
    for (int i = 1; i <= count; ++i) cross(run, ahead_of(from, heading, i));
  }

  /// Into the other cell of this wall.
  static void cross(SpeedRun& run, Spot wall) {
    if (is_middle_of_cell(wall)) return;
    const Spot now = middle_of(run.cells.back());
    run.cells.push_back(cell_at({2 * wall.x - now.x, 2 * wall.y - now.y}));
  }

  const GridMaze& maze_;
  const Task& task_;
  const SpeedModel& model_;
  Aim aim_;
  std::vector<std::vector<TurnShape>> shapes_;
  std::unordered_map<State, Label> labels_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

std::string_view name(const Drive& drive) {
  if (drive.kind == Drive::Kind::turn) return name(drive.turn);
  if (drive.kind == Drive::Kind::pivot) return "pivot";
  return is_diagonal(drive.heading) ? "diagonal" : "straight";
}

std::optional<SpeedRun> speed_run(const GridMaze& maze, const SpeedModel& model, Aim aim) {
  const Task task = task_of(detail::with_closed_border(maze));
  return Search(maze, task, model, aim).run();
}

}  // namespace taut::micromouse
