// Square matrices of lengths as bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace taut {

/// How a matrix is written down.
enum class MatrixFormat : std::uint8_t {
  csv,  ///< a row a line, separated by commas, each number as short as it reads back as itself; `inf`, `nan`
  npy,  ///< NumPy's own (format version 1.0, `<f8`, C order): numpy.load
  raw,  ///< 64-bit IEEE numbers, little-endian, row by row, nothing else: numpy.fromfile
};

/// `csv`, `npy`, `raw`. As the end of a file's name, `.f64`, `.bin` and `.raw` are raw, `.txt` is csv.
std::optional<MatrixFormat> matrix_format_named(std::string_view word);
std::optional<MatrixFormat> matrix_format_of_file(std::string_view file);

/// The bytes of `values`, rows of `columns` each. Precondition: values.size() is a multiple of columns.
std::string matrix_bytes(std::span<const double> values, std::size_t columns, MatrixFormat format);

}  // namespace taut
