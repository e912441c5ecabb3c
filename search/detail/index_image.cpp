#include <taut/search/detail/index_image.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

namespace taut::detail {

namespace {

static_assert(sizeof(IndexImage::Header) <= IndexImage::kHeaderBytes);
static_assert(sizeof(IndexImage::Up) == 28 && sizeof(IndexImage::Core) == 24);

/// Of 4-byte words: accidents show.
class Checksum {
 public:
  void add(const void* words, std::size_t count) {
    const auto* at = static_cast<const std::byte*>(words);
    for (std::size_t i = 0; i < count; ++i) {
      std::uint32_t word;
      std::memcpy(&word, at + 4 * i, 4);
      state_ = (std::rotl(state_, 23) ^ word) * 0x9e3779b97f4a7c15;
    }
  }
  std::uint64_t value() const { return state_ ^ (state_ >> 32); }

 private:
  std::uint64_t state_ = 0x243f6a8885a308d3;
};

[[noreturn]] void refuse(const std::string& why) { throw std::runtime_error(why); }

}  // namespace

std::size_t IndexImage::words(const Header& h) {
  return std::size_t{3} * h.labels + h.bends + 1 + (h.has_sights ? std::size_t{4} * h.triangles + 1 : 0) +
         h.sight_words + (h.has_core ? 2 * (h.bends + std::size_t{1}) : 0) + std::size_t{7} * h.ups +
         std::size_t{6} * h.cores;
}

std::uint64_t IndexImage::checksum(Header header, std::span<const std::byte> bytes) {
  header.check = 0;
  Checksum check;
  check.add(&header, sizeof header / 4);
  check.add(bytes.data() + sizeof header, (bytes.size() - sizeof header) / 4);
  return check.value();
}

IndexImage::IndexImage(std::span<const std::byte> bytes, std::uint64_t space, std::size_t bends, std::size_t places) {
  if (bytes.size() < kHeaderBytes) refuse("is cut off");
  std::memcpy(&header_, bytes.data(), sizeof header_);
  if (header_.magic != kMagic) refuse("holds no index for this kind of machine");
  if (header_.version != kVersion)
    refuse("holds an index of version " + std::to_string(header_.version) + "; this program reads version " +
           std::to_string(kVersion));
  if (bytes.size() != kHeaderBytes + 4 * words(header_)) refuse("is cut off");
  if (checksum(header_, bytes) != header_.check) refuse("is damaged: its checksum is not that of its content");
  if (header_.space != space || header_.bends != bends) refuse("was built on another triangulation of this world");
  const auto* at = reinterpret_cast<const std::uint32_t*>(bytes.data() + kHeaderBytes);
  const auto take = [&](std::size_t count) {
    const std::span<const std::uint32_t> part(at, count);
    at += count;
    return part;
  };
  labels_ = {reinterpret_cast<const Label*>(take(std::size_t{2} * header_.labels).data()), header_.labels};
  next_ = take(header_.labels);
  begin_ = take(header_.bends + std::size_t{1});
  sights_begin_ = take(header_.has_sights ? 4 * std::size_t{header_.triangles} + 1 : 0);
  sights_ = take(header_.sight_words);
  if (header_.has_core) {
    ups_begin_ = take(header_.bends + std::size_t{1});
    cores_begin_ = take(header_.bends + std::size_t{1});
    ups_ = {reinterpret_cast<const Up*>(take(std::size_t{7} * header_.ups).data()), header_.ups};
    cores_ = {reinterpret_cast<const Core*>(take(std::size_t{6} * header_.cores).data()), header_.cores};
  }
  require_sound(places);
}

/// That no number in it leads out of it: a checksum protects from accidents only.
void IndexImage::require_sound(std::size_t places) const {
  bool sound = std::isfinite(header_.per_length) && header_.per_length > 0 && begin_.front() == 0 &&
               begin_.back() == header_.labels;
  for (std::size_t v = 0; v < header_.bends; ++v)
    sound = sound && begin_[v + 1] <= header_.labels &&
            (begin_[v] + 2 <= begin_[v + 1] || (begin_[v] == begin_[v + 1] && has_core()));
  for (std::size_t k = 0; k < labels_.size() && sound; ++k)
    sound = labels_[k].hub < header_.bends && labels_[k].length <= 1u << 30 && next_[k] < labels_.size() &&
            labels_[next_[k]].hub == labels_[k].hub && labels_[next_[k]].length <= labels_[k].length;
  for (std::size_t group = 0; group + 1 < sights_begin_.size() && sound; ++group) {
    const std::uint32_t width = kSightWords[group % 4], first = sights_begin_[group], last = sights_begin_[group + 1];
    sound = first <= last && last <= sights_.size() && (last - first) % width == 0;
    for (std::uint32_t k = first; k < last && sound; k += width) {
      const std::uint32_t bend = sights_[k] / 2;
      sound = bend < header_.bends && sights_[k + 1] <= begin_[bend + 1] - begin_[bend];
      for (std::uint32_t i = 2; i < width; ++i) sound = sound && sights_[k + i] < places;
    }
  }
  if (!sound || !is_core_sound()) refuse("is damaged: a number in it leads out of it");
}

/// An edge's children are of a bend taken out before: so unpacking one comes to an end.
bool IndexImage::is_core_sound() const {
  if (!has_core()) return true;
  const auto is_rising = [&](std::span<const std::uint32_t> begin, std::size_t size) {
    return begin.front() == 0 && begin.back() == size && std::is_sorted(begin.begin(), begin.end());
  };
  if (!is_rising(ups_begin_, ups_.size()) || !is_rising(cores_begin_, cores_.size())) return false;
  std::vector<std::uint32_t> from(ups_.size());
  for (std::uint32_t bend = 0; bend < header_.bends; ++bend)
    std::fill(from.begin() + ups_begin_[bend], from.begin() + ups_begin_[bend + 1], bend);
  const auto is_sound = [&](std::uint32_t bend, const Edge& edge) {
    if (edge.to >= header_.bends || edge.first_hop / 4 >= header_.bends || edge.last_hop / 4 >= header_.bends)
      return false;
    if (edge.first_child == kNone) return true;
    return edge.first_child < ups_.size() && edge.last_child < ups_.size() && ups_[edge.first_child].to == bend &&
           ups_[edge.last_child].to == edge.to && from[edge.first_child] == from[edge.last_child];
  };
  for (std::uint32_t bend = 0; bend < header_.bends; ++bend) {
    for (const Up& edge : ups(bend))
      if (!is_sound(bend, edge) || !(edge.length() >= 0)) return false;
    for (const Core& edge : cores(bend))
      if (!is_sound(bend, edge) || edge.label < begin_[bend] || edge.label > begin_[bend + 1]) return false;
  }
  return true;
}

std::uint64_t space_print(const Triangulation& tri) {
  Checksum check;
  check.add(tri.points.data(), 4 * tri.points.size());
  check.add(tri.triangles.data(), 3 * tri.triangles.size());
  check.add(tri.neighbours.data(), 3 * tri.neighbours.size());
  return check.value();
}

}  // namespace taut::detail
