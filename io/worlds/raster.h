// Grey pictures.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace taut {

/// Rows from the top, first column first.
struct Raster {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> grey;   ///< 0 black, 255 white
  std::vector<std::uint8_t> alpha;  ///< 0 clear, 255 opaque; empty: all opaque
};

/// Do bytes begin as PNG, or as portable grey map (P2, P5)?
bool is_png(std::string_view bytes);
bool is_pgm(std::string_view bytes);

/// Reads PNG (by libpng; colours become grey), P5 and P2 of any depth (scaled to 255). At most 2^28 pixels. Throws
/// InputError with `source` on anything else, and on a picture that ends early.
Raster read_raster(std::string_view bytes, const std::string& source);

}  // namespace taut
