#include <taut/roadmaps/detail/prm_nearest.h>

#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace taut::detail {

namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostBox = bg::model::box<BoostPoint>;
using Entry = std::pair<BoostPoint, std::uint32_t>;
using Rank = std::pair<double, std::uint32_t>;

Rank rank(Point p, const Entry& entry) {
  const double dx = entry.first.x() - p.x, dy = entry.first.y() - p.y;
  return {dx * dx + dy * dy, entry.second};
}

std::vector<std::uint32_t> numbers(const std::vector<Rank>& ranks, std::size_t count) {
  std::vector<std::uint32_t> result;
  result.reserve(count);
  for (std::size_t i = 0; i < std::min(count, ranks.size()); ++i) result.push_back(ranks[i].second);
  return result;
}

}  // namespace

struct PrmNearest::Tree {
  bg::index::rtree<Entry, bg::index::linear<16>> entries;

  template <class Predicate>
  std::vector<Rank> ranked(Point p, const Predicate& predicate) const {
    std::vector<Entry> found;
    entries.query(predicate, std::back_inserter(found));
    std::vector<Rank> ranks;
    ranks.reserve(found.size());
    for (const Entry& entry : found) ranks.push_back(rank(p, entry));
    std::sort(ranks.begin(), ranks.end());
    return ranks;
  }
};

PrmNearest::PrmNearest() : tree_(std::make_unique<Tree>()) {}
PrmNearest::~PrmNearest() = default;
PrmNearest::PrmNearest(PrmNearest&&) noexcept = default;

void PrmNearest::add(std::span<const Point> points) {
  std::vector<Entry> entries;
  entries.reserve(points.size());
  for (const Point p : points) {
    entries.emplace_back(BoostPoint(p.x, p.y), static_cast<std::uint32_t>(points_.size()));
    points_.push_back(p);
  }
  if (entries.size() == points_.size())
    tree_->entries = decltype(tree_->entries)(entries);  // packed
  else
    tree_->entries.insert(entries);
}

std::vector<std::uint32_t> PrmNearest::nearest(Point p, std::size_t count) const {
  // A few more than asked for: of those equally far as the last the tree picks any.
  for (std::size_t ask = count + 4;; ask *= 2) {
    const auto number = static_cast<unsigned>(std::min(ask, points_.size()));
    const std::vector<Rank> ranks = tree_->ranked(p, bg::index::nearest(BoostPoint(p.x, p.y), number));
    if (ranks.size() == points_.size() || ranks[count - 1].first < ranks.back().first) return numbers(ranks, count);
  }
}

std::vector<std::uint32_t> PrmNearest::within(Point p, double radius) const {
  const BoostBox box(BoostPoint(p.x - radius, p.y - radius), BoostPoint(p.x + radius, p.y + radius));
  const std::vector<Rank> ranks = tree_->ranked(p, bg::index::intersects(box));
  const auto end =
      std::partition_point(ranks.begin(), ranks.end(), [&](const Rank& r) { return r.first <= radius * radius; });
  return numbers(ranks, static_cast<std::size_t>(end - ranks.begin()));
}

}  // namespace taut::detail
