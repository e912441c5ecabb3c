#include <taut/cli/world/snap_ends.h>

#include <fmt/format.h>

#include <functional>

#include <taut/cli/messages.h>
#include <taut/cli/world/geographic.h>
#include <taut/geometry/walled_world.h>
#include <taut/io/results/words.h>
#include <taut/roadmaps/disc_places.h>

namespace taut::cli {

namespace {

using Nearest = std::function<std::optional<FreePlace>(Point)>;

std::vector<Point> ends_of(const World& world) {
  std::vector<Point> ends;
  if (world.start()) ends.push_back(*world.start());
  if (world.goal().point) ends.push_back(*world.goal().point);
  return ends;
}

Nearest places_of(const World& world, const Footprint& robot, const EndPlaces& which) {
  if (which.radius > 0) {
    const FreeSpace space(which.limits_are_walls ? walled_world(world, ends_of(world)) : world);
    return [places = DiscPlaces(space, which.radius)](Point p) { return places.nearest(p); };
  }
  return [space = FreeSpace(world, robot)](Point p) { return nearest_free(space, p); };
}

std::optional<EndMove> end_move(const std::string& role, Point given, double most, const Nearest& nearest) {
  const std::optional<FreePlace> place = nearest(given);
  if (!place || place->point == given || place->distance > most) return std::nullopt;
  return EndMove{role, given, *place};
}

void move_ends(Input& input, double most, const Nearest& nearest) {
  const auto moved = [&](const char* role, const std::optional<Point>& given) -> std::optional<Point> {
    if (!given) return std::nullopt;
    const std::optional<EndMove> move = end_move(role, *given, most, nearest);
    if (!move) return std::nullopt;
    note(fmt::format("taut: {}: {}; moved there", input.name,
                     blocked_text(input.world, *given, role, move->place, Shown(input.notes))));
    input.moves.push_back(*move);
    return move->place.point;
  };
  const std::optional<Point> start = moved("start", input.world.start()),
                             goal = moved("goal", input.world.goal().point);
  if (start || goal) input.world = input.world.with_ends(start, goal);
}

}  // namespace

void add_snap_ends_option(CommandLine& app, std::optional<double>& snap_ends) {
  app.add_option_function(
         "--snap-ends",
         [&snap_ends](const std::string& text) {
           snap_ends = number_of(text, "--snap-ends");
           if (*snap_ends < 0) throw UsageError("--snap-ends: '" + text + "' is negative");
         },
         "Move a start or goal that is no place for the robot to the nearest one, by at most this much")
      .type_name("D")
      .group("Query");
}

Input read_input(const WorldOptions& options, const QueryOptions& query, Run& run, const EndPlaces& places) {
  Input input = read_input(options, run, query);
  if (!query.snap_ends || ends_of(input.world).empty()) return input;
  run.stage("ends", [&] { move_ends(input, *query.snap_ends, places_of(input.world, query.robot, places)); });
  if (!input.moves.empty()) run.add_to_result("moved_ends", end_moves_json(Shown(input.notes)(input.moves)));
  return input;
}

}  // namespace taut::cli
