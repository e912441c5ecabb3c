// Queries in a hierarchy of a disc's ways. Private.
#pragma once

#include <taut/search/detail/arc_core.h>

namespace taut::detail {

/// A shortest way between two sets of nodes, in the same memory for query after query.
class ArcHierarchyQuery {
 public:
  explicit ArcHierarchyQuery(const ArcHierarchy& hierarchy)
      : hierarchy_(hierarchy), core_(hierarchy), core_labels_(core_.size()) {
    forth_.labels.resize(hierarchy.size());
    back_.labels.resize(hierarchy.size());
  }

  struct Way {
    double length = std::numeric_limits<double>::infinity();
    std::uint32_t entry = 0, exit = 0;  ///< numbers of the doors
    std::vector<std::uint32_t> nodes;   ///< from the entry's to the exit's; none when there is no way
    std::size_t settled = 0;
  };
  Way find(std::span<const ArcDoor> entries, std::span<const ArcDoor> exits);

 private:
  struct Label {
    double length;
    std::uint32_t before;  // a node, or a door's number
    std::uint32_t edge;    // of before's; kNone: a door, or where the core is entered
    std::uint32_t query = 0;
  };
  struct Open {
    double least;  // of a way through the node, as far as it is known
    double length;
    std::uint32_t node;
    bool operator<(const Open& other) const { return least != other.least ? least > other.least : node > other.node; }
  };
  /// From the start, or turned from the goal.
  struct Side {
    std::vector<Label> labels;
    std::vector<Open> open;
    std::vector<std::uint32_t> core;  // nodes of it that the climb came to
  };

  bool is_nearer(Side& side, std::uint32_t n, double length, std::uint32_t before, std::uint32_t edge);
  void reach(Side& side, std::uint32_t n, double length, std::uint32_t before, std::uint32_t edge);
  static Open next_of(Side& side);
  void climb(Way& way);
  void settle(Side& side, const Side& other, Way& way);
  void cross_core(Way& way);
  void enter_core(std::uint32_t i, double length, std::uint32_t before, std::uint32_t edge);
  /// The nodes from a door's on to n; the door's number.
  std::uint32_t trace(const Side& side, std::uint32_t n, std::vector<std::uint32_t>& nodes) const;
  /// The same of a way that crosses the core.
  std::uint32_t trace_core(std::uint32_t i, std::vector<std::uint32_t>& nodes) const;

  const ArcHierarchy& hierarchy_;
  ArcCore core_;
  Side forth_, back_;
  std::vector<Label> core_labels_;  // by number; from the start
  std::vector<ArcDoor> exits_;      // of the core
  std::uint32_t query_ = 0, meeting_ = 0;
  std::uint32_t crossed_ = kNone;  // the meeting place's number, when the way crosses the core
};

}  // namespace taut::detail
