// 64 headings that are rational: what keeps a car's poses exact.
#pragma once

namespace taut::car {

/// A direction as integers: (x, y) / kHeadingScale is a unit vector, exactly.
struct HeadingVector {
  int x = 0;
  int y = 0;
  friend bool operator==(const HeadingVector&, const HeadingVector&) = default;
};

inline constexpr int kHeadings = 64;
inline constexpr int kHeadingScale = 48841;  ///< 13^2 * 17^2

/// Heading h, about h * 360 / 64 degrees counter-clockwise from +x, 0 <= h < kHeadings.
///
///  1. x^2 + y^2 == kHeadingScale^2. Multiples of 16 are the axes, exactly.
///  2. h + 16 is h turned by 90 degrees. 16 - h is h mirrored at the diagonal, but for h = 8, which is (119, 120) /
///     169.
///  3. At most 0.24 degrees off (h = 8 and its turns), the others at most 0.19.
HeadingVector heading_vector(int heading);

/// Its angle in radians, in (-pi, pi].
double heading_angle(int heading);

/// The heading whose angle is nearest to this one, in radians; the lower number when two are. Precondition: finite.
int nearest_heading(double radians);

}  // namespace taut::car
