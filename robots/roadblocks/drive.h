// The simulator: a driver at the wheel, who sees roadblocks only from near.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <taut/robots/roadblocks/car.h>
#include <taut/robots/roadblocks/roadblock_map.h>

namespace taut::roadblocks {

/// What the car has seen so far: walls are known beforehand, roadblocks are unknown until a cell of theirs is seen. It
/// does not know the sample.
class ObservedMap {
 public:
  explicit ObservedMap(const Course& course) : course_(&course) {}  ///< `course` must outlive it

  const Course& course() const { return *course_; }
  RoadblockSet open() const { return open_; }      ///< seen to be open
  RoadblockSet closed() const { return closed_; }  ///< seen to be closed
  RoadblockSet unknown() const { return all() & ~(open_ | closed_); }
  RoadblockSet all() const { return (RoadblockSet{1} << course_->roadblocks.size()) - 1; }
  void learn(RoadblockSet seen, RoadblockSet open) {
    open_ |= seen & open;
    closed_ |= seen & ~open;
  }

 private:
  const Course* course_;
  RoadblockSet open_ = 0;
  RoadblockSet closed_ = 0;
};

/// The roadblocks with a cell whose centre is at most kSight from the car's.
RoadblockSet seen_from(const Pose& pose, const Course& course);

/// Is the goal in or on the rectangle?
inline bool at_goal(const Pose& pose, const Course& course, double slack = 0) {
  return covers(pose, course.goal, slack);
}

/// What the car would meet.
bool collides(const Pose& from, double control, const Course& course, RoadblockSet closed, WallReading reading);

/// Throws InputError when the car cannot stand at the start: on a wall, or on a roadblock, which may be one.
void require_start_free(const Course& course, WallReading reading, const std::string& source = {});

/// Decides. It is asked once a step and gets nothing but what the car knows.
class Driver {
 public:
  Driver() = default;
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;
  virtual ~Driver() = default;

  /// The next control; nothing when the driver sees no route.
  virtual std::optional<double> next(const ObservedMap& map, const Pose& pose) = 0;
  /// How often a plan was given up or chosen anew because of what was seen.
  virtual int replans() const = 0;
  /// After next() gave nothing: is that unproven, because samples were used up or a discretisation was too coarse?
  virtual bool gave_up() const { return false; }
  /// Was every choice the best of those considered? False when a choice was cut short.
  virtual bool exact() const { return true; }
};

enum class Outcome : std::uint8_t { reached, no_route, collision, limit, gave_up };
std::string_view name(Outcome outcome);  ///< `reached`, `no route`, `collision`, `limit`, `gave up`

/// A drive: everything to replay and draw it.
struct Drive {
  Outcome outcome = Outcome::limit;
  std::vector<double> controls;
  std::vector<Pose> poses;                           ///< one more than controls
  std::vector<std::pair<int, RoadblockSet>> sights;  ///< after so many steps these roadblocks became known
  RoadblockSet open = 0;                             ///< the sample
  int replans = 0;

  /// The roadblocks that were seen at last.
  RoadblockSet known() const {
    RoadblockSet all = 0;
    for (const auto& [steps, seen] : sights) all |= seen;
    return all;
  }
};

/// Drives from course.start with heading 0 until the goal is reached (0 steps when it is there already), the car
/// collides, the driver sees no route or gives up, or kLongestDrive steps are done. After each step: collision, then
/// sight, then goal. Precondition: require_start_free.
Drive drive(const Course& course, RoadblockSet open, Driver& driver, WallReading reading);

}  // namespace taut::roadblocks
