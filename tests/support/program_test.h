// What every test of the program `taut` begins with.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "support/paths.h"
#include "support/run_program.h"

namespace taut::test {

/// Skipped where the program is not built; each test has an empty folder of its own.
class ProgramTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!program()) GTEST_SKIP() << "the program is not built";
  }
  /// The path of a file there, written or not.
  std::string in_folder(std::string_view name) const { return (folder / name).string(); }

  Folder folder;
};

}  // namespace taut::test
