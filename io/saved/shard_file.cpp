#include <taut/io/saved/shard_file.h>

#include <fmt/format.h>
#include <zlib.h>

#include <charconv>
#include <optional>

#include <taut/geometry/errors.h>
#include <taut/io/saved/detail/fnv.h>

namespace taut {

namespace {

constexpr std::string_view kEnd = "end\n";

unsigned crc_of(std::string_view bytes) {
  return static_cast<unsigned>(
      ::crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<z_size_t>(bytes.size())));
}

/// Takes words and lines off the front; nothing where they are not as expected.
class Front {
 public:
  explicit Front(std::string_view text) : rest_(text) {}

  bool take(std::string_view word) {
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }
  std::optional<std::size_t> number(int base = 10) {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value, base);
    if (error != std::errc{}) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }
  /// Up to the line's end, which goes as well.
  std::optional<std::string_view> line() {
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return text;
  }
  std::optional<std::string_view> bytes(std::size_t count) {
    if (rest_.size() < count) return std::nullopt;
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

std::optional<ShardHead> head_in(Front& front) {
  ShardHead head;
  const auto text = [&](std::string_view name, std::string& value) {
    if (!front.take(name)) return false;
    const auto line = front.line();
    if (line) value = *line;
    return line.has_value();
  };
  const auto number = [&](std::string_view name, std::size_t& value) {
    const auto read = front.take(name) ? front.number() : std::nullopt;
    if (read) value = *read;
    return read.has_value();
  };
  const bool good = front.take("taut shard 1\n") && text("command ", head.command) && number("shard ", head.shard) &&
                    number(" of ", head.shards) && number("\nitems ", head.items) && text("\nwork ", head.work) &&
                    front.take("\n") && head.shard >= 1 && head.shard <= head.shards;
  return good ? std::optional(head) : std::nullopt;
}

enum class Piece { whole, cut, damaged };

Piece take_item(Front& front, std::size_t expected, std::string_view& bytes) {
  Front ahead = front;
  const auto line = ahead.line();
  if (!line) return Piece::cut;
  Front words(*line);
  const auto item = words.take("item ") ? words.number() : std::nullopt;
  const auto size = item && words.take(" ") ? words.number() : std::nullopt;
  const auto crc = size && words.take(" ") ? words.number(16) : std::nullopt;
  if (!crc || *item != expected || !words.rest().empty()) return Piece::damaged;
  const auto taken = ahead.bytes(*size);
  if (!taken || ahead.rest().empty()) return Piece::cut;
  if (crc_of(*taken) != *crc || !ahead.take("\n")) return Piece::damaged;
  bytes = *taken;
  front = ahead;
  return Piece::whole;
}

}  // namespace

std::string mark_of(std::span<const std::string> texts) {
  detail::Fnv hash;
  for (const std::string& text : texts) {
    hash.add(std::uint64_t{text.size()});
    hash.add(std::string_view(text));
  }
  return hash.hex();
}

std::string shard_head_text(const ShardHead& head) {
  return fmt::format("taut shard 1\ncommand {}\nshard {} of {}\nitems {}\nwork {}\n\n", head.command, head.shard,
                     head.shards, head.items, head.work);
}

std::string shard_item_text(std::size_t item, std::string_view bytes) {
  std::string text = fmt::format("item {} {} {:08x}\n", item, bytes.size(), crc_of(bytes));
  text.append(bytes).append("\n");
  return text;
}

std::string shard_end_text() { return std::string(kEnd); }

ShardFile read_shard_file(std::string_view bytes, const std::string& name) {
  Front front(bytes);
  const std::optional<ShardHead> head = head_in(front);
  if (!head) throw InputError(name, 0, "is no shard of taut's");
  ShardFile file{*head, {}, bytes.size() - front.rest().size()};
  Piece piece = Piece::whole;
  while (piece == Piece::whole && file.items.size() < head->own_items()) {
    std::string_view item;
    piece = take_item(front, head->item(file.items.size()), item);
    if (piece == Piece::whole) file.items.push_back(item);
  }
  file.whole = bytes.size() - front.rest().size();
  if (piece == Piece::whole && front.rest() == kEnd) {
    file.is_finished = true;
  } else if (piece != Piece::whole) {
    file.trouble =
        fmt::format("is {} at item {}", piece == Piece::cut ? "cut off" : "damaged", head->item(file.items.size()));
  } else {
    file.trouble = kEnd.starts_with(front.rest()) ? "is cut off at its end" : "is damaged at its end";
  }
  return file;
}

}  // namespace taut
