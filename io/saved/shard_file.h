// What one of several machines has done of a work: a file that grows item by item.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace taut {

/// Whose work it is, and which part. Of `items` items shard k of n has those whose number leaves k - 1 divided by n.
struct ShardHead {
  std::string command;    ///< `batch`
  std::size_t shard = 1;  ///< 1 to shards
  std::size_t shards = 1;
  std::size_t items = 0;  ///< of the whole work
  std::string work;       ///< mark_of all that its results depend on

  std::size_t own_items() const { return items / shards + (shard <= items % shards ? 1 : 0); }
  std::size_t item(std::size_t k) const { return shard - 1 + k * shards; }  ///< its k-th one

  friend bool operator==(const ShardHead&, const ShardHead&) = default;
};

/// 32 hexadecimal digits that stand for the texts, the same on every machine: FNV-1a with 128 bits.
std::string mark_of(std::span<const std::string> texts);

/// The file, in three kinds of pieces that are written one after the other:
///
///     taut shard 1
///     command batch
///     shard 3 of 8
///     items 120
///     work 0d3f...
///
///     item 2 517 8a01b3c4         its number, its bytes, their CRC-32; then the bytes and a line end
///     ...
///     item 10 503 11c07f02
///     ...
///     end
std::string shard_head_text(const ShardHead& head);
std::string shard_item_text(std::size_t item, std::string_view bytes);
std::string shard_end_text();

/// Read back; views into the bytes that were read.
struct ShardFile {
  ShardHead head;
  std::vector<std::string_view> items;  ///< of head.item(0), head.item(1), ...: as many as are whole
  std::size_t whole = 0;                ///< bytes up to the end of the last whole item
  bool is_finished = false;             ///< all items and the end are there
  std::string trouble{};                ///< else, in words: `is cut off at item 18`, `is damaged at item 18`
};

/// Throws InputError when the bytes do not begin with the head of a shard.
ShardFile read_shard_file(std::string_view bytes, const std::string& name);

}  // namespace taut
