// Places and edges by boxes of them, a kd-tree.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include <taut/verify/place.h>

namespace taut::proof {

template <class Item>  // with a box()
class Tree {
 public:
  std::vector<Item> items;

  Tree() = default;
  explicit Tree(std::vector<Item> all) : items(std::move(all)), boxes_(4 * items.size()) { build(0, items); }

  /// The first that is wanted, what is near p first; of boxes that are settled none is.
  template <class Settled, class Wanted>
  const Item* find(Place p, Settled settled, Wanted wanted) const {
    return find(p, settled, wanted, 0, items);
  }

  const Box& box() const { return boxes_[0]; }

 private:
  void build(std::size_t at, std::span<Item> run) {
    Box& all = boxes_[at] = run[0].box();
    for (const Item& i : run) {
      const Box b = i.box();
      all = {least(all.min, b.min), most(all.max, b.max), std::min(all.low, b.low), std::max(all.high, b.high)};
    }
    if (run.size() == 1) return;
    const bool wide = all.max.x - all.min.x > all.max.y - all.min.y;
    const std::size_t half = run.size() / 2;
    const auto key = [wide](const Item& i) { return wide ? i.box().min : Place{i.box().min.y, i.box().min.x}; };
    std::ranges::nth_element(run, run.begin() + static_cast<std::ptrdiff_t>(half), {}, key);
    build(2 * at + 1, run.first(half)), build(2 * at + 2, run.subspan(half));
  }

  template <class Settled, class Wanted>
  const Item* find(Place p, Settled& settled, Wanted& wanted, std::size_t at, std::span<const Item> run) const {
    if (settled(boxes_[at])) return nullptr;
    if (run.size() == 1) return wanted(run[0]) ? &run[0] : nullptr;
    const auto away = [&](const Box& b) { return (b.min - p) - (p - b.max); };
    const Place d = away(boxes_[2 * at + 1]), e = away(boxes_[2 * at + 2]);
    const std::size_t nearer = dot(e, e) < dot(d, d) ? 1 : 0, half = run.size() / 2;
    for (const std::size_t i : {nearer, 1 - nearer})
      if (auto* found = find(p, settled, wanted, 2 * at + 1 + i, i == 0 ? run.first(half) : run.subspan(half)))
        return found;
    return nullptr;
  }

  std::vector<Box> boxes_;
};

}  // namespace taut::proof
