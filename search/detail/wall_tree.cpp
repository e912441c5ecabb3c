#include <taut/search/detail/wall_tree.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace taut::detail {

namespace {

constexpr std::uint32_t kLeaf = 4;
constexpr std::size_t kListed = 12;

Box joined(const Box& a, const Box& b) {
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y)}};
}

double squared_to(const Box& box, Point p) {
  const double dx = std::max({box.min.x - p.x, 0.0, p.x - box.max.x}),
               dy = std::max({box.min.y - p.y, 0.0, p.y - box.max.y});
  return dx * dx + dy * dy;
}

}  // namespace

/// The least squared distance so far, and up to where rounding leaves another a chance.
struct WallTree::Bound {
  double least = HUGE_VAL, limit = HUGE_VAL;
  double more = 0;  ///< so much farther is still of interest

  void lower(double squared, double slack) {
    least = squared;
    const double far = std::sqrt(squared) + more;
    limit = far * far * (1 + 0x1p-48) + 4 * slack * (far + slack);
  }
};

WallTree::WallTree(const WallIndex& walls) {
  std::vector<Box> boxes;
  std::vector<Part> parts;
  double largest = 0;
  for (std::uint32_t c = 0; c < walls.ends().size(); ++c) {
    if (walls.is_opening(c)) continue;
    const auto [a, b] = walls.segment(c);
    const double ux = b.x - a.x, uy = b.y - a.y;
    boxes.push_back(box_around(a, b));
    parts.push_back({a.x, a.y, ux, uy, 1 / (ux * ux + uy * uy), c});
    for (const double v : {a.x, a.y, b.x, b.y}) largest = std::max(largest, std::abs(v));
  }
  slack_ = 0x1p-45 * largest + 1e-150;
  order_.resize(parts.size());
  std::iota(order_.begin(), order_.end(), 0u);
  if (!parts.empty()) build(boxes, 0, static_cast<std::uint32_t>(parts.size()));
  for (const std::uint32_t i : order_) parts_.push_back(parts[i]);
  if (!parts_.empty()) make_grid(joined(nodes_[0].boxes[0], nodes_[0].boxes[1]));
}

/// About four cells a wall.
void WallTree::make_grid(const Box& all) {
  const double width = all.max.x - all.min.x, height = all.max.y - all.min.y, longer = std::max(width, height);
  const auto count = static_cast<double>(parts_.size());
  const double side = std::max(std::sqrt(width * height / count) / 2, longer / count) + 1e-9 * longer;
  if (!(side > 0)) return;
  grid_ = all;
  columns_ = static_cast<std::uint32_t>(width / side) + 1;
  rows_ = static_cast<std::uint32_t>(height / side) + 1;
  over_x_ = over_y_ = 1 / side;
  std::vector<NearWall> near;
  first_.push_back(0);
  for (std::uint32_t cell = 0; cell < columns_ * rows_; ++cell) {
    const Point centre{all.min.x + (cell % columns_ + 0.5) * side, all.min.y + (cell / columns_ + 0.5) * side};
    Bound bound;
    // A wall that is nearest somewhere in the cell is not farther from the centre than the nearest one there by more
    // than the cell's diagonal.
    bound.more = 1.5 * side;
    near.clear();
    ask_tree(centre, bound, near);
    std::erase_if(near, [&](const NearWall& wall) { return wall.squared > bound.limit; });
    if (near.size() <= kListed)
      for (const NearWall& wall : near) cell_parts_.push_back(wall.constraint);
    first_.push_back(static_cast<std::uint32_t>(cell_parts_.size()));
  }
  const auto higher = [](const Part& a, const Part& b) { return a.constraint < b.constraint; };
  std::vector<std::uint32_t> part_of(1 + std::max_element(parts_.begin(), parts_.end(), higher)->constraint);
  for (std::uint32_t i = 0; i < parts_.size(); ++i) part_of[parts_[i].constraint] = i;
  for (std::uint32_t& part : cell_parts_) part = part_of[part];
}

std::uint32_t WallTree::cell_at(Point p) const {
  if (!(columns_ > 0 && grid_.contains(p))) return kNone;
  const auto x = static_cast<std::uint32_t>((p.x - grid_.min.x) * over_x_),
             y = static_cast<std::uint32_t>((p.y - grid_.min.y) * over_y_);
  return x < columns_ && y < rows_ ? y * columns_ + x : kNone;
}

/// A node of at least one part; where there are few, its second half is empty.
std::uint32_t WallTree::build(const std::vector<Box>& boxes, std::uint32_t first, std::uint32_t last) {
  const auto box_of = [&](std::uint32_t from, std::uint32_t to) {
    Box box = boxes[order_[from]];
    for (std::uint32_t i = from + 1; i < to; ++i) box = joined(box, boxes[order_[i]]);
    return box;
  };
  const Box all = box_of(first, last);
  const bool wide = all.max.x - all.min.x > all.max.y - all.min.y;
  const auto middle = [&](std::uint32_t i) {
    const Box& b = boxes[i];
    return wide ? b.min.x + b.max.x : b.min.y + b.max.y;
  };
  const std::uint32_t half = first + (last - first + 1) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + (half == last ? first : half), order_.begin() + last,
                   [&](std::uint32_t i, std::uint32_t j) { return std::pair(middle(i), i) < std::pair(middle(j), j); });
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  const std::array<std::pair<std::uint32_t, std::uint32_t>, 2> parts{{{first, half}, {half, last}}};
  for (int side = 0; side < 2; ++side) {
    const auto [from, to] = parts[side];
    Box box{{HUGE_VAL, HUGE_VAL}, {HUGE_VAL, HUGE_VAL}};
    if (from < to) box = box_of(from, to);
    const bool leaf = to - from <= kLeaf;
    const std::uint32_t next = leaf ? from : build(boxes, from, to);
    nodes_[index].boxes[side] = box;
    nodes_[index].next[side] = next;
    nodes_[index].count[side] = leaf ? to - from : kNone;
  }
  return index;
}

void WallTree::nearest(Point p, std::vector<NearWall>& to) const {
  to.clear();
  Bound bound;
  const std::uint32_t cell = cell_at(p);
  if (cell != kNone && first_[cell] != first_[cell + 1])
    for (std::uint32_t i = first_[cell]; i < first_[cell + 1]; ++i) ask_part(cell_parts_[i], p, bound, to);
  else
    ask_tree(p, bound, to);
  std::erase_if(to, [&](const NearWall& wall) { return wall.squared > bound.limit; });
}

void WallTree::ask_part(std::uint32_t i, Point p, Bound& bound, std::vector<NearWall>& to) const {
  const Part& part = parts_[i];
  const double ax = p.x - part.x, ay = p.y - part.y;
  const double t = std::clamp((ax * part.ux + ay * part.uy) * part.over_length, 0.0, 1.0);
  const double dx = ax - t * part.ux, dy = ay - t * part.uy, squared = dx * dx + dy * dy;
  if (squared > bound.limit) return;
  to.push_back({part.constraint, squared});
  if (squared < bound.least) bound.lower(squared, slack_);
}

void WallTree::ask_tree(Point p, Bound& bound, std::vector<NearWall>& to) const {
  if (nodes_.empty()) return;
  struct Open {
    double squared;
    std::uint32_t next, count;
  };
  std::array<Open, 96> open;
  std::size_t size = 0;
  open[size++] = {0, 0, kNone};
  while (size > 0) {
    const Open at = open[--size];
    if (at.squared > bound.limit) continue;
    if (at.count != kNone) {
      for (std::uint32_t i = at.next; i < at.next + at.count; ++i) ask_part(i, p, bound, to);
      continue;
    }
    const Node& node = nodes_[at.next];
    const double d0 = squared_to(node.boxes[0], p), d1 = squared_to(node.boxes[1], p);
    const int near = d1 < d0;
    open[size++] = {std::max(d0, d1), node.next[1 - near], node.count[1 - near]};
    open[size++] = {std::min(d0, d1), node.next[near], node.count[near]};
  }
}

}  // namespace taut::detail
