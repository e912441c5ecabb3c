// What stands in a disc's way, as people know it: walls of the world and gates that are too narrow.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/search/disc_passage.h>

namespace taut {

/// A closed chain of pieces as walls people know: pieces that the chain passes on both sides are dead ends and go, so
/// do those on the sides of `border` unless all are (nobody gets out there anyway); pieces in a line are joined.
std::vector<Segment> joined_walls(const std::vector<Constraint>& chain, const Box& border);

struct NamedGate {
  Segment at;              ///< the nearest points of its two walls
  double width = 0;        ///< to the nearest double
  std::string width_text;  ///< exact where short: `2/5`
  std::string name;        ///< Gates::name
};

NamedGate named_gate(const Gates& gates, std::uint32_t gate);

/// A closed chain around one of two points.
struct Barrier {
  std::vector<Segment> walls;    ///< joined_walls()
  std::vector<NamedGate> gates;  ///< the widest first
  std::vector<Segment> gate_segments() const;
};

Barrier barrier_of(const Gates& gates, const std::vector<BarrierPiece>& pieces);

/// Why a disc of radius r gets from start to none of the goals, found among the world's own walls, its limits counting
/// as such (walled_world): the barrier around the first goal it is kept from. Nothing when walls leave a way to a goal:
/// then only a shape larger than the disc has none.
std::optional<Barrier> disc_barrier(const World& world, Point start, const std::vector<Point>& goals, double r);

/// The wall of the world that a piece came from, or another one that ends in `end`; the piece where none is known.
Segment wall_of(const FreeSpace& space, std::uint32_t constraint, const Point* end = nullptr);

/// Likewise of the piece nearest to p.
Segment wall_near(const FreeSpace& space, std::uint32_t constraint, Point p);

/// From p to the nearest point of a piece, to about an ulp.
double distance_to(const FreeSpace& space, std::uint32_t constraint, Point p);

}  // namespace taut
