#include <taut/robots/micromouse/legality.h>

#include <algorithm>
#include <deque>
#include <set>

#include <taut/robots/micromouse/rules.h>

namespace taut::micromouse {

namespace {

std::string text(Cell c) { return "(" + std::to_string(c.x) + "," + std::to_string(c.y) + ")"; }

std::string text(Cell c, Side side) {
  static constexpr const char* kNames[] = {"north", "east", "south", "west"};
  return text(c) + " " + kNames[static_cast<std::size_t>(side)];
}

constexpr int kClassic = 16;

class Inspection {
 public:
  Inspection(const GridMaze& maze, MazeRules rules)
      : maze_(maze), rules_(rules), goal_(maze.goal.begin(), maze.goal.end()) {
    if (!goal_.empty()) return;
    const auto room = centre_room(maze.width(), maze.height());
    goal_ = {room.begin(), room.end()};
  }

  std::vector<std::string> faults() {
    size();
    border();
    start();
    goal();
    reach();
    if (rules_ == MazeRules::competition && maze_.width() <= kClassic) posts();
    return std::move(faults_);
  }

 private:
  void fault(std::string what) { faults_.push_back(std::move(what)); }
  bool wall(Cell c, Side side) const { return maze_.wall(c, side); }
  bool inside(Cell c) const { return maze_.contains(c); }

  void size() {
    const int w = maze_.width(), h = maze_.height();
    const std::set<int> sides = rules_ == MazeRules::free_posts ? std::set{12, 14, 16} : std::set{16, 32};
    if (w == h && sides.contains(w)) return;
    fault("size " + std::to_string(w) + " x " + std::to_string(h) + ", which is not " +
          (rules_ == MazeRules::free_posts ? "12 x 12, 14 x 14 or 16 x 16" : "16 x 16 or 32 x 32"));
  }

  void border() {
    for (int y = 0; y < maze_.height(); ++y)
      for (int x = 0; x < maze_.width(); ++x)
        for (const Side side : kSides)
          if (!inside(ahead({x, y}, side)) && !wall({x, y}, side))
            fault("the outer wall is open at " + text({x, y}, side));
  }

  void start() {
    const Cell s = maze_.start;
    if (!inside(s)) return fault("the start " + text(s) + " lies outside");
    const bool corner = (s.x == 0 || s.x == maze_.width() - 1) && (s.y == 0 || s.y == maze_.height() - 1);
    if (!corner) fault("the start " + text(s) + " is no corner");
    for (const Side side : {Side::east, Side::south, Side::west})
      if (!wall(s, side) && inside(ahead(s, side)))
        fault("the start " + text(s) + " is open to the " + text_of(side) + ", it must be closed on three sides");
    if (wall(s, Side::north)) fault("the start " + text(s) + " is closed to the north");
  }

  static std::string text_of(Side side) {
    return side == Side::east ? "right (east)" : side == Side::west ? "left (west)" : "south";
  }

  void goal() {
    if (goal_.contains(maze_.start)) fault("the start lies in the goal");
    for (const Cell c : goal_) {
      if (!inside(c)) return fault("goal cell " + text(c) + " lies outside");
      for (const Side side : {Side::north, Side::east})
        if (goal_.contains(ahead(c, side)) && wall(c, side)) fault("a wall in the goal room at " + text(c, side));
    }
    const auto centre = centre_room(maze_.width(), maze_.height());
    const bool small = std::max(maze_.width(), maze_.height()) <= 16;
    if (small && goal_ != std::set<Cell>(centre.begin(), centre.end())) fault("the goal is not the room in the middle");
    if (spread(*goal_.begin(), true).size() < goal_.size() && no_walls_in_goal())
      fault("the goal cells are not one room");
  }

  bool no_walls_in_goal() const {
    for (const Cell c : goal_)
      for (const Side side : kSides)
        if (goal_.contains(ahead(c, side)) && wall(c, side)) return false;
    return true;
  }

  void reach() {
    if (!inside(maze_.start)) return;
    const std::set<Cell> reached = spread(maze_.start, false);
    if (std::none_of(goal_.begin(), goal_.end(), [&](Cell c) { return reached.contains(c); }))
      fault("there is no way from the start to the goal");
  }

  std::set<Cell> spread(Cell from, bool in_goal_only) const {
    std::set<Cell> reached{from};
    std::deque<Cell> queue{from};
    for (; !queue.empty(); queue.pop_front())
      for (const Side side : kSides) {
        const Cell next = ahead(queue.front(), side);
        if (wall(queue.front(), side) || !inside(next) || (in_goal_only && !goal_.contains(next))) continue;
        if (reached.insert(next).second) queue.push_back(next);
      }
    return reached;
  }

  // The post at the north-east corner of each cell.
  void posts() {
    for (int y = 0; y + 1 < maze_.height(); ++y)
      for (int x = 0; x + 1 < maze_.width(); ++x) {
        const Cell sw{x, y}, ne{x + 1, y + 1};
        if (wall(sw, Side::north) || wall(sw, Side::east) || wall(ne, Side::south) || wall(ne, Side::west)) continue;
        if (goal_.contains(sw) && goal_.contains(ne) && goal_.contains({x + 1, y}) && goal_.contains({x, y + 1}))
          continue;
        fault("no wall touches the post at the upper right of " + text(sw));
      }
  }

  const GridMaze& maze_;
  MazeRules rules_;
  std::set<Cell> goal_;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> violations(const GridMaze& maze, MazeRules rules) { return Inspection(maze, rules).faults(); }

}  // namespace taut::micromouse
