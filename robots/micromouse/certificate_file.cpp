#include <taut/robots/micromouse/certificate_file.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <utility>

#include <taut/geometry/errors.h>
#include <taut/robots/micromouse/detail/json_file.h>

namespace taut::micromouse {

namespace {

using Json = nlohmann::json;

constexpr int kFormat = 1;
constexpr int kDeepest = 8;
constexpr int kLargest = 1'000'000;
constexpr std::array<std::string_view, 4> kSideNames{"north", "east", "south", "west"};

std::string text(Cell c) { return "[" + std::to_string(c.x) + ", " + std::to_string(c.y) + "]"; }

std::string text(const Witness& w) {
  return "{\"cell\": " + text(w.wall.cell) + ", \"side\": \"" +
         std::string(kSideNames[static_cast<std::size_t>(w.wall.side)]) + "\", \"step\": " + std::to_string(w.step) +
         "}";
}

std::string text(const Action& a) {
  return a.reset ? "\"reset\"" : "[" + std::to_string(a.rotation) + ", " + std::to_string(a.movement) + "]";
}

template <typename Item>
std::string list(const std::vector<Item>& items, const char* between) {
  std::string out = "[";
  for (std::size_t i = 0; i < items.size(); ++i) out += (i > 0 ? between : "") + text(items[i]);
  return out + "]";
}

/// Takes a parsed file apart, naming what does not fit.
class Reader {
 public:
  explicit Reader(std::string source) : source_(std::move(source)) {}

  const Json& member(const Json& object, const char* key) const {
    if (!object.is_object() || !object.contains(key)) refuse(key, "is missing");
    return object.at(key);
  }

  int number(const Json& value, const char* key) const {
    if (!value.is_number_integer()) refuse(key, "is not a whole number");
    if (value.is_number_unsigned() ? value.get<std::uint64_t>() > static_cast<std::uint64_t>(kLargest)
                                   : value.get<std::int64_t>() < -kLargest)
      refuse(key, "is out of range");
    return value.get<int>();
  }

  Cell cell(const Json& value, const char* key) const {
    if (!value.is_array() || value.size() != 2) refuse(key, "is not a cell [x, y]");
    return {number(value[0], key), number(value[1], key)};
  }

  template <typename Item, typename Parse>
  std::vector<Item> items(const Json& file, const char* key, Parse parse) const {
    const Json& array = member(file, key);
    if (!array.is_array()) refuse(key, "is not a list");
    std::vector<Item> all;
    for (const Json& value : array) all.push_back(parse(value));
    return all;
  }

  std::vector<Cell> cells(const Json& file, const char* key) const {
    return items<Cell>(file, key, [&](const Json& value) { return cell(value, key); });
  }

  std::vector<Witness> witnesses(const Json& file, const char* key, bool closed) const {
    return items<Witness>(file, key, [&](const Json& value) {
      const Json& side = member(value, "side");
      const auto at = side.is_string() ? std::find(kSideNames.begin(), kSideNames.end(), side.get<std::string>())
                                       : kSideNames.end();
      if (at == kSideNames.end()) refuse("side", "is not north, east, south or west");
      return Witness{{cell(member(value, "cell"), "cell"), static_cast<Side>(at - kSideNames.begin())},
                     closed,
                     number(member(value, "step"), "step")};
    });
  }

  std::vector<Action> actions(const Json& file) const {
    return items<Action>(file, "run1", [&](const Json& value) {
      if (value == "reset") return kReset;
      if (!value.is_array() || value.size() != 2) refuse("run1", "holds a step that is not [rotation, movement]");
      return Action{number(value[0], "run1"), number(value[1], "run1"), false};
    });
  }

  Task task(const Json& file) const {
    Task task{number(member(file, "width"), "width"), number(member(file, "height"), "height"),
              cell(member(file, "start"), "start"), cells(file, "goal"),
              number(member(file, "max_steps"), "max_steps")};
    if (task.goal.empty()) refuse("goal", "is empty");
    std::sort(task.goal.begin(), task.goal.end());
    return task;
  }

  void admit(const Json& file) const {
    if (number(member(file, "certificate"), "certificate") != kFormat)
      refuse("certificate", "is a format other than 1");
  }

 private:
  [[noreturn]] void refuse(const std::string& key, const char* why) const {
    throw InputError(source_, 0, "is no certificate: '" + key + "' " + why);
  }

  std::string source_;
};

}  // namespace

CertificateFile file_of(const Certificate& certificate, const Record& record) {
  CertificateFile file{certificate, {}};
  for (const Step& step : record.steps)
    if (step.run == 1) file.run1.push_back(step.action);
  return file;
}

std::string certificate_text(const CertificateFile& file) {
  const auto& [c, run1] = file;
  const auto number = [](const char* key, int value) {
    return std::string("  \"") + key + "\": " + std::to_string(value) + ",\n";
  };
  return "{\n" + number("certificate", kFormat) + number("width", c.task.width) + number("height", c.task.height) +
         "  \"start\": " + text(c.task.start) + ",\n  \"goal\": " + list(c.task.goal, ", ") + ",\n" +
         number("max_steps", c.task.max_steps) + number("steps", c.steps) + "  \"route\": " + list(c.route, ", ") +
         ",\n  \"openings\": " + list(c.openings, ",\n    ") + ",\n  \"walls\": " + list(c.walls, ",\n    ") +
         ",\n  \"run1\": " + list(run1, ", ") + "\n}\n";
}

CertificateFile read_certificate(std::string_view text, const std::string& source) {
  const Reader reader(source);
  const Json json = detail::parse_json(text, source, "certificate", kDeepest);
  reader.admit(json);
  CertificateFile file;
  file.certificate = {reader.task(json), reader.number(reader.member(json, "steps"), "steps"),
                      reader.cells(json, "route"), reader.witnesses(json, "openings", false),
                      reader.witnesses(json, "walls", true)};
  file.run1 = reader.actions(json);
  return file;
}

Finding check_certificate(const CertificateFile& file, const GridMaze& maze) {
  if (const Finding finding = check_certificate(file.certificate, maze); !finding) return finding;
  Trial trial(maze, file.certificate.task.max_steps);
  for (const Action& action : file.run1) {
    if (trial.over() || trial.run() != 1) return {false, "run 1 ends before its last step"};
    trial.act(action);
  }
  if (const Finding finding = check_record(trial.record(), maze); !finding) return finding;
  return check_certificate(file.certificate, maze, trial.record());
}

}  // namespace taut::micromouse
