// Options from a file.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace CLI {
class App;
}  // namespace CLI

namespace taut::cli {

class CommandLine;
struct DescribedCommand;

/// Where options that a file brought stand there: `--samples` in `taut.toml:3`.
using Places = std::map<std::string, std::string>;

/// A command line with what a file brought.
struct Words {
  std::vector<std::string> words{};
  Places places{};
};

/// `--config FILE` in --help; with_config_file() takes it out of the command line before that is read.
void add_config_option(CommandLine& app);

/// The words of a command line, those of `--config FILE` (after the subcommand) replaced by the options of that file.
///
/// The file is as settings_of() says, `samples = 500`, `lazy = true`, `planners = "prm,voronoi"`, named as the options
/// are, without dashes. What stands before the first section is for every subcommand that has such an option; `[solve]`
/// and `[grid.solve]` are for those alone, and overrule it. What the command line itself says wins. Without `--config`
/// the words as they are.
///
/// Throws UsageError, which names file, line and culprit, of a section that is no subcommand, of a name that the
/// section's subcommand does not have, or none where there is no section, and of a flag that is neither true nor false;
/// and InputError when the file cannot be read. `all` gives all subcommands, below the program.
Words with_config_file(const CLI::App& program, std::vector<std::string> words,
                       const std::function<DescribedCommand()>& all);

/// A complaint with the place of the option that it is about before it, where it is one of those.
std::string with_place(const std::string& complaint, const Places& places);

}  // namespace taut::cli
