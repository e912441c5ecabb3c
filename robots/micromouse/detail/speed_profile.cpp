#include <taut/robots/micromouse/detail/speed_profile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace taut::micromouse::detail {

namespace {

constexpr double kRoot = std::numbers::sqrt2;
constexpr double kSlack = 1 + 1e-12;  // a speed is out of reach only when it is so by more than rounding

double reached(double speed, double acceleration, double metres) {
  return std::sqrt(speed * speed + 2 * acceleration * metres);
}

/// Half cells before, in and after the bend, as the turn is driven from an orthogonal heading.
struct Bend {
  double lead, arc, tail;
};

Bend bend_of(Turn turn) {
  switch (turn) {
    case Turn::turn_45: return {0, length(turn) - (kRoot - 1), kRoot - 1};
    case Turn::turn_135: return {3 - kRoot, length(turn) - (3 - kRoot), 0};
    case Turn::turn_180: return {1, length(turn) - 2, 1};
    case Turn::small_90:
    case Turn::large_90:
    case Turn::diagonal_90: break;
  }
  return {0, length(turn), 0};
}

const Ramp& ramp_of(const SpeedModel& model, Eighth heading) {
  return is_diagonal(heading) ? model.diagonal : model.straight;
}

Ramp in_bend(const SpeedModel& model, double top_speed) {
  return {std::max(model.straight.acceleration, model.diagonal.acceleration),
          std::max(model.straight.deceleration, model.diagonal.deceleration), top_speed};
}

/// The greatest speed at which a turn can end: out of its bend, up to the end of the longer of its straight ends.
double fastest_end(const SpeedModel& model) {
  double fastest = 0;
  for (const Turn turn : kAllTurns) {
    const Pace& pace = model.pace(turn);
    const double run_up = pace.time ? 0 : std::max(bend_of(turn).lead, bend_of(turn).tail) * model.cell / 2;
    fastest = std::max(fastest, reached(pace.speed, in_bend(model, pace.speed).acceleration, run_up));
  }
  return fastest;
}

}  // namespace

Piece straight_piece(const SpeedModel& model, Eighth heading, int count) {
  return {ramp_of(model, heading), model.cell / 2 * (is_diagonal(heading) ? kRoot : 1) * count, {}};
}

std::vector<Piece> turn_pieces(const SpeedModel& model, Turn turn, Eighth heading, Eighth after) {
  const Pace& pace = model.pace(turn);
  const Ramp bent = in_bend(model, pace.speed);
  const double unit = model.cell / 2;
  if (pace.time) return {{bent, length(turn) * unit, pace.time}};
  Bend bend = bend_of(turn);
  if (is_diagonal(heading)) std::swap(bend.lead, bend.tail);
  std::vector<Piece> pieces;
  if (bend.lead > 0) pieces.push_back({ramp_of(model, heading), bend.lead * unit, {}});
  pieces.push_back({bent, bend.arc * unit, {}});
  if (bend.tail > 0) pieces.push_back({ramp_of(model, after), bend.tail * unit, {}});
  return pieces;
}

std::vector<Piece> pieces_of(const SpeedModel& model, const Drive& drive) {
  if (drive.kind == Drive::Kind::pivot) return {};
  if (drive.kind == Drive::Kind::turn) return turn_pieces(model, drive.turn, drive.heading, drive.after);
  return {{ramp_of(model, drive.heading), drive.metres, {}}};
}

void fill_fastest(std::span<const Piece> pieces, double in, double out, std::span<double> speeds) {
  const std::size_t n = pieces.size();
  speeds[n] = std::min(out, pieces[n - 1].ramp.top_speed);
  for (std::size_t i = n; i-- > 0;) {
    const Ramp& r = pieces[i].ramp;
    const double before = i == 0 ? in : pieces[i - 1].ramp.top_speed;
    speeds[i] = std::min({before, r.top_speed, reached(speeds[i + 1], r.deceleration, pieces[i].metres)});
  }
  for (std::size_t i = 0; i < n; ++i)
    speeds[i + 1] = std::min(speeds[i + 1], reached(speeds[i], pieces[i].ramp.acceleration, pieces[i].metres));
}

double peak_over(const Piece& piece, double from, double to) {
  return piece.time ? std::max(from, to) : peak_speed(piece.ramp, from, to, piece.metres);
}

double seconds_over(const Piece& piece, double from, double to) {
  if (piece.time) return *piece.time;
  if (piece.metres == 0) return 0;
  const double a = piece.ramp.acceleration, b = piece.ramp.deceleration, peak = peak_over(piece, from, to);
  const double ramps = (peak * peak - from * from) / (2 * a) + (peak * peak - to * to) / (2 * b);
  return (peak - from) / a + (peak - to) / b + std::max(0.0, piece.metres - ramps) / peak;
}

std::vector<SpeedClass> speed_classes(const SpeedModel& model, std::size_t count) {
  const double fastest = fastest_end(model);
  std::vector<double> tops{fastest};
  for (std::size_t i = 1; i < count; ++i) tops.push_back(fastest * static_cast<double>(i) / static_cast<double>(count));
  if (count > 1)
    for (const Pace& pace : model.turns) tops.push_back(pace.speed);
  std::sort(tops.begin(), tops.end());
  tops.erase(std::unique(tops.begin(), tops.end()), tops.end());
  std::vector<SpeedClass> classes{{0, 0}};
  for (const double top : tops) classes.push_back({classes.back().high, top});
  return classes;
}

double least_seconds(std::span<const Piece> pieces, const SpeedClass& in, const SpeedClass& out) {
  std::array<double, kMostPieces + 1> v{};
  fill_fastest(pieces, in.high, out.high, v);
  if (v[0] * kSlack < in.low || v[pieces.size()] * kSlack < out.low) return kNever;
  double seconds = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) seconds += seconds_over(pieces[i], v[i], v[i + 1]);
  return seconds;
}

}  // namespace taut::micromouse::detail
