#include <taut/python/wishes.h>

#include <array>
#include <cmath>

#include <taut/geometry/errors.h>

namespace taut::python {

namespace {

PrmSampler sampler_named(const std::string& word) {
  static constexpr std::array kNames{"uniform", "lattice", "gaussian", "bridge", "medial-axis", "corners", "sobol"};
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (word == kNames[i]) return static_cast<PrmSampler>(i);
  throw py::value_error("sampler: there is no '" + word + "'");
}

PrmConnection connection_named(const std::string& word) {
  using Rule = PrmConnection::Rule;
  if (word == "prm-star") return {.rule = Rule::star};
  const std::size_t colon = std::min(word.find(':'), word.size());
  const std::string rule = word.substr(0, colon), rest = word.substr(std::min(colon + 1, word.size()));
  std::size_t read = 0;
  double number = 0;
  try {
    number = std::stod(rest, &read);
  } catch (const std::logic_error&) {
  }
  const bool is_number = read == rest.size() && number > 0 && number <= World::kLargest;
  if (is_number && rule == "radius") return {.rule = Rule::radius, .radius = number};
  const bool is_count = is_number && number == std::floor(number) && number <= 1000;
  const auto counted = [&](Rule r) { return PrmConnection{.rule = r, .count = static_cast<std::size_t>(number)}; };
  if (is_count && rule == "nearest") return counted(Rule::nearest);
  if (is_count && rule == "visible") return counted(Rule::visible);
  if (is_count && rule == "forest") return counted(Rule::forest);
  throw py::value_error("connection: 'nearest:8', 'visible:8', 'forest:8', 'radius:1.5' or 'prm-star', not '" + word +
                        "'");
}

double clearance_of(py::handle value) {
  const double clearance = value.cast<double>();
  if (!(clearance >= 0 && clearance <= World::kLargest)) throw py::value_error("clearance: 0 or more");
  return clearance;
}

}  // namespace

BuildRequest request_of(const py::kwargs& given) {
  BuildRequest request;
  for (const auto& [key, value] : given) {
    const auto name = key.cast<std::string>();
    if (name == "seed")
      request.seed = value.cast<std::uint64_t>();
    else if (name == "sampler")
      request.prm.sampler = sampler_named(value.cast<std::string>());
    else if (name == "connection")
      request.prm.connection = connection_named(value.cast<std::string>());
    else if (name == "clearance")
      request.prm.clearance = clearance_of(value);
    else if (name == "samples")
      request.prm.samples = value.cast<std::size_t>();
    else if (name == "lazy")
      request.prm.lazy = value.cast<bool>();
    else if (name == "exactly")
      request.prm.exactly = value.cast<bool>();
    else
      throw py::type_error("there is no option '" + name + "'");
  }
  return request;
}

GraphMethod method_of(const std::string& algorithm, const std::string& heuristic) {
  const auto how = graph_algorithm_named(algorithm);
  const auto estimate = graph_heuristic_named(heuristic);
  if (!how) throw py::value_error("algorithm: " + graph_algorithm_names() + ", not '" + algorithm + "'");
  if (!estimate) throw py::value_error("heuristic: " + graph_heuristic_names() + ", not '" + heuristic + "'");
  return {*how, *estimate};
}

const RoadmapKind& kind_named(const std::string& word) {
  const RoadmapKind* kind = roadmap_kind(word);
  if (!kind) throw py::value_error("kind: " + roadmap_kind_names() + ", not '" + word + "'");
  return *kind;
}

void require_point_robot(const FreeSpace& space) {
  if (space.footprint().kind() != Footprint::Kind::point)
    throw py::value_error("the space is a robot's that is no point; make it without a footprint");
}

void require_radius(double r) {
  if (!(r > 0 && r <= World::kLargest)) throw InputError("", 0, "a disc's radius is above 0");
}

}  // namespace taut::python
