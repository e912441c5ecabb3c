// The lengths a search has found so far, each with the chain it is the length of.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include <taut/geometry/exact/twofold.h>
#include <taut/geometry/length.h>
#include <taut/roadmaps/roadmap.h>

namespace taut::detail {

/// Every label ever given, in order. A label is never changed: a shorter way to a vertex is a new label. So a label's
/// chain of parents is the very chain whose length its interval encloses, whatever is found later, and lengths can be
/// compared exactly at any time. Parents are older than their children, so the last common ancestor of two labels is
/// found by climbing from the younger one. Ways of equal length are kept as ties: on a lattice they lead to a common
/// ancestor two legs away where the parents alone would lead far back.
/// 32 bytes a label, 8 a tie.
class Labels {
 public:
  using Vertex = Roadmap::Vertex;
  using Id = std::uint32_t;
  static constexpr Id kNone = 0;
  static constexpr Id kStart = 1;

  struct Label {
    double lo = 0;
    double hi = 0;
    Id parent = kNone;
    Vertex vertex = 0;
    std::uint32_t ties = 0;  ///< the last one found, 0 for none
  };

  /// A chain not yet labelled: that of `label` and a leg on to `end`.
  struct Chain {
    Id label = kNone;
    Point end;
  };

  /// Vertices: those of the roadmap, then the start, then the goals.
  Labels(const Roadmap& roadmap, Point start, std::vector<Point> goals);

  const Label& operator[](Id id) const { return labels_[id]; }
  Point point(Vertex v) const {
    return v < roadmap_->vertex_count() ? roadmap_->point(v) : ends_[v - roadmap_->vertex_count()];
  }
  Chain chain(Id id) const { return {labels_[id].parent, point(labels_[id].vertex)}; }

  /// A new label for v, through `parent`. Precondition: it is shorter than `former`, if there is one; then its lower
  /// and upper bound are not greater than that one's.
  Id extend(Id parent, Vertex v, Id former);

  /// Is the way through `parent` straight to v shorter than the label `than` of v? Exact. Remembers a tie.
  bool is_shorter(Id parent, Vertex v, Id than) {
    return !clearly_not_shorter(parent, v, than) && is_shorter_exactly(parent, v, than);
  }

  /// Exact. Precondition: neither is the start's.
  std::strong_ordering compare(Chain a, Chain b) const;

  /// From the start on; consecutive equal points are merged.
  std::vector<Point> points(Chain chain) const;

 private:
  /// Through `parent` it is exactly as far as through the label's own; `next` is another tie of the same label, 0 for
  /// none.
  struct Tie {
    Id parent = kNone;
    std::uint32_t next = 0;
  };

  /// Without a root: is the leg at least as long as what is left for it?
  bool clearly_not_shorter(Id parent, Vertex v, Id than) const {
    const double left = labels_[than].hi - labels_[parent].lo;
    if (left <= 0) return true;
    const Point p = point(labels_[parent].vertex), q = point(v);
    const double dx = p.x - q.x, dy = p.y - q.y, square = dx * dx + dy * dy;
    // Both sides together are off by less than 16 roundings.
    return square > left * left * (1 + 0x1p-48) && square > 1e-280 && square < 1e280;
  }
  bool is_shorter_exactly(Id parent, Vertex v, Id than);
  std::strong_ordering compare_legs(Chain a, Chain b) const;
  Id common_parent(Id a, Id b) const;
  std::span<const Id> parents(Id id, std::span<Id> room) const;
  Interval enclose(Chain chain) const;

  const Roadmap* roadmap_;
  std::vector<Point> ends_;
  std::vector<Label> labels_;
  std::vector<Tie> ties_;
};

}  // namespace taut::detail
