// A PRM that can still grow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <taut/geometry/box_index.h>
#include <taut/roadmaps/prm.h>
#include <taut/roadmaps/prm_clear.h>
#include <taut/roadmaps/prm_nearest.h>
#include <taut/roadmaps/prm_samples.h>

namespace taut {

/// Which vertices hang together, while edges come in (union by size, path halving).
class PrmParts {
 public:
  void add(std::size_t vertices);
  std::uint32_t part(std::uint32_t v);
  void join(std::uint32_t u, std::uint32_t v);
  std::size_t count() const { return count_; }

 private:
  std::vector<std::uint32_t> parent_, size_;
  std::size_t count_ = 0;
};

/// An edge of a PRM: tested, or only a candidate.
struct PrmEdge {
  enum class State : std::uint8_t { untested, free, blocked };
  Roadmap::Vertex u = 0, v = 0;  // u < v
  State state = State::untested;
};

/// Vertices and edges of a PRM, grown by batches: all samples of a batch are placed, then each new vertex is joined to
/// its neighbours among all vertices by the connection rule. One batch of all samples is the PRM of the textbook.
class PrmGrowth {
 public:
  /// Lazy: edges are not tested as they come. Rules visible and forest, which cannot do without, are then
  /// Rule::nearest.
  PrmGrowth(const FreeSpace& space, const PrmOptions& options, bool lazy = false);
  PrmGrowth(const PrmGrowth&) = delete;  // the samples refer to the clear test
  PrmGrowth& operator=(const PrmGrowth&) = delete;

  const PrmClear& clear() const { return clear_; }
  std::size_t default_count() const { return samples_.default_count(); }
  void add(std::size_t draws);
  /// Draws as many, of which only those in one of the boxes may become vertices.
  void add_in(const BoxIndex& boxes, std::size_t draws);

  struct Size {
    std::size_t vertices, edges;
  };
  Size size() const { return {points_.size(), edges_.size()}; }
  /// Forgets all that was added since it had that size, though it was drawn. Nothing can be added after that, and
  /// parts() are as before.
  void take_back(const Size& size);

  const std::vector<Point>& points() const { return points_; }
  const std::vector<PrmEdge>& edges() const { return edges_; }
  /// Tests an edge unless it has been; is it free?
  bool test(PrmEdge& edge);
  bool test(std::size_t edge) { return test(edges_[edge]); }

  /// Parts by the edges known to be free, or in lazy growth by all candidates that were ever there.
  PrmParts& parts() { return parts_; }
  PrmCounts counts() const;
  /// Of the free edges; with `untested` also of those nobody has looked at.
  Roadmap roadmap(bool untested = false) const;

 private:
  std::vector<Roadmap::Vertex> candidates(Roadmap::Vertex v) const;
  template <class Wanted>
  void draw(std::size_t draws, Wanted&& wanted);
  void connect(Roadmap::Vertex first);
  void connect_visible(Roadmap::Vertex first);
  void connect_forest(Roadmap::Vertex first);

  PrmClear clear_;
  PrmSamples samples_;
  PrmConnection connection_;
  bool lazy_;
  PrmNearest nearest_;
  PrmParts parts_;
  std::vector<Point> points_;
  std::vector<Location> places_;  // of points_
  std::vector<PrmEdge> edges_;    // eager: the free ones only
  std::size_t drawn_ = 0, tested_ = 0;
};

/// As nearest_visible(), among the points of an index.
std::vector<Roadmap::Vertex> nearest_visible(const PrmClear& clear, const PrmNearest& index,
                                             const std::vector<Point>& points, Point p, std::size_t count);

}  // namespace taut
