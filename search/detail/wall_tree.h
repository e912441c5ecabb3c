// The nearest walls to a point, quickly. Private.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <taut/roadmaps/wall_index.h>

namespace taut::detail {

/// A wall that may be the nearest one.
struct NearWall {
  std::uint32_t constraint = kNone;
  double squared = 0;  ///< of the distance, roughly
};

/// A tree of boxes over the walls, and a grid whose cells list the few walls that may be nearest in them. Asked in
/// doubles. O(1) on usual inputs, else O(log n); O(n) at the centre of a ring.
class WallTree {
 public:
  explicit WallTree(const WallIndex& walls);

  bool empty() const { return parts_.empty(); }

  /// Replaces `to` by all walls that rounding leaves a chance to be the nearest to p.
  void nearest(Point p, std::vector<NearWall>& to) const;

  /// How far a distance is off at most, beside 2^-50 of itself.
  double slack() const { return slack_; }

 private:
  struct Part {
    double x, y, ux, uy, over_length;
    std::uint32_t constraint;
  };
  struct Node {
    std::array<Box, 2> boxes;
    std::array<std::uint32_t, 2> next;   ///< a further node, or the first part of a leaf
    std::array<std::uint32_t, 2> count;  ///< of the leaf's parts; kNone: it is a node
  };

  struct Bound;

  void ask_tree(Point p, Bound& bound, std::vector<NearWall>& to) const;
  void ask_part(std::uint32_t part, Point p, Bound& bound, std::vector<NearWall>& to) const;
  void make_grid(const Box& all);
  std::uint32_t cell_at(Point p) const;
  std::uint32_t build(const std::vector<Box>& boxes, std::uint32_t first, std::uint32_t last);

  std::vector<Part> parts_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
  double slack_ = 0;

  Box grid_;
  double over_x_ = 0, over_y_ = 0;  // cells a unit
  std::uint32_t columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> first_;  // of each cell, into cell_parts_; nothing listed: ask the tree
  std::vector<std::uint32_t> cell_parts_;
};

}  // namespace taut::detail
