#include <taut/robots/micromouse/speed_model.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <taut/geometry/errors.h>
#include <taut/robots/micromouse/detail/json_file.h>

namespace taut::micromouse {

namespace {

using Json = nlohmann::json;

constexpr int kDeepest = 4;
constexpr double kLargest = 1e6;

class ModelReader {
 public:
  ModelReader(std::string_view text, std::string source)
      : source_(std::move(source)), json_(detail::parse_json(text, source_, "speed model", kDeepest)) {}

  SpeedModel model() const {
    SpeedModel model;
    allow(json_, "the model", {"comment", "cell", "straight", "diagonal", "turns", "pivot_90", "pivot_180"});
    take(json_, "cell", model.cell);
    take(json_, "pivot_90", model.pivot_90);
    take(json_, "pivot_180", model.pivot_180);
    ramp("straight", model.straight);
    ramp("diagonal", model.diagonal);
    turns(model);
    require_order(model);
    return model;
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const { throw InputError(source_, 0, what); }

  void allow(const Json& object, const std::string& what, const std::vector<std::string_view>& names) const {
    if (!object.is_object()) refuse(what + " is not an object {...}");
    for (const auto& [key, value] : object.items())
      if (std::find(names.begin(), names.end(), key) == names.end()) refuse("unknown name '" + key + "' in " + what);
  }

  void take(const Json& object, const std::string& key, double& value) const {
    if (!object.contains(key)) return;
    const Json& number = object.at(key);
    if (!number.is_number() || !(number.get<double>() > 0) || number.get<double>() > kLargest)
      refuse("'" + key + "' is not a number above 0 and up to 1000000");
    value = number.get<double>();
  }

  void ramp(const std::string& key, Ramp& ramp) const {
    if (!json_.contains(key)) return;
    const Json& object = json_.at(key);
    allow(object, "'" + key + "'", {"acceleration", "deceleration", "top_speed"});
    take(object, "acceleration", ramp.acceleration);
    take(object, "deceleration", ramp.deceleration);
    take(object, "top_speed", ramp.top_speed);
  }

  void turns(SpeedModel& model) const {
    if (!json_.contains("turns")) return;
    const Json& turns = json_.at("turns");
    std::vector<std::string_view> names;
    for (const Turn turn : kAllTurns) names.push_back(name(turn));
    allow(turns, "'turns'", names);
    for (const Turn turn : kAllTurns) {
      const std::string key(name(turn));
      if (!turns.contains(key)) continue;
      Pace& pace = model.turns[static_cast<std::size_t>(turn)];
      allow(turns.at(key), "'" + key + "'", {"speed", "time"});
      take(turns.at(key), "speed", pace.speed);
      double time = 0;
      take(turns.at(key), "time", time);
      if (time > 0) pace.time = time;
    }
  }

  void require_order(const SpeedModel& model) const {
    for (const Turn turn : kAllTurns) {
      const bool orthogonal = turn != Turn::diagonal_90;
      const bool diagonal = turn == Turn::turn_45 || turn == Turn::turn_135 || turn == Turn::diagonal_90;
      const double speed = model.pace(turn).speed;
      if ((orthogonal && speed > model.straight.top_speed) || (diagonal && speed > model.diagonal.top_speed))
        refuse("'" + std::string(name(turn)) + "' is faster than the top speed of what it joins");
    }
  }

  std::string source_;
  Json json_;
};

}  // namespace

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

SpeedModel read_speed_model(std::string_view text, const std::string& source) {
  return ModelReader(text, source).model();
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
