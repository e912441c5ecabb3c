// taut reach: where can a disc get to, and what keeps it from the rest?
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/run.h>
#include <taut/cli/world/snap_ends.h>
#include <taut/geometry/errors.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/results/words.h>
#include <taut/roadmaps/disc_places.h>
#include <taut/search/barrier.h>
#include <taut/search/disc_reach.h>
#include <taut/search/query_ends.h>

namespace taut::cli {

namespace {

struct ReachOptions {
  WorldOptions world;
  QueryOptions query;
  CommonOptions common;
  std::string svg;
  std::string output;
  std::optional<Point> asked;
};

void add_options(CommandLine& app, ReachOptions& options) {
  add_world_options(app, options.world);
  add_query_options(app, options.query);
  add_svg_option(app, options.svg);
  app.add_option("-o,--output", options.output, "Write the places of the centre as GeoJSON polygons")
      .type_name("FILE")
      .group("Output");
  app.add_option_function(
         "--ask", [&options](const std::string& text) { options.asked = point_of(text); },
         "Does the centre get there? Exactly; and which place of the disc is nearest")
      .type_name("X,Y")
      .group("Query");
  app.callback([&options] {
    if (options.query.robot.kind() != Footprint::Kind::disc || !(options.query.robot.radius() > 0))
      throw UsageError("--robot disc:R is needed: the disc's radius");
    if (options.query.to) throw UsageError("--to: reach has no goal; `taut passage` says whether a disc gets there");
    require_one_stdout({{"--svg", options.svg}, {"-o", options.output}, {"--json", options.common.json}});
  });
  app.example("taut reach maze.txt --from 0.5,0.5 --robot disc:0.2 --svg reach.svg");
  app.example("taut reach maze.txt --from 0.5,0.5 --robot disc:0.2 --ask 3.5,2.05");
}

std::string geojson(const DiscReach& reach) {
  Json features = Json::array();
  const auto closed = [](const Ring& ring) {
    Json points = Json::array();
    for (const Point p : ring) points.push_back(p);
    points.push_back(ring.front());
    return points;
  };
  for (const Polygon& polygon : reach.places) {
    Json rings = Json::array();
    rings.push_back(closed(polygon.outer));
    for (const Ring& hole : polygon.holes) rings.push_back(closed(hole));
    features.push_back({{"type", "Feature"},
                        {"properties", Json::object()},
                        {"geometry", {{"type", "Polygon"}, {"coordinates", rings}}}});
  }
  return json_text({{"type", "FeatureCollection"}, {"features", features}});
}

/// One ring to be filled: holes hang on a line there and back.
Ring with_holes(const Polygon& polygon) {
  Ring ring = polygon.outer;
  for (const Ring& hole : polygon.holes) {
    ring.push_back(polygon.outer.front());
    ring.insert(ring.end(), hole.begin(), hole.end());
    ring.push_back(hole.front());
  }
  if (!polygon.holes.empty()) ring.push_back(polygon.outer.front());
  return ring;
}

class Reacher {
 public:
  Reacher(const ReachOptions& options, Run& run) : options_(options), run_(run) {}

  int work() {
    run_.promise(options_.svg);
    run_.promise(options_.output);
    const double r = options_.query.robot.radius();
    const Input input = read_input(options_.world, options_.query, run_, {r});
    if (!input.world.start()) throw InputError(input.name, 0, "says nothing about a start; give --from X,Y");
    const Point start = *input.world.start();
    const FreeSpace space = run_.stage("space", [&] { return triangulated(FreeSpace(input.world)); });
    const PassageIndex index = run_.stage("index", [&] { return PassageIndex(space); });
    const auto reach = run_.stage("search", [&] { return disc_reach(index, start, r); });
    if (!reach) {
      require_free(DiscPlaces(space, r), start, "start");
      throw InputError(input.name, 0, "the disc cannot be at the start");
    }
    if (options_.asked) run_.stage("ask", [&] { ask(index, start, r); });
    return end(input, index, *reach);
  }

 private:
  void ask(const PassageIndex& index, Point start, double r) {
    reached_ = index.passes(start, *options_.asked, r) == DiscStatus::found;
    nearest_ = DiscPlaces(index.gates().space(), r).nearest(*options_.asked);
    if (nearest_) nearest_reached_ = index.passes(start, nearest_->point, r) == DiscStatus::found;
  }

  Json asked_json() const {
    if (!options_.asked) return nullptr;
    Json json = {{"point", *options_.asked}, {"reached", reached_}, {"nearest", nullptr}};
    if (nearest_)
      json["nearest"] = {{"point", nearest_->point},
                         {"distance", nearest_->distance},
                         {"rounding", nearest_->rounding},
                         {"reached", nearest_reached_}};
    return json;
  }

  std::string asked_text() const {
    if (!options_.asked) return "";
    std::string text = fmt::format("; {} to {}", reached_ ? "it gets" : "it does not get", point_text(*options_.asked));
    if (!nearest_ || nearest_->distance == 0) return text;
    return text + fmt::format(", the nearest place {} is {:.6g} away{}", point_text(nearest_->point),
                              nearest_->distance, nearest_reached_ ? "" : " and not reached");
  }

  /// `(0, 1)-(2, 1)` of both walls that a gate is between.
  static std::array<Segment, 2> walls_of(const Gates& gates, std::uint32_t i) {
    const Gate& gate = gates.gates()[i];
    const Point *end = &gate.end, *foot = gate.foot_is_end ? &gate.foot : nullptr;
    return {wall_of(gates.space(), gate.constraint, end), wall_of(gates.space(), gate.facing, foot)};
  }

  int end(const Input& input, const PassageIndex& index, const DiscReach& reach) {
    std::vector<NamedGate> gates;
    for (const std::uint32_t gate : reach.gates) gates.push_back(named_gate(index.gates(), gate));
    Json closed = Json::array();
    for (std::size_t i = 0; i < gates.size(); ++i) {
      const NamedGate& gate = gates[i];
      const auto walls = walls_of(index.gates(), reach.gates[i]);
      closed.push_back({{"posts", gate.at},
                        {"width", gate.width},
                        {"width_text", gate.width_text},
                        {"walls", Json::array({walls[0], walls[1]})}});
    }
    Answer answer;
    answer.result = {{"start", *input.world.start()},
                     {"radius", options_.query.robot.radius()},
                     {"area", reach.area},
                     {"whole_area", reach.whole_area},
                     {"polygons", reach.places.size()},
                     {"outline_error", Footprint::kDiscExcess},
                     {"gates", closed},
                     {"asked", asked_json()}};
    answer.line =
        input.name + ": " + line(index.gates(), reach, gates) + asked_text() + ", " + cpu_text(run_.seconds()) + "\n";
    if (!options_.output.empty()) answer.files.push_back({options_.output, geojson(reach)});
    if (!options_.svg.empty()) answer.files.push_back({options_.svg, picture(input, index, reach, gates)});
    return run_.end(std::move(answer));
  }

  std::string line(const Gates& all, const DiscReach& reach, const std::vector<NamedGate>& gates) const {
    std::string text = fmt::format("a disc of radius {} gets to {:.6g} of {:.6g} (area of its centre's places)",
                                   number_text(options_.query.robot.radius()), reach.area, reach.whole_area);
    if (gates.empty()) return text;
    const auto walls = walls_of(all, reach.gates.front());
    text += fmt::format("; {} too narrow: {}, of the walls {} and {}", gates.size() == 1 ? "this gate is" : "gates are",
                        gates.front().name, segment_text(walls[0]), segment_text(walls[1]));
    return gates.size() == 1 ? text : text + fmt::format(" and {} more", gates.size() - 1);
  }

  std::string picture(const Input& input, const PassageIndex& index, const DiscReach& reach,
                      const std::vector<NamedGate>& gates) const {
    SvgPicture picture;
    picture.title = title_of(input.name);
    picture.facts = {fmt::format("a disc of radius {}", number_text(options_.query.robot.radius())),
                     fmt::format("{} too narrow", count_text(gates.size(), "gate"))};
    picture.start = input.world.start();
    picture.moves = input.moves;
    if (options_.asked) picture.labels.push_back({*options_.asked, reached_ ? "reached" : "not reached"});
    for (const Polygon& polygon : reach.places) picture.fills.push_back({with_holes(polygon), kShade});
    picture.fill_label = "where its centre gets to";
    for (const NamedGate& gate : gates) picture.gates.push_back(gate.at);
    return svg(index.gates().space(), picture);
  }

  static constexpr double kShade = 0.75;

  const ReachOptions& options_;
  Run& run_;
  bool reached_ = false, nearest_reached_ = false;  // of --ask
  std::optional<FreePlace> nearest_;
};

int run(const ReachOptions& options, Run& run) {
  run.source(options.world.file);
  return Reacher(options, run).work();
}

}  // namespace

Command reach_command(CommandLine& app) {
  return command<ReachOptions>(
      app, "reach", "Where --robot disc:R gets to from the start, and what keeps it from the rest", add_options, run);
}

}  // namespace taut::cli
