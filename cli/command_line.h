// What stands on the command line: the one place that knows the library that reads it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <taut/cli/described.h>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace taut::cli {

/// The command line makes no sense: exit code 2. what() names the option and the culprit, in one line.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One name that an option takes, and what it means.
using Choice = std::pair<std::string_view, std::string_view>;

/// An option that was added, to be said more of. Cheap to copy; lives as long as its CommandLine.
class Option {
 public:
  /// Another option in the place of its value is a UsageError: `--json --stats`.
  Option(CLI::App& app, CLI::Option& option);

  Option type_name(const char* name) const;  ///< what stands for the value in --help: `X,Y`
  Option group(const std::string& name) const;
  Option required(bool is = true) const;
  Option excludes(const char* other) const;  ///< an option added before
  Option values(int least, int most) const;  ///< how many follow; 0: it may stand alone
  /// Of numbers: anything else is a UsageError that says so.
  Option range(double least, double most) const;

 private:
  CLI::App* app_;
  CLI::Option* option_;
};

/// The options and operands of one subcommand. What is added takes its value when the command line is read; a value
/// that cannot be is a UsageError which names the option. The variables must outlive that.
class CommandLine {
 public:
  using Take = std::function<void(const std::string&)>;

  explicit CommandLine(CLI::App& app) : app_(&app) {}

  /// `names` as `--quiet,-q`, or a word in capitals: an operand. `take` may throw UsageError; where its words do not
  /// begin with the option's name, that is put before them.
  Option add_option_function(const std::string& names, Take take, const std::string& what);
  /// One that may be given several times, or with several values: `take` gets each.
  Option add_each_function(const std::string& names, Take take, const std::string& what);
  Option add_option(const std::string& names, std::string& value, const std::string& what);
  Option add_option(const std::string& names, std::vector<std::string>& values, const std::string& what);
  Option add_option(const std::string& names, int& value, const std::string& what);
  Option add_option(const std::string& names, std::optional<int>& value, const std::string& what);
  Option add_option(const std::string& names, std::size_t& value, const std::string& what);
  Option add_flag(const std::string& names, bool& value, const std::string& what);
  Option add_flag_callback(const std::string& names, std::function<void()> work, const std::string& what);

  /// An option that went: whoever gives it is told the new name. It is not in --help.
  void renamed(const std::string& old_name, const std::string& new_name);

  /// Called when all is read, in the order in which these were added. May throw UsageError.
  void callback(std::function<void()> work);
  /// Below the options in --help.
  void footer(const std::string& text);
  /// A line at the end of --help that can be typed: `taut solve maze.txt --svg maze.svg`.
  void example(const std::string& line);
  /// A paragraph of --help: a line for each name.
  void explain(const std::string& title, const std::vector<Choice>& choices);

  /// The options that were given, without operands and these, each with its values, in an order of their own:
  /// `--robot disc:0.2;--seed 7;`.
  std::string given_except(const std::vector<std::string>& names) const;
  std::size_t count(const std::string& name) const;
  bool has_subcommand() const;  ///< did one follow?
  void optional_subcommand();
  /// One has to follow.
  void require_subcommand();
  CommandLine add_subcommand(const char* name, const char* description);
  bool is_chosen() const;  ///< was it on the command line?

  std::string full_name() const;  ///< `taut grid solve`
  /// All that --help says, and of what is below; hidden options are left out.
  DescribedCommand described() const;
  CLI::App& app() const { return *app_; }

 private:
  CLI::App* app_;
  std::string paragraphs_;
  std::string examples_;
  std::vector<std::function<void()>> checks_;
};

}  // namespace taut::cli
