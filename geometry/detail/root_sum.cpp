#include <taut/geometry/detail/root_sum.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace taut::detail {

namespace {

__extension__ typedef __int128 Wide;  // NOLINT(modernize-use-using): pedantic compilers take no other

auto key(const RootTerm& t) {
  const twofold::Square& s = t.square;
  return std::tuple(s.sum, s.exact, s.dx.high, s.dx.low, s.dy.high, s.dy.low);
}

bool same_square(const twofold::Square& s, const twofold::Square& t) {
  if (s.sum != t.sum || s.exact != t.exact) return false;
  return s.exact || (s.dx == t.dx && s.dy == t.dy);
}

twofold::Square canonical_square(twofold::Pair dx, twofold::Pair dy) {
  twofold::Square s = twofold::square_of(dx, dy);
  s.exact = s.exact && twofold::is_regular(s);
  if (s.exact)
    s.dx = s.dy = twofold::Pair{};
  else if (std::tie(s.dx.high, s.dx.low) < std::tie(s.dy.high, s.dy.low))
    std::swap(s.dx, s.dy);
  return s;
}

/// A sum of pairs that remembers whether it ever lost a bit.
class PairSum {
 public:
  void add(const twofold::Root& root, std::int64_t count) {
    const double times = static_cast<double>(count);
    const twofold::Pair high = twofold::two_product(root.high, times), low = twofold::two_product(root.low, times);
    const twofold::Pair sum = twofold::two_sum(high_, high.high);
    high_ = sum.high;
    magnitude_ += std::abs(high.high);
    ++terms_;
    exact_ = exact_ && root.exact && low.low == 0;
    add_low(sum.low);
    add_low(high.low);
    add_low(low.high);
  }

  std::optional<int> sign() const {
    const double sum = high_ + low_, bound = error();
    if (sum > bound || (exact_ && sum > 0)) return 1;
    if (-sum > bound || (exact_ && sum < 0)) return -1;
    return exact_ ? std::optional(0) : std::nullopt;
  }

  std::optional<double> nearest() const {
    const double sum = high_ + low_, rest = (high_ - sum) + low_, bound = error();
    // Rounding is monotone: where both ends of the enclosure round to the same double, so does what is between them.
    if (exact_ || (sum + (rest + bound) == sum && sum + (rest - bound) == sum)) return sum;
    return std::nullopt;
  }

 private:
  void add_low(double v) {
    const twofold::Pair sum = twofold::two_sum(low_, v);
    low_ = sum.high;
    exact_ = exact_ && sum.low == 0;
  }

  /// Each of n terms is off by 2^-98 of itself; each of 3n small additions by u * 3n * u of the magnitude.
  double error() const { return exact_ ? 0 : magnitude_ * (0x1p-95 + terms_ * terms_ * 0x1p-101); }

  double high_ = 0, low_ = 0, magnitude_ = 0, terms_ = 0;
  bool exact_ = true;
};

std::optional<PairSum> pair_sum(std::span<const RootTerm> terms) {
  PairSum sum;
  for (const RootTerm& t : terms) {
    if (!twofold::is_regular(t.square)) return std::nullopt;
    sum.add(t.square.exact ? twofold::root_of(t.square.sum, 0, true) : twofold::root_of(t.square), t.count);
  }
  return sum;
}

/// odd * 2^exponent, odd below 2^53: an exact square.
struct SmallSquare {
  std::uint64_t odd = 0;
  int exponent = 0;
  std::int64_t count = 0;
};

SmallSquare small_square(const RootTerm& t) {
  int exponent = 0;
  const auto mantissa = static_cast<std::uint64_t>(std::ldexp(std::frexp(t.square.sum, &exponent), 53));
  const int zeros = std::countr_zero(mantissa);
  return {mantissa >> zeros, exponent - 53 + zeros, t.count};
}

std::uint64_t small_root(std::uint64_t v) { return static_cast<std::uint64_t>(std::sqrt(static_cast<double>(v))); }
bool is_square(std::uint64_t v) { return small_root(v) * small_root(v) == v; }

bool same_class(const SmallSquare& a, const SmallSquare& b) {
  if ((a.exponent - b.exponent) % 2 != 0) return false;
  const std::uint64_t common = std::gcd(a.odd, b.odd);
  return is_square(a.odd / common) && is_square(b.odd / common);
}

/// The sign of the sum of one class, taken out of `squares`; nothing when it would not fit.
std::optional<int> take_class(std::vector<SmallSquare>& squares) {
  const auto rest = std::partition(squares.begin(), squares.end(),
                                   [first = squares.front()](const SmallSquare& s) { return !same_class(first, s); });
  std::uint64_t common = 0;
  int least = INT32_MAX;
  for (auto s = rest; s != squares.end(); ++s) {
    common = std::gcd(common, s->odd);
    least = std::min(least, s->exponent);
  }
  // Squares of one class over their common divisor are squares: the class is sqrt(common) * sum of integers.
  Wide sum = 0;
  for (auto s = rest; s != squares.end(); ++s) {
    const int shift = (s->exponent - least) / 2;
    if (shift > 40 || std::abs(s->count) > INT32_MAX) return std::nullopt;
    sum += static_cast<Wide>(s->count) * small_root(s->odd / common) * (Wide{1} << shift);
  }
  squares.erase(rest, squares.end());
  return (sum > 0) - (sum < 0);
}

}  // namespace

RootSum::RootSum(std::span<const Segment> plus, std::span<const Segment> minus) {
  for (const Segment& leg : plus) add(leg, 1);
  for (const Segment& leg : minus) add(leg, -1);
  merge();
}

void RootSum::add(const Segment& leg, int sign) {
  if (leg.a == leg.b) return;
  const twofold::Pair dx = twofold::absolute_difference(leg.a.x, leg.b.x),
                      dy = twofold::absolute_difference(leg.a.y, leg.b.y);
  // Chains on a lattice run on in one direction.
  if (size_ == 0 || dx != last_dx_ || dy != last_dy_) last_ = find_or_append(canonical_square(dx, dy));
  last_dx_ = dx;
  last_dy_ = dy;
  data()[last_].count += sign;
}

std::size_t RootSum::find_or_append(const twofold::Square& square) {
  const RootTerm* const terms = data();
  for (std::size_t i = 0; i < std::min(size_, kScanned); ++i)
    if (same_square(terms[i].square, square)) return i;
  append({square, 0});
  return size_ - 1;
}

void RootSum::append(const RootTerm& term) {
  if (size_ < kInline) {
    std::construct_at(&inline_[size_++], term);
    return;
  }
  if (spilled_.empty()) spilled_.assign(&inline_[0], &inline_[0] + size_);
  spilled_.push_back(term);
  ++size_;
}

void RootSum::merge() {
  RootTerm* const terms = data();
  if (size_ > kScanned) {
    std::sort(terms, terms + size_, [](const RootTerm& a, const RootTerm& b) { return key(a) < key(b); });
    std::size_t kept = 0;
    for (std::size_t i = 1; i < size_; ++i) {
      if (same_square(terms[kept].square, terms[i].square))
        terms[kept].count += terms[i].count;
      else
        terms[++kept] = terms[i];
    }
    size_ = kept + 1;
  }
  size_ = static_cast<std::size_t>(
      std::remove_if(terms, terms + size_, [](const RootTerm& t) { return t.count == 0; }) - terms);
}

int RootSum::sign() const {
  if (size_ == 0) return 0;
  if (const auto sign = sign_by_pairs(terms())) return *sign;
  if (const auto sign = sign_by_small_classes(terms())) return *sign;
  return sign_by_big_numbers(terms());
}

double RootSum::nearest() const {
  if (const auto value = nearest_by_pairs(terms())) return *value;
  return nearest_by_big_numbers(terms());
}

std::string RootSum::decimals(int places) const { return decimals_by_big_numbers(terms(), places); }

std::optional<int> sign_by_pairs(std::span<const RootTerm> terms) {
  const auto sum = pair_sum(terms);
  return sum ? sum->sign() : std::nullopt;
}

std::optional<double> nearest_by_pairs(std::span<const RootTerm> terms) {
  const auto sum = pair_sum(terms);
  return sum ? sum->nearest() : std::nullopt;
}

std::optional<int> sign_by_small_classes(std::span<const RootTerm> terms) {
  std::vector<SmallSquare> squares;
  squares.reserve(terms.size());
  for (const RootTerm& t : terms) {
    if (!t.square.exact) return std::nullopt;
    squares.push_back(small_square(t));
  }
  int agreed = 0;
  while (!squares.empty()) {
    const auto sign = take_class(squares);
    if (!sign || *sign * agreed < 0) return std::nullopt;
    if (*sign != 0) agreed = *sign;
  }
  return agreed;
}

}  // namespace taut::detail
