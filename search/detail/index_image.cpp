#include <taut/search/detail/index_image.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

namespace taut::detail {

namespace {

constexpr std::uint64_t kMagic = 0x3178656e64697874;  // also tells that bytes are in this machine's order
constexpr std::size_t kHeaderBytes = 128;
static_assert(sizeof(IndexImage::Header) <= kHeaderBytes);

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

/// Puts labels in their places.
class Packer {
 public:
  Packer(const HubGraph& graph, const HubLabels& labels, double extent) : graph_(graph), from_(labels) {
    double longest = 0;
    for (const auto& of_bend : labels.labels)
      for (const HubLabels::Label& label : of_bend) longest = std::max(longest, label.length);
    per_length = longest + extent > 0 ? 0x1p30 / (longest + extent) : 1;
    group_.resize(graph.edges.size() + 1);
    for (std::uint32_t v = 0; v < graph.size(); ++v) pack(v);
    begin.push_back(static_cast<std::uint32_t>(labels_out.size()));
    for (std::uint32_t v = 0; v < graph.size(); ++v) link(v);
  }

  /// How many labels of the bend, itself among them, go on by so many edges from one side on.
  std::uint32_t count(std::uint32_t bend, std::uint32_t edges) const {
    const std::uint32_t v = bend / 2, first = graph_.first[v], last = graph_.first[v + 1];
    if (bend % 2 == kRightTurn) return (first + edges < last ? group_[first + edges] : begin[v + 1] - 1) - begin[v];
    return edges == 0 ? 1 : begin[v + 1] - group_[last - edges];
  }

  std::vector<IndexImage::Label> labels_out;
  std::vector<std::uint32_t> next, begin;
  double per_length = 1;

 private:
  void pack(std::uint32_t v) {
    const auto& labels = from_.labels[v];
    begin.push_back(static_cast<std::uint32_t>(labels_out.size()));
    const IndexImage::Label self{from_.hub_of[v], 0};
    labels_out.push_back(self);
    place_begin_.push_back(place_.size());
    place_.resize(place_.size() + labels.size());
    by_edge_.resize(std::max<std::size_t>(by_edge_.size(), graph_.first[v + 1] - graph_.first[v]));
    for (auto& bucket : by_edge_) bucket.clear();
    for (std::uint32_t k = 0; k < labels.size(); ++k)
      if (labels[k].edge != kNone)
        by_edge_[labels[k].edge - graph_.first[v]].push_back(k);
      else
        place_[place_begin_.back() + k] = begin.back();
    for (std::uint32_t e = graph_.first[v]; e < graph_.first[v + 1]; ++e) {
      group_[e] = static_cast<std::uint32_t>(labels_out.size());
      // Of two edges along both sides of a wall both have the labels.
      for (const std::uint32_t k : by_edge_[graph_.back[graph_.back[e]] - graph_.first[v]]) {
        place_[place_begin_.back() + k] = static_cast<std::uint32_t>(labels_out.size());
        labels_out.push_back({labels[k].hub, static_cast<std::uint32_t>(std::lround(labels[k].length * per_length))});
      }
    }
    labels_out.push_back(self);
  }

  void link(std::uint32_t v) {
    next.push_back(begin[v]);
    for (std::uint32_t e = graph_.first[v]; e < graph_.first[v + 1]; ++e) {
      const std::uint32_t end = e + 1 < graph_.first[v + 1] ? group_[e + 1] : begin[v + 1] - 1;
      const std::uint32_t to = graph_.edges[e].to;
      for (std::uint32_t k = group_[e]; k < end; ++k) next.push_back(place_of(to, labels_out[k].hub));
    }
    next.push_back(begin[v + 1] - 1);
  }

  std::uint32_t place_of(std::uint32_t v, std::uint32_t hub) const {
    const auto& labels = from_.labels[v];
    const auto at = std::lower_bound(labels.begin(), labels.end(), hub,
                                     [](const HubLabels::Label& l, std::uint32_t h) { return l.hub < h; });
    return place_[place_begin_[v] + static_cast<std::size_t>(at - labels.begin())];
  }

  const HubGraph& graph_;
  const HubLabels& from_;
  std::vector<std::uint32_t> group_;      // by edge: its first label
  std::vector<std::size_t> place_begin_;  // by bend, into place_
  std::vector<std::uint32_t> place_;      // by bend and label of from_: where it is now
  std::vector<std::vector<std::uint32_t>> by_edge_;
};

void pack_sights(const SightLists& sights, const Packer& packer, std::vector<std::uint32_t>& begin,
                 std::vector<std::uint32_t>& words) {
  for (std::size_t group = 0; group + 1 < sights.first.size(); ++group) {
    begin.push_back(static_cast<std::uint32_t>(words.size()));
    for (std::uint32_t k = sights.first[group]; k < sights.first[group + 1]; ++k) {
      const Sight& sight = sights.sights[k];
      words.push_back(sight.bend);
      words.push_back(packer.count(sight.bend, sight.edges));
      for (const std::uint32_t place : {sight.right, sight.left})
        if (place != kNone) words.push_back(place);
    }
  }
  begin.push_back(static_cast<std::uint32_t>(words.size()));
}

template <class T>
void append(std::vector<std::byte>& out, const std::vector<T>& part) {
  const auto* bytes = reinterpret_cast<const std::byte*>(part.data());
  out.insert(out.end(), bytes, bytes + part.size() * sizeof(T));
}

std::size_t words_of(const IndexImage::Header& h) {
  return std::size_t{3} * h.labels + h.bends + 1 + (h.has_sights ? std::size_t{4} * h.triangles + 1 : 0) +
         h.sight_words;
}

/// Of all but itself.
std::uint64_t checksum(IndexImage::Header header, std::span<const std::byte> bytes) {
  header.check = 0;
  Checksum check;
  check.add(&header, sizeof header / 4);
  check.add(bytes.data() + sizeof header, (bytes.size() - sizeof header) / 4);
  return check.value();
}

[[noreturn]] void refuse(const std::string& why) { throw std::runtime_error(why); }

}  // namespace

std::vector<std::byte> index_image(const HubGraph& graph, const HubLabels& labels, const SightLists* sights,
                                   std::uint64_t space, std::size_t triangles, double extent) {
  const Packer packer(graph, labels, extent);
  std::vector<std::uint32_t> sights_begin, words;
  if (sights) pack_sights(*sights, packer, sights_begin, words);
  IndexImage::Header header{kMagic,
                            IndexImage::kVersion,
                            graph.size(),
                            static_cast<std::uint32_t>(packer.labels_out.size()),
                            static_cast<std::uint32_t>(triangles),
                            static_cast<std::uint32_t>(words.size()),
                            sights ? 1u : 0u,
                            space,
                            packer.per_length,
                            0};
  std::vector<std::byte> bytes(kHeaderBytes);
  bytes.reserve(kHeaderBytes + 4 * words_of(header));
  append(bytes, packer.labels_out);
  append(bytes, packer.next);
  append(bytes, packer.begin);
  append(bytes, sights_begin);
  append(bytes, words);
  std::memcpy(bytes.data(), &header, sizeof header);
  header.check = checksum(header, bytes);
  std::memcpy(bytes.data(), &header, sizeof header);
  return bytes;
}

IndexImage::IndexImage(std::span<const std::byte> bytes, std::uint64_t space, std::size_t bends, std::size_t places) {
  if (bytes.size() < kHeaderBytes) refuse("is cut off");
  std::memcpy(&header_, bytes.data(), sizeof header_);
  if (header_.magic != kMagic) refuse("holds no index for this kind of machine");
  if (header_.version != kVersion)
    refuse("holds an index of version " + std::to_string(header_.version) + "; this program reads version " +
           std::to_string(kVersion));
  const std::size_t words = words_of(header_);
  if (bytes.size() != kHeaderBytes + 4 * words) refuse("is cut off");
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
  require_sound(places);
}

/// That no number in it leads out of it: a checksum protects from accidents only.
void IndexImage::require_sound(std::size_t places) const {
  bool sound = std::isfinite(header_.per_length) && header_.per_length > 0 && begin_.front() == 0 &&
               begin_.back() == header_.labels;
  for (std::size_t v = 0; v < header_.bends; ++v)
    sound = sound && begin_[v] + 2 <= begin_[v + 1] && begin_[v + 1] <= header_.labels;
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
  if (!sound) refuse("is damaged: a number in it leads out of it");
}

std::uint64_t space_print(const Triangulation& tri) {
  Checksum check;
  check.add(tri.points.data(), 4 * tri.points.size());
  check.add(tri.triangles.data(), 3 * tri.triangles.size());
  check.add(tri.neighbours.data(), 3 * tri.neighbours.size());
  return check.value();
}

}  // namespace taut::detail
