// The subcommands.
#pragma once

#include <CLI/App.hpp>

#include <functional>
#include <memory>
#include <vector>

#include <taut/cli/options.h>

namespace taut::cli {

/// A subcommand that was added to the program. `run` does its work after the command line was read and gives the exit
/// code; it throws InputError, WriteError or std::bad_alloc where that is what happened.
struct Command {
  CLI::App* app = nullptr;
  std::shared_ptr<CommonOptions> common;
  std::function<int()> run;
};

Command solve_command(CLI::App& app);
Command check_command(CLI::App& app);
Command roadmap_command(CLI::App& app);
Command compare_command(CLI::App& app);
Command passage_command(CLI::App& app);
Command generate_command(CLI::App& app);
Command convert_command(CLI::App& app);
Command batch_command(CLI::App& app);
/// The group `grid`.
std::vector<Command> grid_commands(CLI::App& app);
Command grid_solve_command(CLI::App& grid);
Command grid_compare_command(CLI::App& grid);
Command grid_heuristics_command(CLI::App& grid);
Command grid_scenario_command(CLI::App& grid);
Command grid_generate_command(CLI::App& grid);
Command diff_command(CLI::App& app);
/// The group `mouse`: run, compare, check, serve, speed.
std::vector<Command> mouse_commands(CLI::App& app);

/// `taut chase` and, before it, what is below it: of those that were parsed the first is meant.
std::vector<Command> chase_commands(CLI::App& app);
Command chase_compare_command(CLI::App& chase);
Command chase_generate_command(CLI::App& chase);
/// Likewise `taut bug`.
std::vector<Command> bug_commands(CLI::App& app);
Command drive_command(CLI::App& app);

/// Adds a subcommand whose options live as long as the parser: `add` fills the parser, `run` does the work, both with
/// the same Options, which has a member `common`.
template <typename Options>
Command command(CLI::App& app, const char* name, const char* description, void (*add)(CLI::App&, Options&),
                int (*run)(const Options&)) {
  auto options = std::make_shared<Options>();
  CLI::App* sub = app.add_subcommand(name, description);
  add(*sub, *options);
  add_common_options(*sub, options->common);
  return {sub, std::shared_ptr<CommonOptions>(options, &options->common), [options, run] { return run(*options); }};
}

/// A subcommand that only holds others, as `taut grid` holds `solve`: one of them has to follow.
inline CLI::App& command_group(CLI::App& app, const char* name, const char* description) {
  CLI::App* group = app.add_subcommand(name, description);
  group->require_subcommand(1);
  return *group;
}

}  // namespace taut::cli
