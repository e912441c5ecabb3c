#include <taut/robots/micromouse/detail/belief.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <taut/robots/micromouse/detail/boards.h>
#include <taut/robots/micromouse/detail/wall_field.h>

namespace taut::micromouse::detail {

namespace {

constexpr std::uint8_t bit(Side side) { return static_cast<std::uint8_t>(1U << static_cast<unsigned>(side)); }

void assign(std::uint8_t& bits, std::uint8_t mask, bool value) {
  bits = static_cast<std::uint8_t>(value ? bits | mask : bits & ~mask);
}

void assign(CellBits& bits, std::size_t i, bool value) {
  const std::uint64_t mask = std::uint64_t{1} << (i % 64);
  bits[i / 64] = value ? bits[i / 64] | mask : bits[i / 64] & ~mask;
}

}  // namespace

Belief::Belief(const Task& task, int samples, std::uint64_t seed)
    : cells_(static_cast<std::size_t>(task.width) * static_cast<std::size_t>(task.height)),
      places_(2 * cells_),
      wall_weight_(std::exp(kField.wall)),
      border_arm_weight_(std::exp(kField.border_arm)),
      parent_(cells_),
      draws_(seed) {
  const auto w = static_cast<std::size_t>(task.width), h = static_cast<std::size_t>(task.height);
  const auto post = [&](std::size_t x, std::size_t y) { return static_cast<std::uint32_t>(y * (w + 1) + x); };
  at_border_.assign((w + 1) * (h + 1), true);
  for (std::size_t y = 1; y < h; ++y)
    for (std::size_t x = 1; x < w; ++x) at_border_[post(x, y)] = false;
  Sample blank{passages(task.width, task.height, true), std::vector<std::uint8_t>(at_border_.size()),
               std::vector<std::uint8_t>(cells_)};
  for (std::size_t i = 0; i < cells_; ++i) {
    const std::size_t x = i % w, y = i / w;
    const auto cell = static_cast<std::uint32_t>(i), above = static_cast<std::uint32_t>(i + w);
    places_[i] = {{post(x, y + 1), post(x + 1, y + 1)},
                  {cell, above},
                  {bit(Side::east), bit(Side::west)},
                  {bit(Side::north), bit(Side::south)}};
    places_[cells_ + i] = {{post(x + 1, y), post(x + 1, y + 1)},
                           {cell, cell + 1},
                           {bit(Side::north), bit(Side::south)},
                           {bit(Side::east), bit(Side::west)}};
    const std::array<bool, 4> border{y + 1 == h, x + 1 == w, y == 0, x == 0};
    for (const Side side : kSides) assign(blank.cells[i], bit(side), border[static_cast<std::size_t>(side)]);
  }
  for (unsigned sides = 0; sides < 16; ++sides) {
    post_weight_[sides] = std::exp(kField.post_of(sides));
    cell_weight_[sides] = std::exp(kField.cell_of(sides));
  }
  samples_.assign(static_cast<std::size_t>(samples), blank);
}

void Belief::update(const WallMap& map) {
  unknown_.clear();
  for (std::size_t i = 0; i < cells_; ++i) {
    if (holds(map.possible().north, i) && !holds(map.certain().north, i)) unknown_.push_back(i);
    if (holds(map.possible().east, i) && !holds(map.certain().east, i)) unknown_.push_back(cells_ + i);
  }
  for (Sample& sample : samples_) {
    take_over(map, sample);
    for (std::size_t i = unknown_.size(); i-- > 1;)
      std::swap(unknown_[i], unknown_[draws_.below(static_cast<std::uint32_t>(i + 1))]);
    if (fresh_)
      for (const std::size_t wall : unknown_) set(sample, wall, draws_.unit() < 0.4);
    const std::size_t draws = fresh_ ? unknown_.size() * kFirstRounds : std::min(unknown_.size() * kRounds, kMostDraws);
    for (std::size_t i = 0, k = 0; i < draws; ++i, k = k + 1 == unknown_.size() ? 0 : k + 1) draw(sample, unknown_[k]);
    connect(sample);
  }
  fresh_ = false;
}

void Belief::take_over(const WallMap& map, Sample& sample) const {
  const auto differing = [&](const CellBits& certain, const CellBits& possible, const CellBits& open,
                             std::size_t first) {
    for (std::size_t k = 0; k < open.size(); ++k) {
      const std::uint64_t wrong = (certain[k] & ~open[k]) | (open[k] & ~possible[k]);
      for_each_bit(&wrong, 1, [&](std::size_t i) { set(sample, first + k * 64 + i, (certain[k] >> i & 1U) == 0); });
    }
  };
  differing(map.certain().north, map.possible().north, sample.open.north, 0);
  differing(map.certain().east, map.possible().east, sample.open.east, cells_);
}

void Belief::set(Sample& sample, std::size_t wall, bool stands) const {
  const Place& place = places_[wall];
  for (const std::size_t end : {0U, 1U}) {
    assign(sample.posts[place.post[end]], place.arm[end], stands);
    assign(sample.cells[place.cell[end]], place.side[end], stands);
  }
  assign(wall < cells_ ? sample.open.north : sample.open.east, wall < cells_ ? wall : wall - cells_, !stands);
}

bool Belief::stands(const Sample& sample, std::size_t wall) const {
  return wall < cells_ ? !holds(sample.open.north, wall) : !holds(sample.open.east, wall - cells_);
}

void Belief::draw(Sample& sample, std::size_t wall) {
  const Place& place = places_[wall];
  double with = wall_weight_, without = 1;
  for (const std::size_t end : {0U, 1U}) {
    const unsigned sides = sample.cells[place.cell[end]], side = place.side[end];
    with *= cell_weight_[sides | side];
    without *= cell_weight_[sides & ~side];
    if (at_border_[place.post[end]]) {
      with *= border_arm_weight_;
      continue;
    }
    const unsigned arms = sample.posts[place.post[end]], arm = place.arm[end];
    with *= post_weight_[arms | arm];
    without *= post_weight_[arms & ~arm];
  }
  const bool now = draws_.unit() * (with + without) < with;
  if (now != stands(sample, wall)) set(sample, wall, now);
}

std::uint32_t Belief::root(std::uint32_t cell) {
  while (parent_[cell] != cell) cell = parent_[cell] = parent_[parent_[cell]];
  return cell;
}

void Belief::connect(Sample& sample) {
  std::iota(parent_.begin(), parent_.end(), 0U);
  const auto join = [&](std::size_t wall) {
    const std::uint32_t a = root(places_[wall].cell[0]), b = root(places_[wall].cell[1]);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  };
  for_each_bit(sample.open.north.data(), sample.open.words(), [&](std::size_t i) { join(i); });
  for_each_bit(sample.open.east.data(), sample.open.words(), [&](std::size_t i) { join(cells_ + i); });
  for (const std::size_t wall : unknown_)
    if (stands(sample, wall) && join(wall)) set(sample, wall, false);
}

void Belief::thinned(int sample, double share, Passages& into) {
  into = world(sample);
  for (const std::size_t wall : unknown_)
    if (share >= 1 || draws_.unit() < share)
      assign(wall < cells_ ? into.north : into.east, wall < cells_ ? wall : wall - cells_, true);
}

WallBoard Belief::open_share() const {
  WallBoard share{std::vector<float>(cells_), std::vector<float>(cells_)};
  const float each = 1 / static_cast<float>(samples());
  for (const Sample& sample : samples_)
    for (const std::size_t wall : unknown_)
      if (!stands(sample, wall)) (wall < cells_ ? share.north[wall] : share.east[wall - cells_]) += each;
  return share;
}

Outlook::Outlook(const WallMap& map, const WallBoard& weights, const WallBoard& open) {
  const Passages &certain = map.certain(), &possible = map.possible();
  const auto w = static_cast<std::size_t>(certain.width), h = static_cast<std::size_t>(certain.height);
  for (auto& r : rays_) r.assign(w * h, 0);
  const auto through = [&](const CellBits& sure, const CellBits& maybe, const std::vector<float>& weight,
                           const std::vector<float>& share, std::size_t passage, float beyond) {
    if (holds(sure, passage)) return beyond;
    return holds(maybe, passage) ? weight[passage] + share[passage] * beyond : 0.F;
  };
  const auto northwards = [&](std::size_t passage, float beyond) {
    return through(certain.north, possible.north, weights.north, open.north, passage, beyond);
  };
  const auto eastwards = [&](std::size_t passage, float beyond) {
    return through(certain.east, possible.east, weights.east, open.east, passage, beyond);
  };
  auto& [north, east, south, west] = rays_;
  for (std::size_t i = w * h; i-- > 0;) {
    if (i + w < w * h) north[i] = northwards(i, north[i + w]);
    if (i % w + 1 < w) east[i] = eastwards(i, east[i + 1]);
  }
  for (std::size_t i = 0; i < w * h; ++i) {
    if (i >= w) south[i] = northwards(i - w, south[i - w]);
    if (i % w > 0) west[i] = eastwards(i - 1, west[i - 1]);
  }
}

}  // namespace taut::micromouse::detail
