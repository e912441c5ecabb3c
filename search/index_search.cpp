#include <cmath>
#include <limits>
#include <utility>

#include <taut/search/detail/index_query.h>
#include <taut/search/index.h>

namespace taut {

struct IndexSearch::Impl {
  explicit Impl(Index what, const detail::IndexParts& parts) : index(std::move(what)), query(parts) {}

  Index index;
  detail::IndexQuery query;
  std::vector<Point> points;
  double length = std::numeric_limits<double>::infinity();
};

IndexSearch::IndexSearch(Index index) {
  const detail::IndexParts& parts = *index.parts_;
  impl_ = std::make_unique<Impl>(std::move(index), parts);
}
IndexSearch::IndexSearch(IndexSearch&&) noexcept = default;
IndexSearch& IndexSearch::operator=(IndexSearch&&) noexcept = default;
IndexSearch::~IndexSearch() = default;

SearchStatus IndexSearch::find(Point from, Point to) {
  impl_->query.find(from, to, impl_->points);
  if (impl_->points.empty()) {
    impl_->length = std::numeric_limits<double>::infinity();
    return SearchStatus::none;
  }
  impl_->length = 0;
  for (std::size_t i = 1; i < impl_->points.size(); ++i) {
    const double dx = impl_->points[i].x - impl_->points[i - 1].x, dy = impl_->points[i].y - impl_->points[i - 1].y;
    impl_->length += std::sqrt(dx * dx + dy * dy);
  }
  return SearchStatus::found;
}

const std::vector<Point>& IndexSearch::points() const { return impl_->points; }
double IndexSearch::length() const { return impl_->length; }
std::size_t IndexSearch::scanned() const { return impl_->query.scanned(); }

}  // namespace taut
