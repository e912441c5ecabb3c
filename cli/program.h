// The whole command line: all subcommands, and which of them is asked for.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <taut/cli/command.h>

namespace taut::cli {

/// What somebody wants: a subcommand to be run, or a text to be printed, as --help.
struct Asked {
  const Command* command = nullptr;
  std::string text{};
};

class Program {
 public:
  Program();
  ~Program();

  /// `words` without the program's own name. Once only: the subcommands' options take their values. Throws UsageError,
  /// in one line that says where help is; InputError of --config's file. No other file is touched.
  Asked parse(std::vector<std::string> words);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// What only a subcommand's work could find out: the words, and where help is.
UsageError wrong_usage(const Command& command, const std::string& why);

}  // namespace taut::cli
