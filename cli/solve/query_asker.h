// One query of `taut batch`, from its ends to its answer.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include <taut/cli/solve/batch_answers.h>
#include <taut/cli/solve/ends_on_walls.h>
#include <taut/cli/world/geographic.h>
#include <taut/io/worlds/query_lines.h>
#include <taut/search/no_path.h>
#include <taut/search/polyanya.h>

namespace taut::cli {

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
  QueryAsker(const QueryGround& ground, SharedNoPath& no_path, const Polyanya& polyanya)
      : ground_(ground), no_path_(no_path), search_(polyanya) {}

  /// A start or goal in a wall is an answer here, no reason to stop.
  QueryAnswer ask(const QueryLine& query);

 private:
  QueryAnswer ask_on_walls(const QueryLine& query) const;

  const QueryGround& ground_;
  SharedNoPath& no_path_;
  PolyanyaSearch search_;
};

/// One for each thread that asks; those that are given back are lent again.
class QueryAskers {
 public:
  QueryAskers(const QueryGround& ground, SharedNoPath& no_path) : ground_(ground), no_path_(no_path) {}

  std::shared_ptr<QueryAsker> lend(const Polyanya& polyanya);
  /// Those that are idle: the next ones search on another mesh. Only while none is lent.
  void forget();

 private:
  const QueryGround& ground_;
  SharedNoPath& no_path_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<QueryAsker>> idle_;
};

}  // namespace taut::cli
