#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <taut/io/worlds/gzip.h>

#include "support/refusal.h"

namespace taut {
namespace {

using testing::HasSubstr;

// printf 'start 1 1\n' | gzip -n
const std::string kPacked(
    "\x1f\x8b\x08\x00\x00\x00\x00\x00\x00\x03\x2b\x2e\x49\x2c\x2a\x51\x30\x54\x30\xe4\x02\x00\x48\xf2"
    "\x2d\x33\x0a\x00\x00\x00",
    30);

std::string refusal(std::string_view bytes, std::size_t limit = 1000) {
  return test::refusal_of([&] { gunzip(bytes, "x.gz", limit); });
}

TEST(Gzip, UnpacksAllMembers) {
  ASSERT_TRUE(is_gzip(kPacked));
  EXPECT_EQ(gunzip(kPacked, ""), "start 1 1\n");
  EXPECT_EQ(gunzip(kPacked + kPacked, ""), "start 1 1\nstart 1 1\n");
  EXPECT_EQ(gunzip(kPacked + std::string(100, '\0'), ""), "start 1 1\n") << "padding";
}

TEST(Gzip, RefusesWhatIsCutOffDamagedOrTooLong) {
  for (std::size_t n = 2; n < kPacked.size(); ++n)
    EXPECT_THAT(refusal(std::string_view(kPacked).substr(0, n)), HasSubstr("x.gz: gzip data is cut off")) << n;
  for (std::size_t n = 10; n < kPacked.size(); ++n) {
    std::string broken = kPacked;
    broken[n] = static_cast<char>(broken[n] ^ 0x55);
    EXPECT_THAT(refusal(broken), HasSubstr("x.gz: gzip data is")) << n;
  }
  EXPECT_THAT(refusal(kPacked, 9), HasSubstr("more than 9 bytes"));
  EXPECT_EQ(refusal(kPacked, 10), "accepted");
}

}  // namespace
}  // namespace taut
