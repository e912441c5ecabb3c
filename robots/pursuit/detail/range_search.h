// What the exact planner does with one range of the cheapest cell's cost.
#pragma once

#include <vector>

#include <taut/robots/pursuit/detail/reduced.h>

namespace taut::pursuit::detail {

/// Bounds of a range, meeting by meeting.
///
/// For each u <= lo a meeting after t seconds has the bound (*), a concave function of u that the way found for it is a
/// tangent of. Where that way is in time at u = lo, nothing can raise the bound; where it is late a smaller u can, as
/// it makes moves dearer than seconds (Handler and Zang, "A dual algorithm for the constrained shortest path problem",
/// 1980). Meetings whose bound reaches the best plan's cost are done with; what remains late goes to search_labels. One
/// search serves all meetings.
class RangeSearch {
 public:
  /// Both are kept by reference. `meetings` ascending.
  RangeSearch(const Workspace& work, const std::vector<Meeting>& meetings)
      : worker{work}, meetings_(meetings), forward_(worker) {}

  struct Answer {
    Cost bound = kNoCost;        ///< of all meetings; kNoCost: nothing here is better than the best plan
    std::uint32_t cheapest = 0;  ///< of the cells of the way of that bound
    bool is_open = false;        ///< too many labels: the bound may be no way's
    std::vector<Cost> bounds{};  ///< of each meeting, for parts of the range
  };

  /// `bounds`: what is known of each meeting.
  void begin(const CostRange& range, std::vector<Cost> bounds);
  void pass(Cost u);                       ///< one search; u in parts
  void absorb(const RangeSearch& beside);  ///< what another search has found about the same range
  Answer finish(
      std::size_t most_labels);  ///< further searches, the one with labels if any are granted. After pass(parts * lo)

  void release() { forward_.release(); }  ///< the memory; after the last question

  /// Below which no way of the range costs less, as far as it is known; also after a search was stopped.
  Cost bound_so_far() const;

  Cost guess() const;  ///< for the u of a further pass, when it is not known which meeting needs it

  Worker worker;

 private:
  /// A way as a function of u: its bound (*) is moves_cost + slack * u.
  struct Line {
    Cost moves_cost = 0;
    Cost slack = 0;  // seconds - moves; negative: not in time
  };
  struct Subject {
    Cost bound = 0;
    Cost best_u = 0;       // where the bound is that high
    bool is_done = false;  // in time at u = lo
    Line late{0, 0}, early{0, -1};
  };

  bool is_live(const Subject& s) const { return !s.is_done && s.bound < worker.upper(); }
  std::vector<Meeting> live() const;
  Cost lo() const { return worker.work.parts * range_.lo; }
  void note(std::size_t i, Cost u, const Reach& reach);
  bool descend();
  Cost mean_cost() const;

  const std::vector<Meeting>& meetings_;
  ForwardSearch forward_;
  CostRange range_;
  std::vector<Subject> subjects_;
  std::vector<int> latest_;  // for the meetings that a first search left
  std::vector<Cost> tried_;
  Answer answer_;
};

}  // namespace taut::pursuit::detail
