// A second opinion about sums of distances.
#pragma once

#include <gmpxx.h>
#include <mpfr.h>

#include <compare>
#include <string>
#include <vector>

#include <taut/geometry/length.h>

namespace taut::test {

using Legs = std::vector<Segment>;
using Order = std::strong_ordering;

/// A leg of squared length dx^2 + dy^2, laid somewhere.
inline Segment leg(double dx, double dy, Point from = {3, -7}) { return {from, {from.x + dx, from.y + dy}}; }

inline Length length_of(const Legs& legs) {
  Length sum;
  for (const Segment& s : legs) sum.add(s.a, s.b);
  return sum;
}

/// An independent second opinion: both sums with 3000 bits, straight from the coordinates. 0 means equal to 2900 bits.
class Reference {
 public:
  explicit Reference(const Legs& legs) {
    mpfr_inits2(3000, sum_, dx_, dy_, static_cast<mpfr_ptr>(nullptr));
    mpfr_set_zero(sum_, 1);
    for (const Segment& s : legs) {
      mpfr_set_d(dx_, s.a.x, MPFR_RNDN);
      mpfr_sub_d(dx_, dx_, s.b.x, MPFR_RNDN);
      mpfr_set_d(dy_, s.a.y, MPFR_RNDN);
      mpfr_sub_d(dy_, dy_, s.b.y, MPFR_RNDN);
      mpfr_hypot(dx_, dx_, dy_, MPFR_RNDN);
      mpfr_add(sum_, sum_, dx_, MPFR_RNDN);
    }
  }
  ~Reference() { mpfr_clears(sum_, dx_, dy_, static_cast<mpfr_ptr>(nullptr)); }
  Reference(const Reference&) = delete;

  int compare(const Reference& other) const {
    if (mpfr_eq(sum_, other.sum_, 2900)) return 0;
    return mpfr_cmp(sum_, other.sum_) > 0 ? 1 : -1;
  }
  bool is_in(Interval i) const { return mpfr_cmp_d(sum_, i.lo) >= 0 && mpfr_cmp_d(sum_, i.hi) <= 0; }
  double nearest() const { return mpfr_get_d(sum_, MPFR_RNDN); }
  std::string decimals(int places) const {
    char* text = nullptr;
    mpfr_asprintf(&text, "%.*RNf", places, sum_);
    std::string result = text;
    mpfr_free_str(text);
    return result;
  }

 private:
  mpfr_t sum_, dx_, dy_;
};

inline int sign(Order order) { return order < 0 ? -1 : order > 0 ? 1 : 0; }

}  // namespace taut::test
