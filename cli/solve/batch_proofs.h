// --certificate of `taut batch`: a proof of every answer, in one file.
#pragma once

#include <optional>
#include <string>

#include <taut/geometry/free_space.h>
#include <taut/io/results/arc_proof.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/arc_certificate.h>
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

/// Certificates of discs of any radius among one world's walls, one a query.
class DiscProofs {
 public:
  explicit DiscProofs(const World& world) : world_(world) {}

  void add_arcs(int line, const ArcPath& path);
  /// That no disc of that radius gets through, the world's limits being walls.
  void add_none(int line, Point from, Point to, double radius);

  std::size_t missing() const { return missing_; }
  std::string text() const;

 private:
  void add(int line, const std::string& text);

  const World& world_;
  std::optional<ArcProver> prover_;  // of the radius asked about last
  std::optional<ArcTexts> texts_;
  double radius_ = 0;
  std::string proofs_;
  std::size_t missing_ = 0;
};

}  // namespace taut::cli
