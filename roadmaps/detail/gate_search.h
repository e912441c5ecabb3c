// All gates at one vertex. Private.
#pragma once

#include <cstdint>
#include <vector>

#include <taut/roadmaps/exact/gate_shape.h>
#include <taut/roadmaps/wall_index.h>

namespace taut::detail {

/// A gate from a vertex to another vertex, or to the inside of a constraint.
struct FoundGate {
  GateShape shape;
  std::uint32_t vertex = kNone;       ///< whose point is shape.end
  std::uint32_t foot_vertex = kNone;  ///< whose point is the foot; kNone when it is inside a constraint
  std::uint32_t facing = kNone;       ///< that constraint
  bool to_opening = false;
};

/// Looks outward from vertices. Scratch memory is kept from one to the next.
class GateSearch {
 public:
  explicit GateSearch(const WallIndex& walls) : walls_(walls) {}

  /// Appends the gates at v: to vertices above v, and to the insides of constraints.
  void append_gates(std::uint32_t v, std::vector<FoundGate>& to);

 private:
  /// A side looked through: what lies beyond is seen between the directions to `right` and `left`.
  struct View {
    std::uint32_t triangle;  ///< on the near side
    int side;
    std::uint32_t right;
    std::uint32_t left;
  };
  /// A wall point, relative to the vertex: hides all w with w (x, y) >= limit.
  struct Screen {
    double x, y, limit;
  };

  void look_around(std::uint32_t v);
  void look_through(const View& view);
  void meet_side(std::uint32_t constraint);
  void meet_vertex(std::uint32_t z);
  void add_screen(double x, double y);
  bool is_hidden(double x, double y) const;
  bool is_hidden(const View& view) const;
  bool is_empty(const FoundGate& gate) const;
  bool is_empty_between_walls(const FoundGate& gate) const;
  bool is_nearest_to_opening(const FoundGate& gate) const;

  const WallIndex& walls_;
  std::uint32_t v_ = kNone;
  Point p_;
  std::vector<View> views_;
  std::vector<Screen> screens_;
  std::vector<FoundGate> candidates_;
};

}  // namespace taut::detail
