// The nearest places of a disc, as candidates. Private.
#pragma once

#include <taut/geometry/exact/numbers.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <vector>

#include <taut/roadmaps/detail/disc_outline.h>
#include <taut/roadmaps/wall_index.h>

namespace taut::detail {

/// Where a place may be, relative to the point asked about: known to some 60 digits.
struct DiscCandidate {
  Offset<BigFloat> at;
  double distance = 0;      ///< from that point, rounded down
  Offset<double> outwards;  ///< away from what it touches
};

/// Looks for the places nearest to p among squares around it. `offer` is shown candidates that keep their distance, to
/// some 40 digits, and says how far the best place is so far; squares beyond are left out.
class DiscSearch {
 public:
  DiscSearch(const WallIndex& walls, double r, Point p);

  void run(const std::function<double(const DiscCandidate&)>& offer);

 private:
  struct Piece {
    Offset<double> a, b;
    std::uint32_t constraint = kNone;
    bool opening = false;
  };
  struct Square {
    Offset<double> centre;
    double half = 0;
    double distance = 0;
    std::size_t number = 0;
    std::vector<std::uint32_t> pieces;

    friend bool operator<(const Square& a, const Square& b) {
      return a.distance != b.distance ? a.distance > b.distance : a.number > b.number;
    }
  };
  enum class Shape : std::uint8_t { left, right, around_a, around_b, along, at_a, at_b };
  struct Curve {
    std::uint32_t piece;
    Shape shape;
  };
  struct Made {
    Curve s;
    std::optional<Curve> t;  // crossed with
    std::size_t solution = 0;
  };

  bool is_covered(Square& square) const;
  void split(const Square& square);
  void push(Offset<double> centre, double half, const std::vector<std::uint32_t>& pieces);
  std::vector<Curve> curves(const Square& square) const;
  void examine(const Square& square);
  void examine(const Square& square, const Made& made, const Offset<double>& q);
  void take_free(const Square& square);
  bool keeps_distance(const Offset<BigFloat>& q, const std::vector<std::uint32_t>& pieces) const;
  Offset<double> outwards(const Offset<double>& q, const std::vector<std::uint32_t>& pieces) const;
  bool is_outside(const Offset<double>& q, const std::vector<std::uint32_t>& pieces) const;
  void offer(const Offset<BigFloat>& q, const std::vector<std::uint32_t>& pieces);

  template <class T>
  Offset<T> relative(Point q) const;
  template <class T>
  T radius() const;
  template <class T>
  OutlinePiece<T> outline(const Curve& curve) const;
  template <class T>
  std::vector<Offset<T>> solutions(const Curve& s, const std::optional<Curve>& t) const;

  const WallIndex& walls_;
  double r_;
  Point p_;
  std::vector<Piece> pieces_;
  std::priority_queue<Square> open_;
  std::size_t numbered_ = 0;
  double reach_ = 0;  // of the offsets, for what doubles lose
  double best_;
  const std::function<double(const DiscCandidate&)>* offer_ = nullptr;
};

}  // namespace taut::detail
