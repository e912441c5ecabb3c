#include <taut/search/radius_queries.h>

#include <algorithm>

namespace taut {

namespace {

constexpr std::size_t kKept = 16, kAsked = 64;

}  // namespace

bool RadiusQueries::is_first(double r) {
  if (std::find(asked_.begin(), asked_.end(), r) != asked_.end()) return false;
  if (asked_.size() == kAsked) asked_.erase(asked_.begin());
  asked_.push_back(r);
  return true;
}

ArcQueries* RadiusQueries::graph(double r) {
  auto at = std::find_if(kept_.begin(), kept_.end(), [&](const ArcQueries& q) { return q.graph().radius() == r; });
  if (at == kept_.end()) {
    if (is_first(r)) return nullptr;
    if (kept_.size() == kKept) kept_.erase(kept_.begin());
    kept_.emplace_back(all_.at_radius(r));
    ++made_;
    at = kept_.end() - 1;
  }
  std::rotate(at, at + 1, kept_.end());
  return &kept_.back();
}

ArcSearchResult RadiusQueries::find(double r, Point s, Point g) {
  ArcQueries* queries = graph(r);
  return queries ? queries->find(s, g) : arc_search(all_, r, s, g);
}

}  // namespace taut
