// Mazes of four cells, for tests of taut mouse and taut diff.
#pragma once

namespace taut::test {

/// The goal G cannot be reached.
inline constexpr const char* kSealed = "o---o---o\n|   | G |\no   o---o\n| S |   |\no---o---o\n";
/// Start and goal with one way, two steps.
inline constexpr const char* kBend = "o---o---o\n|     G |\no   o---o\n| S |   |\no---o---o\n";

}  // namespace taut::test
