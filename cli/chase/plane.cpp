// taut chase plane: the earliest meeting with a target that moves among obstacles.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <taut/cli/command.h>
#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/path_files.h>
#include <taut/cli/run.h>
#include <taut/geometry/errors.h>
#include <taut/io/pictures/interception_svg.h>
#include <taut/io/results/interception_json.h>
#include <taut/io/worlds/file_kind.h>
#include <taut/io/worlds/read_timed_way.h>
#include <taut/robots/pursuit/verify_meeting.h>

namespace taut::cli {

using namespace pursuit;

namespace {

struct PlaneOptions {
  WorldOptions world;
  QueryOptions query;
  std::string target;
  double speed = 1;
  bool stays = false;
  std::string svg;
  std::string animation;
  PathFiles files;
  CommonOptions common;
};

void add_options(CommandLine& app, PlaneOptions& options) {
  add_world_options(app, options.world);
  add_query_options(app, options.query);
  app.add_option("--target", options.target,
                 "The target's way: lines `T X Y`, between which it goes straight and evenly")
      .type_name("WAY")
      .group("Query")
      .required();
  app.add_option_function(
         "--speed", [&options](const std::string& text) { options.speed = positive_of(text, "--speed"); },
         "How fast the robot is at most, in the world's units (default: 1). The target may be faster")
      .type_name("V")
      .group("Query");
  app.add_flag("--stays", options.stays, "The target stays where its way ends; else it is gone then").group("Query");
  add_svg_option(app, options.svg);
  add_animate_option(app, options.animation, "Write a picture in which robot and target move");
  add_path_file_options(app, options.files);
  app.callback([&app, &options] {
    if (options.query.to) throw UsageError("--to: the goal is the target, say --target");
    settle_animation(app, options.animation, options.svg, options.common.json);
  });
  app.example("taut chase plane data/islands.wkt --target data/islands_way.csv --from 5,8 --svg meeting.svg");
}

std::vector<Point> places_of(const std::vector<ReadTimedPoint>& way) {
  std::vector<Point> places(way.size());
  std::ranges::transform(way, places.begin(), [](const ReadTimedPoint& p) { return p.point.at; });
  return places;
}

Interception question_of(const PlaneOptions& options, const std::vector<ReadTimedPoint>& way, const FreeSpace& space,
                         Point start) {
  Interception question{start, options.speed, {}, options.stays};
  for (const ReadTimedPoint& p : way) question.way.push_back(p.point);
  if (const auto leg = blocked_leg(space, question.way)) {
    const ReadTimedPoint& from = way[*leg];
    const std::string source = source_name(options.target);
    if (!space.holds(from.point.at)) throw InputError(source, from.line, "the target is in a wall, or outside");
    throw InputError(source, way[*leg + 1].line, "a wall is in the target's way to this place");
  }
  return question;
}

void check(const FreeSpace& space, const Interception& question, const MeetingPlace& meeting) {
  if (const std::string fault = meeting_fault(space, question, meeting); !fault.empty())
    throw std::logic_error("the path does not pass its own check: " + fault);
}

std::string headline(const std::optional<MeetingPlace>& meeting) {
  if (!meeting) return "never caught, proven";
  const std::string when =
      fmt::format("caught after {:.9g} at {:.9g},{:.9g}", meeting->time.hi, meeting->at.x, meeting->at.y);
  return meeting->waits > 0 ? when + fmt::format(", the robot waits {:.9g} for it", meeting->waits)
                            : when + ", at this speed nobody does earlier (proven)";
}

std::vector<std::string> facts_of(const Interception& question, const std::optional<MeetingPlace>& meeting) {
  std::vector<std::string> facts;
  if (!meeting) return {"never caught, proven", "speed " + number_text(question.speed)};
  facts.push_back(fmt::format("caught after {:.6f}", meeting->time.hi));
  facts.push_back(fmt::format("length {:.6f}", meeting->length));
  facts.push_back("speed " + number_text(question.speed));
  if (meeting->waits > 0) facts.push_back(fmt::format("waits {:.6f}", meeting->waits));
  return facts;
}

std::string reason_of(const FreeSpace& space, const Interception& question,
                      const std::optional<MeetingPlace>& meeting) {
  if (meeting) return "";
  if (!space.separation(question.start, question.way.front().at).empty()) return "walls separate robot and target";
  return fmt::format("the target's way ends at {} before the robot can be where it is",
                     number_text(question.way.back().time));
}

int run(const PlaneOptions& options, Run& run) {
  run.source(options.world.file);
  for (const std::string& file : {options.svg, options.animation}) run.promise(file);
  promise(run, options.files);
  const Input input = read_input(options.world, run, options.query);
  if (!input.world.start()) throw InputError(input.name, 0, "says no start; give --from X,Y");
  const std::vector<ReadTimedPoint> way = read_timed_way(read_bytes(options.target), source_name(options.target));
  const FreeSpace space =
      run.stage("space", [&] { return triangulated(FreeSpace(input.world, options.query.robot, places_of(way))); });
  const Point start = *input.world.start();
  if (!space.holds(start)) throw InputError(input.name, 0, "the start is in a wall, or outside");
  const Interception question = question_of(options, way, space, start);
  run.so_far(interception_json(question, std::nullopt));
  const VisibilityGraph graph = run.stage("graph", [&] { return VisibilityGraph(space); });
  const std::optional<MeetingPlace> meeting = run.stage("search", [&] { return earliest_meeting(graph, question); });
  if (meeting) run.stage("verify", [&] { check(space, question, *meeting); });
  std::vector<OutputFile> files;
  for (const bool moves : {false, true})
    if (const std::string& file = moves ? options.animation : options.svg; !file.empty())
      files.push_back(
          {file, interception_svg(space, question, meeting,
                                  {title_of(input.name), facts_of(question, meeting), input.moves, moves})});
  if (meeting)
    add_path_files(files, options.files,
                   {{.name = "interception", .points = meeting->path, .length = meeting->length}});
  return run.end({.outcome = meeting ? Outcome::found : Outcome::none,
                  .reason = reason_of(space, question, meeting),
                  .result = interception_json(question, meeting),
                  .line = fmt::format("{}: {}, {}\n", input.name, headline(meeting), seconds_text(run.seconds().cpu)),
                  .files = std::move(files)});
}

}  // namespace

Command chase_plane_command(CommandLine& chase) {
  return command<PlaneOptions>(
      chase, "plane", "Meet a target that moves among obstacles as early as can be, its way known", add_options, run);
}

}  // namespace taut::cli
