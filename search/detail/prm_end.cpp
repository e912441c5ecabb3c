#include <taut/search/detail/prm_end.h>

#include <algorithm>

namespace taut::detail {

using Vertex = Roadmap::Vertex;

PrmEnd::PrmEnd(const PrmClear& clear, Point p, std::size_t count)
    : clear_(clear), p_(p), count_(count), at_(clear.space().locate(p)), keeps_clearance_(clear.point(p)) {}

std::vector<Vertex> PrmEnd::joined(std::span<const Point> points) {
  std::vector<Rank> ranks;
  for (; seen_ < points.size(); ++seen_) {
    const double dx = points[seen_].x - p_.x, dy = points[seen_].y - p_.y;
    const Rank rank{dx * dx + dy * dy, static_cast<Vertex>(seen_)};
    if (nearest_.size() < count_ || rank < nearest_.back()) ranks.push_back(rank);
  }
  std::sort(ranks.begin(), ranks.end());
  for (const Rank& rank : ranks) {
    if (nearest_.size() == count_ && !(rank < nearest_.back())) break;
    const Point q = points[rank.second];
    if (!(keeps_clearance_ ? clear_.leg(p_, at_, q) : clear_.sees(p_, at_, q))) continue;
    if (nearest_.size() == count_) nearest_.pop_back();
    nearest_.insert(std::upper_bound(nearest_.begin(), nearest_.end(), rank), rank);
  }
  std::vector<Vertex> result;
  for (const Rank& rank : nearest_) result.push_back(rank.second);
  return result;
}

}  // namespace taut::detail
