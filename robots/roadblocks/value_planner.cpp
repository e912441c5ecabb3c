#include <taut/robots/roadblocks/value_planner.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <taut/robots/roadblocks/detail/pose_index.h>
#include <taut/robots/roadblocks/detail/steering.h>
#include <taut/robots/roadblocks/detail/tree_search.h>

namespace taut::roadblocks {

namespace {

constexpr double kEighth = std::numbers::pi / 4;
constexpr double kJoin = 1.5;       // how far the first state may be
constexpr double kMostAside = 0.4;  // a leg's heading off its eighth, radians
constexpr int kMostShut = 500;      // actions taken away in one plan
constexpr int kRounds = 8;

/// Turns, then straight moves of one heading, ahead or back.
struct Leg {
  std::vector<std::pair<std::size_t, Action>> turns, moves;
  int turned = 0;  ///< in eighths
  bool back() const { return !moves.empty() && moves.front().second == Action::back; }
  std::size_t last = 0;  ///< the state where it ends
};

/// What cannot be followed: an action, or, without one, a goal state at which the car did not cover the goal.
struct Culprit {
  std::size_t state;
  std::optional<Action> action;
};

class Follower {
 public:
  Follower(const detail::TreeRoom& room, const ValueGrid& grid, const Values& values, const Pose& from)
      : room_(room), grid_(grid), values_(values), pose_(from) {}

  /// Drives to the goal, into `plan`, or gives what is in the way.
  std::optional<Culprit> follow(std::size_t state, DrivePlan& plan) {
    eighths_ = grid_.heading(state);
    eighths_ += 8 * static_cast<int>(std::lround((pose_.heading / kEighth - eighths_) / 8));
    while (true) {
      const Leg leg = next_leg(state);
      if (const auto culprit = drive_leg(leg, plan); culprit || arrived_) return culprit;
      if (leg.turns.empty() && leg.moves.empty()) return Culprit{state, std::nullopt};
      state = leg.last;
    }
  }

 private:
  Leg next_leg(std::size_t state) const {
    Leg leg;
    for (auto action = best_action(grid_, values_, state); action; action = best_action(grid_, values_, state)) {
      const bool straight = action == Action::straight || action == Action::back;
      if (!leg.moves.empty() && action != leg.moves.front().second) break;
      (straight ? leg.moves : leg.turns).emplace_back(state, *action);
      leg.turned += straight ? 0 : action == Action::turn_plus ? 1 : -1;
      state = grid_.after(state, *action);
    }
    leg.last = state;
    return leg;
  }

  /// The turn after which the leg's end lies straight ahead, at most kMostAside off the eighth.
  detail::Turn turn_towards(const Leg& leg, const Pose& end) const {
    const double eighth = (eighths_ + leg.turned) * kEighth;
    detail::Turn turn{eighth - pose_.heading, true, false};
    for (int i = 0; i < kRounds && !leg.moves.empty(); ++i) {
      const Point by = turn.shift(pose_.heading);
      const double sign = leg.back() ? -1 : 1;
      const double towards = std::atan2(sign * (end.y - pose_.y - by.y), sign * (end.x - pose_.x - by.x));
      const double aside = std::remainder(towards - eighth, 2 * std::numbers::pi);
      turn.angle = eighth + std::clamp(aside, -kMostAside, kMostAside) - pose_.heading;
    }
    return turn;
  }

  std::optional<Culprit> drive_leg(const Leg& leg, DrivePlan& plan) {
    const Pose end = grid_.pose(leg.last);
    const detail::Turn turn = turn_towards(leg, end);
    const Point by = turn.shift(pose_.heading);
    std::vector<double> controls;
    turn.append_to(controls);
    const std::size_t turning = controls.size();
    eighths_ += leg.turned;
    if (!leg.moves.empty()) {
      const double heading = pose_.heading + turn.angle;
      const double far = std::cos(heading) * (end.x - pose_.x - by.x) + std::sin(heading) * (end.y - pose_.y - by.y);
      const long steps = leg.back() ? std::lround(-far / kBackward) : std::lround(far / kForward);
      controls.insert(controls.end(), static_cast<std::size_t>(std::max(0L, steps)), leg.back() ? kReverse : 0.0);
    }
    const detail::Stretch way = room_.driven(pose_, controls);
    plan.controls.insert(plan.controls.end(), controls.begin(),
                         controls.begin() + static_cast<std::ptrdiff_t>(way.poses.size()));
    plan.poses.insert(plan.poses.end(), way.poses.begin(), way.poses.end());
    if (!way.poses.empty()) pose_ = way.poses.back();
    arrived_ = way.arrived;
    if (way.whole || way.arrived) return std::nullopt;
    return culprit_of(leg, way.poses.size(), turning, controls.size() - turning);
  }

  /// The action of the leg that was under way after so many steps.
  static Culprit culprit_of(const Leg& leg, std::size_t done, std::size_t turning, std::size_t going) {
    const auto at = [&](const auto& actions, std::size_t step, std::size_t steps) {
      const auto [state, action] =
          actions[std::min(actions.size() - 1, step * actions.size() / std::max<std::size_t>(steps, 1))];
      return Culprit{state, action};
    };
    if (leg.moves.empty() || (done < turning && !leg.turns.empty())) return at(leg.turns, done, turning);
    return at(leg.moves, done < turning ? 0 : done - turning, going);
  }

  const detail::TreeRoom& room_;
  const ValueGrid& grid_;
  const Values& values_;
  Pose pose_;
  int eighths_ = 0;  ///< of the state's heading, whole turns counted
  bool arrived_ = false;
};

/// The nearest state from which there is a way.
std::optional<std::size_t> state_near(const ValueGrid& grid, const Values& values, const Pose& pose) {
  std::optional<std::size_t> best;
  double least = kJoin;
  const int i = static_cast<int>(std::lround((pose.x - 1) * grid.per_unit()));
  const int j = static_cast<int>(std::lround((pose.y - 1) * grid.per_unit()));
  for (int k = 0; k < ValueGrid::kHeadings; ++k)
    for (int y = std::max(j - 2, 0); y <= std::min(j + 2, grid.rows() - 1); ++y)
      for (int x = std::max(i - 2, 0); x <= std::min(i + 2, grid.columns() - 1); ++x) {
        const std::size_t state = grid.index(x, y, k);
        if (values.of[state] == ValueGrid::kNever) continue;
        if (const double far = detail::distance(grid.pose(state), pose); far < least) least = far, best = state;
      }
  return best;
}

}  // namespace

struct ValuePlanner::Impl {
  Impl(const Course& c, WallReading r, double t) : course(c), reading(r), turn_cost(t) {}

  const detail::TreeRoom& room(RoadblockSet closed) {
    auto at = rooms.find(closed);
    if (at == rooms.end()) at = rooms.emplace(closed, detail::TreeRoom(course, closed, reading)).first;
    return at->second;
  }

  std::optional<DrivePlan> planned(const Pose& from, RoadblockSet closed, int per_unit, bool backs) {
    grid.emplace(course, closed, reading, per_unit, ValueCosts{turn_cost * per_unit, backs});
    for (int i = 0; i < kMostShut; ++i) {
      values = value_iteration(*grid);
      const auto state = state_near(*grid, *values, from);
      if (!state) return std::nullopt;
      DrivePlan plan;
      const auto culprit = Follower(room(closed), *grid, *values, from).follow(*state, plan);
      if (!culprit) return plan;
      if (culprit->action)
        grid->shut(culprit->state, *culprit->action);
      else
        grid->shut_goal(culprit->state);
    }
    return std::nullopt;
  }

  const Course& course;
  WallReading reading;
  double turn_cost;
  std::map<RoadblockSet, detail::TreeRoom> rooms;
  std::optional<ValueGrid> grid;
  std::optional<Values> values;
};

ValuePlanner::ValuePlanner(const Course& course, WallReading reading, double turn_cost)
    : impl_(std::make_unique<Impl>(course, reading, turn_cost)) {}

ValuePlanner::~ValuePlanner() = default;

Attempt ValuePlanner::plan(const Pose& from, RoadblockSet closed) {
  if (!impl_->room(closed).distance().reaches({from.x, from.y})) return {std::nullopt, true};
  for (const auto& [per_unit, backs] : {std::pair{2, false}, std::pair{4, false}, std::pair{4, true}})
    if (auto plan = impl_->planned(from, closed, per_unit, backs)) return {std::move(plan), false};
  return {};
}

const ValueGrid* ValuePlanner::grid() const { return impl_->grid ? &*impl_->grid : nullptr; }
const Values* ValuePlanner::values() const { return impl_->values ? &*impl_->values : nullptr; }

}  // namespace taut::roadblocks
