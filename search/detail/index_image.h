// An index in one piece of memory: as it is built, kept in a file and mapped from it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <taut/search/detail/contraction.h>
#include <taut/search/detail/hub_labels.h>
#include <taut/search/detail/sight_lists.h>

namespace taut::detail {

/// What is in an index, beside what follows from its world at once. Offsets into 4-byte words.
///
///  labels   by bend: itself, then its labels by their first edge, counter-clockwise, then itself again. So what may
///           follow where a string arrives is one run of them, from the first or to the last.
///  next     by label: the label of the same hub at the next bend; of the bend itself its own number.
///  begin    by bend, one more: into labels.
///  sights   by triangle, those that need no test, a test of the right ray, of the left one, of both: the bend and side
///           (2 * bend + BendSide), how many labels may follow, the places that rays pass. 2, 3, 3 and 4 words.
///  ups, cores   where only a core of bends has labels, Contraction's edges of the others and of the core, the latter
///           by their first hop; children are numbers of ups, none of a leg.
///  ups_begin, cores_begin   by bend, one more.
///  sights_begin   by triangle and group, 4 a triangle and one more: into the words of sights.
class IndexImage {
 public:
  struct Label {
    std::uint32_t hub;
    std::uint32_t length;  ///< in multiples of 1 / per_length
  };

  /// Of a contraction: numbers of bends, hops times four with TurnBits of a string that comes back from it at this end,
  /// and that arrives at the far one.
  struct Edge {
    std::uint32_t to, first_hop, last_hop, first_child, last_child;
  };
  struct Up : Edge {
    std::uint32_t length_words[2];  ///< of a double

    double length() const {
      double value;
      std::memcpy(&value, length_words, sizeof value);
      return value;
    }
  };
  struct Core : Edge {
    std::uint32_t label;  ///< the first that goes on by it
  };

  static constexpr std::uint64_t kMagic = 0x3178656e64697874;  ///< also tells that bytes are in this machine's order
  static constexpr std::uint32_t kVersion = 1;
  static constexpr std::size_t kHeaderBytes = 128;

  struct Header {
    std::uint64_t magic = 0;
    std::uint32_t version = 0;
    std::uint32_t bends = 0, labels = 0, triangles = 0, sight_words = 0, has_sights = 0;
    std::uint32_t ups = 0, cores = 0, has_core = 0, unused = 0;  ///< all 0 where all bends have labels
    std::uint64_t space = 0;                                     ///< space_print
    double per_length = 0;
    std::uint64_t check = 0;  ///< of all else
  };

  /// How many 4-byte words there are behind the header's bytes.
  static std::size_t words(const Header& header);
  /// Of all but the header's `check`.
  static std::uint64_t checksum(Header header, std::span<const std::byte> bytes);

  /// Of another's bytes, which outlive it. Throws std::runtime_error with a reason when they are none, damaged or of
  /// another space (`triangles` and `bends` are this one's).
  IndexImage(std::span<const std::byte> bytes, std::uint64_t space, std::size_t bends, std::size_t places);

  const Header& header() const { return header_; }
  std::span<const Label> labels() const { return labels_; }
  std::span<const std::uint32_t> next() const { return next_; }
  std::span<const std::uint32_t> begin() const { return begin_; }
  std::span<const std::uint32_t> sights_begin() const { return sights_begin_; }
  std::span<const std::uint32_t> sights() const { return sights_; }
  bool has_core() const { return !ups_begin_.empty(); }
  std::span<const Up> ups() const { return ups_; }
  std::span<const Up> ups(std::uint32_t bend) const {
    return ups_.subspan(ups_begin_[bend], ups_begin_[bend + 1] - ups_begin_[bend]);
  }
  std::span<const Core> cores(std::uint32_t bend) const {
    return cores_.subspan(cores_begin_[bend], cores_begin_[bend + 1] - cores_begin_[bend]);
  }
  std::uint32_t ups_begin(std::uint32_t bend) const { return ups_begin_[bend]; }

 private:
  void require_sound(std::size_t places) const;
  bool is_core_sound() const;

  Header header_;
  std::span<const Label> labels_;
  std::span<const std::uint32_t> next_, begin_, sights_begin_, sights_, ups_begin_, cores_begin_;
  std::span<const Up> ups_;
  std::span<const Core> cores_;
};

/// Words of one group of sights.
inline constexpr std::uint32_t kSightWords[4] = {2, 3, 3, 4};

/// What was labelled of a contraction.
struct LabelledCore {
  const Contraction& contraction;
  const BendTurns& turns;
  const std::vector<std::uint32_t>& edge_of;  ///< of core_graph
};

/// `extent`: nothing that is added to a label is longer. Sights may be absent; without a core all bends are labelled,
/// their graph's vertices.
std::vector<std::byte> index_image(const HubGraph& graph, const HubLabels& labels, const SightLists* sights,
                                   const LabelledCore* core, std::uint64_t space, std::size_t triangles, double extent);

/// Stands for a triangulation, vertex for vertex and triangle for triangle.
std::uint64_t space_print(const Triangulation& tri);

}  // namespace taut::detail
