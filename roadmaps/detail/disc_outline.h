// The outline of a disc's places near a point: lines beside walls, circles around their ends, and where these cross.
// For doubles and for numbers of many digits. Private.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

namespace taut::detail {

/// A vector, from the point that was asked about.
template <class T>
struct Offset {
  T x;
  T y;
};

template <class T>
T dot(const Offset<T>& a, const Offset<T>& b) {
  return T(a.x * b.x + a.y * b.y);
}

template <class T>
T length(const Offset<T>& a) {
  using std::sqrt;
  return T(sqrt(dot(a, a)));
}

/// What a place can lie on.
template <class T>
struct OutlinePiece {
  bool round = false;
  Offset<T> a;  ///< the centre; or where the line begins
  Offset<T> b;  ///< where the line ends
  T radius = 0;
};

/// Candidates for the nearest place: what the piece has nearest to the origin, if that is inside the piece.
template <class T>
std::vector<Offset<T>> feet(const OutlinePiece<T>& piece) {
  if (piece.round) {
    const T far = length(piece.a);
    if (far == 0) return {{piece.radius, 0}, {T(-piece.radius), 0}, {0, piece.radius}, {0, T(-piece.radius)}};
    const T part = 1 - piece.radius / far;
    return {{T(piece.a.x * part), T(piece.a.y * part)}};
  }
  const Offset<T> u{T(piece.b.x - piece.a.x), T(piece.b.y - piece.a.y)};
  const T t = -dot(piece.a, u) / dot(u, u);
  if (t < 0 || t > 1) return {};
  return {{T(piece.a.x + t * u.x), T(piece.a.y + t * u.y)}};
}

namespace outline {

template <class T>
std::vector<Offset<T>> line_and_circle(const OutlinePiece<T>& line, const OutlinePiece<T>& circle, const T& tiny) {
  using std::sqrt;
  const Offset<T> u{T(line.b.x - line.a.x), T(line.b.y - line.a.y)};
  const Offset<T> v{T(circle.a.x - line.a.x), T(circle.a.y - line.a.y)};
  const T uu = dot(u, u), middle = dot(u, v) / uu;
  const T off = (u.x * v.y - u.y * v.x) * (u.x * v.y - u.y * v.x) / uu;
  T rest = circle.radius * circle.radius - off;
  if (rest < -tiny) return {};
  if (rest < tiny) rest = 0;
  const T half = sqrt(T(rest / uu));
  std::vector<Offset<T>> result;
  for (const T& t : {T(middle - half), T(middle + half)})
    result.push_back({T(line.a.x + t * u.x), T(line.a.y + t * u.y)});
  return result;
}

template <class T>
std::vector<Offset<T>> circles(const OutlinePiece<T>& s, const OutlinePiece<T>& t, const T& tiny) {
  const Offset<T> v{T(t.a.x - s.a.x), T(t.a.y - s.a.y)};
  const T d2 = dot(v, v);
  if (d2 <= tiny) return {};
  // Radii are equal, so both points lie on the line in the middle.
  const Offset<T> m{T(s.a.x + v.x / 2), T(s.a.y + v.y / 2)};
  const OutlinePiece<T> line{false, m, {T(m.x - v.y), T(m.y + v.x)}, 0};
  return line_and_circle(line, s, tiny);
}

template <class T>
std::vector<Offset<T>> lines(const OutlinePiece<T>& s, const OutlinePiece<T>& t, const T& tiny) {
  const Offset<T> u{T(s.b.x - s.a.x), T(s.b.y - s.a.y)}, w{T(t.b.x - t.a.x), T(t.b.y - t.a.y)};
  const T whole = u.x * w.y - u.y * w.x;
  if (whole * whole <= tiny * dot(u, u) * dot(w, w)) return {};
  const T along = ((t.a.x - s.a.x) * w.y - (t.a.y - s.a.y) * w.x) / whole;
  return {{T(s.a.x + along * u.x), T(s.a.y + along * u.y)}};
}

}  // namespace outline

/// Where two pieces cross, lines taken as endless; touching ones touch within `tiny`, a squared length.
template <class T>
std::vector<Offset<T>> crossings(const OutlinePiece<T>& s, const OutlinePiece<T>& t, const T& tiny) {
  if (s.round && t.round) return outline::circles(s, t, tiny);
  if (s.round) return outline::line_and_circle(t, s, tiny);
  if (t.round) return outline::line_and_circle(s, t, tiny);
  return outline::lines(s, t, T(0));
}

/// The line beside a wall from a to b: to its left (side 1) or right (-1).
template <class T>
OutlinePiece<T> beside(const Offset<T>& a, const Offset<T>& b, const T& r, int side) {
  const Offset<T> u{T(b.x - a.x), T(b.y - a.y)};
  const T part = side * r / length(u), x = -u.y * part, y = u.x * part;
  return {false, {T(a.x + x), T(a.y + y)}, {T(b.x + x), T(b.y + y)}, 0};
}

/// From the nearest point of the segment a b to q.
template <class T>
Offset<T> away_from(const Offset<T>& a, const Offset<T>& b, const Offset<T>& q) {
  const Offset<T> u{T(b.x - a.x), T(b.y - a.y)}, v{T(q.x - a.x), T(q.y - a.y)};
  const T uu = dot(u, u);
  T t = uu == 0 ? T(0) : T(dot(u, v) / uu);
  if (t < 0) t = 0;
  if (t > 1) t = 1;
  return {T(v.x - t * u.x), T(v.y - t * u.y)};
}

}  // namespace taut::detail
