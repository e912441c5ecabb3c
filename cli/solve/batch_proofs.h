// --certificate of `taut batch`: a proof of every answer, in one file.
#pragma once

#include <optional>
#include <string>

#include <taut/geometry/free_space.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/path.h>

namespace taut::cli {

/// Certificates about one world, one a query.
class BatchProofs {
 public:
  /// Of a point's or a square's space. Throws InputError where the world's numbers allow none.
  explicit BatchProofs(const FreeSpace& space);

  /// Of the query in that line: the path found, or that there is none.
  void add(int line, const std::optional<Path>& path, Point from, Point to);

  std::size_t missing() const { return missing_; }  ///< queries of which nothing could be proven
  std::string text() const;                         ///< a JSON list, each with its `line`

 private:
  FreeSpace plain_;
  VisibilityGraph graph_;
  std::string world_, proofs_;
  std::size_t missing_ = 0;
};

}  // namespace taut::cli
