#include <taut/search/detail/polyanya_engine.h>

#include <algorithm>

namespace taut::detail {

// ---- the queue ------------------------------------------------------------------------------------------------------

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

// ---- what is seen ---------------------------------------------------------------------------------------------------

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
      if (b != start && (written::orientation(start, a, b) != 0 || written::on_segment(start, a, b)))
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

/// Along the chain of sides, counter-clockwise, that the cone falls upon: corners inside it are seen, each side cuts
/// out its part.
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

// ---- turning --------------------------------------------------------------------------------------------------------

/// The turns that a shortest path from `from` can make at a corner: with the obstacle on its side.
std::uint32_t PolyanyaEngine::turns_at(Point from, std::uint32_t corner) const {
  const Point at = mesh_.corners[corner].point;
  const Navmesh::Bend& bend = mesh_.bends[mesh_.corners[corner].bend];
  const int right = written::orientation(from, at, bend.right),
            left = bend.left == bend.right ? right : written::orientation(from, at, bend.left);
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
    const int side = written::orientation(from, at, mesh_.corners[right].point);
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
    const int side = written::orientation(from, at, mesh_.corners[left].point);
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

}  // namespace taut::detail
