// Closed chains of walls and gates, and whether they separate two points. Private.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include <taut/roadmaps/gates.h>
#include <taut/search/disc_passage.h>

namespace taut::detail {

/// How often, modulo 2, pieces cross a line from s to g. A piece with a point on a leg's line counts as if moved to the
/// left of it, which changes nothing for closed chains that avoid the corners of the line.
class CrossingParity {
 public:
  /// Precondition: s and g are in the space. `choice` picks the inner points of the line where an end touches a
  /// constraint.
  CrossingParity(const Gates& gates, Point s, Point g, int choice);

  /// Of the constraint from a to b.
  bool of_constraint(std::uint32_t c) const;
  /// Of the gate from its end to its foot, and on to facing's a when the foot is inside it.
  bool of_gate(std::uint32_t i) const;
  /// A gate ran through a corner of the line: another choice has to be made.
  bool is_degenerate() const { return degenerate_; }

 private:
  struct Leg {
    Point s, g;
    bool within_triangle = false;             // crosses no constraint
    std::vector<std::uint8_t> right_of = {};  // of each vertex: strictly right of s -> g
  };

  void add_leg(Point s, Point g, bool within_triangle);
  bool crosses_constraint(const Leg& leg, std::uint32_t c) const;
  bool crosses_gate(const Leg& leg, std::uint32_t i) const;

  const Gates& gates_;
  std::vector<Leg> legs_;
  mutable bool degenerate_ = false;
};

/// The first closed chain of constraints and of the gates, taken in their order, that separates: its pieces in order,
/// the last gate taken (kNone: constraints alone separate). Gates from `count` on are not looked at. Nothing: no such
/// chain.
struct SeparatingChain {
  std::vector<BarrierPiece> pieces;
  std::uint32_t last_gate = kNone;
};
std::optional<SeparatingChain> separating_chain(const Gates& gates, Point s, Point g, std::uint32_t count);

}  // namespace taut::detail
