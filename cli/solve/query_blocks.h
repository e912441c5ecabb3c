// The queries of `taut batch`, a block at a time.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <taut/cli/input.h>
#include <taut/cli/solve/query_source.h>
#include <taut/cli/solve/wall_lines.h>
#include <taut/cli/world/geographic.h>
#include <taut/io/worlds/query_lines.h>

namespace taut::cli {

/// Reads as many queries as there are without waiting, up to a block: small ones first, so that answers begin, then
/// larger ones, that threads have enough to share. What is made of them must not depend on where blocks end.
class QueryBlocks {
 public:
  QueryBlocks(QuerySource& source, const Input& input, const Shown& shown, unsigned jobs)
      : source_(source), input_(input), shown_(shown), reader_(source.name()), length_(std::size_t{8} * jobs) {}

  /// Appends them, up to a line that changes the world; false where no more are to come. Throws InputError for a line
  /// that is wrong, after those before it.
  bool next(std::vector<QueryLine>& block);
  /// The line that changes the world, after what was read last.
  const std::optional<WallLine>& wall() const { return wall_; }
  int line() const { return line_; }  ///< the number of the last line read

 private:
  void require_for_this_map(const QueryLine& query) const;

  QuerySource& source_;
  const Input& input_;
  const Shown& shown_;
  QueryReader reader_;
  std::optional<WallLine> wall_;
  std::size_t length_;
  int line_ = 0;
};

}  // namespace taut::cli
