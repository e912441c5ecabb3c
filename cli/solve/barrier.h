// What stands in a disc's way, for people: walls, gates that are too narrow, and the two walls of a pinch.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <taut/geometry/world.h>
#include <taut/search/clearance_search.h>
#include <taut/search/disc_passage.h>

namespace taut::cli {

/// A world in which its limits are walls, so that a disc stays inside whole; but where one of the `ends` stands on an
/// opening that is parallel to an axis, the opening is a door into a dead end as deep as it is wide.
World walled_world(const World& world, const std::vector<Point>& ends);

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

/// The wall of the world that a piece came from, or another one that ends in `end`; the piece where none is known.
Segment wall_of(const FreeSpace& space, std::uint32_t constraint, const Point* end = nullptr);

/// Likewise of the piece nearest to p.
Segment wall_near(const FreeSpace& space, std::uint32_t constraint, Point p);

/// `these walls separate start and goal: ...`
std::string separation_text(const Barrier& barrier);

/// Why a disc of radius r does not get through, in one line. Precondition: it does not.
std::string blocked_text(const Gates& gates, const DiscPassage& passage, const Barrier& barrier, Point start,
                         Point goal, double r);

/// Why a disc of radius r gets from start to none of the goals, found among the world's own walls: the barrier around
/// the first goal it is kept from, and its text. Nothing when walls leave a way to a goal: then only a shape larger
/// than the disc has none.
struct DiscBarrier {
  Barrier barrier;
  std::string text;
};
std::optional<DiscBarrier> disc_barrier(const World& world, Point start, const std::vector<Point>& goals, double r);

/// `narrowest 1 between (3, 4) and (3, 5), of the walls (3, 0)-(3, 4) and (3, 5)-(3, 9)`; at an end
/// `nearest to a wall at the start (1, 1): 0.5 from the wall (0, 0)-(9, 0)`.
std::string pinch_text(const Pinch& pinch, const FreeSpace& space, const std::string& width = {});

}  // namespace taut::cli
