#include <taut/robots/micromouse/detail/boards.h>

#include <algorithm>

namespace taut::micromouse::detail {

namespace {

// Words is the number of words where it is known at compile time (0: it is not): small mazes are unrolled.
template <std::size_t Words>
void slide_words(const Passages& p, const std::uint64_t* from, std::uint64_t* into, Side side, std::uint64_t* a,
                 std::uint64_t* b) {
  const std::size_t words = Words == 0 ? p.words() : Words;
  const bool vertical = side == Side::north || side == Side::south;
  const std::uint64_t* open = vertical ? p.north.data() : p.east.data();
  const std::size_t bits = vertical ? static_cast<std::size_t>(p.width) : 1;
  std::copy_n(from, words, a);
  for (int i = 0; i < kLongestMove; ++i) {
    if (side == Side::north || side == Side::east) {
      for (std::size_t k = 0; k < words; ++k) a[k] &= open[k];
      shift_up(a, b, words, bits);
      std::swap(a, b);
    } else {
      shift_down(a, b, words, bits);
      for (std::size_t k = 0; k < words; ++k) b[k] &= open[k];
      std::swap(a, b);
    }
    for (std::size_t k = 0; k < words; ++k) into[k] |= a[k];
  }
}

}  // namespace

void slide(const Passages& p, const std::uint64_t* from, std::uint64_t* into, Side side, std::uint64_t* a,
           std::uint64_t* b) {
  switch (p.words()) {
    case 3: return slide_words<3>(p, from, into, side, a, b);
    case 4: return slide_words<4>(p, from, into, side, a, b);
    case 16: return slide_words<16>(p, from, into, side, a, b);
    default: return slide_words<0>(p, from, into, side, a, b);
  }
}

void StepSearch::start(const Passages& p, std::size_t cell) {
  std::fill(frontier_.begin(), frontier_.end(), 0);
  put(frontier_, cell);
  passages_ = &p;
  reached_ = frontier_;
  level_ = 0;
}

void StepSearch::start(const Passages& p, const CellBits& cells) {
  frontier_ = cells;
  passages_ = &p;
  reached_ = frontier_;
  level_ = 0;
}

bool StepSearch::advance() {
  std::fill(next_.begin(), next_.end(), 0);
  for (const Side side : kSides) detail::slide(*passages_, frontier_.data(), next_.data(), side, a_.data(), b_.data());
  std::uint64_t any = 0;
  for (std::size_t k = 0; k < words_; ++k) {
    frontier_[k] = next_[k] & ~reached_[k];
    reached_[k] |= next_[k];
    any |= frontier_[k];
  }
  ++level_;
  return any != 0;
}

}  // namespace taut::micromouse::detail
