// The search of Polyanya: cones of sight from roots, through portals.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <taut/geometry/written.h>
#include <taut/roadmaps/navmesh.h>
#include <taut/search/detail/landmarks.h>
#include <taut/search/detail/taut_string.h>
#include <taut/search/graph_search.h>

namespace taut::detail {

/// A place where a path may end, and the polygons whose sight of it counts.
struct MeshGoal {
  Point point;
  std::vector<std::uint32_t> polygons;
};

/// One search after the other on one mesh, in the same memory: nothing is cleared or allocated between them once it has
/// grown.
///
/// A root is the start or a bend that a shortest path may turn at, with its length and the root before it. A node is a
/// root and what is seen from it through a portal: a cone between two rays, each through a corner, or away from the
/// root before (the straight continuation of the last leg). Rays are never rounded, so what is seen is exact: every
/// test is the side of three given points.
///
/// Where only one way leads from polygon to polygon, as in a maze without loops, there is nothing to search: a string
/// is pulled taut along it.
///
/// Two numbers are doubles, with their error bounds: a root's length, and the lower bound of a path through a node, by
/// which the queue is ordered. Where bounds overlap lengths are compared as sums of roots, and the search goes on until
/// no open node's lower bound is below the best path's upper one. So the path is the shortest, whatever was rounded.
class PolyanyaEngine {
 public:
  /// `landmarks` may be absent; they outlive the engine.
  explicit PolyanyaEngine(const Navmesh& mesh, const Landmarks* landmarks = nullptr);

  /// The mesh has changed, within the box of its corners.
  void renew();

  /// What is asked. `start_polygons` are those that hold `start`.
  struct Query {
    Point start;
    std::span<const std::uint32_t> start_polygons;
    std::span<const MeshGoal> goals;
    bool nearest = true;      ///< the nearest of the goals; else each of them
    bool other_ends = false;  ///< on_root may add ways to ends that are not among the goals
    SearchLimits limits{};
  };

  /// A way to a goal: from root to root, then straight to `end`.
  struct Way {
    std::uint32_t root = kNone;
    std::uint32_t goal = kNone;
    Point end;
    double length = std::numeric_limits<double>::infinity();
    double error = 0;

    bool exists() const { return root != kNone; }
  };

  /// `on_root(p, root, length)` is called for the start and each bend that is turned at, and may add_way().
  template <typename OnRoot>
  SearchStatus run(const Query& query, OnRoot&& on_root) {
    begin(query);
    on_root(query.start, 0);
    if (follow_corridors(query)) return SearchStatus::found;
    if (!is_separated_) look_around(query.start_polygons);
    while (take()) {
      if (expanded_ >= query.limits.expansions || out_of_time()) return SearchStatus::stopped;
      ++expanded_;
      if (node_.enter != kNone) {
        look_through();
      } else {
        on_root(roots_[node_.root].point, node_.root);
        turn();
      }
    }
    return found() ? SearchStatus::found : SearchStatus::none;
  }

  /// The lengths of the shortest paths from one bend to all, to within a few roundings; infinite where there is none.
  void measure(std::uint32_t bend, std::vector<double>& distances);

  /// A further way to goal 0, straight from `root` to `end`.
  void add_way(std::uint32_t root, Point end) { improve(root, 0, end); }
  /// A place in the direction of the inside of the sector that a root turns in; nothing of the start.
  std::optional<Point> beyond(std::uint32_t root) const {
    const Root& at = roots_[root];
    if (at.bend == kNone) return std::nullopt;
    const Navmesh::Bend& bend = mesh_.bends[at.bend];
    return Point{3 * at.point.x - bend.right.x - bend.left.x, 3 * at.point.y - bend.right.y - bend.left.y};
  }
  /// Could a way from this root, `distance` on (rounded), still be the shortest?
  bool may_improve(std::uint32_t root, double distance) const {
    return roots_[root].length + distance - slack_ * 4 - roots_[root].error <= bound_;
  }

  /// Of the nearest goal, or of goal i.
  const Way& way(std::size_t i = 0) const { return ways_[i]; }
  /// The points of a way, consecutive equal ones merged.
  void points(const Way& way, std::vector<Point>& out) const;

  std::size_t expanded() const { return expanded_; }
  std::size_t generated() const { return generated_; }

 private:
  static constexpr std::uint32_t kAway = 0xfffffffe;  // a ray: away from the root before
  static constexpr std::uint32_t kLeftTurn = 1, kRightTurn = 2;

  struct Root {
    Point point;
    double length;
    double error;  // of `length`, at most
    std::uint32_t before;
    std::uint32_t bend;
    double least = 0;  // of a path through it, at least
  };

  /// enter: the side, seen from inside, of the polygon that the cone comes to; kNone: the root's turns, those in
  /// `right`.
  struct Node {
    double bound;
    std::uint32_t root;
    std::uint32_t enter;
    std::uint32_t right;
    std::uint32_t left;
  };

  /// The cone that is being followed.
  struct Cone {
    std::uint32_t root;
    Point origin;
    Point right_through, left_through;
    int right_sign, left_sign;
    std::uint32_t right, left;

    int from_right(Point p) const { return right_sign * written::orientation(origin, right_through, p); }
    int from_left(Point p) const { return left_sign * written::orientation(origin, left_through, p); }
  };

  static double distance(Point p, Point q) {
    const double dx = p.x - q.x, dy = p.y - q.y;
    return std::sqrt(dx * dx + dy * dy);
  }

  /// Of the length of a way: to `before`, then `leg`; `length` is the sum.
  static double error_of(const Root& before, double leg, double length) {
    return before.error + 0x1p-50 * leg + 0x1p-52 * length + 1e-150;
  }

  struct Best {
    std::uint32_t query = 0;
    std::uint32_t root = kNone;
  };
  struct GoalPlace {
    std::uint32_t polygon;
    std::uint32_t goal;
  };
  struct GoalsHere {
    std::uint32_t query = 0;
    std::uint32_t first = 0;
  };

  void begin(const Query& query);
  void place_goals(std::span<const MeshGoal> goals);
  void allow_blocks(std::span<const std::uint32_t> starts);
  bool allow_between(std::uint32_t p, std::uint32_t q);
  bool follow_corridors(const Query& query);
  bool lay_out(std::uint32_t p, std::uint32_t q, std::span<const std::uint32_t> starts);
  void pull_taut();
  bool out_of_time();
  bool found() const;

  bool take();
  void push(const Node& node);

  void look_around(std::span<const std::uint32_t> polygons);
  void look_through();
  void turn();
  void turn_left();
  void turn_right();
  Cone cone(std::uint32_t root, std::uint32_t right, std::uint32_t left) const;
  void follow(const Cone& cone, std::uint32_t polygon, std::uint32_t chain, std::uint32_t sides);
  void pass(const Cone& cone, std::uint32_t side, Point a, Point b, bool right_is_a, bool left_is_b);
  void see_goals(const Cone& cone, std::uint32_t polygon);
  void see_corner(std::uint32_t root, std::uint32_t corner);
  std::uint32_t turns_at(Point from, std::uint32_t corner) const;
  bool is_worse(std::uint32_t before, Point at, double length, double error, std::uint32_t than);
  void improve(std::uint32_t root, std::uint32_t goal, Point end);
  bool is_shorter_exactly(std::uint32_t root_a, Point end_a, std::uint32_t root_b, Point end_b);
  double to_goal(Point p) const;
  double bound_through(const Cone& cone, Point a, Point b, bool right_is_a, bool left_is_b) const;
  void renew_bound();

  const Navmesh& mesh_;
  double magnitude_ = 0;  // of the greatest coordinate
  double slack_ = 0;

  std::uint32_t query_ = 0;
  std::vector<Best> best_;              // by bend
  std::vector<GoalsHere> goals_here_;   // by polygon
  std::vector<std::uint32_t> allowed_;  // by block: the last query that may pass it
  std::vector<Root> roots_;
  std::vector<Node> open_;              // a heap, the least bound first
  std::vector<GoalPlace> goal_places_;  // by polygon
  std::vector<Way> ways_;
  std::vector<Segment> legs_a_, legs_b_;
  std::vector<std::uint32_t> corridor_, corridor_back_;  // the corners of its portals, from the polygon that is left
  TautString string_;
  std::vector<bool> reachable_;  // by goal
  LandmarkBounds landmarks_;
  std::vector<double>* distances_ = nullptr;  // by bend, while measuring

  std::span<const MeshGoal> goals_;
  Box goal_box_;
  bool nearest_ = true;
  bool is_separated_ = false;  // no goal lies in a component of the start
  bool only_bridges_ = false;  // from start to goals one way leads, portal after portal
  std::size_t unreached_ = 0;  // of goals asked each
  double bound_ = 0;           // no way longer than this is of interest
  Node next_{};                // the best of those just made, not yet in the heap
  bool has_next_ = false;
  Node node_{};
  std::size_t expanded_ = 0, generated_ = 0;
  SearchLimits limits_;
  double deadline_ = 0;
};

}  // namespace taut::detail
