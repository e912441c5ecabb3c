#include <taut/search/detail/hub_labels.h>

#include <limits>
#include <utility>

#include <taut/geometry/length.h>

namespace taut::detail {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr double kMargin = 1e-12;

class Labeller {
 public:
  Labeller(const HubGraph& graph, HubTree& tree, const SightLists* sights, std::vector<std::uint32_t> order)
      : graph_(graph), tree_(tree), sights_(sights), at_root_(graph.size(), kFar), label_of_(graph.size(), kNone) {
    made_.vertices = std::move(order);
    made_.hub_of.resize(graph.size());
    for (std::uint32_t h = 0; h < graph.size(); ++h) made_.hub_of[made_.vertices[h]] = h;
    made_.labels.resize(graph.size());
    made_.rests.resize(graph.size());
  }

  std::optional<HubLabels> labels(std::size_t most, const TellProgress& tell) && {
    ProgressCount done("bends", graph_.size(), tell);
    for (std::uint32_t hub = 0; hub < graph_.size(); ++hub) {
      label(hub);
      done.add();
      if (count_ > most) return {};
    }
    return std::move(made_);
  }

 private:
  void label(std::uint32_t hub) {
    const std::uint32_t root = made_.vertices[hub];
    remember(root);
    tree_.grow(root, [&](std::uint32_t v, const PrintedLength& length) {
      if (is_covered(v, length)) return false;
      if (tree_.is_needed(v)) add(hub, v, length);
      return true;
    });
    for (const std::uint32_t h : remembered_) at_root_[h] = kFar;
    remembered_.clear();
  }

  /// How far the root is from its hubs; by half legs, too, where that is nearer.
  void remember(std::uint32_t root) {
    const auto& labels = made_.labels[root];
    for (std::uint32_t k = 0; k < labels.size(); ++k) {
      at_root_[labels[k].hub] = labels[k].length;
      label_of_[labels[k].hub] = k;
      remembered_.push_back(labels[k].hub);
    }
    root_ = root;
    if (!sights_) return;
    const HalfLegs& halves = sights_->halves;
    for (std::uint32_t i = halves.in_first[root]; i < halves.in_first[root + 1]; ++i)
      for (const HubLabels::Label& label : made_.labels[halves.in[i].to]) {
        const double length = (halves.in[i].length + label.length) * (1 + kMargin);
        if (length >= at_root_[label.hub]) continue;
        if (at_root_[label.hub] == kFar) remembered_.push_back(label.hub);
        at_root_[label.hub] = length;
        label_of_[label.hub] = kNone;
      }
  }

  /// Does the way to v pass a hub before, or is it longer than one that does?
  bool is_covered(std::uint32_t v, const PrintedLength& length) {
    const double limit = length.sum.high * (1 + kDoubt);
    const auto& labels = made_.labels[v];
    for (std::size_t k = 0; k < labels.size(); ++k)
      if (at_root_[labels[k].hub] + labels[k].length <= limit && is_covered_by(v, k, length)) return true;
    return false;
  }

  bool is_covered_by(std::uint32_t v, std::size_t k, const PrintedLength& length) {
    const HubLabels::Label& label = made_.labels[v][k];
    const std::uint32_t at_root = label_of_[label.hub];
    if (at_root == kNone || !tree_.is_needed(v)) return true;
    if (at_root_[label.hub] + label.length < length.sum.high * (1 - kDoubt)) return true;
    const auto printed = [&](std::uint32_t u, std::size_t i) {
      const HubLabels::Rest& rest = made_.rests[u][i];
      return PrintedLength{{made_.labels[u][i].length, rest.low}, rest.print};
    };
    const PrintedLength a = printed(root_, at_root), b = printed(v, k);
    const int order = compare({plus(a.sum, b.sum), a.print + b.print}, length);
    return order == 2 ? !is_longer_exactly(v, label.hub) : order <= 0;
  }

  /// Is the way over the hub longer than the one found now?
  bool is_longer_exactly(std::uint32_t v, std::uint32_t hub) {
    std::vector<Segment> over, now;
    add_legs(root_, hub, over);
    add_legs(v, hub, over);
    tree_.legs(v, now);
    return compare_lengths(over, now) > 0;
  }

  void add_legs(std::uint32_t v, std::uint32_t hub, std::vector<Segment>& legs) const {
    while (v != made_.vertices[hub]) {
      std::size_t k = 0;
      while (made_.labels[v][k].hub != hub) ++k;
      graph_.legs(graph_, made_.labels[v][k].edge, legs);
      v = graph_.edges[made_.labels[v][k].edge].to;
    }
  }

  void add(std::uint32_t hub, std::uint32_t v, const PrintedLength& length) {
    auto& labels = made_.labels[v];
    auto& rests = made_.rests[v];
    if (!labels.empty() && labels.back().hub == hub) {
      labels.pop_back();
      rests.pop_back();
      --count_;
    }
    const std::uint32_t via = tree_.via(v);
    labels.push_back({hub, via == kNone ? kNone : graph_.back[via], length.sum.high});
    rests.push_back({length.sum.low, length.print});
    ++count_;
  }

  const HubGraph& graph_;
  HubTree& tree_;
  const SightLists* sights_;
  HubLabels made_;
  std::vector<double> at_root_;          // by hub
  std::vector<std::uint32_t> label_of_;  // by hub: which label of the root; kNone where it came by a half leg
  std::vector<std::uint32_t> remembered_;
  std::uint32_t root_ = 0;
  std::size_t count_ = 0;
};

}  // namespace

std::size_t HubLabels::count() const {
  std::size_t n = 0;
  for (const auto& of_vertex : labels) n += of_vertex.size();
  return n;
}

std::optional<HubLabels> hub_labels(const HubGraph& graph, HubTree& tree, const SightLists* sights,
                                    std::vector<std::uint32_t> order, std::size_t most, const TellProgress& tell) {
  return Labeller(graph, tree, sights, std::move(order)).labels(most, tell);
}

}  // namespace taut::detail
