// GMP and MPFR: whatever doubles could not decide.
#include <taut/geometry/detail/root_sum.h>

#include <gmpxx.h>
#include <mpfr.h>

#include <taut/geometry/expects.h>

namespace taut::detail {

namespace {

class Float {
 public:
  explicit Float(mpfr_prec_t precision) { mpfr_init2(value_, precision); }
  ~Float() { mpfr_clear(value_); }
  Float(const Float&) = delete;
  Float& operator=(const Float&) = delete;

  operator mpfr_ptr() { return value_; }
  operator mpfr_srcptr() const { return value_; }

 private:
  mpfr_t value_;
};

struct BigTerm {
  mpq_class square;
  std::int64_t count;
};
using BigTerms = std::vector<BigTerm>;

mpq_class exact(const twofold::Pair& p) { return mpq_class(p.high) + mpq_class(p.low); }

mpq_class exact(const twofold::Square& s) {
  if (s.exact) return mpq_class(s.sum);
  const mpq_class dx = exact(s.dx), dy = exact(s.dy);
  return dx * dx + dy * dy;
}

BigTerms big_terms(std::span<const RootTerm> terms) {
  BigTerms big;
  big.reserve(terms.size());
  for (const RootTerm& t : terms) big.push_back({exact(t.square), t.count});
  return big;
}

/// sqrt(v) where that is rational.
std::optional<mpq_class> rational_root(const mpq_class& v) {
  if (!mpz_perfect_square_p(v.get_num_mpz_t()) || !mpz_perfect_square_p(v.get_den_mpz_t())) return std::nullopt;
  return mpq_class(sqrt(v.get_num()), sqrt(v.get_den()));
}

/// The sum as rational multiples of roots no two of which are rationally dependent; the first is sqrt(1).
struct RootClass {
  mpq_class square;
  mpq_class factor;
};

std::vector<RootClass> classes(const BigTerms& terms) {
  std::vector<RootClass> all{{1, 0}};
  for (const BigTerm& t : terms) {
    bool placed = false;
    for (RootClass& c : all) {
      const auto ratio = rational_root(t.square / c.square);
      if (!ratio) continue;
      c.factor += *ratio * mpz_class(static_cast<long>(t.count));
      placed = true;
      break;
    }
    if (!placed) all.push_back({t.square, mpz_class(static_cast<long>(t.count))});
  }
  return all;
}

bool is_rational(const std::vector<RootClass>& all) {
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i].factor != 0) return false;
  return true;
}

/// The sum of the terms, enclosed.
struct BigInterval {
  Float lo, hi;

  BigInterval(const BigTerms& terms, mpfr_prec_t precision) : lo(precision), hi(precision) {
    mpfr_set_zero(lo, 1);
    mpfr_set_zero(hi, 1);
    Float root(precision);
    for (const BigTerm& t : terms) {
      add(lo, root, t, MPFR_RNDD);
      add(hi, root, t, MPFR_RNDU);
    }
  }

 private:
  static void add(Float& sum, Float& root, const BigTerm& t, mpfr_rnd_t outward) {
    const mpfr_rnd_t rounding = t.count > 0 ? outward : (outward == MPFR_RNDD ? MPFR_RNDU : MPFR_RNDD);
    mpfr_set_q(root, t.square.get_mpq_t(), rounding);
    mpfr_sqrt(root, root, rounding);
    mpfr_mul_si(root, root, static_cast<long>(t.count), outward);
    mpfr_add(sum, sum, root, outward);
  }
};

constexpr mpfr_prec_t kFirstPrecision = 192, kClassPrecision = 384;

/// Doubles the precision until decide(enclosure) answers. An irrational sum is never where an answer changes, so only a
/// rational one needs to be known as such: `rational(value)` answers for it.
template <class Decide, class Rational>
auto decide_sum(const BigTerms& terms, Decide decide, Rational rational) {
  for (mpfr_prec_t precision = kFirstPrecision;; precision *= 2) {
    if (precision == kClassPrecision)
      if (const auto all = classes(terms); is_rational(all)) return rational(all.front().factor);
    if (const auto answer = decide(BigInterval(terms, precision))) return *answer;
  }
}

double nearest(const mpq_class& v) {
  Float result(53);
  mpfr_set_q(result, v.get_mpq_t(), MPFR_RNDN);
  return mpfr_get_d(result, MPFR_RNDN);
}

mpz_class power_of_ten(int exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(exponent));
  return power;
}

mpz_class rounded_half_even(const mpq_class& v) {
  mpz_class floor, twice_rest;
  mpz_fdiv_qr(floor.get_mpz_t(), twice_rest.get_mpz_t(), v.get_num_mpz_t(), v.get_den_mpz_t());
  twice_rest *= 2;
  const int side = cmp(twice_rest, v.get_den());
  if (side > 0 || (side == 0 && mpz_odd_p(floor.get_mpz_t()))) ++floor;
  return floor;
}

mpz_class scaled_and_rounded(const Float& v, const mpz_class& scale, mpfr_rnd_t outward) {
  Float scaled(mpfr_get_prec(v));
  mpfr_mul_z(scaled, v, scale.get_mpz_t(), outward);
  mpz_class result;
  mpfr_get_z(result.get_mpz_t(), scaled, MPFR_RNDN);
  return result;
}

std::string with_point(const mpz_class& digits, int places) {
  std::string text = digits.get_str();
  const auto wanted = static_cast<std::size_t>(places);
  if (text.size() <= wanted) text.insert(0, wanted + 1 - text.size(), '0');
  if (places > 0) text.insert(text.size() - wanted, 1, '.');
  return text;
}

}  // namespace

int sign_by_big_numbers(std::span<const RootTerm> terms) {
  const auto decide = [](const BigInterval& sum) -> std::optional<int> {
    if ((mpfr_sgn)(sum.lo) > 0) return 1;
    if ((mpfr_sgn)(sum.hi) < 0) return -1;
    return std::nullopt;
  };
  return decide_sum(big_terms(terms), decide, [](const mpq_class& v) { return sgn(v); });
}

double nearest_by_big_numbers(std::span<const RootTerm> terms) {
  const auto decide = [](const BigInterval& sum) -> std::optional<double> {
    const double lo = mpfr_get_d(sum.lo, MPFR_RNDN), hi = mpfr_get_d(sum.hi, MPFR_RNDN);
    return lo == hi ? std::optional(lo) : std::nullopt;
  };
  return decide_sum(big_terms(terms), decide, [](const mpq_class& v) { return nearest(v); });
}

std::string decimals_by_big_numbers(std::span<const RootTerm> terms, int places) {
  TAUT_EXPECTS(places >= 0);
  const mpz_class scale = power_of_ten(places);
  const auto decide = [&](const BigInterval& sum) -> std::optional<mpz_class> {
    const mpz_class lo = scaled_and_rounded(sum.lo, scale, MPFR_RNDD),
                    hi = scaled_and_rounded(sum.hi, scale, MPFR_RNDU);
    return lo == hi ? std::optional(lo) : std::nullopt;
  };
  const auto rational = [&](const mpq_class& v) { return rounded_half_even(v * scale); };
  return with_point(decide_sum(big_terms(terms), decide, rational), places);
}

}  // namespace taut::detail
