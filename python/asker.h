// Queries on one free space, from any number of threads.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <taut/geometry/written_places.h>
#include <taut/python/answers.h>
#include <taut/search/no_path.h>
#include <taut/search/polyanya.h>

namespace taut::python {

enum class QueryStatus : std::uint8_t {
  found,
  none,      ///< proven
  blocked,   ///< an end is no place for the robot
  unproven,  ///< nothing found, which proves nothing
};

/// Two points of one query.
using Ends = std::pair<Point, Point>;

/// Answers to many queries, in their order.
struct Answers {
  std::vector<std::uint8_t> status;
  std::vector<double> length;         ///< infinite where there is none, NaN where blocked or unproven
  std::vector<std::int64_t> offsets;  ///< when paths are wanted: one more than queries
  std::vector<Point> points;          ///< of query i: from offsets[i] to offsets[i + 1]
};

/// A free space with its navigation mesh, that threads share. Searches are kept for the next query. An end that a bent
/// wall was moved from (WrittenPlaces) is asked about in a space of its own.
class Asker {
 public:
  explicit Asker(Polyanya polyanya);

  const Polyanya& polyanya() const { return polyanya_; }
  const FreeSpace& space() const { return polyanya_.space(); }

  /// The shortest path; nothing when there is none, proven. Throws InputError, Unproven.
  std::optional<FoundPath> find(Point from, const Goal& to) const;
  /// To the nearest of the goals, and which one that is.
  std::optional<std::pair<FoundPath, std::size_t>> find_nearest(Point from, std::span<const Point> goals) const;
  std::vector<std::optional<FoundPath>> find_each(Point from, std::span<const Point> goals) const;

  /// The length from each start to each goal, a row a start; infinite where there is none, proven, NaN where that
  /// is not, or an end is not free.
  /// Precondition: threads >= 1, points are in reach.
  std::vector<double> distances(std::span<const Point> starts, std::span<const Point> goals, unsigned threads,
                                const std::function<bool()>& is_over) const;

  /// The same answers however many threads there are. `is_over` is asked now and then by the calling thread; once it
  /// says so, what is left is not answered. Precondition: threads >= 1, points are in reach.
  Answers find_many(std::span<const Ends> queries, bool with_paths, unsigned threads,
                    const std::function<bool()>& is_over) const;

 private:
  class Loan;  // a search, given back at its end

  /// One that knows these ends, where one of them was moved.
  std::optional<Asker> knowing(std::span<const Point> ends) const;
  FoundPath found(Point from, const Goal& to, Path path, std::size_t expanded) const;
  std::optional<FoundPath> find_here(Point from, const Goal& to) const;
  QueryStatus status_of_none(Point from, Point to) const;
  /// Into row i of what is preset; the path's points when they are wanted.
  void answer(PolyanyaSearch& search, const Ends& ends, std::size_t i, Answers& answers,
              std::vector<Point>* path) const;
  void answer_here(PolyanyaSearch& search, const Ends& ends, std::size_t i, Answers& answers,
                   std::vector<Point>* path) const;
  /// Into what is preset with NaN.
  void measure(PolyanyaSearch& search, Point from, std::span<const Point> goals, double* lengths) const;

  Polyanya polyanya_;
  WrittenPlaces places_;
  std::shared_ptr<NoPath> no_path_;
  std::shared_ptr<std::mutex> mutex_;
  std::shared_ptr<std::vector<PolyanyaSearch>> idle_;
};

}  // namespace taut::python
