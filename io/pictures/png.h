// Pixels as PNG.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace taut {

using Pixel = std::array<std::uint8_t, 3>;  ///< red, green, blue

/// Row by row, the first at the top. Precondition: pixels.size() == width * height > 0.
struct Pixels {
  int width = 0;
  int height = 0;
  std::vector<Pixel> pixels;
};

/// A PNG file. Same pixels, same bytes, for one libpng and zlib. Throws std::runtime_error when libpng refuses.
std::string png(const Pixels& image);

/// The same as `data:image/png;base64,...`
std::string png_address(const Pixels& image);

}  // namespace taut
