// The lines that go to a robot and come from it, wherever it runs.
#pragma once

#include <memory>
#include <string>

namespace taut::cli {

/// All of it may throw InputError that names the robot and the line: it is no longer there, does not answer in time, or
/// writes a line longer than 1000 bytes.
class RobotLines {
 public:
  RobotLines() = default;
  RobotLines(const RobotLines&) = delete;
  RobotLines& operator=(const RobotLines&) = delete;
  virtual ~RobotLines() = default;

  /// The next line, read as it comes; false at the end.
  bool next(std::string& line);
  virtual void say(const std::string& text) = 0;
  int number() const { return number_; }  ///< of the line that next() gave last, from 1
  virtual std::string name() const = 0;

  /// Throws InputError with the robot's name and its line.
  [[noreturn]] void refuse(const std::string& why) const;

  /// How it ended, in words, after next() was false: `ends`, `ended with exit code 1`.
  virtual std::string ended() = 0;
  /// The trial is over: says that, if anything, and lets it go.
  virtual void close(const std::string& last) = 0;

 protected:
  /// Adds what has come to `buffer`; false at the end.
  virtual bool more(std::string& buffer) = 0;

 private:
  std::string buffer_;
  int number_ = 0;
};

/// Standard input and output. close() leaves the last line to whoever prints.
std::unique_ptr<RobotLines> standard_lines();

/// A command of the shell, started now; its standard error is this program's.
///  1. It has `seconds` for each line. say() does not wait for one that does not read.
///  2. Nothing of it is left: it and what it started (its process group) are ended and waited for when this goes, after
///     close() half a second later at the latest; when this program is stopped or dies they are killed.
std::unique_ptr<RobotLines> program_lines(const std::string& command, double seconds);

}  // namespace taut::cli
