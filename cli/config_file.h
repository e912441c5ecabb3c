// Options from a file.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}  // namespace CLI

namespace taut::cli {

class CommandLine;

/// `--config FILE` in --help; with_config_file() takes it out of the command line before that is read.
void add_config_option(CommandLine& app);

/// The words of a command line, those of `--config FILE` (after the subcommand) replaced by the options of that file.
///
/// The file is TOML or INI: `samples = 500`, `lazy = true`, `planners = "prm,voronoi"`, named as the options are,
/// without dashes. What stands before the first section is for every subcommand that has such an option; `[solve]` and
/// `[grid.solve]` are for those alone, which must have it. What the command line itself says wins. Without `--config`
/// the words as they are.
///
/// Throws UsageError that names the file and the option, and InputError when the file cannot be read.
std::vector<std::string> with_config_file(const CLI::App& program, std::vector<std::string> words);

}  // namespace taut::cli
