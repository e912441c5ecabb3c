// The subcommands.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <taut/cli/command_line.h>
#include <taut/cli/config_file.h>
#include <taut/cli/options.h>

namespace taut::cli {

class Run;

/// A subcommand that was added to the program. `run` does its work after the command line was read and gives the exit
/// code; it throws InputError, WriteError or std::bad_alloc where that is what happened.
struct Command {
  std::shared_ptr<CommandLine> line;
  std::shared_ptr<CommonOptions> common;
  std::function<int(Run&)> run;
  Places places{};  ///< of the options that a file brought
};

Command solve_command(CommandLine& app);
Command check_command(CommandLine& app);
Command verify_command(CommandLine& app);
Command audit_command(CommandLine& app);
Command roadmap_command(CommandLine& app);
Command compare_command(CommandLine& app);
Command passage_command(CommandLine& app);
Command reach_command(CommandLine& app);
Command generate_command(CommandLine& app);
Command convert_command(CommandLine& app);
Command view_command(CommandLine& app);
Command space_command(CommandLine& app);
Command batch_command(CommandLine& app);
Command matrix_command(CommandLine& app);
/// The group `grid`.
std::vector<Command> grid_commands(CommandLine& app);
Command grid_solve_command(CommandLine& grid);
Command grid_compare_command(CommandLine& grid);
Command grid_heuristics_command(CommandLine& grid);
Command grid_scenario_command(CommandLine& grid);
Command grid_generate_command(CommandLine& grid);
Command diff_command(CommandLine& app);
/// The group `mouse`: run, compare, check, serve, speed.
std::vector<Command> mouse_commands(CommandLine& app);

/// `taut chase` and, before it, what is below it: of those that were parsed the first is meant.
std::vector<Command> chase_commands(CommandLine& app);
Command chase_compare_command(CommandLine& chase);
Command chase_generate_command(CommandLine& chase);
Command chase_plane_command(CommandLine& chase);
/// Likewise `taut bug`.
std::vector<Command> bug_commands(CommandLine& app);
Command drive_command(CommandLine& app);

/// Adds a subcommand whose options live as long as the program: `add` fills the parser, `run` does the work, both with
/// the same Options, which has a member `common`.
template <typename Options>
Command command(CommandLine& app, const char* name, const char* description, void (*add)(CommandLine&, Options&),
                int (*run)(const Options&, Run&)) {
  auto options = std::make_shared<Options>();
  auto line = std::make_shared<CommandLine>(app.add_subcommand(name, description));
  add(*line, *options);
  add_result_options(*line, options->common);
  add_common_options(*line, options->common);
  add_config_option(*line);
  return {line,
          std::shared_ptr<CommonOptions>(options, &options->common),
          [options, run](Run& how) { return run(*options, how); },
          {}};
}

/// A subcommand that only holds others, as `taut grid` holds `solve`: one of them has to follow.
CommandLine command_group(CommandLine& app, const char* name, const char* description);

}  // namespace taut::cli
