// Where the queries of `taut batch` come from.
#pragma once

#include <cstddef>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

namespace taut::cli {

/// Lines of a file or of standard input, unpacked where they are gzipped, each as soon as it is there.
class QuerySource {
 public:
  /// `-` is standard input. Throws InputError.
  explicit QuerySource(const std::string& path);

  const std::string& name() const { return name_; }
  /// Throws InputError where it cannot be read.
  bool next(std::string& line);
  /// How many lines are to come; 0 where nobody knows, as of a pipe.
  std::size_t line_count();
  /// Is there no whole line yet, so that the next one has to be waited for? Never in a file that is all there.
  bool may_wait() const { return !is_all_there_ && in_->rdbuf()->in_avail() <= 0; }

 private:
  void unpack();

  std::string name_;
  std::ifstream file_;
  std::istringstream unpacked_;
  std::istream* in_ = &std::cin;
  bool is_all_there_ = false;
};

}  // namespace taut::cli
