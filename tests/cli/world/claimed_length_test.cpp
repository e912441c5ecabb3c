// taut check --path: the length that a file claims.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/program_test.h"

namespace taut::test {
namespace {

using testing::HasSubstr;

class ClaimedLength : public ProgramTest {
 protected:
  Outcome check(const std::string& length) const {
    const std::string path = folder.file("path", R"({"points": [[1, 1], [2, 2], [3, 1]], "length": )" + length + "}");
    return run_taut("check - --path " + path, "boundary 0 0 4 4\n");
  }
};

TEST_F(ClaimedLength, IsWhatTheLegsAddUpTo) {
  EXPECT_EQ(check("2.8284271247461903").code, 0);
  EXPECT_EQ(check("2.82842712474619").code, 0);
}

TEST_F(ClaimedLength, IsRefusedWhereItIsOffByMoreThanRounding) {
  for (const char* length : {"2.8284271247471903", "2.8284271247451903", "2.828427124746200", "2.828427124746180"}) {
    SCOPED_TRACE(length);
    const Outcome run = check(length);
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.out, HasSubstr("but measures 2.8284271247461903"));
  }
}

}  // namespace
}  // namespace taut::test
