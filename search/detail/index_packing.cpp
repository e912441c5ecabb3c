// How an index is laid out in one piece of memory.
#include <algorithm>
#include <cmath>
#include <optional>

#include <taut/search/detail/index_image.h>

namespace taut::detail {

namespace {

/// Puts labels in their places.
class Packer {
 public:
  /// `bends`: what the graph's vertices stand for, ascending, of so many.
  Packer(const HubGraph& graph, const HubLabels& labels, double extent, const std::vector<std::uint32_t>& bends,
         std::uint32_t bend_count)
      : graph_(graph), from_(labels), vertex_of_(bend_count, kNone) {
    double longest = 0;
    for (const auto& of_bend : labels.labels)
      for (const HubLabels::Label& label : of_bend) longest = std::max(longest, label.length);
    per_length = longest + extent > 0 ? 0x1p30 / (longest + extent) : 1;
    group_.resize(graph.edges.size() + 1);
    for (std::uint32_t v = 0; v < graph.size(); ++v) {
      vertex_of_[bends[v]] = v;
      pack(v);
    }
    begin_.push_back(static_cast<std::uint32_t>(labels_out.size()));
    for (std::uint32_t v = 0; v < graph.size(); ++v) link(v);
    for (std::uint32_t bend = 0, v = 0; bend <= bend_count; ++bend) {
      begin.push_back(begin_[v]);
      if (bend < bend_count && vertex_of_[bend] != kNone) ++v;
    }
  }

  /// How many labels of the bend, itself among them, go on by so many edges from one side on. Precondition: it has
  /// some.
  std::uint32_t count(std::uint32_t bend, std::uint32_t edges) const {
    const std::uint32_t v = vertex_of_[bend / 2];
    const std::uint32_t first = graph_.first[v], last = graph_.first[v + 1];
    if (bend % 2 == kRightTurn) return (first + edges < last ? group_[first + edges] : begin_[v + 1] - 1) - begin_[v];
    return edges == 0 ? 1 : begin_[v + 1] - group_[last - edges];
  }
  std::uint32_t first_label(std::uint32_t edge) const { return group_[edge]; }

  std::vector<IndexImage::Label> labels_out;
  std::vector<std::uint32_t> next, begin;
  double per_length = 1;

 private:
  void pack(std::uint32_t v) {
    const auto& labels = from_.labels[v];
    begin_.push_back(static_cast<std::uint32_t>(labels_out.size()));
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
        place_[place_begin_.back() + k] = begin_.back();
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
    next.push_back(begin_[v]);
    for (std::uint32_t e = graph_.first[v]; e < graph_.first[v + 1]; ++e) {
      const std::uint32_t end = e + 1 < graph_.first[v + 1] ? group_[e + 1] : begin_[v + 1] - 1;
      const std::uint32_t to = graph_.edges[e].to;
      for (std::uint32_t k = group_[e]; k < end; ++k) next.push_back(place_of(to, labels_out[k].hub));
    }
    next.push_back(begin_[v + 1] - 1);
  }

  std::uint32_t place_of(std::uint32_t v, std::uint32_t hub) const {
    const auto& labels = from_.labels[v];
    const auto at = std::lower_bound(labels.begin(), labels.end(), hub,
                                     [](const HubLabels::Label& l, std::uint32_t h) { return l.hub < h; });
    return place_[place_begin_[v] + static_cast<std::size_t>(at - labels.begin())];
  }

  const HubGraph& graph_;
  const HubLabels& from_;
  std::vector<std::uint32_t> vertex_of_;  // by bend
  std::vector<std::uint32_t> begin_;      // by vertex
  std::vector<std::uint32_t> group_;      // by edge: its first label
  std::vector<std::size_t> place_begin_;  // by bend, into place_
  std::vector<std::uint32_t> place_;      // by bend and label of from_: where it is now
  std::vector<std::vector<std::uint32_t>> by_edge_;
};

/// Without a packer no labels are counted: above a core the climb tells which may follow.
void pack_sights(const SightLists& sights, const Packer* packer, std::vector<std::uint32_t>& begin,
                 std::vector<std::uint32_t>& words) {
  for (std::size_t group = 0; group + 1 < sights.first.size(); ++group) {
    begin.push_back(static_cast<std::uint32_t>(words.size()));
    for (std::uint32_t k = sights.first[group]; k < sights.first[group + 1]; ++k) {
      const Sight& sight = sights.sights[k];
      words.push_back(sight.bend);
      words.push_back(packer ? packer->count(sight.bend, sight.edges) : 0);
      for (const std::uint32_t place : {sight.right, sight.left})
        if (place != kNone) words.push_back(place);
    }
  }
  begin.push_back(static_cast<std::uint32_t>(words.size()));
}

IndexImage::Edge edge_of(const LabelledCore& core, std::uint32_t from, const Contraction::Edge& edge,
                         const std::vector<std::uint32_t>& ups_begin) {
  const BendTurns& turns = core.turns;
  const auto child = [&](std::uint32_t k) { return edge.middle == kNone ? kNone : ups_begin[edge.middle] + k; };
  return {edge.to, 4 * edge.first_hop + turns.arriving(turns.at(edge.first_hop), from),
          4 * edge.last_hop + turns.arriving(turns.at(edge.last_hop), edge.to), child(edge.first_child),
          child(edge.last_child)};
}

struct PackedCore {
  PackedCore(const LabelledCore& core, const HubGraph& graph, const Packer& packer) {
    const auto& up = core.contraction.up;
    std::vector<std::uint32_t> vertex_of(up.size(), kNone);
    for (std::uint32_t v = 0; v < graph.size(); ++v) vertex_of[core.contraction.core[v]] = v;
    ups_begin.push_back(0);
    for (std::uint32_t bend = 0; bend < up.size(); ++bend)
      ups_begin.push_back(ups_begin.back() +
                          (vertex_of[bend] == kNone ? static_cast<std::uint32_t>(up[bend].size()) : 0));
    cores_begin.push_back(0);
    for (std::uint32_t bend = 0; bend < up.size(); ++bend) {
      if (const std::uint32_t v = vertex_of[bend]; v != kNone) {
        for (std::uint32_t e = graph.first[v]; e < graph.first[v + 1]; ++e)
          cores.push_back({edge_of(core, bend, up[bend][core.edge_of[e]], ups_begin), packer.first_label(e)});
      } else {
        for (const Contraction::Edge& edge : up[bend]) {
          IndexImage::Up packed{edge_of(core, bend, edge, ups_begin), {}};
          std::memcpy(packed.length_words, &edge.length.sum.high, sizeof packed.length_words);
          ups.push_back(packed);
        }
      }
      cores_begin.push_back(static_cast<std::uint32_t>(cores.size()));
    }
  }

  std::vector<std::uint32_t> ups_begin, cores_begin;
  std::vector<IndexImage::Up> ups;
  std::vector<IndexImage::Core> cores;
};

template <class T>
void append(std::vector<std::byte>& out, const std::vector<T>& part) {
  const auto* bytes = reinterpret_cast<const std::byte*>(part.data());
  out.insert(out.end(), bytes, bytes + part.size() * sizeof(T));
}

}  // namespace

std::vector<std::byte> index_image(const HubGraph& graph, const HubLabels& labels, const SightLists* sights,
                                   const LabelledCore* core, std::uint64_t space, std::size_t triangles,
                                   double extent) {
  std::vector<std::uint32_t> all;
  if (!core)
    for (std::uint32_t v = 0; v < graph.size(); ++v) all.push_back(v);
  const auto bends = core ? static_cast<std::uint32_t>(core->contraction.up.size()) : graph.size();
  const Packer packer(graph, labels, extent, core ? core->contraction.core : all, bends);
  std::optional<PackedCore> packed;
  if (core) packed.emplace(*core, graph, packer);
  std::vector<std::uint32_t> sights_begin, words;
  if (sights) pack_sights(*sights, core ? nullptr : &packer, sights_begin, words);
  IndexImage::Header header;
  header.magic = IndexImage::kMagic;
  header.version = IndexImage::kVersion;
  header.bends = bends;
  header.labels = static_cast<std::uint32_t>(packer.labels_out.size());
  header.triangles = static_cast<std::uint32_t>(triangles);
  header.sight_words = static_cast<std::uint32_t>(words.size());
  header.has_sights = sights ? 1 : 0;
  if (packed) {
    header.has_core = 1;
    header.ups = static_cast<std::uint32_t>(packed->ups.size());
    header.cores = static_cast<std::uint32_t>(packed->cores.size());
  }
  header.space = space;
  header.per_length = packer.per_length;
  std::vector<std::byte> bytes(IndexImage::kHeaderBytes);
  bytes.reserve(IndexImage::kHeaderBytes + 4 * IndexImage::words(header));
  append(bytes, packer.labels_out);
  append(bytes, packer.next);
  append(bytes, packer.begin);
  append(bytes, sights_begin);
  append(bytes, words);
  if (packed) {
    append(bytes, packed->ups_begin);
    append(bytes, packed->cores_begin);
    append(bytes, packed->ups);
    append(bytes, packed->cores);
  }
  std::memcpy(bytes.data(), &header, sizeof header);
  header.check = IndexImage::checksum(header, bytes);
  std::memcpy(bytes.data(), &header, sizeof header);
  return bytes;
}

}  // namespace taut::detail
