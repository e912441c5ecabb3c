// Whether a disc gets from a start to a goal, how large it may be, and what stops a larger one.
#pragma once

#include <optional>
#include <vector>

#include <taut/search/barrier.h>
#include <taut/search/disc_passage.h>
#include <taut/search/passage_index.h>

namespace taut {

struct Passage {
  Point start;
  Point goal;                           ///< of several, the one to which the largest disc gets; the first of equals
  std::optional<double> radius;         ///< that was asked about
  std::optional<WidestPassage> widest;  ///< absent: not even a point gets through, or to no goal
  std::optional<DiscPassage> asked;     ///< of `radius`
  Barrier barrier;                      ///< against `radius`, else against any larger disc, else against a point

  bool gets_through() const { return asked ? asked->status == DiscStatus::found : widest.has_value(); }
  /// What does not get through has a chain of walls and gates in its way; without one nothing is proven.
  bool is_proven() const { return gets_through() || !barrier.walls.empty() || !barrier.gates.empty(); }
};

/// Precondition: there are goals, and start and goals are not outside. O(n) a goal, nearly.
Passage passage(const Gates& gates, Point start, const std::vector<Point>& goals, std::optional<double> radius = {});

/// The same by an index: O(1) a goal, nearly, and one chain for the barrier.
Passage passage(const PassageIndex& index, Point start, const std::vector<Point>& goals,
                std::optional<double> radius = {});

/// Passage::goal. The same precondition.
Point widest_goal(const Gates& gates, Point start, const std::vector<Point>& goals);

}  // namespace taut
