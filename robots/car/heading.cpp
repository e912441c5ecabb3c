#include <taut/robots/car/heading.h>

#include <array>
#include <cmath>
#include <numbers>

namespace taut::car {

namespace {

/// The first octant, over 1, 221, 3757, 2873, 13, 17, 289, 221 and 169, brought to kHeadingScale.
constexpr std::array<HeadingVector, 9> kOctant{{{48841, 0},
                                                {220 * 221, 21 * 221},
                                                {3685 * 13, 732 * 13},
                                                {2752 * 17, 825 * 17},
                                                {12 * 3757, 5 * 3757},
                                                {15 * 2873, 8 * 2873},
                                                {240 * 169, 161 * 169},
                                                {171 * 221, 140 * 221},
                                                {119 * 289, 120 * 289}}};

constexpr std::array<HeadingVector, kHeadings> all_headings() {
  std::array<HeadingVector, kHeadings> all{};
  for (std::size_t h = 0; h < all.size(); ++h)
    all[h] = h <= 8   ? kOctant[h]
             : h < 16 ? HeadingVector{kOctant[16 - h].y, kOctant[16 - h].x}
                      : HeadingVector{-all[h - 16].y, all[h - 16].x};
  return all;
}

constexpr std::array<HeadingVector, kHeadings> kAll = all_headings();

}  // namespace

HeadingVector heading_vector(int heading) { return kAll[static_cast<std::size_t>(heading)]; }

double heading_angle(int heading) {
  const HeadingVector v = heading_vector(heading);
  return std::atan2(v.y, v.x);
}

int nearest_heading(double radians) {
  int best = 0;
  double least = 10;
  for (int h = 0; h < kHeadings; ++h) {
    const double off = std::abs(std::remainder(radians - heading_angle(h), 2 * std::numbers::pi));
    if (off < least) least = off, best = h;
  }
  return best;
}

}  // namespace taut::car
