#include <taut/robots/roadblocks/detail/lattice_search.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace taut::roadblocks::detail {

namespace {

constexpr double kUnit = 2 * std::numbers::pi / kLatticeHeadings;
constexpr double kTrust = 1.05;            // the estimate is mostly a little low
constexpr int kLost = 64;                  // steps, where the estimate knows no way
constexpr double kInscribed = 1.0 - 0.36;  // room below it: not even the disc fits

struct Primitive {
  std::vector<double> controls;
  int turn = 0;  ///< in kUnit
};

std::vector<Primitive> primitives(const Lattice& lattice) {
  std::vector<Primitive> all;
  const auto add = [&](int backwards, double control, int times, int turn) {
    Primitive p;
    for (int i = 0; i < times; ++i) {
      p.controls.insert(p.controls.end(), static_cast<std::size_t>(backwards), kReverse);
      if (control != kReverse) p.controls.push_back(control);
    }
    p.turn = turn;
    all.push_back(std::move(p));
  };
  const int arc = lattice.arc;
  add(0, 0, arc, 0);
  for (const int side : {1, -1}) add(0, side * kLatticeTurn, arc, side * arc);
  add(3 * arc / 2, kReverse, 1, 0);
  for (const int back : {3, 6})  // the turn on the spot; the arc backwards, as wide as the one ahead
    for (const int side : {1, -1}) add(back, side * kLatticeTurn, arc, side * arc);
  return all;
}

struct Node {
  double x, y;
  int cost;
  std::uint32_t parent;
  std::uint8_t heading;
  std::uint8_t primitive;
  std::uint8_t taken;  ///< steps of it
  bool arrived;
};

/// The best node of each bin and heading; memory comes unit by unit.
class Bins {
 public:
  Bins(const Course& course, const Lattice& lattice)
      : columns_(course.width),
        rows_(course.height),
        lattice_(lattice),
        tiles_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

  static constexpr std::uint32_t kNone = ~0U;

  std::uint32_t& at(double x, double y, int heading) {
    const int i = std::clamp(static_cast<int>((x - 0.5) * lattice_.bins), 0, columns_ * lattice_.bins - 1);
    const int j = std::clamp(static_cast<int>((y - 0.5) * lattice_.bins), 0, rows_ * lattice_.bins - 1);
    const int headings = kLatticeHeadings / lattice_.arc;
    auto& tile = tiles_[static_cast<std::size_t>(j / lattice_.bins) * static_cast<std::size_t>(columns_) +
                        static_cast<std::size_t>(i / lattice_.bins)];
    if (!tile) {
      const auto size = static_cast<std::size_t>(lattice_.bins * lattice_.bins * headings);
      tile = std::make_unique<std::uint32_t[]>(size);
      std::fill_n(tile.get(), size, kNone);
    }
    return tile[static_cast<std::size_t>(((j % lattice_.bins) * lattice_.bins + i % lattice_.bins) * headings +
                                         heading / lattice_.arc)];
  }

 private:
  int columns_, rows_;
  Lattice lattice_;
  std::vector<std::unique_ptr<std::uint32_t[]>> tiles_;
};

/// By estimate; the latest first among equals, which goes deep.
class Buckets {
 public:
  void push(int estimate, std::uint32_t node) {
    const auto at = static_cast<std::size_t>(estimate);
    if (at >= buckets_.size()) buckets_.resize(at + 64);
    buckets_[at].push_back(node);
    least_ = std::min(least_, at);
  }
  std::optional<std::uint32_t> pop() {
    while (least_ < buckets_.size() && buckets_[least_].empty()) ++least_;
    if (least_ == buckets_.size()) return std::nullopt;
    const std::uint32_t node = buckets_[least_].back();
    buckets_[least_].pop_back();
    return node;
  }

 private:
  std::vector<std::vector<std::uint32_t>> buckets_;
  std::size_t least_ = 0;
};

class Search {
 public:
  Search(const Obstacles& obstacles, const DiscDistance& disc, const PoseDistance& distance, const Lattice& lattice,
         const Pose& from)
      : obstacles_(obstacles),
        disc_(disc),
        distance_(distance),
        from_(from),
        slack_(lattice.slack),
        most_(lattice.most),
        primitives_(primitives(lattice)),
        bins_(obstacles.course(), lattice) {
    lay_steps();
  }

  LatticeAnswer run(std::size_t& expanded) {
    Node start{from_.x, from_.y, 0, Bins::kNone, 0, 0, 0, at_goal(from_, obstacles_.course(), -kMargin)};
    push(start);
    std::size_t done = 0;
    while (const std::optional<std::uint32_t> next = open_.pop()) {
      const Node node = nodes_[*next];
      if (node.arrived) return {plan_to(*next), false};
      if (bins_.at(node.x, node.y, node.heading) != *next) continue;
      if (++done > most_) return {};
      ++expanded;
      for (std::size_t i = 0; i < primitives_.size(); ++i) extend(*next, node, i);
    }
    return {std::nullopt, true};
  }

 private:
  /// The poses of each primitive, from each heading, at the origin. Headings count from the start's own, which may be
  /// off the lattice by rounding.
  void lay_steps() {
    for (const Primitive& p : primitives_)
      for (int h = 0; h < kLatticeHeadings; ++h) {
        Pose pose{0, 0, from_.heading + h * kUnit};
        std::vector<Pose> poses{pose};
        for (const double control : p.controls) poses.push_back(pose = stepped(pose, control));
        steps_.push_back(std::move(poses));
      }
  }

  bool is_clear(const Pose& from, double control, const Pose& to) const {
    return obstacles_.room({to.x, to.y}) > kInscribed && obstacles_.is_clear(from, control, to, slack_);
  }

  void extend(std::uint32_t parent, const Node& node, std::size_t which) {
    const Primitive& p = primitives_[which];
    const std::vector<Pose>& steps = steps_[which * kLatticeHeadings + node.heading];
    Pose at{node.x, node.y, steps[0].heading};
    for (std::size_t i = 0; i < p.controls.size(); ++i) {
      const Pose to{node.x + steps[i + 1].x, node.y + steps[i + 1].y, steps[i + 1].heading};
      if (!is_clear(at, p.controls[i], to)) return;
      at = to;
      const int cost = node.cost + static_cast<int>(i) + 1;
      if (disc_.steps_from({to.x, to.y}) == 0 && at_goal(to, obstacles_.course(), -kMargin)) {
        push({to.x, to.y, cost, parent, 0, static_cast<std::uint8_t>(which), static_cast<std::uint8_t>(i + 1), true});
        return;
      }
    }
    const int heading = (node.heading + p.turn + kLatticeHeadings) % kLatticeHeadings;
    push({at.x, at.y, node.cost + static_cast<int>(p.controls.size()), parent, static_cast<std::uint8_t>(heading),
          static_cast<std::uint8_t>(which), static_cast<std::uint8_t>(p.controls.size()), false});
  }

  void push(const Node& node) {
    const int ahead = node.arrived ? 0 : steps_ahead(node);
    if (ahead == DiscDistance::kFar) return;
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    if (!node.arrived) {
      std::uint32_t& best = bins_.at(node.x, node.y, node.heading);
      if (best != Bins::kNone && nodes_[best].cost <= node.cost) return;
      best = index;
    }
    nodes_.push_back(node);
    open_.push(node.cost + ahead, index);
  }

  int steps_ahead(const Node& node) const {
    const int disc = disc_.steps_from({node.x, node.y});
    if (disc == DiscDistance::kFar) return disc;
    const double steps = distance_.steps_from({node.x, node.y, from_.heading + node.heading * kUnit});
    return steps == PoseDistance::kFar ? disc + kLost : std::max(disc, static_cast<int>(kTrust * steps));
  }

  DrivePlan plan_to(std::uint32_t last) const {
    std::vector<const Node*> way;
    for (std::uint32_t n = last; n != Bins::kNone; n = nodes_[n].parent) way.push_back(&nodes_[n]);
    DrivePlan plan;
    Pose pose = from_;
    for (std::size_t i = way.size() - 1; i-- > 0;)
      for (std::size_t k = 0; k < way[i]->taken; ++k) {
        const double control = primitives_[way[i]->primitive].controls[k];
        plan.controls.push_back(control);
        plan.poses.push_back(pose = stepped(pose, control));
      }
    return plan;
  }

  const Obstacles& obstacles_;
  const DiscDistance& disc_;
  const PoseDistance& distance_;
  Pose from_;
  double slack_;
  std::size_t most_;
  std::vector<Primitive> primitives_;
  std::vector<std::vector<Pose>> steps_;
  std::vector<Node> nodes_;
  Bins bins_;
  Buckets open_;
};

}  // namespace

LatticeAnswer lattice_search(const Obstacles& obstacles, const DiscDistance& disc, const PoseDistance& distance,
                             const Lattice& lattice, const Pose& from, std::size_t& expanded) {
  return Search(obstacles, disc, distance, lattice, from).run(expanded);
}

}  // namespace taut::roadblocks::detail
