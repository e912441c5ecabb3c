// taut chase generate: a map and a target from a seed.
#include <fmt/format.h>

#include <string>

#include <taut/cli/command.h>
#include <taut/cli/options.h>
#include <taut/cli/run.h>
#include <taut/robots/pursuit/chase_generator.h>

namespace taut::cli {

using namespace pursuit;

namespace {

struct ChaseGenerateOptions {
  ChaseRecipe recipe;
  std::string file = "-";
  CommonOptions common;
};

void set_size(ChaseRecipe& recipe, const std::string& text) {
  const std::size_t by = text.find('x');
  const auto number = [](const std::string& side) { return number_of(side, "--size"); };
  const double x = number(text.substr(0, by)), y = by == std::string::npos ? x : number(text.substr(by + 1));
  for (const double side : {x, y})
    if (side < 3 || side > ChaseMap::kLongestSide || side != static_cast<int>(side))
      throw UsageError(fmt::format("--size: '{}' is not XxY or N, of 3 to {}", text, ChaseMap::kLongestSide));
  recipe.x_size = static_cast<int>(x);
  recipe.y_size = static_cast<int>(y);
}

void refuse_idle_options(const CommandLine& app, const ChaseRecipe& recipe) {
  const bool is_building = recipe.ground == ChaseGround::building;
  if (app.count("--inflation") > 0 && !(is_building && recipe.costly))
    throw UsageError("--inflation needs --building and --costly");
  if (app.count("--buildings") > 0 && is_building) throw UsageError("--buildings is for a town, not for --building");
}

void add_generate_options(CommandLine& app, ChaseGenerateOptions& options) {
  app.add_option_function(
         "--size", [&options](const std::string& text) { set_size(options.recipe, text); },
         "Cells in x and y, or one number for both (default: 200)")
      .type_name("XxY")
      .group("Map");
  app.add_option("--duration", options.recipe.seconds, "Seconds of the target's trajectory (default: 400)")
      .type_name("N")
      .range(1, 1'000'000)
      .group("Map");
  app.add_flag("--costly", options.recipe.costly,
               "Hills of cost 1 to 100, in a building costs that rise towards walls; else every free cell costs 1")
      .group("Map");
  const auto build = [&options] { options.recipe.ground = ChaseGround::building; };
  app.add_flag_callback("--building", build, "One building of corridors and rooms instead of a town").group("Map");
  app.add_option("--inflation", options.recipe.inflation,
                 "In a costly building a cell costs 1 + 10 for each cell of wall so near in x and y (default: 12)")
      .type_name("CELLS")
      .range(1, 100)
      .group("Map");
  app.add_option_function(
         "--buildings",
         [&options](const std::string& text) {
           options.recipe.buildings = number_of(text, "--buildings");
           if (options.recipe.buildings < 0 || options.recipe.buildings > 0.6)
             throw UsageError("--buildings: '" + text + "' is not a share of 0 to 0.6");
         },
         "About this share of the map under buildings, 0 to 0.6 (default: 0.2)")
      .type_name("SHARE")
      .group("Map");
  app.add_option("-o,--output", options.file, "Write to this file instead of standard output")
      .type_name("FILE")
      .group("Map");
  app.callback([&app, &options] { refuse_idle_options(app, options.recipe); });
  app.example("taut chase generate --size 120x80 --costly --seed 7 -o town.chase");
}

int run_generate(const ChaseGenerateOptions& options, Run& run) {
  run.promise(options.file);
  ChaseRecipe recipe = options.recipe;
  recipe.seed = options.common.seed;
  std::string text = run.stage("generate", [&] { return chase_map_text(generate_chase_map(recipe)); });
  Json result{{"x_size", recipe.x_size},
              {"y_size", recipe.y_size},
              {"duration", recipe.seconds},
              {"seed", recipe.seed},
              {"bytes", text.size()}};
  return run.end({.result = std::move(result), .files = {{options.file, std::move(text)}}});
}

}  // namespace

Command chase_generate_command(CommandLine& chase) {
  return command<ChaseGenerateOptions>(chase, "generate", "Make a town with a target walking in it, from a seed",
                                       add_generate_options, run_generate);
}

}  // namespace taut::cli
