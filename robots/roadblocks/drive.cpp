#include <taut/robots/roadblocks/drive.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/errors.h>
#include <taut/geometry/text.h>

namespace taut::roadblocks {

namespace {

constexpr double kReach = 2.7;      // half a diagonal of the car, half one of a square, a step
constexpr double kRounding = 1e-9;  // of the swept reading: no contact is lost to rounding

/// Calls `visit` for each cell that a car near the pose might touch, until it says true.
template <typename Visit>
bool any_cell_near(const Pose& pose, const Course& course, Visit visit) {
  const int left = std::max(1, static_cast<int>(std::ceil(std::max(pose.x - kReach, 0.0))));
  const int right = std::min(course.width, static_cast<int>(std::floor(std::min(pose.x + kReach, 1e6))));
  const int top = std::max(1, static_cast<int>(std::ceil(std::max(pose.y - kReach, 0.0))));
  const int bottom = std::min(course.height, static_cast<int>(std::floor(std::min(pose.y + kReach, 1e6))));
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x)
      if (visit(Cell{x, y})) return true;
  return false;
}

double slack_of(WallReading reading) { return reading == WallReading::squares ? kRounding : 0; }

}  // namespace

RoadblockSet seen_from(const Pose& pose, const Course& course) {
  RoadblockSet seen = 0;
  for (std::size_t i = 0; i < course.roadblocks.size(); ++i)
    for (const Cell c : course.roadblocks[i].cells) {
      const double dx = c.x - pose.x, dy = c.y - pose.y;
      if (dx * dx + dy * dy <= kSight * kSight) seen |= RoadblockSet{1} << i;
    }
  return seen;
}

bool collides(const Pose& from, double control, const Course& course, RoadblockSet closed, WallReading reading) {
  const auto met = [&](Cell c) { return meets(from, control, c, reading, slack_of(reading)); };
  if (any_cell_near(from, course, [&](Cell c) { return course.is_wall(c) && met(c); })) return true;
  for (std::size_t i = 0; i < course.roadblocks.size(); ++i)
    if ((closed >> i) & 1 && std::ranges::any_of(course.roadblocks[i].cells, met)) return true;
  return false;
}

void require_start_free(const Course& course, WallReading reading, const std::string& source) {
  const Pose pose{course.start.x, course.start.y, 0};
  const auto met = [&](Cell c) { return touches(pose, c, reading, slack_of(reading)); };
  any_cell_near(pose, course, [&](Cell c) {
    if (course.is_wall(c) && met(c))
      throw InputError(source, 0, "the car at start " + text(course.start) + " touches the wall " + text(c));
    return false;
  });
  for (const Roadblock& block : course.roadblocks)
    if (std::ranges::any_of(block.cells, met))
      throw InputError(source, 0,
                       "the car at start " + text(course.start) + " stands on the roadblock " + block.letter);
}

std::string_view name(Outcome outcome) {
  switch (outcome) {
    case Outcome::reached: return "reached";
    case Outcome::no_route: return "no route";
    case Outcome::collision: return "collision";
    case Outcome::gave_up: return "gave up";
    case Outcome::limit: break;
  }
  return "limit";
}

Drive drive(const Course& course, RoadblockSet open, Driver& driver, WallReading reading) {
  Drive run;
  run.open = open;
  ObservedMap map(course);
  Pose pose{course.start.x, course.start.y, 0};
  run.poses.push_back(pose);
  if (at_goal(pose, course)) run.outcome = Outcome::reached;
  while (run.outcome == Outcome::limit && run.controls.size() < static_cast<std::size_t>(kLongestDrive)) {
    const std::optional<double> control = driver.next(map, pose);
    if (!control) {
      run.outcome = driver.gave_up() ? Outcome::gave_up : Outcome::no_route;
      break;
    }
    const bool hit = collides(pose, *control, course, map.all() & ~open, reading);
    pose = stepped(pose, *control);
    run.controls.push_back(*control);
    run.poses.push_back(pose);
    if (hit) {
      run.outcome = Outcome::collision;
      break;
    }
    if (const RoadblockSet seen = seen_from(pose, course) & map.unknown()) {
      map.learn(seen, open);
      run.sights.emplace_back(static_cast<int>(run.controls.size()), seen);
    }
    if (at_goal(pose, course)) run.outcome = Outcome::reached;
  }
  run.replans = driver.replans();
  return run;
}

}  // namespace taut::roadblocks
