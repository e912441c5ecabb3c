// taut view: a world as a page to be played with.
#include <fmt/format.h>

#include <array>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/input.h>
#include <taut/cli/messages.h>
#include <taut/cli/output.h>
#include <taut/cli/run.h>
#include <taut/cli/stop.h>
#include <taut/cli/view/server.h>
#include <taut/io/results/words.h>
#include <taut/io/worlds/write_world.h>
#include <taut/web/page.h>
#include <taut/web/session.h>

namespace taut::cli {

namespace {

struct ViewOptions {
  WorldOptions world;
  QueryOptions query;
  CommonOptions common;
  std::string page = "-";
  bool serve = false;
  std::optional<double> seconds;
};

// The layers that a page without a planner can show.
constexpr std::array kStill{"triangulation", "mesh", "voronoi", "region", "gates"};
constexpr std::size_t kStillWalls = 20'000;  // of more the layers would be megabytes

void add_options(CommandLine& app, ViewOptions& options) {
  add_world_options(app, options.world);
  app.add_option("--output,-o", options.page, "Write the page here; - is standard output (default)").type_name("PAGE");
  app.add_flag("--serve", options.serve,
               "Answer a page on this machine instead: its address is printed, until SIGINT or SIGTERM");
  app.add_option_function(
         "--for", [&options](const std::string& text) { options.seconds = positive_of(text, "--for"); },
         "With --serve: so long, in seconds")
      .type_name("SECONDS");
  const auto point = [](std::optional<Point>& to) { return [&to](const std::string& text) { to = point_of(text); }; };
  app.add_option_function("--from", point(options.query.from), "Start here instead of where FILE says")
      .type_name("X,Y")
      .group("Query");
  app.add_option_function("--to", point(options.query.to), "Go here instead of where FILE says")
      .type_name("X,Y")
      .group("Query");
  app.callback([&options] {
    if (options.seconds && !options.serve) throw UsageError("--for: goes with --serve");
    if (options.serve && options.page != "-") throw UsageError("--output: --serve writes no page");
    if (options.serve && !can_serve()) throw UsageError("--serve: this program was built without cpp-httplib");
    if (!options.serve) require_one_stdout({{"--output", options.page}, {"--json", options.common.json}});
  });
  app.example("taut view data/floor_plan.geojson -o plan.html");
  app.example("taut view data/maze_61x61_loops.txt --serve");
}

/// The request that loads the world: as GeoJSON, which holds all of it, however it was read.
Json load_request(const Input& input) {
  const World& world = input.world;
  const bool fits = world.walls().empty() && world.raster() != nullptr && !world.start();
  if (fits) return {{"do", "load"}, {"name", input.name}, {"format", "movingai"}, {"bytes", write_movingai(world)}};
  return {{"do", "load"}, {"name", input.name}, {"format", "geojson"}, {"bytes", write_geojson(world)}};
}

Json asked(web::Session& session, const Json& request) { return Json::verbatim(session.answer(json_line(request))); }

bool is_error(const Json& answer) { return json_line(answer).starts_with(R"({"error")"); }

/// What is shown where nobody answers.
Json still(web::Session& session, const Input& input, const Json& world) {
  Json kept{{"world", world}};
  if (input.world.start()) {
    kept["path"] = asked(session, {{"do", "path"}, {"digits", 6}});
    kept["widest"] = asked(session, {{"do", "widest"}});
  }
  if (input.world.walls().size() > kStillWalls) return kept;
  Json layers = Json::object();
  for (const char* name : kStill) {
    const Json layer = asked(session, {{"do", "layer"}, {"name", name}});
    if (!is_error(layer)) layers[name] = layer;
  }
  kept["layers"] = std::move(layers);
  return kept;
}

int serve_page(const ViewOptions& options, Run& run, web::Session& session, Json parts) {
  const auto page_at = [&](const std::string& ask) {
    parts["server"] = ask;
    return web::page(json_line(parts), {});
  };
  const auto begun = [&](const std::string& address) {
    if (run.is_talkative() || options.common.quiet) print(address + "\n");
  };
  const auto answer = [&](const std::string& question) { return session.answer(question); };
  const std::size_t answered = run.stage("serve", [&] {
    return serve({answer, page_at, begun, instead_of_stopping, options.seconds});
  });
  return run.end({.result = {{"questions", answered}}});
}

int run(const ViewOptions& options, Run& run) {
  run.source(options.world.file);
  if (!options.serve) run.promise(options.page);
  const Input input = read_input(options.world, run, options.query);
  web::Session session;
  Json parts{{"name", input.name}, {"load", load_request(input)}};
  const Json world = run.stage("space", [&] { return asked(session, parts["load"]); });
  if (is_error(world)) throw InputError(input.name, 0, "cannot be shown: " + json_line(world));
  if (options.serve) return serve_page(options, run, session, std::move(parts));
  const web::Wasm wasm = web::embedded_wasm();
  parts["still"] = run.stage("layers", [&] { return still(session, input, world); });
  std::string page = web::page(json_line(parts), wasm);
  const std::string line =
      fmt::format("{}: a page of {} kB, {}\n", input.name, page.size() / 1000,
                  wasm.bytes.empty() ? "a picture without planner (--serve has one)" : "with its planner");
  return run.end({.result = {{"bytes", page.size()}, {"planner", !wasm.bytes.empty()}},
                  .line = line,
                  .files = {{options.page, std::move(page)}}});
}

}  // namespace

Command view_command(CommandLine& app) {
  return command<ViewOptions>(app, "view", "Write a page to drag start and goal in, draw walls and see why",
                              add_options, run);
}

}  // namespace taut::cli
