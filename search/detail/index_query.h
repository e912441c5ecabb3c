// One query of an index.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <taut/search/detail/index_climb.h>
#include <taut/search/detail/index_parts.h>
#include <taut/search/detail/integer_sights.h>

namespace taut::detail {

/// One query after the other in the same memory.
///
/// Lengths are integers that are off by half of a unit at most each, so a sum over a hub by two. Whatever comes within
/// that of the least is unpacked and compared by its roots.
class IndexQuery {
 public:
  explicit IndexQuery(const IndexParts& parts);

  /// The points of the shortest path, none in line with its neighbours; none where there is none.
  void find(Point from, Point to, std::vector<Point>& path);
  std::size_t scanned() const { return scanned_; }

 private:
  /// A bend seen from an end, and what may follow there.
  struct Run {
    std::uint32_t begin, end;  // labels
    std::uint32_t length;      // from the end to the bend
    std::uint32_t bend;
    std::uint32_t turns = 0;  // TurnBits of a string from the end
    std::uint32_t least = 0;  // of the ways from the start that end with it
  };
  struct End {
    explicit End(const IndexParts& parts) : climb(parts) {}

    Point point;
    PlaceAt place;
    bool is_integer = false;
    std::vector<Run> runs;
    std::size_t count = 0;
    IndexClimb climb;  // where a core alone has labels
  };
  struct Best {
    std::uint32_t length = kFar;
    std::uint32_t label = 0;
  };
  /// From a bend that the start sees over a hub to one that the goal sees.
  struct Way {
    std::uint32_t from, to;         // labels
    std::uint32_t before;           // its part from the start to the hub may be so long
    std::uint32_t meeting = kNone;  // below the core: a bend instead of labels
  };

  static constexpr std::uint32_t kFar = std::uint32_t{1} << 31;
  static constexpr std::uint32_t kDoubtUnits = 5;

  void settle(End& end, Point point, const char* role) const;
  bool is_seen(const End& from, const End& to) const;
  void look_around(End& end);
  void look_in(End& end, std::uint32_t triangle) const;
  void climb(End& end) const;
  void spread_from();
  void meet_to();
  void meet_below();
  void collect();
  void collect_ties();
  void forget();
  void unpack(const Way& way, std::vector<std::uint32_t>& bends);
  void unpack(End& end, std::uint32_t label, std::vector<std::uint32_t>& bends) const;
  const IndexImage::Edge& core_edge(std::uint32_t bend, std::uint32_t label) const;
  void give(const std::vector<std::uint32_t>& bends, std::vector<Point>& path) const;
  bool is_shorter(const std::vector<Point>& a, const std::vector<Point>& b);

  const IndexParts& parts_;
  double per_place_ = 0;  // units of length for one of places
  End from_, to_;
  std::optional<IntegerSights> sights_;  // where there are integers, but no lists
  std::vector<Best> best_;               // by hub
  std::uint32_t least_ = kFar;
  bool has_ties_ = false;  // two bends from which a hub is equally far
  std::vector<Way> ways_;
  struct Meeting {
    std::uint32_t bend, length;
  };
  std::vector<Meeting> meetings_;
  std::vector<std::uint32_t> bends_, other_bends_, part_;
  std::vector<Point> other_;
  std::vector<Segment> legs_a_, legs_b_;
  std::size_t scanned_ = 0;
};

}  // namespace taut::detail
