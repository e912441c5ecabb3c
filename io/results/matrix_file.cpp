#include <taut/io/results/matrix_file.h>

#include <fmt/format.h>

#include <bit>

#include <taut/io/results/words.h>

namespace taut {

namespace {

std::string csv(std::span<const double> values, std::size_t columns) {
  std::string text;
  text.reserve(values.size() * 18);
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += number_text(values[i]);
    text += (i + 1) % columns == 0 ? '\n' : ',';
  }
  return text;
}

void append_little_endian(std::string& bytes, std::span<const double> values) {
  if constexpr (std::endian::native == std::endian::little) {
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  } else {
    for (const double value : values)
      for (int shift = 0; shift < 64; shift += 8)
        bytes += static_cast<char>(std::bit_cast<std::uint64_t>(value) >> shift & 0xff);
  }
}

/// Padded so that the numbers begin at a multiple of 64.
std::string npy_header(std::size_t rows, std::size_t columns) {
  constexpr std::size_t kBefore = 10;
  std::string dict = fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}), }}", rows, columns);
  dict.append(63 - (kBefore + dict.size()) % 64, ' ').append("\n");
  std::string bytes = "\x93NUMPY\x01";
  for (const std::size_t byte : {std::size_t{0}, dict.size() & 0xff, dict.size() >> 8})
    bytes.push_back(static_cast<char>(byte));
  return bytes + dict;
}

}  // namespace

std::optional<MatrixFormat> matrix_format_named(std::string_view word) {
  if (word == "csv") return MatrixFormat::csv;
  if (word == "npy") return MatrixFormat::npy;
  if (word == "raw") return MatrixFormat::raw;
  return std::nullopt;
}

std::optional<MatrixFormat> matrix_format_of_file(std::string_view file) {
  const std::size_t dot = file.find_last_of("./");
  if (dot == std::string_view::npos || file[dot] == '/') return std::nullopt;
  const std::string_view ending = file.substr(dot + 1);
  if (ending == "txt") return MatrixFormat::csv;
  if (ending == "bin" || ending == "f64") return MatrixFormat::raw;
  return matrix_format_named(ending);
}

std::string matrix_bytes(std::span<const double> values, std::size_t columns, MatrixFormat format) {
  if (format == MatrixFormat::csv) return csv(values, columns);
  std::string bytes;
  const std::string header =
      format == MatrixFormat::npy ? npy_header(columns == 0 ? 0 : values.size() / columns, columns) : "";
  bytes.reserve(header.size() + values.size_bytes());
  bytes += header;
  append_little_endian(bytes, values);
  return bytes;
}

}  // namespace taut
