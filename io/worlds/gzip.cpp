#include <taut/io/worlds/gzip.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <new>

#include <taut/geometry/errors.h>

namespace taut {

namespace {

constexpr std::size_t kLargestPiece = std::size_t{1} << 30;  // zlib counts in 32 bits

class Inflation {
 public:
  Inflation(std::string_view bytes, const std::string& source, std::size_t limit)
      : rest_(bytes), source_(source), limit_(limit) {
    if (inflateInit2(&stream_, 15 + 16) != Z_OK) throw std::bad_alloc();
  }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;
  ~Inflation() { inflateEnd(&stream_); }

  std::string all() {
    do member();
    while (is_gzip(rest_));
    // Like gzip, what is no further member is padding.
    return std::move(out_);
  }

 private:
  void member() {
    inflateReset(&stream_);
    for (int code = Z_OK; code != Z_STREAM_END;) {
      const std::size_t piece = std::min(rest_.size(), kLargestPiece);
      stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(rest_.data()));
      stream_.avail_in = static_cast<uInt>(piece);
      stream_.next_out = block_.data();
      stream_.avail_out = static_cast<uInt>(block_.size());
      code = inflate(&stream_, Z_NO_FLUSH);
      rest_.remove_prefix(piece - stream_.avail_in);
      keep(block_.size() - stream_.avail_out);
      if (code == Z_OK) continue;
      if (code == Z_MEM_ERROR) throw std::bad_alloc();
      if (code == Z_BUF_ERROR) throw InputError(source_, 0, "gzip data is cut off");
      if (code != Z_STREAM_END)
        throw InputError(source_, 0, std::string("gzip data is damaged: ") + (stream_.msg ? stream_.msg : "unknown"));
    }
  }

  void keep(std::size_t count) {
    if (count > limit_ - out_.size())
      throw InputError(source_, 0, "gzip data unpacks to more than " + std::to_string(limit_) + " bytes");
    out_.append(reinterpret_cast<const char*>(block_.data()), count);
  }

  std::string_view rest_;
  const std::string& source_;
  std::size_t limit_;
  z_stream stream_{};
  std::string out_;
  std::array<Bytef, 1 << 16> block_;
};

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

std::string gunzip(std::string_view bytes, const std::string& source, std::size_t limit) {
  return Inflation(bytes, source, limit).all();
}

}  // namespace taut
