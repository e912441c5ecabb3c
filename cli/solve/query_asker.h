// One query of `taut batch`, from its ends to its answer.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <taut/cli/solve/batch_answers.h>
#include <taut/cli/solve/ends_on_walls.h>
#include <taut/cli/world/geographic.h>
#include <taut/io/worlds/query_lines.h>
#include <taut/search/changing_world.h>
#include <taut/search/index.h>
#include <taut/search/no_path.h>
#include <taut/search/polyanya.h>

namespace taut::cli {

/// One query after the other, by cones and bends, by an index, or in a world that changes.
class QueryFinder {
 public:
  explicit QueryFinder(const Polyanya& polyanya) : search_(PolyanyaSearch(polyanya)) {}
  explicit QueryFinder(const Index& index) : search_(IndexSearch(index)) {}
  explicit QueryFinder(ChangingWorld world) : search_(std::move(world)) {}

  ChangingWorld* changing() { return std::get_if<ChangingWorld>(&search_); }

  SearchStatus find(Point from, Point to) {
    return std::visit([&](auto& search) { return search.find(from, to); }, search_);
  }
  const std::vector<Point>& points() const {
    return std::visit([](const auto& search) -> const std::vector<Point>& { return search.points(); }, search_);
  }
  /// 0 where it is not by cones and bends.
  std::size_t expanded() const {
    const auto* const cones = std::get_if<PolyanyaSearch>(&search_);
    return cones ? cones->expanded() : 0;
  }

 private:
  std::variant<PolyanyaSearch, IndexSearch, ChangingWorld> search_;
};

/// What all queries of a batch share, for any number of threads. What it is made of must outlive it.
struct QueryGround {
  const FreeSpace& space;
  const EndsOnWalls& walls;
  const Shown& shown;               ///< --project: queries are longitude and latitude
  std::optional<double> snap_ends;  ///< how far an end may be moved
  bool wants_nearest = false;       ///< the free place nearest to a blocked end
  bool wants_path = false;

  Point plane(Point p) const { return shown ? shown.geographic()->metres(p) : p; }
};

/// Whether there is proof that there is no path: asked by one thread at a time.
class SharedNoPath {
 public:
  explicit SharedNoPath(const FreeSpace& space) : no_path_(space) {}
  bool holds(Point from, Point to) {
    const std::lock_guard lock(mutex_);
    return no_path_.holds(from, {to, {}});
  }

 private:
  std::mutex mutex_;
  NoPath no_path_;
};

/// Answers one query after the other, in the same memory; one thread at a time.
class QueryAsker {
 public:
  QueryAsker(const QueryGround& ground, SharedNoPath& no_path, QueryFinder search)
      : ground_(ground), no_path_(no_path), search_(std::move(search)) {}

  /// A start or goal in a wall is an answer here, no reason to stop.
  QueryAnswer ask(const QueryLine& query);
  /// The world that changes, where one is asked.
  ChangingWorld* changing() { return search_.changing(); }

 private:
  QueryAnswer ask_in_changed(ChangingWorld& world, const QueryLine& query);
  QueryAnswer ask_on_walls(const QueryLine& query) const;

  const QueryGround& ground_;
  SharedNoPath& no_path_;
  QueryFinder search_;
};

/// One for each thread that asks; those that are given back are lent again.
class QueryAskers {
 public:
  QueryAskers(const QueryGround& ground, SharedNoPath& no_path) : ground_(ground), no_path_(no_path) {}

  /// One that searches there: always the same place.
  std::shared_ptr<QueryAsker> lend(const Polyanya& polyanya) {
    return lend_or([&] { return QueryFinder(polyanya); });
  }
  std::shared_ptr<QueryAsker> lend(const Index& index) {
    return lend_or([&] { return QueryFinder(index); });
  }

 private:
  std::shared_ptr<QueryAsker> lend_or(const std::function<QueryFinder()>& make);

  const QueryGround& ground_;
  SharedNoPath& no_path_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<QueryAsker>> idle_;
};

}  // namespace taut::cli
