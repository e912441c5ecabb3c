// What was kept for a later run, and came back otherwise: indexes whose numbers changed and whose checksum was made to fit,
// saved roadmaps with other words, shards. Refused, or answers without leaving the file; a roadmap that is the world's
// own gives the shortest paths.
#include <cstring>
#include <memory>

#include <taut/geometry/free_space.h>
#include <taut/io/saved/planned_roadmap.h>
#include <taut/io/saved/shard_file.h>
#include <taut/io/worlds/read_world.h>
#include <taut/search/index.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

#include "fuzz/fuzzed.h"
#include "support/sealed_index.h"

namespace {

using namespace taut;
using Bytes = std::vector<std::byte>;

const FreeSpace& room() {
  static const FreeSpace space(read_world(
      "boundary 0 0 8 8\n4 0 4 5\n2 2 2 8\n5 6 8 6\n6 0 7 4\nsolid 5 2 5.5 2 5.5 3 5 3\nstart 1 4\ngoal 7 5\n"));
  return space;
}

// All bends with labels, and a core of them.
Bytes kept_index(bool all) {
  Index index(room());
  for (std::size_t memory = 400; !all; memory += 200) {
    try {
      index = Index(room(), memory);
      break;
    } catch (const InputError&) {
    }
  }
  return {index.bytes().begin(), index.bytes().end()};
}

// A few words of it become others; it may be cut off, too.
Bytes tampered(Bytes bytes, FuzzedDataProvider& wishes) {
  while (wishes.remaining_bytes() > 2) {
    const auto word = wishes.ConsumeIntegralInRange<std::size_t>(0, bytes.size() / 4 - 1);
    const auto value = wishes.ConsumeBool() ? wishes.ConsumeIntegralInRange<std::uint32_t>(0, 40)
                                            : wishes.ConsumeIntegral<std::uint32_t>();
    std::memcpy(bytes.data() + 4 * word, &value, sizeof value);
  }
  test::seal_index(bytes);
  return bytes;
}

void ask_index(FuzzedDataProvider& wishes) {
  static const Bytes all = kept_index(true), core = kept_index(false);
  const auto bytes = std::make_shared<const Bytes>(tampered(wishes.ConsumeBool() ? all : core, wishes));
  try {
    IndexSearch search(Index(room(), *bytes, bytes));
    for (const Point from : {Point{1, 4}, Point{4, 5}, Point{0, 0}})
      for (const Point to : {Point{7, 5}, Point{7.5, 0.5}, Point{3, 7.25}}) search.find(from, to);
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& refusal) {
    fuzz::require(refusal.what()[0] != '\0', "a refusal without words");
  }
}

std::string kept_roadmap(const RoadmapKind& kind) {
  BuildRequest request;
  request.from = Point{1, 4};
  request.to = Goal{Point{7, 5}, {}};
  return saved_text(kind, kind.build(room(), request), room());
}

const std::vector<std::string>& kept_roadmaps() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> texts;
    for (const RoadmapKind& kind : roadmap_kinds())
      if (kind.keeping != RoadmapKind::Keeping::none) texts.push_back(kept_roadmap(kind));
    return texts;
  }();
  return all;
}

std::string with_other_digits(std::string text, FuzzedDataProvider& wishes) {
  while (wishes.remaining_bytes() > 2) {
    const auto at = wishes.ConsumeIntegralInRange<std::size_t>(0, text.size() - 1);
    if (wishes.ConsumeBool())
      text[at] = wishes.ConsumeIntegral<char>();
    else if (const std::size_t digit = text.find_first_of("0123456789", at); digit != std::string::npos)
      text[digit] = static_cast<char>('0' + wishes.ConsumeIntegralInRange<int>(0, 9));
  }
  return text;
}

void ask_roadmap(FuzzedDataProvider& wishes) {
  const auto& kept = kept_roadmaps();
  const auto which = wishes.ConsumeIntegralInRange<std::size_t>(0, kept.size() - 1);
  const LoadedRoadmap loaded = load_roadmap(with_other_digits(kept[which], wishes), "saved", room());
  const Point from{1, 4};
  const Goal to{Point{7, 5}, {}};
  const GraphSearchResult found = loaded.planned.search(from, to, GraphMethod{});
  if (found.status != SearchStatus::found) return;
  const Verdict verdict = verify(found.path, room(), from, to);
  fuzz::require(verdict.valid, "a path that is none: " + verdict.reason);
  const auto shortest = shortest_path(room(), from, *to.point);
  fuzz::require(!loaded.kind->optimal || found.path.length == shortest->length, "not the shortest path");
}

void read_shard(FuzzedDataProvider& wishes) {
  static const std::string kept = [] {
    const ShardHead head{"batch", 1, 2, 5, mark_of({})};
    std::string text = shard_head_text(head);
    for (std::size_t k = 0; k < head.own_items(); ++k) text += shard_item_text(head.item(k), std::string(k, 'x'));
    return text + shard_end_text();
  }();
  const std::string text = with_other_digits(kept, wishes);
  const ShardFile file = read_shard_file(text, "shard");
  fuzz::require(file.items.size() <= file.head.own_items() && file.whole <= text.size(), "more than there is");
  fuzz::require(file.is_finished == file.trouble.empty(), "trouble with what is finished");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider wishes(data, size);
  const int what = wishes.ConsumeIntegralInRange(0, 5);
  fuzz::read([&] {
    if (what < 3)
      ask_index(wishes);
    else if (what < 5)
      ask_roadmap(wishes);
    else
      read_shard(wishes);
  });
  return 0;
}
