// A priority queue whose entries can be found again.
#pragma once

#include <cstdint>
#include <vector>

namespace taut {

/// A binary heap of nodes 0, 1, ..., the least priority on top, that keeps in each node where it is: `nodes[i].place`,
/// kNowhere outside. So a priority can change and a node be taken out. `Nodes` is an array of such; the same one is
/// passed to every call. Each is O(log size); among equal priorities the order depends on the calls alone.
template <class Priority>
class IndexedHeap {
 public:
  using Index = std::uint32_t;
  static constexpr Index kNowhere = 0xffffffff;

  struct Entry {
    Priority priority;
    Index node;
    friend bool operator<(const Entry& a, const Entry& b) { return a.priority < b.priority; }
  };

  bool empty() const { return entries_.empty(); }
  /// Precondition: not empty.
  const Entry& top() const { return entries_[0]; }
  /// Precondition: every place is, or will be, kNowhere.
  void clear() { entries_.clear(); }

  /// Into the heap, or to another priority in it.
  template <class Nodes>
  void set(Nodes& nodes, Index node, const Priority& priority) {
    const Entry entry{priority, node};
    Index& place = nodes[node].place;
    if (place == kNowhere) {
      place = static_cast<Index>(entries_.size());
      entries_.push_back(entry);
    }
    if (place > 0 && entry < entries_[(place - 1) / 2])
      rise(nodes, place, entry);
    else
      sink(nodes, place, entry);
  }

  /// Precondition: it is in the heap.
  template <class Nodes>
  void remove(Nodes& nodes, Index node) {
    const Index hole = nodes[node].place;
    const Entry last = entries_.back();
    nodes[node].place = kNowhere;
    entries_.pop_back();
    if (last.node == node) return;
    // The last is seldom small: down to the bottom, without looking at it, and up again.
    rise(nodes, sink_hole(nodes, hole), last);
  }

 private:
  template <class Nodes>
  void put(Nodes& nodes, Index place, const Entry& entry) {
    entries_[place] = entry;
    nodes[entry.node].place = place;
  }

  template <class Nodes>
  void rise(Nodes& nodes, Index place, const Entry& entry) {
    for (; place > 0 && entry < entries_[(place - 1) / 2]; place = (place - 1) / 2)
      put(nodes, place, entries_[(place - 1) / 2]);
    put(nodes, place, entry);
  }

  template <class Nodes>
  Index sink_hole(Nodes& nodes, Index place) {
    const auto size = static_cast<Index>(entries_.size());
    for (Index child = 2 * place + 1; child < size; child = 2 * place + 1) {
      if (child + 1 < size) child += entries_[child + 1] < entries_[child];
      put(nodes, place, entries_[child]);
      place = child;
    }
    return place;
  }

  template <class Nodes>
  void sink(Nodes& nodes, Index place, const Entry& entry) {
    const auto size = static_cast<Index>(entries_.size());
    for (Index child = 2 * place + 1; child < size; child = 2 * place + 1) {
      if (child + 1 < size) child += entries_[child + 1] < entries_[child];
      if (!(entries_[child] < entry)) break;
      put(nodes, place, entries_[child]);
      place = child;
    }
    put(nodes, place, entry);
  }

  std::vector<Entry> entries_;
};

}  // namespace taut
