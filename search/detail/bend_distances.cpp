#include <taut/search/detail/bend_distances.h>

#include <algorithm>

namespace taut::detail {

BendDistances::BendDistances(const VisibilityGraph& graph)

    : shared_(std::make_shared<const TautLegs>(graph)),
      legs_(*shared_),
      at_(legs_.vertex_count(), kFar),
      via_(at_.size(), kPlace),
      open_(kBuckets) {
  for (std::size_t e = 0; e < legs_.size(); ++e) {
    longest_ = std::max(longest_, legs_[e].length);
    mean_ += legs_[e].length / static_cast<double>(legs_.size());
  }
}

void BendDistances::from(std::span<const Leg> legs) {
  std::fill(at_.begin(), at_.end(), kFar);
  aim(legs);
  for (const Leg& leg : legs)
    if (is_less(leg.length, at_[leg.to])) reach(leg.to, leg.length, kPlace);
  for (Open next{}; take(next);) {
    const twofold::Pair here = at_[next.vertex];
    if (next.bound != here.high) continue;  // there was a shorter way by then
    const std::size_t via = via_[next.vertex];
    if (via == kPlace) {
      follow(here, legs_.of(next.vertex));
    } else {
      follow(here, legs_.right_of(via));
      follow(here, legs_.left_of(via));
    }
  }
}

void BendDistances::follow(twofold::Pair here, TautLegs::Range range) {
  for (std::size_t e = range.first; e < range.last; ++e) {
    const TautLegs::Leg& leg = legs_[e];
    const twofold::Pair& known = at_[leg.to];
    const double length = here.high + leg.length;
    if (length * (1 - kDoubt) > known.high) continue;
    const twofold::Pair exact = plus(here, legs_.length(e));
    if (is_less(exact, known)) reach(leg.to, exact, e);
  }
}

void BendDistances::reach(std::uint32_t v, twofold::Pair length, std::size_t leg) {
  at_[v] = length;
  via_[v] = leg;
  push({length.high, v});
}

void BendDistances::aim(std::span<const Leg> legs) {
  double longest = longest_;
  for (const Leg& leg : legs) longest = std::max(longest, leg.length.high);
  width_ = std::max(mean_ / 4, longest / (kBuckets - 4));
  if (!(width_ > 0)) width_ = 1;
  now_ = size_ = 0;
}

void BendDistances::push(const Open& open) {
  open_[static_cast<std::size_t>(open.bound / width_) % kBuckets].push_back(open);
  ++size_;
}

bool BendDistances::take(Open& next) {
  if (size_ == 0) return false;
  while (open_[now_ % kBuckets].empty()) ++now_;
  std::vector<Open>& bucket = open_[now_ % kBuckets];
  next = bucket.back();
  bucket.pop_back();
  --size_;
  return true;
}

}  // namespace taut::detail
