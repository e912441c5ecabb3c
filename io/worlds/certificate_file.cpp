#include <taut/io/worlds/certificate_file.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <taut/geometry/errors.h>
#include <taut/io/results/json.h>
#include <taut/io/worlds/detail/json_tree.h>

namespace taut {

namespace {

using detail::JsonTree;
using micromouse::Action;
using micromouse::Witness;

constexpr int kFormat = 1;
constexpr int kLargest = 1'000'000;
constexpr std::array<std::string_view, 4> kSideNames{"north", "east", "south", "west"};

Json json_of(Cell c) { return Json::array({c.x, c.y}); }

Json json_of(const Witness& w) {
  return {
      {"cell", json_of(w.wall.cell)}, {"side", kSideNames[static_cast<std::size_t>(w.wall.side)]}, {"step", w.step}};
}

Json json_of(const Action& a) { return a.reset ? Json("reset") : Json::array({a.rotation, a.movement}); }

template <typename Item>
Json json_of(const std::vector<Item>& items) {
  Json all = Json::array();
  for (const Item& item : items) all.push_back(json_of(item));
  return all;
}

/// Takes a parsed file apart, naming what does not fit.
class Reader {
 public:
  explicit Reader(std::string source) : source_(std::move(source)) {}

  const JsonTree& member(const JsonTree& object, const char* key) const {
    const JsonTree* const found = object.find(key);
    if (!found) refuse(object, key, "is missing");
    return *found;
  }

  int number(const JsonTree& value, const char* key) const {
    if (value.kind != JsonTree::Kind::number || std::trunc(value.number) != value.number)
      refuse(value, key, "is not a whole number");
    if (std::abs(value.number) > kLargest) refuse(value, key, "is out of range");
    return static_cast<int>(value.number);
  }

  Cell cell(const JsonTree& value, const char* key) const {
    if (!is_pair(value)) refuse(value, key, "is not a cell [x, y]");
    return {number(value.items[0], key), number(value.items[1], key)};
  }

  template <typename Item, typename Parse>
  std::vector<Item> items(const JsonTree& file, const char* key, Parse parse) const {
    const JsonTree& array = member(file, key);
    if (array.kind != JsonTree::Kind::array) refuse(array, key, "is not a list");
    std::vector<Item> all;
    for (const JsonTree& value : array.items) all.push_back(parse(value));
    return all;
  }

  std::vector<Cell> cells(const JsonTree& file, const char* key) const {
    return items<Cell>(file, key, [&](const JsonTree& value) { return cell(value, key); });
  }

  std::vector<Witness> witnesses(const JsonTree& file, const char* key, bool closed) const {
    return items<Witness>(file, key, [&](const JsonTree& value) {
      const JsonTree& side = member(value, "side");
      const auto at =
          side.kind == JsonTree::Kind::string ? std::ranges::find(kSideNames, side.string) : kSideNames.end();
      if (at == kSideNames.end()) refuse(side, "side", "is not north, east, south or west");
      return Witness{{cell(member(value, "cell"), "cell"), static_cast<Side>(at - kSideNames.begin())},
                     closed,
                     number(member(value, "step"), "step")};
    });
  }

  std::vector<Action> actions(const JsonTree& file) const {
    return items<Action>(file, "run1", [&](const JsonTree& value) {
      if (value.kind == JsonTree::Kind::string && value.string == "reset") return micromouse::kReset;
      if (!is_pair(value)) refuse(value, "run1", "holds a step that is not [rotation, movement]");
      return Action{number(value.items[0], "run1"), number(value.items[1], "run1"), false};
    });
  }

  micromouse::Task task(const JsonTree& file) const {
    micromouse::Task task{number(member(file, "width"), "width"), number(member(file, "height"), "height"),
                          cell(member(file, "start"), "start"), cells(file, "goal"),
                          number(member(file, "max_steps"), "max_steps")};
    if (task.goal.empty()) refuse(file, "goal", "is empty");
    std::ranges::sort(task.goal);
    return task;
  }

  void admit(const JsonTree& file) const {
    if (number(member(file, "certificate"), "certificate") != kFormat)
      refuse(file, "certificate", "is a format other than 1");
  }

 private:
  static bool is_pair(const JsonTree& value) { return value.kind == JsonTree::Kind::array && value.items.size() == 2; }

  [[noreturn]] void refuse(const JsonTree& at, const std::string& key, const char* why) const {
    throw InputError(source_, at.line, "is no certificate: '" + key + "' " + why);
  }

  std::string source_;
};

}  // namespace

std::string certificate_text(const micromouse::CertifiedRun& certified) {
  const auto& [c, run1] = certified;
  return json_text({{"certificate", kFormat},
                    {"width", c.task.width},
                    {"height", c.task.height},
                    {"start", json_of(c.task.start)},
                    {"goal", json_of(c.task.goal)},
                    {"max_steps", c.task.max_steps},
                    {"steps", c.steps},
                    {"route", json_of(c.route)},
                    {"openings", json_of(c.openings)},
                    {"walls", json_of(c.walls)},
                    {"run1", json_of(run1)}});
}

micromouse::CertifiedRun read_certificate(std::string_view text, const std::string& source) {
  const Reader reader(source);
  const JsonTree json = detail::parse_json(text, source);
  reader.admit(json);
  micromouse::CertifiedRun certified;
  certified.certificate = {reader.task(json), reader.number(reader.member(json, "steps"), "steps"),
                           reader.cells(json, "route"), reader.witnesses(json, "openings", false),
                           reader.witnesses(json, "walls", true)};
  certified.run1 = reader.actions(json);
  return certified;
}

}  // namespace taut
