// The way of a disc by the corners that it bends around, for any radius: when it is free, how long it is. Private.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <taut/roadmaps/exact/tangent_parts.h>
#include <taut/search/length_formula.h>

namespace taut::detail {

struct WordStop {
  std::uint32_t site = kNone;
  int side = 0;  ///< ArcBend::turn

  friend bool operator==(const WordStop&, const WordStop&) = default;
};
using DiscWord = std::vector<WordStop>;

/// Words of ways between two places. A word is that of a shortest way of its homotopy class for some radius. While r
/// grows a class gains corners until a gate on it closes, and turns ever more around those that it has; only corners of
/// openings, which are no circles, can be lost again (docs/tradeoff.md).
class DiscWords {
 public:
  DiscWords(std::shared_ptr<const TangentGround> ground, Point s, Point g);

  /// Can the disc follow it? Exact.
  bool is_free(const DiscWord& word, double r) const;
  /// The largest double up to `most` to which the word's class keeps the word. Precondition: it is free for `from`.
  double last_free(const DiscWord& word, double from, double most) const;
  /// The word of the same class just above last_free(); nothing when the class ends there.
  std::optional<DiscWord> beyond(const DiscWord& word, double last) const;

  ArcPath path(const DiscWord& word, double r) const;
  /// A search's answer; nothing when a corner is not known.
  std::optional<DiscWord> word_of(const ArcPath& path) const;
  bool passes_corner_of_openings(const DiscWord& word) const;

  Point start() const { return s_.at; }
  Point goal() const { return g_.at; }

 private:
  const TangentSite& at(const DiscWord& word, std::size_t i) const;
  static int side(const DiscWord& word, std::size_t i);
  bool leg_is_free(const DiscWord& word, std::size_t i, double r) const;
  bool arc_is_free(const DiscWord& word, std::size_t i, double r, bool may_be_none) const;
  bool keeps_turning(const DiscWord& word, std::size_t i, double r, int turn) const;
  int turn_at(const DiscWord& word, std::size_t i, double r) const;
  bool part_is_free(const DiscWord& word, std::size_t part, double r, const std::vector<int>& turns) const;
  std::vector<WordStop> touched_by(const DiscWord& word, std::size_t leg, double r) const;
  bool fill(DiscWord& word, std::size_t at, const std::vector<WordStop>& all, std::size_t next, double r) const;

  std::shared_ptr<const TangentGround> ground_;
  TangentSite s_, g_;
};

}  // namespace taut::detail
