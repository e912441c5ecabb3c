// The greatest speeds on a line of straights and turns, and least times between classes of speeds. Private.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <taut/robots/micromouse/detail/turn_shapes.h>

namespace taut::micromouse::detail {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// A part of a line. `time`: it takes that, at whatever speeds up to the top speed; absent: what the ramp allows.
struct Piece {
  Ramp ramp;
  double metres = 0;
  std::optional<double> time;
};

/// A straight of so many half cells, or of their diagonals.
Piece straight_piece(const SpeedModel& model, Eighth heading, int count);

/// A turn, in the order in which it is driven: where it bends no faster than its speed, on its straight ends (of the
/// turns of 45, 135 and 180) as on any straight; one that has a time of its own as a whole. Where it bends the greater
/// accelerations of the two ramps count.
std::vector<Piece> turn_pieces(const SpeedModel& model, Turn turn, Eighth heading, Eighth after);

/// Of a straight, its piece; of a turn, those; of a pivot none.
std::vector<Piece> pieces_of(const SpeedModel& model, const Drive& drive);

/// The speeds at the ends of the pieces, one more than these, of the drive that is nowhere slower than any other: no
/// faster than `in` at the begin, `out` at the end and the top speeds, no harder up and down than the ramps allow.
void fill_fastest(std::span<const Piece> pieces, double in, double out, std::span<double> speeds);

/// The time over a piece between two such speeds, and the greatest speed on it.
double seconds_over(const Piece& piece, double from, double to);
double peak_over(const Piece& piece, double from, double to);

/// Speeds above `low` and up to `high`; 0 and 0: standing.
struct SpeedClass {
  double low = 0;
  double high = 0;
};

/// Class 0 is standing; the others leave no gap up to the greatest speed at which a turn can end. About `count` of the
/// same width, cut at the turns' speeds; 1: all in one.
std::vector<SpeedClass> speed_classes(const SpeedModel& model, std::size_t count);

/// No drive over `pieces` takes less that begins at a speed of `in` and ends at one of `out`: the time of the one that
/// fill_fastest() knows. kNever when its speeds at the ends are below these classes, for so are all others then. At
/// most kMostPieces.
double least_seconds(std::span<const Piece> pieces, const SpeedClass& in, const SpeedClass& out);
inline constexpr std::size_t kMostPieces = 4;

}  // namespace taut::micromouse::detail
