#include <taut/cli/solve/query_asker.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <taut/search/stopwatch.h>

namespace taut::cli {

namespace {

using Status = QueryAnswer::Status;

/// Asks in a space in which the ends are where they were written.
class Question {
 public:
  Question(const QueryGround& ground, const FreeSpace& space) : ground_(ground), space_(space) {}

  template <typename IsProven>
  QueryAnswer answer(QueryFinder& search, QueryLine query, IsProven is_proven) const {
    QueryAnswer answer;
    query.from = ground_.plane(query.from);
    query.to = ground_.plane(query.to);
    if (settle("start", query.from, answer) && settle("goal", query.to, answer)) find(search, query, answer, is_proven);
    show(answer);
    return answer;
  }

 private:
  /// Is p a place for the robot, or moved to one by --snap-ends?
  bool settle(const char* role, Point& p, QueryAnswer& answer) const {
    if (space_.locate(p).kind != Location::Kind::outside) return true;
    std::optional<FreePlace> nearest;
    if (ground_.snap_ends || ground_.wants_nearest) nearest = nearest_free(space_, p);
    if (nearest && ground_.snap_ends && nearest->distance <= *ground_.snap_ends) {
      answer.moves.push_back({role, p, *nearest});
      p = nearest->point;
      return true;
    }
    answer.status = Status::blocked;
    answer.blocked = role;
    answer.nearest = nearest;
    return false;
  }

  template <typename IsProven>
  void find(QueryFinder& search, const QueryLine& query, QueryAnswer& answer, IsProven is_proven) const {
    const Stopwatch watch(Stopwatch::Of::thread);
    const SearchStatus status = search.find(query.from, query.to);
    answer.cpu = watch.seconds().cpu;
    if (status != SearchStatus::found) {
      if (!is_proven(query.from, query.to)) answer.status = Status::unproven;
      return;
    }
    answer.status = Status::found;
    answer.length = Length(search.points()).value();
    answer.nodes = search.expanded();
    answer.straight = std::hypot(query.to.x - query.from.x, query.to.y - query.from.y);
    if (ground_.wants_path) answer.points.assign(search.points().begin(), search.points().end());
  }

  void show(QueryAnswer& answer) const {
    const Shown& shown = ground_.shown;
    if (!shown) return;
    answer.points = shown(std::move(answer.points));
    answer.moves = shown(std::move(answer.moves));
    if (answer.nearest) answer.nearest = shown(*answer.nearest);
  }

  const QueryGround& ground_;
  const FreeSpace& space_;
};

}  // namespace

QueryAnswer QueryAsker::ask(const QueryLine& query) {
  if (ChangingWorld* const world = search_.changing()) return ask_in_changed(*world, query);
  const EndsOnWalls& walls = ground_.walls;
  if (walls.concern(ground_.plane(query.from)) || walls.concern(ground_.plane(query.to))) return ask_on_walls(query);
  return Question(ground_, ground_.space).answer(search_, query, [&](Point from, Point to) {
    return no_path_.holds(from, to);
  });
}

/// Walls without thickness leave a point all its places.
QueryAnswer QueryAsker::ask_in_changed(ChangingWorld& world, const QueryLine& query) {
  const auto is_thick = [](const Wall& wall) { return wall.thickness > 0; };
  const bool are_same_places = ground_.space.footprint().kind() == Footprint::Kind::point &&
                               std::ranges::none_of(ground_.space.world().walls(), is_thick);
  const FreeSpace& places = are_same_places ? ground_.space : world.space();
  return Question(ground_, places).answer(search_, query, [&](Point from, Point to) {
    return world.is_among_cells() || NoPath(world.space()).holds(from, {to, {}});
  });
}

/// A space of their own has the ends where they are.
QueryAnswer QueryAsker::ask_on_walls(const QueryLine& query) const {
  const FreeSpace space = ground_.walls.space_with(std::vector{query.from, query.to});
  QueryFinder search{Polyanya(space)};
  const NoPath no_path(space);
  return Question(ground_, space).answer(search, query, [&](Point from, Point to) {
    return no_path.holds(from, {to, {}});
  });
}

std::shared_ptr<QueryAsker> QueryAskers::lend_or(const std::function<QueryFinder()>& make) {
  const auto give_back = [this](QueryAsker* asker) {
    const std::lock_guard lock(mutex_);
    idle_.emplace_back(asker);
  };
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      std::unique_ptr<QueryAsker> asker = std::move(idle_.back());
      idle_.pop_back();
      return {asker.release(), give_back};
    }
  }
  return {new QueryAsker(ground_, no_path_, make()), give_back};
}

}  // namespace taut::cli
