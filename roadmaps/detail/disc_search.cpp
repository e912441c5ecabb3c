#include <taut/roadmaps/detail/disc_search.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include <taut/geometry/exact/exact_point.h>

namespace taut::detail {

namespace {

constexpr std::size_t kFew = 6;       // pieces whose curves are crossed pair by pair
constexpr double kFinest = 1.0 / 64;  // of the radius: no smaller squares

double distance_to(const Offset<double>& a, const Offset<double>& b, const Offset<double>& q) {
  return length(away_from(a, b, q));
}

double distance_to_square(const Offset<double>& centre, double half) {
  return std::hypot(std::max(0.0, std::abs(centre.x) - half), std::max(0.0, std::abs(centre.y) - half));
}

}  // namespace

template <class T>
Offset<T> DiscSearch::relative(Point q) const {
  if constexpr (std::is_same_v<T, double>)
    return {q.x - p_.x, q.y - p_.y};
  else
    return {big_float(Rational(meaning(q.x) - meaning(p_.x))), big_float(Rational(meaning(q.y) - meaning(p_.y)))};
}

template <class T>
T DiscSearch::radius() const {
  if constexpr (std::is_same_v<T, double>)
    return r_;
  else
    return big_float(meaning(r_));
}

template <class T>
OutlinePiece<T> DiscSearch::outline(const Curve& curve) const {
  const Segment s = walls_.segment(pieces_[curve.piece].constraint);
  const Offset<T> a = relative<T>(s.a), b = relative<T>(s.b);
  switch (curve.shape) {
    case Shape::left: return beside(a, b, radius<T>(), 1);
    case Shape::right: return beside(a, b, radius<T>(), -1);
    case Shape::around_a: return {true, a, a, radius<T>()};
    case Shape::around_b: return {true, b, b, radius<T>()};
    default: return {false, a, b, radius<T>()};
  }
}

template <class T>
std::vector<Offset<T>> DiscSearch::solutions(const Curve& s, const std::optional<Curve>& t) const {
  const OutlinePiece<T> piece = outline<T>(s);
  if (s.shape == Shape::at_a) return {piece.a};
  if (s.shape == Shape::at_b) return {piece.b};
  if (!t) return feet(piece);
  const T r = radius<T>();
  T tiny = r * r;
  if constexpr (std::is_same_v<T, double>)
    tiny *= 1e-9;
  else
    tiny = halved(tiny, 200);
  return crossings(piece, outline<T>(*t), tiny);
}

DiscSearch::DiscSearch(const WallIndex& walls, double r, Point p)
    : walls_(walls), r_(r), p_(p), best_(std::numeric_limits<double>::infinity()) {
  std::vector<std::uint32_t> all;
  Offset<double> low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};
  for (std::uint32_t c = 0; c < walls.ends().size(); ++c) {
    const Segment s = walls.segment(c);
    pieces_.push_back({relative<double>(s.a), relative<double>(s.b), c, walls.is_opening(c)});
    all.push_back(c);
    for (const Offset<double>& q : {pieces_.back().a, pieces_.back().b}) {
      low = {std::min(low.x, q.x), std::min(low.y, q.y)};
      high = {std::max(high.x, q.x), std::max(high.y, q.y)};
    }
  }
  if (all.empty()) return;
  reach_ = std::max({std::abs(low.x), std::abs(low.y), std::abs(high.x), std::abs(high.y), std::abs(p.x) * 1e-3,
                     std::abs(p.y) * 1e-3, r});
  push({(low.x + high.x) / 2, (low.y + high.y) / 2}, 0.5001 * std::max(high.x - low.x, high.y - low.y), all);
}

void DiscSearch::run(const std::function<double(const DiscCandidate&)>& offer) {
  offer_ = &offer;
  while (!open_.empty() && open_.top().distance < best_) {
    Square square = open_.top();
    open_.pop();
    if (is_covered(square)) continue;
    if (square.pieces.empty())
      take_free(square);
    else if (square.pieces.size() <= kFew || square.half < kFinest * r_)
      examine(square);
    else
      split(square);
  }
}

/// Leaves the pieces that concern the square; true when one wall is near all of it.
bool DiscSearch::is_covered(Square& square) const {
  const double slack = 1e-12 * reach_, diagonal = square.half * 1.4142136;
  std::vector<std::uint32_t> near;
  for (const std::uint32_t i : square.pieces) {
    const Piece& piece = pieces_[i];
    const double distance = distance_to(piece.a, piece.b, square.centre), keep = piece.opening ? 0 : r_;
    if (distance + diagonal < keep - slack) return true;
    if (distance - diagonal <= keep + slack) near.push_back(i);
  }
  square.pieces = std::move(near);
  return false;
}

void DiscSearch::split(const Square& square) {
  const double h = square.half / 2;
  for (const auto& [x, y] : {std::pair{-h, -h}, {h, -h}, {-h, h}, {h, h}})
    push({square.centre.x + x, square.centre.y + y}, h, square.pieces);
}

void DiscSearch::push(Offset<double> centre, double half, const std::vector<std::uint32_t>& pieces) {
  open_.push({centre, half, distance_to_square(centre, half * (1 + 1e-9)), numbered_++, pieces});
}

/// No wall is near: all of it is free, or none.
void DiscSearch::take_free(const Square& square) {
  const Point centre{p_.x + square.centre.x, p_.y + square.centre.y};
  if (walls_.space().locate(centre).kind == Location::Kind::outside) return;
  const auto nearest = [&](double c) {
    return c > square.half ? c - square.half : c < -square.half ? c + square.half : 0;
  };
  offer({big_float(Rational(nearest(square.centre.x))), big_float(Rational(nearest(square.centre.y)))}, square.pieces);
}

std::vector<DiscSearch::Curve> DiscSearch::curves(const Square& square) const {
  std::vector<Curve> result;
  std::vector<Point> centres;
  const auto add_centre = [&](Point q, Curve curve) {
    if (std::ranges::find(centres, q) != centres.end()) return;
    centres.push_back(q);
    result.push_back(curve);
  };
  for (const std::uint32_t i : square.pieces) {
    const Segment s = walls_.segment(pieces_[i].constraint);
    if (pieces_[i].opening) {
      for (const Shape shape : {Shape::along, Shape::at_a, Shape::at_b}) result.push_back({i, shape});
      continue;
    }
    result.push_back({i, Shape::left});
    result.push_back({i, Shape::right});
    add_centre(s.a, {i, Shape::around_a});
    add_centre(s.b, {i, Shape::around_b});
  }
  return result;
}

void DiscSearch::examine(const Square& square) {
  const std::vector<Curve> all = curves(square);
  const auto is_point = [](const Curve& c) { return c.shape == Shape::at_a || c.shape == Shape::at_b; };
  const auto examine_all = [&](const Curve& s, const std::optional<Curve>& t) {
    const std::vector<Offset<double>> found = solutions<double>(s, t);
    for (std::size_t k = 0; k < found.size(); ++k) examine(square, {s, t, k}, found[k]);
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    examine_all(all[i], std::nullopt);
    if (is_point(all[i])) continue;
    for (std::size_t j = 0; j < i; ++j)
      if (!is_point(all[j])) examine_all(all[i], all[j]);
  }
}

/// A candidate as doubles see it; what they would let pass is looked at with many digits.
void DiscSearch::examine(const Square& square, const Made& made, const Offset<double>& q) {
  const double slack = 1e-12 * reach_ + 1e-6 * r_, around = square.half * 1.001 + slack;
  if (std::abs(q.x - square.centre.x) > around || std::abs(q.y - square.centre.y) > around) return;
  if (length(q) > best_ + slack) return;
  for (const std::uint32_t i : square.pieces)
    if (const Piece& piece = pieces_[i]; !piece.opening && distance_to(piece.a, piece.b, q) < r_ - slack) return;
  const std::vector<Offset<BigFloat>> fine = solutions<BigFloat>(made.s, made.t);
  if (made.solution < fine.size() && keeps_distance(fine[made.solution], square.pieces))
    offer(fine[made.solution], square.pieces);
}

bool DiscSearch::keeps_distance(const Offset<BigFloat>& q, const std::vector<std::uint32_t>& pieces) const {
  const BigFloat r = radius<BigFloat>();
  BigFloat least = r * r;
  least -= halved(least, 130);
  return std::ranges::all_of(pieces, [&](std::uint32_t i) {
    if (pieces_[i].opening) return true;
    const Segment s = walls_.segment(pieces_[i].constraint);
    const Offset<BigFloat> away = away_from(relative<BigFloat>(s.a), relative<BigFloat>(s.b), q);
    return dot(away, away) >= least;
  });
}

Offset<double> DiscSearch::outwards(const Offset<double>& q, const std::vector<std::uint32_t>& pieces) const {
  const double slack = 1e-12 * reach_ + 1e-6 * r_;
  Offset<double> sum{0, 0};
  const auto add = [&](const Offset<double>& v) {
    if (const double size = length(v); size > 0) sum = {sum.x + v.x / size, sum.y + v.y / size};
  };
  for (const std::uint32_t i : pieces) {
    const Piece& piece = pieces_[i];
    const Offset<double> away = away_from(piece.a, piece.b, q);
    if (!piece.opening && length(away) < r_ + slack) add(away);
    if (!piece.opening || length(away) > slack) continue;
    const double side = walls_.space().constraints()[piece.constraint].solid_left ? -1 : 1;
    add({side * (piece.a.y - piece.b.y), side * (piece.b.x - piece.a.x)});
  }
  const double size = length(sum);
  return size > 0 ? Offset<double>{sum.x / size, sum.y / size} : sum;
}

/// Beyond a wall, in an obstacle or outside the world. On an opening doubles may not tell.
bool DiscSearch::is_outside(const Offset<double>& q, const std::vector<std::uint32_t>& pieces) const {
  const double slack = 1e-12 * reach_ + 1e-6 * r_;
  const bool at_opening = std::ranges::any_of(pieces, [&](std::uint32_t i) {
    return pieces_[i].opening && distance_to(pieces_[i].a, pieces_[i].b, q) <= slack;
  });
  return !at_opening && walls_.space().locate({p_.x + q.x, p_.y + q.y}).kind == Location::Kind::outside;
}

void DiscSearch::offer(const Offset<BigFloat>& q, const std::vector<std::uint32_t>& pieces) {
  const double distance = to_double(length(q));
  if (distance > best_ || is_outside({to_double(q.x), to_double(q.y)}, pieces)) return;
  best_ = (*offer_)({q, distance, outwards({to_double(q.x), to_double(q.y)}, pieces)});
}

}  // namespace taut::detail
