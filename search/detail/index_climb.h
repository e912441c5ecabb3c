// From one end of a query up to the core of bends that have labels.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <taut/geometry/length.h>
#include <taut/search/detail/index_parts.h>

namespace taut::detail {

/// One climb after the other in the same memory: Dijkstra's algorithm along up-edges where a string turns so.
///
/// Lengths are doubles. Ways to a bend that doubles do not tell apart are all remembered, and compared by their roots
/// when the bend lies on a way that may be the shortest (chain); until then any of them may go on.
class IndexClimb {
 public:
  explicit IndexClimb(const IndexParts& parts)
      : parts_(parts), nodes_(parts.image.has_core() ? parts.bends.size() : 0) {}

  /// Labels that may follow.
  struct Range {
    std::uint32_t begin, end;
  };

  void begin(Point end, const IntegerPlaces::Place* place);
  /// A bend that the end sees, `arriving` being TurnBits.
  void add(std::uint32_t bend, std::uint32_t arriving, double length);
  /// Afterwards the questions below.
  void run();

  /// Bends that shortest paths may pass, by length.
  const std::vector<std::uint32_t>& reached() const { return reached_; }
  bool is_reached(std::uint32_t bend) const { return is_known(bend) && nodes_[bend].is_reached; }
  double length(std::uint32_t bend) const { return nodes_[bend].length; }
  /// Precondition: the bend is in the core and reached.
  Range labels_behind(std::uint32_t bend) const;

  /// The bends on the shortest way to one that is reached, from the end on, it included.
  void chain(std::uint32_t bend, std::vector<std::uint32_t>& bends);

 private:
  struct Node {
    double length = 0;
    std::uint32_t query = 0;
    std::uint32_t before = kNone;  // kNone: the end itself
    std::uint32_t edge = kNone;
    std::uint32_t arriving = 0;
    bool is_settled = false, is_reached = false, has_ties = false;
  };
  struct Tie {
    std::uint32_t bend, before, edge;
    double length;
  };

  bool is_known(std::uint32_t bend) const { return nodes_[bend].query == query_; }
  bool is_stalled(std::uint32_t bend) const;
  void follow(std::uint32_t bend);
  bool may_follow(std::uint32_t bend, const IndexImage::Edge& edge) const;
  bool is_taut(std::uint32_t bend, std::uint32_t via, std::uint32_t arriving, const IndexImage::Edge& edge) const;
  int side(std::uint32_t from, std::uint32_t at, std::uint32_t to) const;
  std::uint32_t hop_of(std::uint32_t edge) const {
    return edge == kNone ? kNone : parts_.image.ups()[edge].last_hop / 4;
  }
  void reach(std::uint32_t bend, double length, std::uint32_t before, std::uint32_t edge, std::uint32_t arriving);
  void settle_ties(std::uint32_t bend);
  void legs(std::uint32_t bend, std::uint32_t before, std::uint32_t edge, std::vector<Segment>& out);

  const IndexParts& parts_;
  Point end_;
  IntegerPlaces::Place place_{};
  bool is_integer_ = false;
  std::uint32_t query_ = 0;
  std::vector<Node> nodes_;  // by bend
  std::vector<Tie> ties_;
  std::vector<std::uint32_t> reached_;
  std::vector<std::pair<double, std::uint32_t>> open_;
  std::vector<std::uint32_t> steps_;
};

/// Appends the bends of an edge behind its first one; of one that is passed the other way (`back`) those behind `to`.
void unpack_edge(const IndexImage& image, const IndexImage::Edge& edge, bool back, std::vector<std::uint32_t>& bends);

}  // namespace taut::detail
