// Places and edges by boxes of them, a kd-tree.
#pragma once

#include <algorithm>
#include <bit>
#include <span>
#include <vector>

#include <taut/verify/place.h>

namespace taut::proof {

template <class Item>  // with a box()
class Tree {
 public:
  std::vector<Item> items;

  Tree() = default;
  explicit Tree(std::vector<Item> all) : items(all.size()), boxes_(2 * all.size()) { build(1, all); }

  /// The first that is wanted, what is near p first; of boxes that are settled none is.
  template <class Settled, class Wanted>
  const Item* find(Place p, const Settled& settled, const Wanted& wanted, std::size_t at = 1) const {
    if (settled(boxes_[at])) return nullptr;
    if (at >= items.size()) return wanted(items[at - items.size()]) ? &items[at - items.size()] : nullptr;
    const std::size_t nearer = 2 * at + (boxes_[2 * at + 1].middle(p) < boxes_[2 * at].middle(p));
    const Item* const found = find(p, settled, wanted, nearer);
    return found ? found : find(p, settled, wanted, nearer ^ 1);
  }

  const Box& box() const { return boxes_[1]; }

 private:
  // As a heap, whose last items.size() boxes are those of the items.
  void build(std::size_t at, std::span<Item> run) {
    Box& all = boxes_[at] = run[0].box();
    for (const Item& i : run) {
      const Box b = i.box();
      all = {least(all.min, b.min), most(all.max, b.max), std::min(all.low, b.low), std::max(all.high, b.high)};
    }
    if (run.size() == 1) return void(items[at - items.size()] = run[0]);
    const bool wide = all.max.x - all.min.x > all.max.y - all.min.y;
    const std::size_t floor = std::bit_floor(run.size()), left = std::min(floor, run.size() - floor / 2);
    const auto key = [wide](const Item& i) { return wide ? i.box().min : Place{i.box().min.y, i.box().min.x}; };
    std::ranges::nth_element(run, run.begin() + static_cast<std::ptrdiff_t>(left), {}, key);
    build(2 * at, run.first(left)), build(2 * at + 1, run.subspan(left));
  }

  std::vector<Box> boxes_;
};

}  // namespace taut::proof
