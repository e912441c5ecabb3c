#include <taut/robots/pursuit/heading_pursuer.h>

#include <algorithm>
#include <utility>

#include <taut/geometry/expects.h>
#include <taut/robots/pursuit/detail/hops.h>

namespace taut::pursuit {

HeadingPursuer::HeadingPursuer(Chase chase, int ahead) : chase_(std::move(chase)), ahead_(ahead) {
  TAUT_EXPECTS(ahead >= 0);
}

const Meeting& HeadingPursuer::aim(int now) const {
  const auto& all = chase_.meetings;
  if (ahead_ == kToTheEnd) return all.back();
  const auto later = std::lower_bound(all.begin(), all.end(), std::int64_t{now} + ahead_,
                                      [](const Meeting& m, std::int64_t second) { return m.second < second; });
  return later == all.end() ? all.back() : *later;
}

CellIndex HeadingPursuer::next(CellIndex at, int now) {
  if (chase_.meetings.empty()) return at;
  const CellIndex to = aim(now).cell;
  const bool goes_on = !way_.empty() && way_.back() == at && way_.front() == to;
  if (!goes_on) {
    way_ = detail::cheapest_way(*chase_.map, at, to);
    std::reverse(way_.begin(), way_.end());
    ++plans_;
  }
  if (way_.size() < 2) return at;
  way_.pop_back();
  return way_.back();
}

}  // namespace taut::pursuit
