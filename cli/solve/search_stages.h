// What the queries of a batch are searched on.
#pragma once

#include <cstddef>
#include <vector>

#include <taut/cli/solve/batch_answers.h>
#include <taut/search/polyanya.h>

namespace taut::cli {

/// The mesh; then, once searches have looked at about as much as making it takes, with the graph; then with landmarks:
/// if paths wind. Where they are hardly longer than straight lines a corner has many legs, and landmarks say nothing
/// that those lines do not. Only the first kWeighed answers decide, in their order, so whoever knows those knows what
/// each query is searched on.
class SearchStages {
 public:
  static constexpr std::size_t kWeighed = 4096;

  SearchStages(Polyanya mesh, unsigned jobs) : made_{std::move(mesh)}, from_{0}, jobs_(jobs) {}

  const Polyanya& now() const { return made_.back(); }
  std::size_t stage() const { return made_.size() - 1; }
  /// The stage of the query after `number` others.
  std::size_t stage_of(std::size_t number) const;
  const Polyanya& operator[](std::size_t stage) const { return made_[stage]; }

  /// One more answer: is it time to go on?
  bool weigh(const QueryAnswer& answer);
  /// Where there is no memory for it, things stay as they are. Gives the CPU seconds.
  Seconds go_on();
  /// Nothing that is still weighed could change it.
  bool is_settled() const { return weighed_ >= kWeighed || made_.back().has_landmarks() || is_full_; }

 private:
  std::vector<Polyanya> made_;     // by stage
  std::vector<std::size_t> from_;  // the number of its first query
  unsigned jobs_;
  bool is_full_ = false;  // there was no memory
  std::size_t weighed_ = 0, nodes_ = 0;
  double lengths_ = 0, straight_ = 0;
};

}  // namespace taut::cli
