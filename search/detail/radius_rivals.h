// Ways that may become shorter than the best one as a disc grows. Private.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <taut/search/detail/arc_ends.h>
#include <taut/search/detail/arc_walk.h>
#include <taut/search/detail/disc_word.h>

namespace taut::detail {

/// Looks in the graph of one radius a for all classes that can have the shortest way for some radius up to b.
///
/// A class that a disc of radius r > a gets along has a word at a, a way in the graph, and its length for r is not less
/// than that of this word, nor than the word's tangent in a: legs as long as at a, arcs on circles of radius r. Should
/// the tangent be longer at b than the best way, then so it is for all radii between, as lengths are convex. What is
/// left is followed with its length as a function of the radius; of ways to one tangent point that differ by a
/// straight line, or whose tangent lies above the other's chord, one is kept (docs/tradeoff.md).
class RadiusRivals {
 public:
  /// The best way keeps to this word from a on, as long as it can.
  RadiusRivals(const TangentParts& graph, const DiscWords& words, DiscWord best);

  /// Words of ways that may be shorter than `length` (the best one's at b) before b; nothing when they are too many to
  /// tell.
  std::optional<std::vector<DiscWord>> until(double b, double length);

 private:
  struct Label {
    std::uint32_t node = kNone, before = kNone;
    double here = 0;             ///< the length at a
    double tangent = 0;          ///< at b
    double there = 0;            ///< the word's at b
    std::uint64_t legs = 0;      ///< a sum over the legs that turn: equal for equal ones
    std::uint32_t best = kNone;  ///< how many stops of the best way it has made, having made no other; or kNone
    bool passing = false;        ///< this is not one of them, unless it is passed straight
    bool dropped = false;
  };
  struct Step {
    double leg = 0, arc = 0;
    double square = 0, k = 0;
  };

  void measure(double b, double most);
  void add(const Label& from, std::uint32_t index, std::uint32_t node, const Step& step);
  bool is_dominated(const Label& label);
  double grown(double square, double k) const;
  Step step(std::uint32_t from, std::uint32_t to, double length) const;
  Step end_step(const ArcEndLeg& leg, Point end, double whole) const;
  void follow_best(const Label& from, Label& label) const;
  DiscWord word(std::uint32_t label, const ArcExit& exit) const;
  int side_of(std::uint32_t node) const;

  const TangentParts& graph_;
  const DiscWords& words_;
  DiscWord best_;
  double a_, b_ = 0, most_ = 0, slack_ = 0;
  ArcWalk walk_;
  ArcEnds ends_;
  std::vector<double> left_;  // the tangents' least length from each node to the goal
  std::vector<Label> labels_;
  std::vector<std::vector<std::uint32_t>> at_;  // labels of each node
  std::vector<std::uint32_t> used_;             // nodes with labels
  std::vector<std::pair<double, std::uint32_t>> open_;
};

}  // namespace taut::detail
