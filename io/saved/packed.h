// Values as bytes, the same on every machine.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <taut/geometry/errors.h>
#include <taut/geometry/point.h>

namespace taut {

/// Puts values one after the other: numbers as 8 bytes, lowest first, texts behind their length.
class Packer {
 public:
  Packer& put(std::uint64_t value) {
    for (int i = 0; i < 64; i += 8) bytes_ += static_cast<char>(static_cast<unsigned char>(value >> i));
    return *this;
  }
  Packer& put(double value) { return put(std::bit_cast<std::uint64_t>(value)); }
  Packer& put(Point p) { return put(p.x).put(p.y); }
  Packer& put(std::string_view text) {
    put(std::uint64_t{text.size()});
    bytes_ += text;
    return *this;
  }
  std::string bytes() && { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Takes them again, in the same order. Throws InputError with `name` where there are fewer bytes.
class Unpacker {
 public:
  Unpacker(std::string_view bytes, std::string name) : rest_(bytes), name_(std::move(name)) {}

  std::uint64_t number() {
    const std::string_view bytes = take(8);
    std::uint64_t value = 0;
    for (std::size_t i = 8; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return value;
  }
  double real() { return std::bit_cast<double>(number()); }
  Point point() {
    const double x = real();
    return {x, real()};
  }
  std::string text() { return std::string(take(number())); }
  bool empty() const { return rest_.empty(); }

 private:
  std::string_view take(std::uint64_t count) {
    if (rest_.size() < count) throw InputError(name_, 0, "holds less than it says");
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

  std::string_view rest_;
  std::string name_;
};

}  // namespace taut
