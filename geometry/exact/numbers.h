// Integers and rationals of any length. They are GMP's; Boost.Multiprecision's where there is none (TAUT_BOOST_NUMBERS,
// as in a page). Both answer alike, GMP several times faster.
//
// What is common to both needs no word here: + - * / and comparisons of each other and of int, construction from
// double (exact), sgn, cmp, abs, and for integers sqrt (rounded down) and lcm. All else is below.
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>
#include <string>

#ifdef TAUT_BOOST_NUMBERS
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#else
#include <gmpxx.h>
#endif

namespace taut {

#ifdef TAUT_BOOST_NUMBERS

using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;
using Rational =
    boost::multiprecision::number<boost::multiprecision::rational_adaptor<boost::multiprecision::cpp_int_backend<>>,
                                  boost::multiprecision::et_off>;
/// A binary fraction of 512 bits.
using BigFloat =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<512, boost::multiprecision::digit_base_2>,
                                  boost::multiprecision::et_off>;

using boost::multiprecision::denominator;
using boost::multiprecision::numerator;

inline int sgn(const Integer& v) { return v.sign(); }
inline int sgn(const Rational& v) { return v.sign(); }
inline int cmp(const Integer& a, const Integer& b) { return a.compare(b); }
inline int cmp(const Rational& a, const Rational& b) { return a.compare(b); }

inline Integer integer(std::int64_t v) { return Integer(v); }
inline Rational fraction(const Integer& over, const Integer& under) { return Rational(over) / Rational(under); }
inline Integer power(unsigned base, unsigned exponent) { return pow(Integer(base), exponent); }
inline bool is_odd(const Integer& v) { return bit_test(Integer(abs(v)), 0); }
/// Of v > 0: how many.
inline std::int64_t bits(const Integer& v) { return static_cast<std::int64_t>(msb(v)) + 1; }
/// Rounded down. Precondition: under > 0.
inline Integer floor_of_ratio(const Integer& over, const Integer& under) {
  Integer whole, rest;
  divide_qr(over, under, whole, rest);
  return rest < 0 ? Integer(whole - 1) : whole;
}
inline bool is_square(const Integer& v) {
  if (v < 0) return false;
  const Integer root = sqrt(v);
  return root * root == v;
}
inline std::int64_t to_int64(const Integer& v) { return static_cast<std::int64_t>(v); }
inline std::string text_of(const Integer& v) { return v.str(); }
inline std::string text_of(const Rational& v) {
  return denominator(v) == 1 ? numerator(v).str() : numerator(v).str() + "/" + denominator(v).str();
}

/// Towards zero.
double to_double(const Rational& v);
double to_double(const BigFloat& v);

inline BigFloat big_float(const Rational& v, int = 256) { return BigFloat(v); }
inline BigFloat halved(const BigFloat& v, int times) { return ldexp(v, -times); }

#else

using Integer = mpz_class;
using Rational = mpq_class;
/// A binary fraction, of as many bits as big_float was told.
using BigFloat = mpf_class;

inline const Integer& numerator(const Rational& v) { return v.get_num(); }
inline const Integer& denominator(const Rational& v) { return v.get_den(); }

inline Integer integer(std::int64_t v) {
  static_assert(sizeof(long) == sizeof(std::int64_t), "GMP takes nothing longer; see TAUT_BOOST_NUMBERS");
  return Integer(static_cast<long>(v));
}
inline Rational fraction(const Integer& over, const Integer& under) {
  Rational result(over, under);
  result.canonicalize();
  return result;
}
inline Integer power(unsigned base, unsigned exponent) {
  Integer result;
  mpz_ui_pow_ui(result.get_mpz_t(), base, exponent);
  return result;
}
inline bool is_odd(const Integer& v) { return mpz_odd_p(v.get_mpz_t()); }
/// Of v > 0: how many.
inline std::int64_t bits(const Integer& v) { return static_cast<std::int64_t>(mpz_sizeinbase(v.get_mpz_t(), 2)); }
/// Rounded down. Precondition: under > 0.
inline Integer floor_of_ratio(const Integer& over, const Integer& under) {
  Integer result;
  mpz_fdiv_q(result.get_mpz_t(), over.get_mpz_t(), under.get_mpz_t());
  return result;
}
inline bool is_square(const Integer& v) { return mpz_perfect_square_p(v.get_mpz_t()); }
inline std::int64_t to_int64(const Integer& v) { return v.get_si(); }
inline std::string text_of(const Integer& v) { return v.get_str(); }
inline std::string text_of(const Rational& v) { return v.get_str(); }

/// Towards zero.
inline double to_double(const Rational& v) { return v.get_d(); }
inline double to_double(const BigFloat& v) { return v.get_d(); }

/// Of so many bits at least.
inline BigFloat big_float(const Rational& v, int digits = 256) { return BigFloat(v, static_cast<mp_bitcnt_t>(digits)); }
inline BigFloat halved(const BigFloat& v, int times) { return BigFloat(v >> static_cast<mp_bitcnt_t>(times)); }

#endif

inline Integer floor_of(const Rational& v) { return floor_of_ratio(numerator(v), denominator(v)); }

/// v 2^by, rounded down. Precondition: v >= 0.
inline Integer shifted(const Integer& v, std::int64_t by) {
  return by >= 0 ? Integer(v << static_cast<unsigned>(by)) : Integer(v >> static_cast<unsigned>(-by));
}

}  // namespace taut
