#include <taut/robots/bug/detail/place.h>

namespace taut::bug::detail {

ContourPlace ContourPlaces::at(const Stand& stand) const {
  const bool vertex = stand.kind == Stand::Kind::vertex;
  const Contours::At at = vertex ? contours_.at(tri_.sectors[stand.sector]) : contours_.at(stand.t, stand.i);
  return {at.contour, 2 * at.edge + (vertex ? 0 : 1), stand};
}

ContourPlace ContourPlaces::vertex(Contours::At at) const {
  const HalfEdge e = contours_.edges(at.contour)[at.edge];
  return {at.contour, 2 * at.edge, {Stand::Kind::vertex, e.t, 0, contours_.sector(at), ExactPoint(contours_.tail(at))}};
}

ContourPlace ContourPlaces::side(Contours::At at, ExactPoint x) const {
  const HalfEdge e = contours_.edges(at.contour)[at.edge];
  return {at.contour, 2 * at.edge + 1, {Stand::Kind::side, e.t, e.i, kNone, std::move(x)}};
}

ContourPlace ContourPlaces::on(Contours::At at, const ExactPoint& x) const {
  if (x == ExactPoint(contours_.tail(at))) return vertex(at);
  if (x == ExactPoint(contours_.head(at))) return next_vertex(side(at, x), Turn::left);
  return side(at, x);
}

ContourPlace ContourPlaces::next_vertex(const ContourPlace& from, Turn turn) const {
  const std::uint32_t at = station(from, from.is_vertex() ? 2 : 1, turn);
  return vertex({from.contour, at / 2});
}

Contours::At ContourPlaces::ahead(const ContourPlace& from, Turn turn) const {
  if (turn == Turn::left || !from.is_vertex()) return from.edge();
  return {from.contour, station(from, 1, turn) / 2};
}

bool ContourPlaces::is_ahead(const ContourPlace& a, const ContourPlace& b) const {
  const ExactPoint tail(contours_.tail(a.edge()));
  return squared_distance(a.stand.at, tail) < squared_distance(b.stand.at, tail);
}

}  // namespace taut::bug::detail
