#include <taut/io/worlds/raster.h>

#include <png.h>

#include <cctype>
#include <cstddef>
#include <optional>

#include <taut/geometry/errors.h>

namespace taut {

namespace {

constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 28;

[[noreturn]] void fail(const std::string& source, const std::string& message) { throw InputError(source, 0, message); }

void check_size(std::uint64_t width, std::uint64_t height, const std::string& source) {
  if (width == 0 || height == 0) fail(source, "a picture without pixels");
  if (width > kMostPixels || height > kMostPixels || width * height > kMostPixels)
    fail(source, "a picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels is too large");
}

Raster read_png(std::string_view bytes, const std::string& source) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0)
    fail(source, std::string("not a valid PNG: ") + image.message);
  image.format = PNG_FORMAT_GA;
  const std::uint64_t width = image.width, height = image.height;
  if (width * height > kMostPixels) png_image_free(&image);
  check_size(width, height, source);
  std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) == 0)
    fail(source, std::string("not a valid PNG: ") + image.message);
  Raster raster{image.width, image.height, {}, {}};
  for (std::size_t i = 0; i < pixels.size(); i += 2) {
    raster.grey.push_back(pixels[i]);
    raster.alpha.push_back(pixels[i + 1]);
  }
  return raster;
}

// Header words and, of P2, values: separated by white space, `#` to the end of a line being a comment.
class Pgm {
 public:
  Pgm(std::string_view bytes, const std::string& source) : rest_(bytes.substr(2)), source_(source) {}

  std::optional<unsigned> number() {
    skip();
    if (rest_.empty() || std::isdigit(static_cast<unsigned char>(rest_.front())) == 0) return std::nullopt;
    std::uint64_t value = 0;
    while (!rest_.empty() && std::isdigit(static_cast<unsigned char>(rest_.front())) != 0 && value <= kMostPixels) {
      value = value * 10 + static_cast<std::uint64_t>(rest_.front() - '0');
      rest_.remove_prefix(1);
    }
    return static_cast<unsigned>(value);
  }

  unsigned header(const char* what) {
    const std::optional<unsigned> value = number();
    if (!value) fail(source_, std::string("a portable grey map without its ") + what);
    return *value;
  }

  // What follows the single blank after the header.
  std::string_view binary() const { return rest_.substr(rest_.empty() ? 0 : 1); }

 private:
  void skip() {
    while (!rest_.empty()) {
      if (rest_.front() == '#') {
        const std::size_t end = rest_.find('\n');
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end);
      } else if (std::isspace(static_cast<unsigned char>(rest_.front())) != 0) {
        rest_.remove_prefix(1);
      } else {
        return;
      }
    }
  }

  std::string_view rest_;
  const std::string& source_;
};

std::uint8_t scaled(unsigned value, unsigned most) {
  return static_cast<std::uint8_t>((value * 255ULL + most / 2) / most);
}

[[noreturn]] void ends_early(std::size_t found, std::size_t wanted, const std::string& source) {
  fail(source, "the picture ends after " + std::to_string(found) + " of " + std::to_string(wanted) + " pixels");
}

void read_values(Pgm& pgm, unsigned most, std::size_t count, Raster& raster, const std::string& source) {
  while (raster.grey.size() < count) {
    const std::optional<unsigned> value = pgm.number();
    if (!value) ends_early(raster.grey.size(), count, source);
    if (*value > most) fail(source, "grey value " + std::to_string(*value) + " above " + std::to_string(most));
    raster.grey.push_back(scaled(*value, most));
  }
}

void read_bytes(std::string_view bytes, unsigned most, std::size_t count, Raster& raster, const std::string& source) {
  const std::size_t depth = most > 255 ? 2 : 1;
  if (bytes.size() / depth < count) ends_early(bytes.size() / depth, count, source);
  for (std::size_t i = 0; i < count; ++i) {
    unsigned value = static_cast<unsigned char>(bytes[i * depth]);
    if (depth == 2) value = value * 256 + static_cast<unsigned char>(bytes[i * depth + 1]);
    raster.grey.push_back(scaled(std::min(value, most), most));
  }
}

Raster read_pgm(std::string_view bytes, const std::string& source) {
  Pgm pgm(bytes, source);
  const unsigned width = pgm.header("width"), height = pgm.header("height"), most = pgm.header("greatest value");
  check_size(width, height, source);
  if (most == 0 || most > 65535)
    fail(source, "the greatest grey value is " + std::to_string(most) + ", not 1 to 65535");
  Raster raster{width, height, {}, {}};
  const std::size_t count = std::size_t{width} * height;
  if (bytes[1] == '2')
    read_values(pgm, most, count, raster, source);
  else
    read_bytes(pgm.binary(), most, count, raster, source);
  return raster;
}

}  // namespace

bool is_png(std::string_view bytes) { return bytes.starts_with("\x89PNG\r\n\x1a\n"); }

bool is_pgm(std::string_view bytes) {
  return bytes.size() > 2 && bytes[0] == 'P' && (bytes[1] == '2' || bytes[1] == '5') &&
         std::isspace(static_cast<unsigned char>(bytes[2])) != 0;
}

Raster read_raster(std::string_view bytes, const std::string& source) {
  if (is_png(bytes)) return read_png(bytes, source);
  if (is_pgm(bytes)) return read_pgm(bytes, source);
  fail(source, "is no picture that is read here (PNG, or a portable grey map P2, P5)");
}

}  // namespace taut
