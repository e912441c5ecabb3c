#include <taut/roadmaps/exact/tangent_parts.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace taut {

namespace {

/// Candidates are pairs of sites that see each other within both's taut cones.
std::vector<FoundTangent> all_tangents(const TangentGround& ground, double r, const TellProgress& tell) {
  std::vector<FoundTangent> result;
  const std::vector<TangentSite>& sites = ground.sites;
  ProgressCount done("circles", sites.size(), tell);
  for (std::uint32_t i = 0; i < sites.size(); ++i, done.add())
    for (const std::uint32_t v : ground.walls.seen_from_vertex(sites[i].vertex, sites[i].cones.reaching(r))) {
      const std::uint32_t j = ground.site_at[v];
      if (j == kNone || j <= i || sites[j].vertex == sites[i].vertex) continue;
      const Point back{sites[i].at.x - sites[j].at.x, sites[i].at.y - sites[j].at.y};
      if (!sites[j].cones.reaching(r).may_lead(back)) continue;
      for (TangentPair& pair : free_tangents(ground.walls, r, sites[i], sites[j]))
        result.push_back({{i, j, pair.from.here.side, -pair.to.here.side}, pair});
    }
  return result;
}

/// Insertion: for what is nearly in order, as what doubles have sorted.
template <class Iterator, class Before>
void sort_again(Iterator first, Iterator last, Before before) {
  for (Iterator at = first; at != last; ++at)
    for (Iterator to = at; to != first && before(*to, *(to - 1)); --to) std::swap(*to, *(to - 1));
}

}  // namespace

bool same_point(const TangentPoint& a, const TangentPoint& b) { return cross_sign(a, b) == 0 && dot_sign(a, b) > 0; }

bool is_before(const TangentPoint& p, const TangentPoint& q, const TangentSite& site) {
  const int turn = cross_sign(p, q);
  if (turn != 0 || dot_sign(p, q) > 0) return turn > 0;
  return cross_sign(p, PlainDirection(site.at, site.walls.front(), 0)) < 0;
}

void SiteOrder::put(const TangentSite& site, std::span<const TangentPoint> ends) {
  order.clear();
  is_first.assign(ends.size(), 0);
  if (!is_first.empty()) is_first[0] = 1;
  for (std::uint32_t e = 0; e < ends.size(); ++e) order.push_back(e);
  if (!site.round) return;
  // They lie across from the walls, within half a turn: from a wall on counter-clockwise their sines fall.
  const Point wall{site.walls.front().x - site.at.x, site.walls.front().y - site.at.y};
  sines_.clear();
  for (const std::uint32_t e : order) sines_.emplace_back(ends[e].x.middle() * wall.y - ends[e].y.middle() * wall.x, e);
  std::sort(sines_.begin(), sines_.end());
  for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = sines_[k].second;
  sort_again(order.begin(), order.end(),
             [&](std::uint32_t a, std::uint32_t b) { return is_before(ends[a], ends[b], site); });
  for (std::uint32_t k = 0, behind = 0; k < order.size(); k = behind) {
    is_first[k] = 1;
    for (behind = k + 1; behind < order.size() && same_point(ends[order[k]], ends[order[behind]]);) ++behind;
    std::sort(order.begin() + k, order.begin() + behind);
  }
}

TangentParts::TangentParts(std::shared_ptr<const TangentGround> common, double radius, const TellProgress& tell)
    : TangentParts(common, radius, all_tangents(*common, radius, tell),
                   [&, obstacles = CircleObstacles()](std::uint32_t i) mutable -> const CircleObstacles& {
                     return obstacles = common->walls.around(common->sites[i].at, radius);
                   }) {}

TangentParts::TangentParts(std::shared_ptr<const TangentGround> common, double radius,
                           const std::vector<FoundTangent>& tangents,
                           const std::function<const CircleObstacles&(std::uint32_t)>& around)
    : r(radius), ground(std::move(common)) {
  std::vector<std::uint32_t> point_of(2 * tangents.size());
  put_in_order(tangents, point_of);
  find_arcs(around);
  sort_legs(tangents, point_of);
}

/// point_of: of the ends of each tangent.
void TangentParts::put_in_order(const std::vector<FoundTangent>& tangents, std::vector<std::uint32_t>& point_of) {
  const std::size_t count = sites().size();
  const auto end = [&](std::uint32_t e) -> const TangentPoint& {
    return e % 2 == 0 ? tangents[e / 2].ends.from : tangents[e / 2].ends.to;
  };
  const auto site = [&](std::uint32_t e) { return e % 2 == 0 ? tangents[e / 2].name.from : tangents[e / 2].name.to; };
  std::vector<std::uint32_t> first(count + 1), order(2 * tangents.size());
  for (std::uint32_t e = 0; e < order.size(); ++e) ++first[site(e) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> next = first;
  for (std::uint32_t e = 0; e < order.size(); ++e) order[next[site(e)]++] = e;
  first_point.reserve(count + 1);
  points.reserve(order.size());
  site_of.reserve(order.size());
  std::vector<TangentPoint> here;
  SiteOrder around;
  for (std::uint32_t i = 0; i < count; ++i) {
    here.clear();
    for (std::uint32_t k = first[i]; k < first[i + 1]; ++k) here.push_back(end(order[k]));
    around.put(sites()[i], here);
    first_point.push_back(static_cast<std::uint32_t>(points.size()));
    for (std::uint32_t k = 0; k < here.size(); ++k) {
      if (around.is_first[k]) {
        points.push_back(here[around.order[k]]);
        site_of.push_back(i);
      }
      point_of[order[first[i] + around.order[k]]] = static_cast<std::uint32_t>(points.size() - 1);
    }
  }
  first_point.push_back(static_cast<std::uint32_t>(points.size()));
}

void TangentParts::find_arcs(const std::function<const CircleObstacles&(std::uint32_t)>& around) {
  arc_is_free.assign(points.size(), 0);
  for (std::uint32_t i = 0; i < sites().size(); ++i) {
    const std::uint32_t first = first_point[i], end = first_point[i + 1];
    if (!sites()[i].round || end - first < 2) continue;
    const CircleObstacles& obstacles = around(i);
    for (std::uint32_t p = first; p + 1 < end; ++p) {
      arc_is_free[p] = walls().arc_is_free(points[p], points[p + 1], obstacles);
      arcs += arc_is_free[p];
    }
  }
}

void TangentParts::sort_legs(const std::vector<FoundTangent>& tangents, const std::vector<std::uint32_t>& point_of) {
  first_leg.assign(points.size() + 1, 0);
  for (const std::uint32_t p : point_of) ++first_leg[p + 1];
  std::partial_sum(first_leg.begin(), first_leg.end(), first_leg.begin());
  std::vector<std::uint32_t> next(first_leg.begin(), first_leg.end() - 1);
  legs.resize(point_of.size());
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    const std::uint32_t from = point_of[2 * i], to = point_of[2 * i + 1];
    const int s = tangents[i].name.from_side, t = tangents[i].name.to_side;
    legs[next[from]++] = {from, to, s, t, tangents[i].ends.length};
    legs[next[to]++] = {to, from, -t, -s, tangents[i].ends.length};
  }
}

}  // namespace taut
