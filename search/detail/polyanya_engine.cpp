#include <taut/search/detail/polyanya_engine.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace taut::detail {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double distance(Point p, Point q) {
  const double dx = p.x - q.x, dy = p.y - q.y;
  return std::sqrt(dx * dx + dy * dy);
}

/// Between two boxes, at least.
double gap(const Box& a, const Box& b) {
  const double dx = std::max({0.0, a.min.x - b.max.x, b.min.x - a.max.x}),
               dy = std::max({0.0, a.min.y - b.max.y, b.min.y - a.max.y});
  return std::sqrt(dx * dx + dy * dy);
}

Box box_of(Point a, Point b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

double cross(Point o, Point a, Point b) { return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x); }

/// A ray's end on a side, rounded, and how far from the true one it may lie.
struct RayEnd {
  Point point;
  double error = 0;
};

RayEnd end_of_ray(Point origin, Point through, Point a, Point b, double magnitude) {
  const double at_a = cross(origin, through, a), at_b = cross(origin, through, b), all = at_a - at_b;
  if (all == 0) return {a, kInfinity};
  const double t = std::clamp(at_a / all, 0.0, 1.0);
  const double ray = std::abs(through.x - origin.x) + std::abs(through.y - origin.y),
               side = std::abs(b.x - a.x) + std::abs(b.y - a.y);
  // Each cross product is off by at most 8 roundings of ray * magnitude.
  return {{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}, 0x1p-48 * side * ray * magnitude / std::abs(all)};
}

/// p on the other side of the line a b, when it is to the left of it.
Point mirrored_if_left(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y, turn = dx * (p.y - a.y) - dy * (p.x - a.x);
  if (turn <= 0) return p;
  const double scale = 2 * turn / (dx * dx + dy * dy);
  return {p.x + dy * scale, p.y - dx * scale};
}

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

PolyanyaEngine::PolyanyaEngine(const Navmesh& mesh, const Landmarks* landmarks)
    : mesh_(mesh),
      best_(mesh.bends.size()),
      goals_here_(mesh.polygon_count()),
      allowed_(mesh.blocks.top.size(), 0),
      landmarks_(landmarks, mesh) {
  for (const Navmesh::Corner& c : mesh.corners)
    magnitude_ = std::max({magnitude_, std::abs(c.point.x), std::abs(c.point.y)});
  slack_ = 0x1p-44 * magnitude_;
}

// ---- a query ------------------------------------------------------------------------------------------------------------------------

void PolyanyaEngine::begin(const Query& query) {
  if (++query_ == 0) {
    std::fill(best_.begin(), best_.end(), Best{});
    std::fill(goals_here_.begin(), goals_here_.end(), GoalsHere{});
    std::fill(allowed_.begin(), allowed_.end(), 0);
    query_ = 1;
  }
  roots_.clear();
  open_.clear();
  roots_.push_back({query.start, 0, 0, kNone, kNone});
  has_next_ = false;
  expanded_ = generated_ = 1;
  nearest_ = query.nearest;
  limits_ = query.limits;
  if (limits_.seconds < 1e9) deadline_ = now() + limits_.seconds;
  place_goals(query.goals);
  allow_blocks(query.start_polygons);
  if (query.other_ends) is_separated_ = false;
  if (nearest_ && !query.other_ends && goals_.size() == 1)
    landmarks_.aim_at(goals_[0].point, goals_[0].polygons);
  else
    landmarks_.aim_at_nothing();
}

void PolyanyaEngine::measure(std::uint32_t bend, std::vector<double>& distances) {
  std::vector<std::uint32_t> around;
  for (const Navmesh::Corner& corner : mesh_.corners)
    if (corner.bend == bend) around.push_back(corner.polygon);
  begin({mesh_.corners[mesh_.bends[bend].right_corner].point, around, {}, false, false, {}});
  std::fill(allowed_.begin(), allowed_.end(), query_);
  distances.assign(mesh_.bends.size(), kInfinity);
  distances[bend] = 0;
  distances_ = &distances;
  look_around(around);
  while (take()) node_.enter != kNone ? look_through() : turn();
  distances_ = nullptr;
}

void PolyanyaEngine::place_goals(std::span<const MeshGoal> goals) {
  goals_ = goals;
  goal_places_.clear();
  ways_.assign(nearest_ ? 1 : goals.size(), Way{});
  unreached_ = ways_.size();
  bound_ = kInfinity;
  if (goals.empty()) return;
  goal_box_ = {goals[0].point, goals[0].point};
  for (std::uint32_t i = 0; i < goals.size(); ++i) {
    const Point p = goals[i].point;
    goal_box_.min = {std::min(goal_box_.min.x, p.x), std::min(goal_box_.min.y, p.y)};
    goal_box_.max = {std::max(goal_box_.max.x, p.x), std::max(goal_box_.max.y, p.y)};
    for (const std::uint32_t polygon : goals[i].polygons) goal_places_.push_back({polygon, i});
  }
  if (goals.size() > 1)
    std::sort(goal_places_.begin(), goal_places_.end(), [](const GoalPlace& a, const GoalPlace& b) {
      return a.polygon != b.polygon ? a.polygon < b.polygon : a.goal < b.goal;
    });
  for (std::uint32_t i = static_cast<std::uint32_t>(goal_places_.size()); i-- > 0;)
    goals_here_[goal_places_[i].polygon] = {query_, i};
}

void PolyanyaEngine::allow_blocks(std::span<const std::uint32_t> starts) {
  reachable_.assign(goals_.size(), false);
  only_bridges_ = true;
  for (const std::uint32_t p : starts)
    for (const GoalPlace& place : goal_places_)
      if (allow_between(p, place.polygon)) reachable_[place.goal] = true;
  const auto reachable = static_cast<std::size_t>(std::count(reachable_.begin(), reachable_.end(), true));
  is_separated_ = reachable == 0;
  if (!nearest_) unreached_ = reachable;
}

/// All blocks between two polygons: the only ones that a shortest path from one to the other can pass. False when they lie in two components.
bool PolyanyaEngine::allow_between(std::uint32_t p, std::uint32_t q) {
  const Navmesh::BlockTree& tree = mesh_.blocks;
  while (p != q) {
    std::uint32_t& deeper = tree.depth[p] >= tree.depth[q] ? p : q;
    const std::uint32_t block = tree.above[deeper];
    if (block == kNone) return false;
    allowed_[block] = query_;
    only_bridges_ = only_bridges_ && tree.bridge[block] != kNone;
    deeper = tree.top[block];
  }
  return true;
}

/// From start to goal along each pair of their polygons, where no other way leads from the one to the other. False where there is something to search.
bool PolyanyaEngine::follow_corridors(const Query& query) {
  if (is_separated_ || !nearest_ || query.other_ends || goals_.size() != 1 || !only_bridges_ ||
      query.limits.expansions <= mesh_.polygon_count())
    return false;
  for (const std::uint32_t p : query.start_polygons)
    for (const GoalPlace& place : goal_places_)
      if (lay_out(p, place.polygon, query.start_polygons)) pull_taut();
  return true;
}

/// The corridor between two polygons. False when there is none, or when it passes another polygon of the same end: from there it is no longer.
bool PolyanyaEngine::lay_out(std::uint32_t p, std::uint32_t q, std::span<const std::uint32_t> starts) {
  const Navmesh::BlockTree& tree = mesh_.blocks;
  const std::uint32_t start = p, goal = q;
  const auto is_other_end = [&](std::uint32_t polygon) {
    return (polygon != goal && goals_here_[polygon].query == query_) ||
           (polygon != start && starts.size() > 1 && std::find(starts.begin(), starts.end(), polygon) != starts.end());
  };
  corridor_.clear();
  corridor_back_.clear();
  if (is_other_end(p) || is_other_end(q)) return false;
  while (p != q) {
    const bool ahead = tree.depth[p] >= tree.depth[q];
    std::uint32_t& deeper = ahead ? p : q;
    const std::uint32_t block = tree.above[deeper];
    if (block == kNone) return false;
    std::uint32_t c = tree.bridge[block];
    if ((mesh_.corners[c].polygon == deeper) != ahead) c = mesh_.corners[c].across;
    (ahead ? corridor_ : corridor_back_).push_back(c);
    deeper = tree.top[block];
    if (p != q && is_other_end(deeper)) return false;
  }
  corridor_.insert(corridor_.end(), corridor_back_.rbegin(), corridor_back_.rend());
  return true;
}

void PolyanyaEngine::pull_taut() {
  const Point end = goals_[0].point;
  string_.begin(roots_[0].point);
  Point right = roots_[0].point, left = right;
  for (const std::uint32_t c : corridor_) {
    const Point a = mesh_.corners[c].point, b = mesh_.corners[mesh_.next(c)].point;
    if (a != right) string_.widen_right(right = a);
    if (b != left) string_.widen_left(left = b);
  }
  const std::vector<Point>& points = string_.close(end);
  std::uint32_t root = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Root& before = roots_[root];
    const double leg = distance(before.point, points[i]), length = before.length + leg;
    const Root next{points[i], length, error_of(before, leg, length), root, kNone};
    root = static_cast<std::uint32_t>(roots_.size());
    roots_.push_back(next);
  }
  improve(root, 0, end);
}

bool PolyanyaEngine::out_of_time() { return limits_.seconds < 1e9 && expanded_ % 64 == 0 && now() >= deadline_; }

bool PolyanyaEngine::found() const {
  return std::any_of(ways_.begin(), ways_.end(), [](const Way& way) { return way.exists(); });
}

void PolyanyaEngine::points(const Way& way, std::vector<Point>& out) const {
  out.assign(1, way.end);
  for (std::uint32_t r = way.root; r != kNone; r = roots_[r].before)
    if (roots_[r].point != out.back()) out.push_back(roots_[r].point);
  std::reverse(out.begin(), out.end());
}

// ---- the queue ----------------------------------------------------------------------------------------------------------------------

namespace {
constexpr auto kLater = [](const auto& a, const auto& b) { return a.bound > b.bound; };
}

/// The best of the nodes just made is often the next one taken; it need not go through the heap.
void PolyanyaEngine::push(const Node& node) {
  ++generated_;
  if (!has_next_) {
    next_ = node;
    has_next_ = true;
    return;
  }
  const bool better = node.bound < next_.bound;
  open_.push_back(better ? next_ : node);
  if (better) next_ = node;
  std::push_heap(open_.begin(), open_.end(), kLater);
}

bool PolyanyaEngine::take() {
  while (has_next_ || !open_.empty()) {
    if (has_next_ && (open_.empty() || next_.bound <= open_.front().bound)) {
      node_ = next_;
    } else {
      node_ = open_.front();
      std::pop_heap(open_.begin(), open_.end(), kLater);
      open_.pop_back();
      if (has_next_) {
        open_.push_back(next_);
        std::push_heap(open_.begin(), open_.end(), kLater);
      }
    }
    has_next_ = false;
    if (node_.bound > bound_) return false;
    const std::uint32_t bend = roots_[node_.root].bend;
    if (bend == kNone || best_[bend].root == node_.root) return true;  // else there is a shorter way to its root by now
  }
  return false;
}

// ---- what is seen -------------------------------------------------------------------------------------------------------------------

PolyanyaEngine::Cone PolyanyaEngine::cone(std::uint32_t root, std::uint32_t right, std::uint32_t left) const {
  const Root& r = roots_[root];
  Cone cone{root, r.point, {}, {}, right == kAway ? -1 : 1, left == kAway ? -1 : 1, right, left};
  cone.right_through = right == kAway ? roots_[r.before].point : mesh_.corners[right].point;
  cone.left_through = left == kAway ? roots_[r.before].point : mesh_.corners[left].point;
  return cone;
}

/// From the start, all of its polygons.
void PolyanyaEngine::look_around(std::span<const std::uint32_t> polygons) {
  const Point start = roots_[0].point;
  for (const std::uint32_t polygon : polygons) {
    if (goals_here_[polygon].query == query_)
      for (std::uint32_t i = goals_here_[polygon].first; i < goal_places_.size() && goal_places_[i].polygon == polygon;
           ++i)
        improve(0, goal_places_[i].goal, goals_[goal_places_[i].goal].point);
    for (std::uint32_t c = mesh_.first[polygon]; c < mesh_.first[polygon + 1]; ++c) {
      const std::uint32_t d = mesh_.next(c);
      const Point a = mesh_.corners[c].point, b = mesh_.corners[d].point;
      if (a == start) continue;
      see_corner(0, c);
      // Of a side in line with the start nothing is seen through, unless it is on it.
      if (b != start && (side_of(start, a, b) != 0 || on_segment(start, a, b)))
        pass(cone(0, c, d), c, a, b, true, true);
    }
  }
}

/// From outside through a side: the chain of the others begins at the side's right end.
void PolyanyaEngine::look_through() {
  const Cone cone = this->cone(node_.root, node_.right, node_.left);
  const std::uint32_t polygon = mesh_.corners[node_.enter].polygon;
  if (goals_here_[polygon].query == query_) see_goals(cone, polygon);
  follow(cone, polygon, mesh_.next(node_.enter), mesh_.first[polygon + 1] - mesh_.first[polygon] - 1);
}

/// Along the chain of sides, counter-clockwise, that the cone falls upon: corners inside it are seen, each side cuts out its part.
void PolyanyaEngine::follow(const Cone& cone, std::uint32_t polygon, std::uint32_t chain, std::uint32_t sides) {
  const std::uint32_t first = mesh_.first[polygon], end = mesh_.first[polygon + 1];
  const auto next = [first, end](std::uint32_t c) { return c + 1 == end ? first : c + 1; };
  const Navmesh::Corner* corners = mesh_.corners.data();
  std::uint32_t c = chain, d = next(c), left_over = sides;
  bool right_is_corner = cone.from_right(corners[c].point) == 0;
  for (;; c = d, d = next(d)) {
    if (left_over == 0) return;
    const int side = cone.from_right(corners[d].point);
    if (side > 0) break;
    right_is_corner = side == 0;
    if (--left_over > 0 && side == 0) see_corner(cone.root, d);
  }
  for (; left_over > 0; --left_over, c = d, d = next(d), right_is_corner = true) {
    const int side = cone.from_left(corners[d].point);
    if (corners[c].across != kNone) pass(cone, c, corners[c].point, corners[d].point, right_is_corner, side <= 0);
    if (side > 0) return;
    if (left_over > 1) see_corner(cone.root, d);
    if (side == 0) break;
  }
  // Further corners on the left ray.
  while (left_over > 2) {
    d = next(d);
    --left_over;
    if (cone.from_left(corners[d].point) != 0) return;
    see_corner(cone.root, d);
  }
}

/// Through the side from a to b, where it is a portal that leads on.
void PolyanyaEngine::pass(const Cone& cone, std::uint32_t side, Point a, Point b, bool right_is_a, bool left_is_b) {
  const Navmesh::Corner& corner = mesh_.corners[side];
  if (corner.across == kNone || allowed_[corner.block] != query_) return;
  const double bound = std::max(roots_[cone.root].least, bound_through(cone, a, b, right_is_a, left_is_b));
  if (bound > bound_) return;
  push({bound, cone.root, corner.across, right_is_a ? side : cone.right, left_is_b ? corner.across : cone.left});
}

void PolyanyaEngine::see_goals(const Cone& cone, std::uint32_t polygon) {
  for (std::uint32_t i = goals_here_[polygon].first; i < goal_places_.size() && goal_places_[i].polygon == polygon;
       ++i) {
    const std::uint32_t goal = goal_places_[i].goal;
    const Point p = goals_[goal].point;
    if (cone.from_right(p) >= 0 && cone.from_left(p) <= 0) improve(cone.root, goal, p);
  }
}

// ---- turning ------------------------------------------------------------------------------------------------------------------------

/// The turns that a shortest path from `from` can make at a corner: with the obstacle on its side.
std::uint32_t PolyanyaEngine::turns_at(Point from, std::uint32_t corner) const {
  const Point at = mesh_.corners[corner].point;
  const Navmesh::Bend& bend = mesh_.bends[mesh_.corners[corner].bend];
  const int right = side_of(from, at, bend.right),
            left = bend.left == bend.right ? right : side_of(from, at, bend.left);
  if (right * left < 0) return 0;
  const auto is_ahead = [&](int side, Point p) {
    return side == 0 && (at.x - from.x) * (p.x - at.x) + (at.y - from.y) * (p.y - at.y) > 0;
  };
  std::uint32_t turns = 0;
  if (right >= 0 && left >= 0 && !is_ahead(left, bend.left)) turns |= kLeftTurn;
  if (right <= 0 && left <= 0 && !is_ahead(right, bend.right)) turns |= kRightTurn;
  return turns;
}

void PolyanyaEngine::see_corner(std::uint32_t root, std::uint32_t corner) {
  const std::uint32_t bend = mesh_.corners[corner].bend;
  if (bend == kNone) return;
  const Root& before = roots_[root];
  const Point at = mesh_.corners[corner].point;
  Best& best = best_[bend];
  const bool known = best.query == query_;
  if (known && (roots_[best.root].before == root || best.root == root)) return;
  const double leg = distance(before.point, at), length = before.length + leg;
  const double error = error_of(before, leg, length);
  const double slack = slack_ + error + 0x1p-50 * length;
  if (distances_) (*distances_)[bend] = std::min((*distances_)[bend], length);
  const double bound = length + std::max(to_goal(at), landmarks_.rest(bend)) - slack;
  if (bound > bound_) return;
  const std::uint32_t turns = turns_at(before.point, corner);
  if (turns == 0 || (known && is_worse(root, at, length, error, best.root))) return;
  best = {query_, static_cast<std::uint32_t>(roots_.size())};
  roots_.push_back({at, length, error, root, bend, bound});
  push({bound, best.root, kNone, turns, 0});
}

void PolyanyaEngine::turn() {
  if (node_.right & kLeftTurn) turn_left();
  if (node_.right & kRightTurn) turn_right();
}

/// From the wall on the left to the straight continuation of the last leg.
void PolyanyaEngine::turn_left() {
  const std::uint32_t root = node_.root;
  const Point at = roots_[root].point, from = roots_[roots_[root].before].point;
  std::uint32_t c = mesh_.bends[roots_[root].bend].left_corner;
  for (bool at_wall = true;; at_wall = false) {
    const std::uint32_t polygon = mesh_.corners[c].polygon, right = mesh_.next(c), left = mesh_.previous(c);
    const int side = side_of(from, at, mesh_.corners[right].point);
    const Cone cone = this->cone(root, side >= 0 ? right : kAway, left);
    if (goals_here_[polygon].query == query_) see_goals(cone, polygon);
    if (at_wall) see_corner(root, left);
    if (side >= 0) see_corner(root, right);
    follow(cone, polygon, right, mesh_.first[polygon + 1] - mesh_.first[polygon] - 2);
    const std::uint32_t across = mesh_.corners[c].across;
    if (side <= 0 || across == kNone) return;
    c = mesh_.next(across);
  }
}

void PolyanyaEngine::turn_right() {
  const std::uint32_t root = node_.root;
  const Point at = roots_[root].point, from = roots_[roots_[root].before].point;
  std::uint32_t c = mesh_.bends[roots_[root].bend].right_corner;
  for (bool at_wall = true;; at_wall = false) {
    const std::uint32_t polygon = mesh_.corners[c].polygon, right = mesh_.next(c), left = mesh_.previous(c);
    const int side = side_of(from, at, mesh_.corners[left].point);
    const Cone cone = this->cone(root, right, side <= 0 ? left : kAway);
    if (goals_here_[polygon].query == query_) see_goals(cone, polygon);
    if (at_wall) see_corner(root, right);
    if (side <= 0) see_corner(root, left);
    follow(cone, polygon, right, mesh_.first[polygon + 1] - mesh_.first[polygon] - 2);
    const std::uint32_t across = mesh_.corners[left].across;
    if (side >= 0 || across == kNone) return;
    c = across;
  }
}

// ---- lengths ------------------------------------------------------------------------------------------------------------------------

/// Is the way through `before` to `at`, not shorter than that to a known root of the same bend?
bool PolyanyaEngine::is_worse(std::uint32_t before, Point at, double length, double error, std::uint32_t than) {
  const Root& old = roots_[than];
  const double difference = length - old.length, doubt = error + old.error;
  if (difference > doubt) return true;
  if (difference < -doubt) return false;
  return !is_shorter_exactly(before, at, old.before, old.point);
}

bool PolyanyaEngine::is_shorter_exactly(std::uint32_t a, Point end_a, std::uint32_t b, Point end_b) {
  legs_a_.clear();
  legs_b_.clear();
  const auto climb = [this](std::uint32_t& root, Point& end, std::vector<Segment>& legs) {
    legs.push_back({roots_[root].point, end});
    end = roots_[root].point;
    root = roots_[root].before;
  };
  while (a != b) a > b ? climb(a, end_a, legs_a_) : climb(b, end_b, legs_b_);
  legs_a_.push_back({roots_[a].point, end_a});
  legs_b_.push_back({roots_[a].point, end_b});
  return compare_lengths(legs_a_, legs_b_) < 0;
}

void PolyanyaEngine::improve(std::uint32_t root, std::uint32_t goal, Point end) {
  const Root& from = roots_[root];
  const double leg = distance(from.point, end), length = from.length + leg;
  const double error = error_of(from, leg, length);
  Way& way = ways_[nearest_ ? 0 : goal];
  if (way.exists()) {
    const double difference = length - way.length, doubt = error + way.error;
    if (difference > doubt) return;
    if (difference >= -doubt && !is_shorter_exactly(root, end, way.root, way.end)) return;
  } else {
    --unreached_;
  }
  way = {root, goal, end, length, error};
  renew_bound();
}

void PolyanyaEngine::renew_bound() {
  if (unreached_ > 0) return;
  bound_ = 0;
  for (const Way& way : ways_)
    if (way.exists()) bound_ = std::max(bound_, way.length + way.error * 2);
}

/// A lower bound but for rounding.
double PolyanyaEngine::to_goal(Point p) const {
  if (!nearest_) return 0;
  if (goals_.size() == 1) return distance(p, goal_box_.min);
  return gap({p, p}, goal_box_);
}

double PolyanyaEngine::bound_through(const Cone& cone, Point a, Point b, bool right_is_a, bool left_is_b) const {
  const Root& root = roots_[cone.root];
  const Point r = cone.origin;
  const RayEnd right = right_is_a ? RayEnd{a, 0} : end_of_ray(r, cone.right_through, a, b, magnitude_);
  const RayEnd left = left_is_b ? RayEnd{b, 0} : end_of_ray(r, cone.left_through, a, b, magnitude_);
  double error = 2 * (right.error + left.error), rest;
  if (!(error < 0x1p-30 * magnitude_)) {
    error = 0;
    rest = to_goal(r);
  } else if (goals_.size() == 1 && nearest_) {
    const Point goal = mirrored_if_left(goal_box_.min, a, b);
    if (cross(r, right.point, goal) < 0)
      rest = distance(r, right.point) + distance(right.point, goal);
    else if (cross(r, left.point, goal) > 0)
      rest = distance(r, left.point) + distance(left.point, goal);
    else
      rest = distance(r, goal);
  } else {
    const Box part = box_of(right.point, left.point), here{r, r};
    rest = gap(here, part);
    if (nearest_) rest = std::max(gap(here, goal_box_), rest + gap(part, goal_box_));
  }
  const double length = root.length + rest;
  return length - (error + slack_ + root.error + 0x1p-50 * length);
}

}  // namespace taut::detail
