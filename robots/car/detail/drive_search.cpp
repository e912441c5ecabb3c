#include <taut/robots/car/detail/drive_search.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>

#include <taut/robots/car/curve_bound.h>
#include <taut/robots/car/detail/car_space_impl.h>

namespace taut::car::detail {

namespace {

constexpr std::uint32_t kRoot = 0xffffffff;
constexpr double kBackward = 1 + 1e-9;      // of drives as long as each other the one that goes forward is taken
constexpr double kNearGoal = 8;             // radii: further off the heading makes little difference
constexpr std::size_t kBetweenLooks = 256;  // expansions between looks at the clock

struct Node {
  LatticePose pose;
  double length = 0;
  double ahead = 0;
  std::uint32_t parent = kRoot;
  bool backward = false;
  bool done = false;
  bool on_lattice = true;
};

/// From 64-bit keys to numbers, all of them kept: open addressing.
class Table {
 public:
  Table() : slots_(1 << 12, Slot{kEmpty, 0}) {}

  /// The number of the key; `fresh` when it is new.
  std::uint32_t& at(std::uint64_t key, bool& fresh) {
    if (2 * used_ > slots_.size()) grow();
    Slot& slot = slots_[find(key)];
    fresh = slot.key == kEmpty;
    if (fresh) {
      slot.key = key;
      ++used_;
    }
    return slot.value;
  }

 private:
  struct Slot {
    std::uint64_t key;
    std::uint32_t value;
  };
  static constexpr std::uint64_t kEmpty = ~std::uint64_t{0};

  std::size_t find(std::uint64_t key) const {
    std::size_t i = (key * 0x9e3779b97f4a7c15U) >> 20 & (slots_.size() - 1);
    while (slots_[i].key != key && slots_[i].key != kEmpty) i = (i + 1) & (slots_.size() - 1);
    return i;
  }
  void grow() {
    std::vector<Slot> old(2 * slots_.size(), Slot{kEmpty, 0});
    old.swap(slots_);
    for (const Slot& slot : old)
      if (slot.key != kEmpty) slots_[find(slot.key)] = slot;
  }

  std::vector<Slot> slots_;
  std::size_t used_ = 0;
};

}  // namespace

/// What CarSpace lets look at what it is made of.
class DriveSearch {
 public:
  DriveSearch(const CarSpace& space, const DriveQuery& query, const LegLattice& lattice, const Geodesic& geodesic,
              PlannedDrive& result)
      : space_(space),
        query_(query),
        lattice_(lattice),
        geodesic_(geodesic),
        result_(result),
        primitives_(primitives(lattice, space.shape())) {
    for (const auto& of_heading : primitives_) {
      Box box{{0, 0}, {0, 0}};
      for (const Primitive& p : of_heading) {
        box.min = {std::min(box.min.x, p.leg.box().min.x), std::min(box.min.y, p.leg.box().min.y)};
        box.max = {std::max(box.max.x, p.leg.box().max.x), std::max(box.max.y, p.leg.box().max.y)};
      }
      reach_.push_back(box);
    }
    for (int h = 0; h < kHeadings; h += query.goal_heading ? 1 : lattice.stride)
      if (!query.goal_heading || h == *query.goal_heading) goal_headings_.push_back(h);
    for (const Point goal : query.goals) {
      const LatticePose pose{goal, query.goal_heading.value_or(0)};
      goals_off_lattice_.push_back(!lattice.holds(pose));
    }
  }

  void run(const std::vector<LatticePose>& starts, const SearchLimits& limits) {
    const auto begin = std::chrono::steady_clock::now();
    for (const LatticePose& start : starts) {
      // Of free headings off the lattice there are enough on it.
      if (starts.size() > 1 && start.heading % lattice_.stride != 0) continue;
      push({start, 0, ahead_of(start.at), kRoot, false, false, lattice_.holds(start)});
    }
    for (std::size_t expanded = 0; !open_.empty();) {
      const std::uint32_t index = std::get<2>(open_.top());
      open_.pop();
      if (nodes_[index].done) continue;
      nodes_[index].done = true;
      if (is_goal(nodes_[index].pose)) return accept(index);
      if (expanded == limits.expansions) return;
      if (++expanded % kBetweenLooks == 0 &&
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() > limits.seconds)
        return;
      ++result_.expanded;
      expand(index);
    }
  }

 private:
  bool is_goal(const LatticePose& pose) const {
    if (query_.goal_heading && pose.heading != *query_.goal_heading) return false;
    return std::ranges::find(query_.goals, pose.at) != query_.goals.end();
  }

  std::uint64_t place_key(Point p) const {
    const auto i = static_cast<std::int64_t>(std::lround(p.x / lattice_.step));
    const auto j = static_cast<std::int64_t>(std::lround(p.y / lattice_.step));
    return static_cast<std::uint64_t>((i & 0xfffffff) << 28 | (j & 0xfffffff));
  }

  /// A lower bound of the way to a goal from a node of the lattice.
  double ahead_at_node(Point p) {
    bool fresh = false;
    std::uint32_t& number = places_.at(place_key(p), fresh);
    if (fresh) {
      number = static_cast<std::uint32_t>(ahead_.size());
      ahead_.push_back(geodesic_.from(p));
    }
    return ahead_[number];
  }
  double ahead_of(Point p) const { return geodesic_.from(p); }

  /// The same of a pose: where the goal's heading is given, near it, also without walls.
  double ahead_at_node(const LatticePose& pose) {
    const double ahead = ahead_at_node(pose.at);
    if (!query_.goal_heading || !(ahead < kNearGoal * space_.shape().radius)) return ahead;
    double least = 1e300;
    const Pose from{pose.at.x, pose.at.y, heading_angle(pose.heading)};
    for (const Point goal : query_.goals) {
      const Pose to{goal.x, goal.y, heading_angle(*query_.goal_heading)};
      const auto bound = space_.shape().reverse ? reeds_shepp_bound : dubins_bound;
      least = std::min(least, bound(from, to, space_.shape().radius));
    }
    return std::max(ahead, (1 - 1e-9) * least);
  }

  static double cost(const Leg& leg, double length) { return leg.backward ? kBackward * length : length; }

  void push(const Node& node) {
    if (!(node.ahead < 1e300)) return;
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    if (node.on_lattice) {
      bool fresh = false;
      std::uint32_t& known =
          known_.at(place_key(node.pose.at) << 6 | static_cast<std::uint64_t>(node.pose.heading), fresh);
      if (!fresh && nodes_[known].length <= node.length) return;
      if (!fresh) nodes_[known].done = true;
      known = index;
    }
    nodes_.push_back(node);
    open_.emplace(node.length + query_.weight * node.ahead, node.ahead, index);
  }

  /// Is there already as short a way to this node?
  bool is_known(const LatticePose& pose, double length) {
    bool fresh = false;
    std::uint32_t& known = known_.at(place_key(pose.at) << 6 | static_cast<std::uint64_t>(pose.heading), fresh);
    if (fresh) {
      known = static_cast<std::uint32_t>(nodes_.size());
      nodes_.push_back({pose, 1e300, 0, kRoot, false, true, true});
    }
    return nodes_[known].length <= length;
  }

  void expand(std::uint32_t index) {
    const Node node = nodes_[index];
    reach_goals(index, node);
    if (!node.on_lattice) {
      for (const Leg& leg : legs_onto(lattice_, space_.shape(), node.pose)) {
        ++result_.tested;
        if (space_.is_clear(leg))
          push({leg.to, node.length + cost(leg, curve_of(leg).length()), ahead_at_node(leg.to), index, leg.backward,
                false, true});
      }
      return;
    }
    const auto which = static_cast<std::size_t>(node.pose.heading / lattice_.stride);
    space_.impl_->walls_near(reach_[which], node.pose.at, near_);
    for (const Primitive& p : primitives_[which]) {
      const Leg leg{
          node.pose,
          {{node.pose.at.x + p.di * lattice_.step, node.pose.at.y + p.dj * lattice_.step}, p.leg.leg().to.heading},
          p.leg.leg().backward};
      const double length = node.length + cost(leg, p.leg.length());
      if (is_known(leg.to, length)) continue;
      const double ahead = ahead_at_node(leg.to);
      if (!(ahead < 1e300)) continue;
      ++result_.tested;
      if (space_.impl_->is_clear(p.leg, leg, near_)) push({leg.to, length, ahead, index, leg.backward, false, true});
    }
  }

  /// Legs to goals that are no nodes.
  void reach_goals(std::uint32_t index, const Node& node) {
    const double reach = 2 * space_.shape().radius + 6 * lattice_.step;
    for (std::size_t i = 0; i < query_.goals.size(); ++i) {
      const Point goal = query_.goals[i];
      if (!goals_off_lattice_[i] || std::hypot(goal.x - node.pose.at.x, goal.y - node.pose.at.y) > reach) continue;
      for (const Leg& leg : legs_to(space_.shape(), node.pose, goal, goal_headings_)) {
        ++result_.tested;
        if (space_.is_clear(leg))
          push({leg.to, node.length + cost(leg, curve_of(leg).length()), 0, index, leg.backward, false, false});
      }
    }
  }

  void accept(std::uint32_t last) {
    result_.status = SearchStatus::found;
    result_.legs.clear();
    std::uint32_t n = last;
    for (; nodes_[n].parent != kRoot; n = nodes_[n].parent)
      result_.legs.push_back({nodes_[nodes_[n].parent].pose, nodes_[n].pose, nodes_[n].backward});
    result_.start = nodes_[n].pose;
    std::ranges::reverse(result_.legs);
  }

  const CarSpace& space_;
  const DriveQuery& query_;
  LegLattice lattice_;
  const Geodesic& geodesic_;
  PlannedDrive& result_;
  std::vector<std::vector<Primitive>> primitives_;
  std::vector<Box> reach_;
  std::vector<int> goal_headings_;
  std::vector<bool> goals_off_lattice_;
  std::vector<Node> nodes_;
  Table known_, places_;
  std::vector<double> ahead_;  // by places_
  std::vector<NearWall> near_;
  using Entry = std::tuple<double, double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

void search_drive(const CarSpace& space, const DriveQuery& query, const std::vector<LatticePose>& starts,
                  const LegLattice& lattice, const Geodesic& geodesic, const SearchLimits& limits,
                  PlannedDrive& result) {
  DriveSearch(space, query, lattice, geodesic, result).run(starts, limits);
}

}  // namespace taut::car::detail
