// A hash that never changes.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace taut::detail {

/// FNV-1a with 128 bits (Fowler, Noll, Vo; draft-eastlake-fnv).
class Fnv {
 public:
  void add(std::string_view bytes) {
    for (const char c : bytes) byte(static_cast<unsigned char>(c));
  }
  void add(std::uint64_t value) {  ///< as 8 bytes, lowest first
    for (int i = 0; i < 64; i += 8) byte(static_cast<unsigned char>(value >> i));
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value + 0.0)); }  ///< -0 as 0

  std::string hex() const {  ///< 32 digits
    std::string out;
    for (int shift = 124; shift >= 0; shift -= 4)
      out += "0123456789abcdef"[static_cast<unsigned>(state_ >> shift) & 15];
    return out;
  }

 private:
  __extension__ using Wide = unsigned __int128;

  void byte(unsigned char b) { state_ = (state_ ^ b) * ((Wide{1} << 88) + 0x13b); }

  Wide state_ = (Wide{0x6c62272e07bb0142} << 64) + 0x62b821756295c58d;
};

}  // namespace taut::detail
