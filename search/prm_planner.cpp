#include <taut/search/prm_planner.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include <taut/roadmaps/prm_growth.h>
#include <taut/search/detail/prm_end.h>
#include <taut/search/detail/prm_lazy.h>
#include <taut/search/detail/room_entries.h>
#include <taut/search/no_path.h>
#include <taut/search/query_ends.h>

namespace taut {

namespace {

using Vertex = Roadmap::Vertex;

constexpr std::size_t kNeighbours = 8, kFirstBatch = 64, kMostSamples = 1'000'000;

std::vector<Point> goal_points(const FreeSpace& space, const Goal& goal) {
  if (goal.point) return {*goal.point};
  std::vector<Point> points;
  for (const Box& box : goal.room) {
    const Point middle = detail::middle(box);
    if (space.locate(middle).kind != Location::Kind::outside) points.push_back(middle);
  }
  return points;
}

bool is_in_room(const FreeSpace& space, Point p, const Goal& goal) {
  return !goal.point && std::any_of(goal.room.begin(), goal.room.end(), [&](const Box& box) {
    return box.contains(p) && space.sees(p, detail::middle(box));
  });
}

bool is_clear_leg(const PrmClear& clear, Point p, Point q) {
  const bool keeps_clearance = clear.point(p) && clear.point(q);
  return keeps_clearance ? clear.leg(p, q) : clear.space().sees(p, q);
}

/// Both ends, joined to what `joined` says a point is joined to.
GraphQuery query_of(const PrmClear& clear, Point from, const std::vector<Point>& goals, const auto& joined) {
  GraphQuery query{{from, joined(from)}, {}, {}};
  for (const Point goal : goals) {
    if (is_clear_leg(clear, from, goal)) query.direct.push_back(query.goals.size());
    query.goals.push_back({goal, joined(goal)});
  }
  return query;
}

/// One run of prm_path.
class PrmRun {
 public:
  PrmRun(const FreeSpace& space, Point from, const std::vector<Point>& goals, const PrmPlan& plan)
      : plan_(plan),
        most_(plan.roadmap.samples.value_or(kMostSamples)),
        growth_(space, plan.roadmap, plan.lazy),
        start_(growth_.clear(), from, kNeighbours) {
    for (const Point goal : goals) goals_.emplace_back(growth_.clear(), goal, kNeighbours);
    for (const Point goal : goals) is_direct_.push_back(is_clear_leg(growth_.clear(), from, goal));
  }

  PrmResult run() {
    result_.search.status = SearchStatus::stopped;
    while (plan_.exactly && may_go_on() && grow()) continue;
    for (bool is_first = true; !solve(); is_first = false)
      if (goals_.empty() || (!is_first && !may_go_on()) || !grow()) break;
    if (result_.search.status == SearchStatus::found && plan_.refine > 0 && may_go_on()) refine();
    finish();
    return std::move(result_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  double seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

  bool may_go_on() const {
    if (plan_.progress && !plan_.progress({growth_.counts(), seconds()})) return false;
    return seconds() < plan_.seconds;
  }

  /// False when the samples are used up.
  bool grow() {
    const std::size_t whole = plan_.roadmap.sampler == PrmSampler::lattice ? growth_.default_count() : 0;
    const std::size_t batch = drawn_ == 0 && whole > 0 ? whole : std::max(kFirstBatch, drawn_ / 16);
    const std::size_t draws = std::min(batch, most_ - drawn_);
    growth_.add(draws);
    drawn_ += draws;
    return draws > 0;
  }

  /// Around each leg a box that reaches half as far beyond it as samples lie apart.
  void refine() {
    const Box box = growth_.clear().space().world().box();
    const double area = (box.max.x - box.min.x) * (box.max.y - box.min.y);
    const double reach = std::sqrt(area / static_cast<double>(growth_.points().size() + 1)) / 2;
    std::vector<Box> boxes;
    const std::vector<Point>& way = result_.search.path.points;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) boxes.push_back(widened(box_around(way[i], way[i + 1]), reach));
    const double wanted = plan_.refine * static_cast<double>(drawn_), left = static_cast<double>(most_ - drawn_);
    const auto draws = static_cast<std::size_t>(std::min(wanted, left));
    if (draws == 0) return;
    const PrmGrowth::Size size = growth_.size();
    const GraphQuery query = query_;
    Roadmap roadmap = std::move(result_.roadmap);
    GraphSearchResult found = std::exchange(result_.search, {});
    growth_.add_in(BoxIndex(std::move(boxes)), draws);
    drawn_ += draws;
    if (solve() && result_.search.path.length <= found.path.length) return;
    // The vertices nearest to an end are others now, from which the way may be longer, or none.
    growth_.take_back(size);
    query_ = query;
    result_.roadmap = std::move(roadmap);
    result_.search = std::move(found);
  }

  bool solve() {
    join_ends();
    if (query_.direct.empty() && !may_be_joined()) return false;
    if (!plan_.lazy) {
      result_.roadmap = growth_.roadmap();
      result_.search = graph_search(result_.roadmap, query_, plan_.algorithm);
    } else if (auto found = detail::PrmLazySearch(growth_, query_).search(plan_.algorithm)) {
      result_.search = std::move(*found);
    }
    return result_.search.status == SearchStatus::found;
  }

  void join_ends() {
    query_ = {{start_.point(), start_.joined(growth_.points())}, {}, {}};
    for (std::size_t i = 0; i < goals_.size(); ++i) {
      if (is_direct_[i]) query_.direct.push_back(i);
      query_.goals.push_back({goals_[i].point(), goals_[i].joined(growth_.points())});
    }
  }

  bool may_be_joined() {
    for (const Vertex v : query_.start.vertices)
      for (const Terminal& goal : query_.goals)
        for (const Vertex w : goal.vertices)
          if (growth_.parts().part(v) == growth_.parts().part(w)) return true;
    return false;
  }

  void finish() {
    if (plan_.lazy || result_.search.status != SearchStatus::found) result_.roadmap = growth_.roadmap();
    result_.counts = growth_.counts();
    std::vector<bool> reached(result_.roadmap.vertex_count()), from_goal(reached);
    result_.start_part = reach(query_.start.vertices, reached);
    std::vector<Vertex> at_goal;
    for (const Terminal& goal : query_.goals) at_goal.insert(at_goal.end(), goal.vertices.begin(), goal.vertices.end());
    result_.goal_part = reach(at_goal, from_goal);
    const std::size_t covered = result_.start_part + reach(at_goal, reached), count = reached.size();
    result_.coverage = count == 0 ? 0 : static_cast<double>(covered) / static_cast<double>(count);
    result_.seconds = seconds();
  }

  /// Marks what hangs together with `open`; how many vertices that adds.
  std::size_t reach(std::vector<Vertex> open, std::vector<bool>& reached) const {
    std::size_t added = 0;
    while (!open.empty()) {
      const Vertex v = open.back();
      open.pop_back();
      if (reached[v]) continue;
      reached[v] = true;
      ++added;
      for (const Vertex w : result_.roadmap.neighbours(v)) open.push_back(w);
    }
    return added;
  }

  const PrmPlan& plan_;
  std::size_t most_;
  Clock::time_point begin_ = Clock::now();
  PrmGrowth growth_;
  detail::PrmEnd start_;
  std::vector<detail::PrmEnd> goals_;
  std::vector<bool> is_direct_;  // of goals_: straight from the start
  GraphQuery query_;
  std::size_t drawn_ = 0;
  PrmResult result_;
};

void require_ends(const FreeSpace& space, Point from, const Goal& to) {
  require_free(space, from, "start");
  if (to.point) require_free(space, *to.point, "goal");
}

}  // namespace

PrmResult prm_path(const FreeSpace& space, Point from, const Goal& to, const PrmPlan& plan) {
  require_ends(space, from, to);
  PrmResult result;
  if (is_in_room(space, from, to)) {
    result.search.status = SearchStatus::found;
    result.search.path.points = {from};
    return result;
  }
  if (NoPath(space).holds(from, to)) return result;
  return PrmRun(space, from, goal_points(space, to), plan).run();
}

GraphQuery prm_query(const FreeSpace& space, const Roadmap& roadmap, Point from, const Goal& to, double clearance) {
  require_ends(space, from, to);
  PrmNearest index;
  index.add(roadmap.points());
  const PrmClear clear(space, clearance);
  return query_of(clear, from, goal_points(space, to),
                  [&](Point p) { return nearest_visible(clear, index, roadmap.points(), p, kNeighbours); });
}

}  // namespace taut
