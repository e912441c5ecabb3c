// What is asked, what may be passed, and ways on which there is nothing to search.
#include <taut/search/detail/polyanya_engine.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace taut::detail {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

PolyanyaEngine::PolyanyaEngine(const Navmesh& mesh, const Landmarks* landmarks)
    : mesh_(mesh), landmarks_(landmarks, mesh) {
  renew();
  for (const Navmesh::Corner& c : mesh.corners)
    magnitude_ = std::max({magnitude_, std::abs(c.point.x), std::abs(c.point.y)});
  slack_ = 0x1p-44 * magnitude_;
}

void PolyanyaEngine::renew() {
  best_.resize(mesh_.bends.size());
  goals_here_.resize(mesh_.polygon_count());
  allowed_.resize(mesh_.blocks.top.size(), 0);
}

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

/// All blocks between two polygons: the only ones that a shortest path from one to the other can pass. False when they
/// lie in two components.
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

/// From start to goal along each pair of their polygons, where no other way leads from the one to the other. False
/// where there is something to search.
bool PolyanyaEngine::follow_corridors(const Query& query) {
  if (is_separated_ || !nearest_ || query.other_ends || goals_.size() != 1 || !only_bridges_ ||
      query.limits.expansions <= mesh_.polygon_count())
    return false;
  for (const std::uint32_t p : query.start_polygons)
    for (const GoalPlace& place : goal_places_)
      if (lay_out(p, place.polygon, query.start_polygons)) pull_taut();
  return true;
}

/// The corridor between two polygons. False when there is none, or when it passes another polygon of the same end: from
/// there it is no longer.
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

}  // namespace taut::detail
