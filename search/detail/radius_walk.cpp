#include <taut/search/detail/radius_walk.h>

namespace taut::detail {

RadiusWalk::RadiusWalk(const AllRadiiParts& parts, double r)
    : parts_(parts),
      r_(r),
      sites_(parts.ground->sites.size()),
      point_of_(2 * parts.legs.size()),
      has_(parts.legs.size(), -1) {}

bool RadiusWalk::has(std::uint32_t leg) {
  if (has_[leg] < 0) has_[leg] = parts_.has(leg, r_);
  return has_[leg] != 0;
}

void RadiusWalk::find_ends(std::uint32_t i) {
  ends_.clear();
  ways_.clear();
  own_.clear();
  for (const std::uint32_t end : parts_.ends_at(i)) {
    if (!has(end / 2)) continue;
    const FoundTangent found = parts_.tangent(end / 2, r_);
    const bool leads_back = end % 2 == 1;
    const int s = found.name.from_side, t = found.name.to_side;
    ends_.push_back(leads_back ? found.ends.to : found.ends.from);
    ways_.push_back({leads_back ? found.name.from : found.name.to, end ^ 1, leads_back ? -t : s, leads_back ? -s : t,
                     found.ends.length});
    own_.push_back(end);
  }
}

const RadiusWalk::Made& RadiusWalk::made(std::uint32_t i) {
  if (sites_[i].first != kNone) return sites_[i];
  find_ends(i);
  order_.put(site(i), ends_);
  const auto first = static_cast<std::uint32_t>(points_.size());
  for (std::uint32_t k = 0; k < ends_.size(); ++k) {
    const std::uint32_t e = order_.order[k];
    if (order_.is_first[k]) {
      points_.push_back(ends_[e]);
      site_of_.push_back(i);
      first_leg_.push_back(0);
    }
    point_of_[own_[e]] = static_cast<std::uint32_t>(points_.size() - 1);
    legs_.push_back(ways_[e]);
    first_leg_.back() = static_cast<std::uint32_t>(legs_.size());
  }
  const auto end = static_cast<std::uint32_t>(points_.size());
  arc_is_free_.resize(end, 0);
  if (site(i).round && end - first > 1) {
    parts_.look_around(i, r_, obstacles_);
    for (std::uint32_t p = first; p + 1 < end; ++p)
      arc_is_free_[p] = parts_.ground->walls.arc_is_free(points_[p], points_[p + 1], obstacles_);
  }
  sites_[i] = {first, end};
  return sites_[i];
}

}  // namespace taut::detail
