#include <taut/io/worlds/speed_model_file.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/io/worlds/detail/json_tree.h>
#include <taut/io/worlds/detail/text_input.h>

namespace taut {

namespace {

using detail::JsonTree;
using micromouse::kAllTurns;
using micromouse::Pace;
using micromouse::Ramp;
using micromouse::SpeedModel;
using micromouse::Turn;

constexpr double kLargest = 1e6;

class ModelReader {
 public:
  ModelReader(std::string_view text, std::string source)
      : source_(std::move(source)), json_(detail::parse_json(text, source_)) {}

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
  [[noreturn]] void refuse(const JsonTree& at, const std::string& what) const {
    throw InputError(source_, at.line, what);
  }

  void allow(const JsonTree& object, const std::string& what, const std::vector<std::string_view>& names) const {
    if (object.kind != JsonTree::Kind::object) refuse(object, what + " is not an object {...}");
    for (std::size_t i = 0; i < object.keys.size(); ++i)
      if (std::ranges::find(names, object.keys[i]) == names.end())
        refuse(object.items[i], "unknown name " + detail::quoted(object.keys[i]) + " in " + what);
  }

  void take(const JsonTree& object, const std::string& key, double& value) const {
    const JsonTree* const number = object.find(key);
    if (!number) return;
    if (number->kind != JsonTree::Kind::number || !(number->number > 0) || number->number > kLargest)
      refuse(*number, "'" + key + "' is not a number above 0 and up to 1000000");
    value = number->number;
  }

  void ramp(const std::string& key, Ramp& ramp) const {
    const JsonTree* const object = json_.find(key);
    if (!object) return;
    allow(*object, "'" + key + "'", {"acceleration", "deceleration", "top_speed"});
    take(*object, "acceleration", ramp.acceleration);
    take(*object, "deceleration", ramp.deceleration);
    take(*object, "top_speed", ramp.top_speed);
  }

  void turns(SpeedModel& model) const {
    const JsonTree* const turns = json_.find("turns");
    if (!turns) return;
    std::vector<std::string_view> names;
    names.reserve(std::size(kAllTurns));
    for (const Turn turn : kAllTurns) names.push_back(name(turn));
    allow(*turns, "'turns'", names);
    for (const Turn turn : kAllTurns) {
      const std::string key(name(turn));
      const JsonTree* const object = turns->find(key);
      if (!object) continue;
      Pace& pace = model.turns[static_cast<std::size_t>(turn)];
      allow(*object, "'" + key + "'", {"speed", "time"});
      take(*object, "speed", pace.speed);
      double time = 0;
      take(*object, "time", time);
      if (time > 0) pace.time = time;
    }
  }

  void require_order(const SpeedModel& model) const {
    for (const Turn turn : kAllTurns) {
      const bool orthogonal = turn != Turn::diagonal_90;
      const bool diagonal = turn == Turn::turn_45 || turn == Turn::turn_135 || turn == Turn::diagonal_90;
      const double speed = model.pace(turn).speed;
      if ((orthogonal && speed > model.straight.top_speed) || (diagonal && speed > model.diagonal.top_speed))
        refuse(json_, "'" + std::string(name(turn)) + "' is faster than the top speed of what it joins");
    }
  }

  std::string source_;
  JsonTree json_;
};

}  // namespace

SpeedModel read_speed_model(std::string_view text, const std::string& source) {
  return ModelReader(text, source).model();
}

}  // namespace taut
