// What room costs: the shortest way of a disc as its radius grows, and every radius at which it changes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <taut/roadmaps/all_radii.h>
#include <taut/search/length_formula.h>
#include <taut/search/passage_index.h>

namespace taut {

/// Radii for which the shortest way bends around the same corners.
struct TradeoffStretch {
  /// What happens beyond `to`.
  enum class End : std::uint8_t {
    bend,     ///< the way comes to touch a further corner (or leaves one of openings): the length goes on smoothly
    shorter,  ///< another way becomes shorter: the length goes on, with a smaller slope
    closed,   ///< the way is too narrow: the length jumps
    left,     ///< an end is too near to a wall: from here on it is left for another place
    last,     ///< no larger disc gets through
  };

  double from = 0, to = 0;
  Point start, goal;           ///< the disc's own ends
  std::vector<ArcBend> bends;  ///< as in ArcPath
  double aside = 0;            ///< straight to `start` and from `goal`, where an end had to be left
  Interval at_from, at_to;     ///< lengths, `aside` included
  End end = End::last;
  std::uint32_t gate = kNone;  ///< End::closed: the gate that closes, the lowest; kNone: it is not known

  /// For r in [from, to].
  ArcPath path(double r) const;
  double length(double r) const { return aside + path(r).value(); }
  /// `aside` included.
  LengthFormula formula() const;
};

/// All of them.
struct RadiusTradeoff {
  DiscStatus status = DiscStatus::none;  ///< of the smallest disc
  std::uint32_t wall = kNone;            ///< when an end is blocked
  std::vector<TradeoffStretch> stretches{};
  std::optional<WidestPassage> widest{};  ///< what stops larger discs, from `stretches.back()`'s ends
  bool start_left = false, goal_left = false;
  std::size_t graphs = 0;  ///< TangentGraphs looked into
};

struct RadiusTradeoffRequest {
  double least = 0;  ///< from which radius on; 0: from AllRadii::least_radius
  std::function<void(const TradeoffStretch&)> told{};
};

/// The shortest way of every disc from s to g.
///
///  1. Between the least radius and the largest that gets through, stretches follow each other: `to` is the last double
///     of one, and the next one's `from` is the double after it: where the way bends anew and where a gate closes that
///     is exact (the legs and arcs are asked as arc_search asks them). Where another way becomes shorter lengths are
///     transcendental and the radius is enclosed: up to `to` one is certainly not longer, from the next `from` on the
///     other; they lie about 1e-13 apart.
///  2. Within a stretch no way of any other class is shorter by more than 1e-12 of the length. Every class is bounded
///     from below by its tangent, and followed as a function where that does not tell (docs/tradeoff.md).
///  3. Of ways of equal length the one at hand is kept.
///  4. An end nearer to a wall than the largest disc that the gates between the ends let through is left, for radii
///     above its own distance, straight for the place of that largest disc that is nearest to it (DiscPlaces), if there
///     is one to which the leg keeps that distance. One place for all radii: `--keep` looks for one for each.
/// A TangentGraph for each change of class, and more where many ways are as short. bench/all_radii_bench.cpp.
/// Preconditions: the same space in both; s != g.
RadiusTradeoff radius_tradeoff(const AllRadii& radii, const PassageIndex& index, Point s, Point g,
                               const RadiusTradeoffRequest& request = {});

}  // namespace taut
