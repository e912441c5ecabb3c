// taut passage: can a disc get from start to goal, and how large may it be? By the gates, without building a path.
#include <fmt/format.h>

#include <utility>
#include <vector>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/run.h>
#include <taut/cli/world/snap_ends.h>
#include <taut/geometry/errors.h>
#include <taut/io/pictures/clearance_svg.h>
#include <taut/io/results/barrier_words.h>
#include <taut/io/results/clearance_json.h>
#include <taut/search/passage.h>
#include <taut/search/query_ends.h>
#include <taut/search/voronoi_search.h>

namespace taut::cli {

namespace {

struct PassageOptions {
  WorldOptions world;
  QueryOptions query;
  CommonOptions common;
  std::string svg;

  std::optional<double> radius() const {
    if (query.robot.kind() != Footprint::Kind::disc) return std::nullopt;
    return query.robot.radius();
  }
};

void add_options(CommandLine& app, PassageOptions& options) {
  add_world_options(app, options.world);
  add_query_options(app, options.query);
  add_svg_option(app, options.svg);
  app.callback([&options] {
    if (options.query.robot.kind() == Footprint::Kind::polygon)
      throw UsageError("--robot: passages are for discs; `taut solve --robot square:R` knows squares");
    require_one_stdout({{"--svg", options.svg}, {"--json", options.common.json}});
  });
  app.example("taut passage maze.txt");
  app.example("taut passage maze.txt --robot disc:0.3 --svg gates.svg");
}

std::vector<Point> read_goals(const FreeSpace& space, const Input& input) {
  require_free(space, *input.world.start(), "start");
  if (input.world.goal().point) require_free(space, *input.world.goal().point, "goal");
  std::vector<Point> goals = goal_points(space, input.world.goal());
  if (goals.empty()) throw InputError(input.name, 0, "the middles of its goal room are no free places; give --to X,Y");
  return goals;
}

std::string widest_text(const Passage& passage, const Gates& gates) {
  const std::string limit = limit_text(gates, *passage.widest, passage.start, passage.goal);
  if (passage.widest->limit == WidestPassage::Limit::none) return "a disc of any radius gets through: " + limit;
  const bool is_gate = passage.widest->limit == WidestPassage::Limit::gate;
  return fmt::format("the largest disc that gets through has radius {}{} {}", number_text(passage.widest->radius),
                     is_gate ? ", diameter" : ":", limit);
}

std::string why_not(const Passage& passage, const Gates& gates) {
  if (!passage.is_proven()) return "no way found, but no walls and gates that prove that there is none";
  return passage.asked
             ? blocked_text(gates, *passage.asked, passage.barrier, passage.start, passage.goal, *passage.radius)
             : separation_text(passage.barrier);
}

std::string line(const Passage& passage, const Gates& gates, const std::string& reason, const Seconds& total) {
  if (passage.gets_through()) {
    const std::string asked =
        passage.radius ? fmt::format("a disc of radius {} gets through; ", number_text(*passage.radius)) : "";
    return asked + widest_text(passage, gates) + ", " + cpu_text(total);
  }
  if (!passage.is_proven()) return reason;
  return passage.radius ? fmt::format("no disc of radius {} gets through: {}", number_text(*passage.radius), reason)
                        : "no path: " + reason;
}

int run(const PassageOptions& options, Run& run) {
  run.source(options.world.file);
  run.promise(options.svg);
  const Input input = read_input(options.world, options.query, run, {options.radius().value_or(0)});
  require_ends(input);
  const FreeSpace space = run.stage("space", [&] { return triangulated(FreeSpace(input.world)); });
  const std::vector<Point> goals = read_goals(space, input);
  const Gates gates = run.stage("gates", [&] { return Gates(space); });
  const Passage found =
      run.stage("search", [&] { return passage(gates, *input.world.start(), goals, options.radius()); });
  Answer answer;
  answer.outcome = found.gets_through() ? Outcome::found : found.is_proven() ? Outcome::none : Outcome::unproven;
  if (answer.outcome != Outcome::found) answer.reason = why_not(found, gates);
  answer.result = passage_json(found, gates);
  answer.line = input.name + ": " + line(found, gates, answer.reason, run.seconds()) + "\n";
  answer.stats = {{"gates", count_text(gates.gates().size(), "gate")}};
  if (!options.svg.empty())
    answer.files = {{options.svg, passage_svg(found, space, title_of(input.name), input.moves)}};
  return run.end(std::move(answer));
}

}  // namespace

Command passage_command(CommandLine& app) {
  return command<PassageOptions>(app, "passage",
                                 "Say whether --robot disc:R gets from start to goal, or how large a disc may be",
                                 add_options, run);
}

}  // namespace taut::cli
