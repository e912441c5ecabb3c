#include <taut/roadmaps/prm_nearest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace taut {

namespace {

constexpr double kPointsInBucket = 2, kSlack = 1e-6;

double squared(Point p, Point q) {
  const double dx = q.x - p.x, dy = q.y - p.y;
  return dx * dx + dy * dy;
}

int bucket(double offset, double side, int count) {
  const double place = std::floor(offset / side);
  return place >= count - 1 ? count - 1 : place > 0 ? static_cast<int>(place) : 0;
}

using Ranks = std::vector<std::pair<double, std::uint32_t>>;

/// The first `count` of the ranks in order. Squared distances of points in the plane are spread evenly, so buckets of
/// equal width hold few each.
std::vector<std::uint32_t> numbers(const Ranks& ranks, std::size_t count) {
  constexpr std::size_t kBuckets = 64;
  std::array<std::uint32_t, kBuckets + 1> first{};
  double most = 0;
  for (const auto& rank : ranks) most = std::max(most, rank.first);
  const double per = most > 1e-290 ? kBuckets / most : 0;
  const auto bucket_of = [per](double distance) {
    return std::min(static_cast<std::size_t>(distance * per), kBuckets - 1);
  };
  for (const auto& rank : ranks) ++first[bucket_of(rank.first)];
  std::partial_sum(first.begin(), first.end(), first.begin());
  Ranks sorted(ranks.size());
  for (const auto& rank : ranks) sorted[--first[bucket_of(rank.first)]] = rank;
  std::vector<std::uint32_t> result;
  count = std::min(count, ranks.size());
  result.reserve(count);
  for (std::size_t b = 0; b < kBuckets && result.size() < count; ++b) {
    if (first[b + 1] - first[b] > 1) std::sort(sorted.begin() + first[b], sorted.begin() + first[b + 1]);
    for (std::uint32_t k = first[b]; k < first[b + 1] && result.size() < count; ++k) result.push_back(sorted[k].second);
  }
  return result;
}

}  // namespace

int PrmNearest::column(double x) const { return bucket(x - box_.min.x, side_, columns_); }
int PrmNearest::row(double y) const { return bucket(y - box_.min.y, side_, rows_); }

void PrmNearest::add(std::span<const Point> points) {
  if (points.empty()) return;
  points_.insert(points_.end(), points.begin(), points.end());
  lay();
}

void PrmNearest::lay() {
  box_ = {points_.front(), points_.front()};
  for (const Point p : points_) {
    box_.min = {std::min(box_.min.x, p.x), std::min(box_.min.y, p.y)};
    box_.max = {std::max(box_.max.x, p.x), std::max(box_.max.y, p.y)};
  }
  const double width = box_.max.x - box_.min.x, height = box_.max.y - box_.min.y;
  const double buckets = std::max(1.0, static_cast<double>(points_.size()) / kPointsInBucket);
  side_ = std::max({std::sqrt(width) * std::sqrt(height) / std::sqrt(buckets), std::max(width, height) / buckets,
                    std::numeric_limits<double>::min()});
  columns_ = static_cast<int>(width / side_) + 1;
  rows_ = static_cast<int>(height / side_) + 1;
  first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  const auto place = [&](Point p) {
    return static_cast<std::size_t>(row(p.y)) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column(p.x));
  };
  for (const Point p : points_) ++first_[place(p)];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  numbers_.resize(points_.size());
  for (std::size_t i = points_.size(); i-- > 0;) numbers_[--first_[place(points_[i])]] = static_cast<std::uint32_t>(i);
}

void PrmNearest::gather(Point p, const Block& block, std::vector<Rank>& ranks) const {
  for (int y = std::max(block.bottom, 0); y <= std::min(block.top, rows_ - 1); ++y) {
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_);
    const int left = std::max(block.left, 0), right = std::min(block.right, columns_ - 1);
    if (left > right) continue;
    for (std::uint32_t k = first_[row + static_cast<std::size_t>(left)];
         k < first_[row + static_cast<std::size_t>(right) + 1]; ++k)
      ranks.emplace_back(squared(p, points_[numbers_[k]]), numbers_[k]);
  }
}

/// No point outside the block is nearer than that. (The slack is for the rounding of the buckets' sides.)
double PrmNearest::reach(Point p, const Block& block) const {
  double least = std::numeric_limits<double>::infinity();
  if (block.left > 0) least = std::min(least, p.x - (box_.min.x + block.left * side_));
  if (block.right < columns_ - 1) least = std::min(least, box_.min.x + (block.right + 1) * side_ - p.x);
  if (block.bottom > 0) least = std::min(least, p.y - (box_.min.y + block.bottom * side_));
  if (block.top < rows_ - 1) least = std::min(least, box_.min.y + (block.top + 1) * side_ - p.y);
  return least - kSlack * side_;
}

std::vector<std::uint32_t> PrmNearest::nearest(Point p, std::size_t count) const {
  if (points_.empty()) return {};
  const int x = column(p.x), y = row(p.y);
  std::vector<Rank> ranks;
  for (int r = static_cast<int>(std::sqrt(static_cast<double>(count) / kPointsInBucket / 3));; r += 1 + r / 2) {
    const Block block{x - r, x + r, y - r, y + r};
    ranks.clear();
    gather(p, block, ranks);
    const double sure = reach(p, block);
    const auto is_sure = [&](const Rank& rank) { return rank.first < sure * sure; };
    const auto enough = static_cast<std::ptrdiff_t>(std::min(count, points_.size()));
    const bool is_whole = ranks.size() == points_.size();
    if (is_whole || (sure > 0 && std::count_if(ranks.begin(), ranks.end(), is_sure) >= enough))
      return numbers(ranks, count);
  }
}

std::vector<std::uint32_t> PrmNearest::within(Point p, double radius) const {
  if (points_.empty()) return {};
  std::vector<Rank> ranks;
  const double wide = radius + kSlack * (radius + side_);
  gather(p, {column(p.x - wide), column(p.x + wide), row(p.y - wide), row(p.y + wide)}, ranks);
  std::erase_if(ranks, [&](const Rank& rank) { return rank.first > radius * radius; });
  return numbers(ranks, ranks.size());
}

}  // namespace taut
