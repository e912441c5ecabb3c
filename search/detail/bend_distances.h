// How far all bends of a visibility graph are from one place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include <taut/search/detail/taut_legs.h>

namespace taut::detail {

/// Dijkstra's algorithm along taut legs, from one place after the other in the same memory. Lengths are sums of two
/// doubles and compared as such where doubles do not tell; a vertex that turns out to be nearer is taken up again, so
/// order decides nothing. A copy, for another thread, shares the legs.
class BendDistances {
 public:
  explicit BendDistances(const VisibilityGraph& graph);

  /// The way from the place to a vertex that it is joined to.
  struct Leg {
    std::uint32_t to;
    twofold::Pair length;
  };

  void from(std::span<const Leg> legs);

  std::size_t size() const { return at_.size(); }
  /// Infinite where there is no way.
  twofold::Pair operator[](std::size_t v) const { return at_[v]; }

 private:
  static constexpr twofold::Pair kFar{std::numeric_limits<double>::infinity(), 0};
  static constexpr std::size_t kPlace = static_cast<std::size_t>(-1);  // a vertex reached from the place itself

  struct Open {
    double bound;
    std::uint32_t vertex;
  };

  void follow(twofold::Pair here, TautLegs::Range range);
  void reach(std::uint32_t v, twofold::Pair length, std::size_t leg);
  void aim(std::span<const Leg> legs);
  void push(const Open& open);
  bool take(Open& next);

  std::shared_ptr<const TautLegs> shared_;
  const TautLegs& legs_;  // those
  std::vector<twofold::Pair> at_;
  std::vector<std::size_t> via_;  // by vertex: the leg that it was reached by

  // The queue: what is nearer than `width_` to each other is taken in any order. No leg spans all of it.
  static constexpr std::size_t kBuckets = 4096;
  std::vector<std::vector<Open>> open_;  // by bound / width_, modulo kBuckets
  std::size_t now_ = 0;                  // bound / width_ of the bucket that is being emptied
  std::size_t size_ = 0;
  double longest_ = 0, mean_ = 0;  // of the legs
  double width_ = 1;
};

}  // namespace taut::detail
