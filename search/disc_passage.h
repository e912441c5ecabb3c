// Can a disc get from s to g, and how large may it be? Proven, without a configuration space.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <taut/roadmaps/gates.h>
#include <taut/search/search_status.h>

namespace taut {

/// A piece of a closed chain around one of two points: a constraint or a gate; the other one is kNone.
struct BarrierPiece {
  std::uint32_t constraint = kNone;  ///< index into FreeSpace::constraints()
  std::uint32_t gate = kNone;        ///< index into Gates::gates()

  friend bool operator==(const BarrierPiece&, const BarrierPiece&) = default;
};

/// The answer, and what proves it when it is no.
struct DiscPassage {
  DiscStatus status = DiscStatus::found;
  /// When separated: the closed chain that separates, in order. Its gates are narrower than the disc; the widest of
  /// them is the narrowest possible. When an end is blocked: the wall nearest to it; empty when it is outside.
  std::vector<BarrierPiece> barrier;
};

/// Does a path lead from s to g for a disc of radius r > 0 (its centre goes from s to g)? Exact.
///
///  1. The disc is closed and may touch walls: its centre keeps a distance >= r from every wall (Gates, guarantee 1:
///     not from openings), stays within the space, and does not cross openings. r is that double, not a polygon around
///     it.
///  2. A point on an opening stands for the inside near it. At a joint of several openings, for the triangle that
///     FreeSpace::locate names.
/// Method: a union-find over the walls' ends that knows for each the parity of crossings between a chain to it and a
/// line from s to g. A chain of gates and constraints that closes with an odd number separates (docs/disc-gates.md).
/// O(n) a query, nearly.
DiscPassage disc_passage(const Gates& gates, Point s, Point g, double r);

/// The same, once: builds the gates first.
DiscPassage disc_passage(const FreeSpace& space, Point s, Point g, double r);

/// The largest disc that gets from s to g.
struct WidestPassage {
  enum class Limit {
    gate,   ///< a gate that every way passes, or a narrower one
    start,  ///< the nearest wall to the start
    goal,   ///< likewise; the start is no tighter
    none,   ///< there is no wall at all: radius is infinite
  };
  Limit limit = Limit::none;
  double radius = 0;                  ///< the largest double that passes; 0: s or g lies on a wall
  std::uint32_t gate = kNone;         ///< whose width is exactly the largest diameter
  std::uint32_t constraint = kNone;   ///< with Limit::start and goal: the nearest wall
  std::vector<BarrierPiece> barrier;  ///< with Limit::gate: what separates s from g for any larger disc
};

/// Nothing when no path leads from s to g even for a point, or one of them is outside. Exact: disc_passage says
/// reachable for `radius` and for no larger double. O(n), nearly.
std::optional<WidestPassage> widest_passage(const Gates& gates, Point s, Point g);
std::optional<WidestPassage> widest_passage(const FreeSpace& space, Point s, Point g);

}  // namespace taut
