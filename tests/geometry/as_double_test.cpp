#include <taut/geometry/exact/as_double.h>

#include <mpfr.h>

#include <cmath>
#include <limits>
#include <random>

namespace taut {
namespace {

/// A second opinion: MPFR, with so many bits that a second rounding cannot change the first.
class Reference {
 public:
  Reference(const Rational& v, bool root) {
    mpfr_inits2(20000, value_, under_, static_cast<mpfr_ptr>(nullptr));
    mpfr_set_str(value_, text_of(numerator(v)).c_str(), 10, MPFR_RNDN);
    mpfr_set_str(under_, text_of(denominator(v)).c_str(), 10, MPFR_RNDN);
    mpfr_div(value_, value_, under_, MPFR_RNDN);
    if (root) mpfr_sqrt(value_, value_, MPFR_RNDN);
  }
  ~Reference() { mpfr_clears(value_, under_, static_cast<mpfr_ptr>(nullptr)); }
  Reference(const Reference&) = delete;
  Reference& operator=(const Reference&) = delete;

  double as_double(Toward toward) const {
    const mpfr_rnd_t rounding = toward == Toward::down ? MPFR_RNDD : toward == Toward::up ? MPFR_RNDU : MPFR_RNDN;
    return mpfr_get_d(value_, rounding);
  }

 private:
  mpfr_t value_, under_;
};

constexpr Toward kAll[] = {Toward::down, Toward::nearest, Toward::up};

/// A digit more or less beside a power of two, ties, the least doubles, the largest: what rounding goes wrong at.
Rational drawn(std::mt19937_64& engine) {
  const auto below = [&](unsigned n) { return static_cast<unsigned>(engine() % n); };
  Integer over = power(2, below(140)) + integer(static_cast<int>(below(5)) - 2), under = power(2, below(140)) + 1;
  if (below(3) == 0) over = Integer(over * integer(static_cast<std::int64_t>(engine() >> 2)));
  if (below(2) == 0) under = power(2, below(1300));
  if (below(4) == 0) over = Integer(over * power(2, below(1300)));
  if (over <= 0) over = 1;
  return fraction(over, under);
}

TEST(AsDouble, IsWhatMpfrRoundsTo) {
  std::mt19937_64 engine(1);
  for (int i = 0; i < 3000; ++i) {
    const Rational v = drawn(engine);
    const Reference reference(v, false);
    for (const Toward toward : kAll) {
      ASSERT_EQ(as_double(v, toward), reference.as_double(toward)) << text_of(v);
      const Toward mirrored = toward == Toward::up ? Toward::down : toward == Toward::down ? Toward::up : toward;
      ASSERT_EQ(as_double(Rational(-v), mirrored), -reference.as_double(toward)) << text_of(v);
    }
  }
}

TEST(RootAsDouble, IsWhatMpfrRoundsTo) {
  std::mt19937_64 engine(2);
  for (int i = 0; i < 3000; ++i) {
    Rational v = drawn(engine);
    if (i % 3 == 0) v = Rational(v * v);
    const Reference reference(v, true);
    for (const Toward toward : kAll) ASSERT_EQ(root_as_double(v, toward), reference.as_double(toward)) << text_of(v);
  }
}

TEST(RootAsDouble, OfASquareIsTheRootInAllDirections) {
  for (const Toward toward : kAll) {
    EXPECT_EQ(root_as_double(0, toward), 0);
    EXPECT_EQ(root_as_double(fraction(9, 16), toward), 0.75);
    EXPECT_EQ(root_as_double(Rational(Rational(0x1p-1074) * Rational(0x1p-1074)), toward), 0x1p-1074);
  }
  EXPECT_LT(root_as_double(2, Toward::down), root_as_double(2, Toward::up));
}

TEST(AsDouble, OfWhatIsTooLargeIsInfinityOrTheLargest) {
  const Rational v(power(2, 1024));
  EXPECT_EQ(as_double(v, Toward::down), std::numeric_limits<double>::max());
  EXPECT_EQ(as_double(v, Toward::nearest), HUGE_VAL);
  const Rational half_way =
      Rational(power(2, 1024)) - Rational(power(2, 970));  // between the largest and what would follow
  EXPECT_EQ(as_double(half_way, Toward::nearest), HUGE_VAL);
  EXPECT_EQ(as_double(Rational(half_way - 1), Toward::nearest), std::numeric_limits<double>::max());
}

TEST(AsDouble, TakesAnIntegerAndAPowerOfTwo) {
  EXPECT_EQ(as_double(Integer(3), -1, Toward::up), 1.5);
  EXPECT_EQ(as_double(Integer(3), -1075, Toward::nearest), 0x1p-1073) << "a tie goes to the even one";
  EXPECT_EQ(as_double(Integer(1), -1075, Toward::nearest), 0);
  EXPECT_EQ(as_double(Integer(1), -3000, Toward::up), 0x1p-1074);
  EXPECT_EQ(as_double(Integer(1), -3000, Toward::down), 0);
  EXPECT_EQ(as_double(Integer(0), -3000, Toward::up), 0);
}

TEST(Numbers, GoTowardsZeroAsDoubles) {
  EXPECT_EQ(to_double(fraction(1, 3)), 0x1.5555555555555p-2);
  EXPECT_EQ(to_double(fraction(-2, 3)), -0x1.5555555555555p-1);
  EXPECT_EQ(to_double(big_float(fraction(2, 3))), 0x1.5555555555555p-1);
  EXPECT_EQ(to_double(halved(big_float(3), 2)), 0.75);
}

TEST(Numbers, AnswerAlikeWhoeverKeepsThem) {
  EXPECT_EQ(floor_of(fraction(-7, 2)), -4);
  EXPECT_EQ(floor_of(fraction(7, 2)), 3);
  EXPECT_EQ(floor_of_ratio(-8, 2), -4);
  EXPECT_EQ(text_of(fraction(-6, 4)), "-3/2");
  EXPECT_EQ(text_of(fraction(6, -3)), "-2");
  EXPECT_EQ(text_of(Integer(power(10, 20))), "100000000000000000000");
  EXPECT_EQ(bits(power(2, 100)), 101);
  EXPECT_EQ(bits(Integer(power(2, 100) - 1)), 100);
  EXPECT_TRUE(is_odd(Integer(-3)));
  EXPECT_FALSE(is_odd(Integer(4)));
  EXPECT_TRUE(is_square(power(3, 80)));
  EXPECT_FALSE(is_square(Integer(power(3, 80) + 1)));
  EXPECT_EQ(to_int64(integer(INT64_MIN)), INT64_MIN);
  EXPECT_EQ(shifted(5, -1), 2);
  EXPECT_EQ(Rational(0.1), fraction(3602879701896397, integer(std::int64_t{1} << 55)));
  EXPECT_EQ(sgn(fraction(-1, 7)), -1);
  EXPECT_LT(cmp(fraction(1, 7), fraction(1, 6)), 0);
}

}  // namespace
}  // namespace taut
