#include <taut/robots/micromouse/detail/belief.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/detail/draws.h>

namespace taut::micromouse::detail {

Belief::Belief(const Task& task, int samples, std::uint64_t seed) {
  const std::size_t cells = static_cast<std::size_t>(task.width) * static_cast<std::size_t>(task.height);
  taut::detail::Draws draws(seed);
  const auto board = [&] {
    std::vector<CellBits> levels(kLevels + 1, CellBits((cells + 63) / 64));
    for (std::size_t i = 0; i < cells; ++i) {
      const std::uint32_t drawn = draws.below(kLevels);
      for (std::size_t level = 0; level <= drawn; ++level) put(levels[level], i);
    }
    return levels;
  };
  for (int k = 0; k < samples; ++k) {
    north_.push_back(board());
    east_.push_back(board());
  }
}

void Belief::world(int sample, const WallMap& map, double density, Passages& into) const {
  const auto k = static_cast<std::size_t>(sample);
  const auto level =
      static_cast<std::size_t>(std::clamp(std::lround(density * kLevels), 0L, static_cast<long>(kLevels)));
  const Passages& certain = map.certain();
  const Passages& possible = map.possible();
  into = certain;
  for (std::size_t i = 0; i < into.words(); ++i) {
    into.north[i] |= possible.north[i] & north_[k][level][i];
    into.east[i] |= possible.east[i] & east_[k][level][i];
  }
}

double Belief::density(const WallMap& map, double share, double weight) {
  return (static_cast<double>(map.seen_closed()) + share * weight) / (static_cast<double>(map.seen()) + weight);
}

Outlook::Outlook(const WallMap& map, const WallWeights& weights, double density) {
  const Passages &certain = map.certain(), &possible = map.possible();
  const auto w = static_cast<std::size_t>(certain.width), h = static_cast<std::size_t>(certain.height);
  for (auto& r : rays_) r.assign(w * h, 0);
  const auto open = static_cast<float>(1 - density);
  const auto through = [&](const CellBits& sure, const CellBits& maybe, std::size_t passage, float weight,
                           float beyond) {
    if (holds(sure, passage)) return beyond;
    return holds(maybe, passage) ? weight + open * beyond : 0.F;
  };
  auto& [north, east, south, west] = rays_;
  for (std::size_t i = w * h; i-- > 0;) {
    if (i + w < w * h) north[i] = through(certain.north, possible.north, i, weights.north[i], north[i + w]);
    if (i % w + 1 < w) east[i] = through(certain.east, possible.east, i, weights.east[i], east[i + 1]);
  }
  for (std::size_t i = 0; i < w * h; ++i) {
    if (i >= w) south[i] = through(certain.north, possible.north, i - w, weights.north[i - w], south[i - w]);
    if (i % w > 0) west[i] = through(certain.east, possible.east, i - 1, weights.east[i - 1], west[i - 1]);
  }
}

}  // namespace taut::micromouse::detail
