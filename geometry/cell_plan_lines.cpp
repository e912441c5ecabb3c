#include <taut/geometry/cell_plan.h>

#include <algorithm>

namespace taut {

namespace {

/// Moves the bits from `at` on up by one; bit `at` stays as well.
void double_bit(std::uint64_t* row, std::size_t words, std::size_t at) {
  const std::size_t word = at / 64;
  for (std::size_t w = words - 1; w > word; --w) row[w] = row[w] << 1 | row[w - 1] >> 63;
  const std::uint64_t bit = std::uint64_t{1} << (at % 64), kept = row[word] & (bit | (bit - 1)),
                      moved = row[word] & ~(bit - 1);
  row[word] = kept | moved << 1;
}

}  // namespace

/// Room for a further column.
void CellPlan::widen_rows() {
  if (columns() + 1 <= 64 * words_) return;
  for (auto* bits : {&free_, &open_right_, &open_above_}) {
    std::vector<std::uint64_t> wider(rows() * (words_ + 1), 0);
    for (std::size_t row = 0; row < rows(); ++row)
      std::copy_n(bits->data() + row * words_, words_, wider.data() + row * (words_ + 1));
    *bits = std::move(wider);
  }
  ++words_;
}

std::uint32_t CellPlan::make_x_line(double x) {
  const auto [column, right] = columns_at(x);
  if (column != right) return static_cast<std::uint32_t>(right);
  widen_rows();
  const auto at = static_cast<std::size_t>(column);
  for (auto* bits : {&free_, &open_right_, &open_above_})
    for (std::size_t row = 0; row < rows(); ++row) double_bit(bits->data() + row * words_, words_, at);
  xs_.insert(xs_.begin() + column + 1, x);
  for (std::int32_t row = 0; row < static_cast<std::int32_t>(rows()); ++row)
    set_open_right({column, row}, is_free({column, row}));
  return static_cast<std::uint32_t>(column) + 1;
}

std::uint32_t CellPlan::make_y_line(double y) {
  const auto [row, above] = rows_at(y);
  if (row != above) return static_cast<std::uint32_t>(above);
  const auto at = static_cast<std::ptrdiff_t>(words_) * row, words = static_cast<std::ptrdiff_t>(words_);
  for (auto* bits : {&free_, &open_right_, &open_above_}) {
    bits->insert(bits->begin() + at, words, 0);
    std::copy_n(bits->begin() + at + words, words, bits->begin() + at);
  }
  std::copy_n(free_.begin() + at, words, open_above_.begin() + at);
  ys_.insert(ys_.begin() + row + 1, y);
  return static_cast<std::uint32_t>(row) + 1;
}

}  // namespace taut
