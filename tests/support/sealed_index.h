// Bytes of indexes that were changed, with the checksum made to fit: what somebody could hand out on purpose.
#pragma once

#include <cstddef>
#include <cstring>
#include <vector>

#include <taut/search/detail/index_image.h>

namespace taut::test {

inline void seal_index(std::vector<std::byte>& bytes) {
  detail::IndexImage::Header header;
  std::memcpy(&header, bytes.data(), sizeof header);
  header.check = detail::IndexImage::checksum(header, bytes);
  std::memcpy(bytes.data(), &header, sizeof header);
}

}  // namespace taut::test
