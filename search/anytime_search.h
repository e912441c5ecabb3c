// Anytime search: a path soon, a better one later, the shortest in the end; each with a proven bound.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include <taut/roadmaps/roadmap.h>
#include <taut/search/graph_search.h>
#include <taut/search/path.h>

namespace taut {

/// A stage that an AnytimeSearch has finished.
struct AnytimeImprovement {
  double epsilon = 1;        ///< what the stage aimed at
  double bound = 1;          ///< what it proved; at most epsilon
  Length length;             ///< of the best path then
  std::size_t expanded = 0;  ///< vertices looked around from, since the beginning
  double seconds = 0;        ///< spent in improve(), since the beginning
};

/// ARA* (Likhachev, Gordon, Thrun, "ARA*: Anytime A* with provable bounds on sub-optimality", NIPS 2003) on a roadmap,
/// with exact lengths: A* with its heuristic inflated by epsilon, then again with a smaller one, keeping all that was
/// found.
///
///  1. The length of best() is at most bound() times that of the shortest path from the start to any goal of the query
///     (bound() times the exact value, the product not rounded). bound() never falls below 1, and never rises.
///  2. It does not rest on the paper's theorem, which rounding breaks, but on what is left: a path shorter than the
///     best one leads through a vertex that is open or inconsistent, with its final label. So the bound is the upper
///     end of the best length over the least lower bound (label and heuristic) of those, rounded up. A stage reopens
///     inconsistent vertices until that is at most epsilon.
///  3. The last stage has epsilon 1 and goes on until no lower bound is below the best length. Then optimal() is true,
///     and best() is exactly as long as what graph_search finds.
///  4. Same calls, same answers, but for limits in seconds: ties go to the vertex nearer to the goal, then to the
///     smaller index.
/// Stages: epsilon as given; then half way from the smaller of epsilon and bound to 1, and 1 itself once within 1/64 of
/// it. So every stage proves a smaller bound than the one before.
///
/// O((V + E) log V) a stage, as a rule far less; memory 32 bytes a vertex and 32 each time one gets a shorter way.
class AnytimeSearch {
 public:
  static constexpr double kLargestEpsilon = 1e6;

  /// Precondition: 1 <= epsilon <= kLargestEpsilon.
  AnytimeSearch(std::shared_ptr<const Roadmap> roadmap, GraphQuery query, double epsilon = 3);
  ~AnytimeSearch();
  AnytimeSearch(AnytimeSearch&&) noexcept;
  AnytimeSearch& operator=(AnytimeSearch&&) noexcept;

  /// The next stage; nothing to do once optimal() or proven that there is none. The limits are those of this call.
  ///  found: bound() <= epsilon(). none: there is no path, proven. stopped: a limit came first; calling again goes on
  ///  where it stood, and best() and bound() hold for what is known already, if anything.
  SearchStatus improve(const SearchLimits& limits = {});

  /// The best path so far; of no point when there is none yet. O(its points).
  Path best() const;
  std::size_t goal() const;  ///< which one best() ends in
  double bound() const;      ///< infinite while there is no path
  bool optimal() const;      ///< best() is proven to be the shortest

  double epsilon() const;         ///< of the last stage begun
  std::size_t expanded() const;   ///< vertices looked around from, since the beginning; one counts each time
  std::size_t generated() const;  ///< vertices that ever got a length, start and goals included
  double seconds() const;         ///< spent in improve(), since the beginning
  AnytimeImprovement latest() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// What a whole run of an AnytimeSearch gave.
struct AnytimeAnswer {
  /// found: there is a path, whether proven the shortest or not. stopped: the seconds ended before there was one
  GraphSearchResult result;
  double bound = 1;
  bool optimal = false;  ///< in the roadmap
  std::vector<AnytimeImprovement> improvements;
};

/// Stage after stage until the path is proven the shortest or `seconds` (on the wall) are over. `told` hears of each
/// stage that was finished: what there is so far.
AnytimeAnswer anytime_path(std::shared_ptr<const Roadmap> roadmap, GraphQuery query, double epsilon, double seconds,
                           const std::function<void(const AnytimeAnswer&)>& told = {});

}  // namespace taut
