#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/io/saved/packed.h>
#include <taut/io/saved/shard_file.h>

#include "support/refusal.h"

namespace taut {
namespace {

using testing::ElementsAre;

const ShardHead kHead{"batch", 2, 3, 8, "0d3f"};

std::string file_of(const std::vector<std::string>& items) {
  std::string text = shard_head_text(kHead);
  for (std::size_t k = 0; k < items.size(); ++k) text += shard_item_text(kHead.item(k), items[k]);
  return text + shard_end_text();
}

TEST(ShardFile, HasEachThirdItem) {
  EXPECT_EQ(kHead.own_items(), 3U);  // 1, 4, 7
  EXPECT_EQ((ShardHead{"batch", 3, 3, 8, ""}.own_items()), 2U);
  EXPECT_EQ((ShardHead{"batch", 3, 3, 2, ""}.own_items()), 0U);
  EXPECT_EQ(kHead.item(2), 7U);
}

TEST(ShardFile, IsReadBackWhateverBytesItemsHold) {
  const std::vector<std::string> items{"item 4 0 0\n\nend\n", std::string("\0\n\xff", 3), ""};
  const std::string bytes = file_of(items);
  const ShardFile file = read_shard_file(bytes, "a");
  EXPECT_EQ(file.head, kHead);
  EXPECT_TRUE(file.is_finished);
  EXPECT_THAT(file.items, ElementsAre(items[0], items[1], items[2]));
}

TEST(ShardFile, CutOffAnywhereHasWhatIsWhole) {
  const std::string bytes = file_of({"one", "two", "three"}), head = shard_head_text(kHead);
  for (std::size_t size = head.size(); size < bytes.size(); ++size) {
    const ShardFile file = read_shard_file(std::string_view(bytes).substr(0, size), "a");
    ASSERT_FALSE(file.is_finished);
    ASSERT_LE(file.whole, size);
    ASSERT_THAT(file.trouble, testing::StartsWith("is cut off at "));
    std::string expected = head;
    for (std::size_t k = 0; k < file.items.size(); ++k) expected += shard_item_text(kHead.item(k), file.items[k]);
    ASSERT_EQ(bytes.substr(0, file.whole), expected);
  }
}

TEST(ShardFile, KnowsAnyByteThatChanged) {
  const std::string bytes = file_of({"one", "two", "three"});
  for (std::size_t at = shard_head_text(kHead).size(); at < bytes.size(); ++at) {
    std::string changed = bytes;
    changed[at] ^= 1;
    const ShardFile file = read_shard_file(changed, "a");
    ASSERT_FALSE(file.is_finished) << at;
    ASSERT_FALSE(file.trouble.empty()) << at;
  }
}

TEST(ShardFile, RefusesWhatIsNone) {
  for (const char* text : {"", "taut shard 2\n", "taut shard 1\ncommand batch\nshard 4 of 3\nitems 1\nwork 0\n\n"})
    EXPECT_EQ(test::refusal_of([&] { read_shard_file(text, "a.part"); }), "a.part: is no shard of taut's");
}

TEST(Marks, DifferWhereTextsDoOrTheirBordersMove) {
  const auto mark = [](std::vector<std::string> texts) { return mark_of(texts); };
  EXPECT_EQ(mark({"a", "bc"}), mark({"a", "bc"}));
  EXPECT_NE(mark({"a", "bc"}), mark({"ab", "c"}));
  EXPECT_EQ(mark({}).size(), 32U);
}

TEST(PackedValues, ComeBackAsTheyWere) {
  Packer packer;
  packer.put(std::uint64_t{1} << 63).put(-0.1).put(Point{1e300, -0.0}).put("text");
  const std::string bytes = std::move(packer).bytes();
  Unpacker unpacker(bytes, "a");
  EXPECT_EQ(unpacker.number(), std::uint64_t{1} << 63);
  EXPECT_EQ(unpacker.real(), -0.1);
  EXPECT_EQ(unpacker.point().x, 1e300);
  EXPECT_EQ(unpacker.text(), "text");
  EXPECT_TRUE(unpacker.empty());
  EXPECT_EQ(test::refusal_of([&] { unpacker.number(); }), "a: holds less than it says");
}

}  // namespace
}  // namespace taut
