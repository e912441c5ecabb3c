#include <taut/search/detail/sleeves.h>

#include <algorithm>

#include <taut/geometry/length.h>

namespace taut::detail {

namespace {

/// The polygon above across a bridge; kNone at the root of a tree.
std::vector<std::uint32_t> parents(const Navmesh::BlockTree& blocks) {
  std::vector<std::uint32_t> above(blocks.above.size(), kNone);
  for (std::uint32_t p = 0; p < above.size(); ++p)
    if (const std::uint32_t block = blocks.above[p]; block != kNone && blocks.bridge[block] != kNone)
      above[p] = blocks.top[block];
  return above;
}

std::vector<std::uint32_t> by_depth(const std::vector<std::uint32_t>& depth) {
  std::vector<std::uint32_t> first(depth.empty() ? 1 : *std::max_element(depth.begin(), depth.end()) + 2, 0);
  for (const std::uint32_t d : depth) ++first[d + 1];
  for (std::size_t d = 1; d < first.size(); ++d) first[d] += first[d - 1];
  std::vector<std::uint32_t> order(depth.size());
  for (std::uint32_t p = 0; p < depth.size(); ++p) order[first[depth[p]]++] = p;
  return order;
}

}  // namespace

Sleeves::Sleeves(const Triangulation& tri, const Navmesh& mesh)
    : node_of_(mesh.polygon_count(), kNone), nodes_(mesh.polygon_count()) {
  number(mesh, parents(mesh.blocks));
  add_portals(tri, mesh);
}

/// In preorder, the largest branch first.
void Sleeves::number(const Navmesh& mesh, const std::vector<std::uint32_t>& above) {
  const std::vector<std::uint32_t> order = by_depth(mesh.blocks.depth);
  std::vector<std::uint32_t> size(above.size(), 1), heavy(above.size(), kNone), next(above.size());
  for (auto p = order.rbegin(); p != order.rend(); ++p) {
    const std::uint32_t up = above[*p];
    if (up == kNone) continue;
    size[up] += size[*p];
    if (heavy[up] == kNone || size[*p] > size[heavy[up]]) heavy[up] = *p;
  }
  std::uint32_t roots = 0;
  for (const std::uint32_t p : order) {
    const std::uint32_t up = above[p];
    std::uint32_t& free = up == kNone ? roots : next[up];
    const std::uint32_t at = up != kNone && heavy[up] == p ? node_of_[up] + 1 : free;
    if (up == kNone || heavy[up] != p) free += size[p];
    node_of_[p] = at;
    next[p] = at + 1 + (heavy[p] == kNone ? 0 : size[heavy[p]]);
    nodes_[at].above = up == kNone ? kNone : node_of_[up];
    nodes_[at].tree = up == kNone ? at : nodes_[node_of_[up]].tree;
  }
}

void Sleeves::add_portals(const Triangulation& tri, const Navmesh& mesh) {
  for (std::uint32_t t = 0; t < tri.triangles.size(); ++t) {
    if (!tri.free[t] || mesh.polygon_of[t] == kNone) continue;
    Node& node = nodes_[node_of_[mesh.polygon_of[t]]];
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t n = tri.neighbours[t][i];
      if (tri.is_constrained(t, i) || n == kNone || mesh.polygon_of[n] == mesh.polygon_of[t]) continue;
      if (node.above == kNone || node_of_[mesh.polygon_of[n]] != node.above) continue;
      node.right = tri.triangles[t][Triangulation::ccw(i)];
      node.left = tri.triangles[t][Triangulation::cw(i)];
      if (tri.lattice.empty()) continue;
      node.right_at = tri.lattice[node.right];
      node.left_at = tri.lattice[node.left];
    }
  }
}

int SleeveSides::turn_as_written(const Place& a, const Place& b, const Place& p) const {
  return written::orientation(point(a), point(b), point(p));
}

bool SleeveSides::is_between_as_written(const Place& a, const Place& b, const Place& p) const {
  return WrittenSides{}.is_between(point(a), point(b), point(p));
}

bool SleeveString::find(Point from, std::span<const std::uint32_t> starts, Point to,
                        std::span<const std::uint32_t> goals, std::vector<Point>& path) {
  if (!are_in_one_tree(starts, goals)) return false;
  string_.sides().set_ends(from, to);
  path.clear();
  if (lay_out_at_once()) {
    pull_taut(path);
    return true;
  }
  for (const std::uint32_t p : starts_)
    for (const std::uint32_t q : goals_) {
      if (!lay_out(p, q)) continue;
      if (path.empty()) {
        pull_taut(path);
      } else {
        pull_taut(other_);
        if (is_shorter(other_, path)) path.swap(other_);
      }
    }
  return true;
}

bool SleeveString::are_in_one_tree(std::span<const std::uint32_t> starts, std::span<const std::uint32_t> goals) {
  const auto nodes_of = [&](std::span<const std::uint32_t> polygons, std::vector<std::uint32_t>& nodes) {
    nodes.clear();
    for (const std::uint32_t p : polygons) nodes.push_back(sleeves_.node_of(p));
    return !nodes.empty();
  };
  if (!nodes_of(starts, starts_) || !nodes_of(goals, goals_)) return false;
  const std::uint32_t tree = sleeves_[starts_.front()].tree;
  const auto is_in_it = [&](std::uint32_t node) { return sleeves_[node].tree == tree; };
  return std::all_of(starts_.begin(), starts_.end(), is_in_it) && std::all_of(goals_.begin(), goals_.end(), is_in_it);
}

/// Where each end is in one polygon, or on the portal between two: then the way from the lower one needs no portal that
/// the end lies on.
bool SleeveString::lay_out_at_once() {
  const auto lowest = [&](const std::vector<std::uint32_t>& nodes) {
    if (nodes.size() == 1) return nodes[0];
    const std::uint32_t low = std::max(nodes[0], nodes[1]), high = std::min(nodes[0], nodes[1]);
    return nodes.size() == 2 && sleeves_[low].above == high ? low : kNone;
  };
  std::uint32_t p = lowest(starts_), q = lowest(goals_);
  if (p == kNone || q == kNone) return false;
  up_.clear();
  down_.clear();
  while (p != q) {
    std::uint32_t& lower = p > q ? p : q;
    (p > q ? up_ : down_).push_back(lower);
    lower = sleeves_[lower].above;
  }
  if (starts_.size() == 2 && !up_.empty()) up_.erase(up_.begin());
  if (goals_.size() == 2 && !down_.empty()) down_.erase(down_.begin());
  return true;
}

/// The way between two nodes. False when it passes another node of an end: from there it is no longer.
bool SleeveString::lay_out(std::uint32_t p, std::uint32_t q) {
  const std::uint32_t start = p, goal = q;
  const auto holds = [](const std::vector<std::uint32_t>& nodes, std::uint32_t node) {
    return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
  };
  const auto is_other_end = [&](std::uint32_t node) {
    return (node != start && holds(starts_, node)) || (node != goal && holds(goals_, node));
  };
  up_.clear();
  down_.clear();
  if (is_other_end(p) || is_other_end(q)) return false;
  while (p != q) {
    std::uint32_t& lower = p > q ? p : q;
    (p > q ? up_ : down_).push_back(lower);
    lower = sleeves_[lower].above;
    if (p != q && is_other_end(lower)) return false;
  }
  return !is_other_end(p);
}

void SleeveString::pull_taut(std::vector<Point>& path) {
  string_.begin({{}, SleeveSides::kFrom});
  right_ = left_ = SleeveSides::kFrom;
  for (const std::uint32_t n : up_) {
    const Sleeves::Node& node = sleeves_[n];
    widen({node.right_at, node.right}, {node.left_at, node.left});
  }
  for (auto n = down_.rbegin(); n != down_.rend(); ++n) {
    const Sleeves::Node& node = sleeves_[*n];
    widen({node.left_at, node.left}, {node.right_at, node.right});
  }
  path.clear();
  for (const Place& place : string_.close({{}, SleeveSides::kTo})) {
    const Point point = string_.sides().point(place);
    if (path.empty() || path.back() != point) path.push_back(point);
  }
}

bool SleeveString::is_shorter(const std::vector<Point>& a, const std::vector<Point>& b) {
  const auto legs_of = [](const std::vector<Point>& path, std::vector<Segment>& legs) {
    legs.clear();
    for (std::size_t i = 1; i < path.size(); ++i) legs.push_back({path[i - 1], path[i]});
  };
  legs_of(a, legs_a_);
  legs_of(b, legs_b_);
  return compare_lengths(legs_a_, legs_b_) < 0;
}

void SleeveString::widen(const Place& right, const Place& left) {
  if (right.vertex != right_) string_.widen_right(right);
  if (left.vertex != left_) string_.widen_left(left);
  right_ = right.vertex;
  left_ = left.vertex;
}

}  // namespace taut::detail
