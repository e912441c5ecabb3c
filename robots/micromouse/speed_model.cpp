#include <taut/robots/micromouse/speed_model.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace taut::micromouse {

std::string_view name(Turn turn) {
  switch (turn) {
    case Turn::small_90: return "small-90";
    case Turn::large_90: return "large-90";
    case Turn::turn_45: return "45";
    case Turn::turn_135: return "135";
    case Turn::turn_180: return "180";
    case Turn::diagonal_90: return "diagonal-90";
  }
  return "";
}

// An arc of angle A that leaves its tangents t from their crossing has radius t / tan(A / 2).
double length(Turn turn) {
  constexpr double kPi = std::numbers::pi, kRoot = std::numbers::sqrt2;
  switch (turn) {
    case Turn::small_90: return kPi / 2;
    case Turn::large_90: return kPi;
    case Turn::turn_45: return (1 + kRoot) * kPi / 4 + (kRoot - 1);
    case Turn::turn_135: return kRoot * (kRoot - 1) * 3 * kPi / 4 + (3 - kRoot);
    case Turn::turn_180: return kPi + 2;
    case Turn::diagonal_90: return kRoot * kPi / 2;
  }
  return 0;
}

double SpeedModel::seconds(Turn turn) const {
  const Pace& p = pace(turn);
  return p.time ? *p.time : length(turn) * cell / 2 / p.speed;
}

double peak_speed(const Ramp& ramp, double from, double to, double metres) {
  const double a = ramp.acceleration, b = ramp.deceleration;
  const double squared = (2 * a * b * metres + b * from * from + a * to * to) / (a + b);
  return std::min(std::max({std::sqrt(squared), from, to}), ramp.top_speed);
}

std::optional<double> straight_seconds(const Ramp& ramp, double from, double to, double metres) {
  const double a = ramp.acceleration, b = ramp.deceleration;
  if (to * to > from * from + 2 * a * metres || from * from > to * to + 2 * b * metres) return std::nullopt;
  const double peak = peak_speed(ramp, from, to, metres);
  if (peak == 0) return 0;
  const double ramps = (peak * peak - from * from) / (2 * a) + (peak * peak - to * to) / (2 * b);
  return (peak - from) / a + (peak - to) / b + std::max(0.0, metres - ramps) / peak;
}

}  // namespace taut::micromouse
