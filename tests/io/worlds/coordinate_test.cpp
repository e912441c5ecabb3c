// Numbers as text.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>

#include <taut/geometry/errors.h>
#include <taut/io/worlds/detail/text_input.h>

namespace taut {
namespace {

double coordinate(const std::string& text) {
  static const std::string source = "file";
  return detail::coordinate(text, {source, 1});
}

TEST(Coordinate, IsTheDoubleNearestToItsDigits) {
  std::mt19937_64 random(1);
  for (int round = 0; round < 100000; ++round) {
    std::string text = random() % 2 ? "-" : "";
    for (std::uint64_t n = random() % 10; n > 0; --n) text += static_cast<char>('0' + random() % 10);
    text += static_cast<char>('0' + random() % 10);
    if (random() % 2) text += '.';
    if (text.back() == '.')
      for (std::uint64_t n = random() % 12; n > 0; --n) text += static_cast<char>('0' + random() % 10);
    if (random() % 8 == 0) text += "e-3";
    ASSERT_EQ(coordinate(text), std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(Coordinate, MayLackDigitsOnOneSideOfThePoint) {
  EXPECT_EQ(coordinate(".5"), 0.5);
  EXPECT_EQ(coordinate("-.5"), -0.5);
  EXPECT_EQ(coordinate("7."), 7);
  EXPECT_EQ(coordinate("+2.25"), 2.25);
  EXPECT_FALSE(std::signbit(coordinate("-0")));
}

TEST(Coordinate, IsRefusedWhenItIsNoNumber) {
  for (const char* text : {".", "-", "1.2.3", "--5", "1x", "", "+-1"})
    EXPECT_THROW(coordinate(text), InputError) << text;
}

}  // namespace
}  // namespace taut
