// Sets of cells as bits, moved in bulk. Private.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include <taut/robots/micromouse/wall_map.h>

namespace taut::micromouse::detail {

inline std::size_t index_of(int width, Cell c) {
  return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(c.x);
}

inline Cell cell_of(int width, std::size_t i) {
  return {static_cast<int>(i % static_cast<std::size_t>(width)), static_cast<int>(i / static_cast<std::size_t>(width))};
}

inline bool holds(const CellBits& bits, std::size_t i) { return (bits[i / 64] >> (i % 64) & 1U) != 0; }
inline void put(CellBits& bits, std::size_t i) { bits[i / 64] |= std::uint64_t{1} << (i % 64); }

template <class Visit>
void for_each_bit(const std::uint64_t* bits, std::size_t words, Visit visit) {
  for (std::size_t k = 0; k < words; ++k)
    for (std::uint64_t w = bits[k]; w != 0; w &= w - 1) visit(k * 64 + static_cast<std::size_t>(std::countr_zero(w)));
}

/// out = (in << bits), in and out distinct.
inline void shift_up(const std::uint64_t* in, std::uint64_t* out, std::size_t words, std::size_t bits) {
  const std::size_t whole = bits / 64, part = bits % 64;
  for (std::size_t k = words; k-- > 0;) {
    const std::uint64_t high = k >= whole ? in[k - whole] : 0;
    const std::uint64_t low = k > whole ? in[k - whole - 1] : 0;
    out[k] = part == 0 ? high : high << part | low >> (64 - part);
  }
}

/// out = (in >> bits), in and out distinct.
inline void shift_down(const std::uint64_t* in, std::uint64_t* out, std::size_t words, std::size_t bits) {
  const std::size_t whole = bits / 64, part = bits % 64;
  for (std::size_t k = 0; k < words; ++k) {
    const std::uint64_t low = k + whole < words ? in[k + whole] : 0;
    const std::uint64_t high = k + whole + 1 < words ? in[k + whole + 1] : 0;
    out[k] = part == 0 ? low : low >> part | high << (64 - part);
  }
}

/// Breadth-first search in steps over the passages, one set of cells a level.
class StepSearch {
 public:
  explicit StepSearch(std::size_t width, std::size_t words)
      : width_(width), words_(words), reached_(words), frontier_(words), next_(words), a_(words), b_(words) {}

  void start(const Passages& p, std::size_t cell);
  void start(const Passages& p, const CellBits& cells);
  /// The cells that come in with the next level; false when there are none.
  bool advance();

  const CellBits& frontier() const { return frontier_; }
  const CellBits& reached() const { return reached_; }
  int level() const { return level_; }

 private:
  void slide(Side side);

  std::size_t width_;
  std::size_t words_;
  const Passages* passages_ = nullptr;
  CellBits reached_, frontier_, next_, a_, b_;
  int level_ = 0;
};

/// The cells one step (1 to 3 cells) from the set `from`, added to `into`; scratch as large as these.
void slide(const Passages& p, const std::uint64_t* from, std::uint64_t* into, Side side, std::uint64_t* a,
           std::uint64_t* b);

}  // namespace taut::micromouse::detail
