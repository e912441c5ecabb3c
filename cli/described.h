// What the command line takes, as data: for manual pages and for shells that complete words.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace taut::cli {

/// An option or operand of a subcommand.
struct DescribedOption {
  std::vector<std::string> names{};  ///< `--quiet`, `-q`; of an operand `FILE`
  std::string value{};               ///< what stands for its value, `X,Y`; empty for a flag and an operand
  std::string what{};
  std::string group{};                                         ///< `World`
  std::vector<std::pair<std::string, std::string>> choices{};  ///< names that it takes, and what they mean; maybe empty
  bool is_operand = false;
  bool is_required = false;

  bool is_file() const { return value == "FILE" || value == "[FILE]" || value == "FOLDER"; }
};

/// A subcommand, and what is below it; the program itself is the root.
struct DescribedCommand {
  std::string name{};  ///< `taut grid solve`
  std::string what{};
  std::string usage{};  ///< the line of --help without `Usage: `
  std::vector<DescribedOption> options{};
  std::string footer{};  ///< what stands below the options in --help
  std::vector<DescribedCommand> below{};

  bool needs_below() const { return usage.ends_with(" SUBCOMMAND"); }
};

/// A page for `man`, in roff: of one subcommand, or of the program with a list of all.
std::string manual_page(const DescribedCommand& command, const std::string& version);

/// Shells that complete: `bash`, `zsh`, `fish`. A script that is sourced, or put where the shell looks for such.
bool is_shell(const std::string& name);
/// Precondition: is_shell(shell).
std::string completion_script(const DescribedCommand& program, const std::string& shell);

}  // namespace taut::cli
