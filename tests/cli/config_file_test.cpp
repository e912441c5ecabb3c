// Options from a file: --config.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kRoom = "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 3\nstart 1 2\ngoal 3 2\n";

class ConfigFile : public ProgramTest {
 protected:
  /// The answer without the time that it took.
  static std::string answer(const Outcome& run) {
    const std::size_t end = run.out.find(" s CPU"), begin = run.out.rfind(", ", end);
    return end == std::string::npos ? run.out : std::string(run.out).erase(begin, end - begin);
  }
  Outcome with(const std::string& settings, const std::string& words) {
    return run_taut(words + " --config " + folder.file("taut.toml", settings), kRoom);
  }
};

TEST_F(ConfigFile, GivesOptionsFlagsAndSectionsOfSubcommands) {
  EXPECT_EQ(answer(with("path = true\nquiet = false\n", "solve -")), answer(run_taut("solve - --path", kRoom)));
  EXPECT_EQ(answer(with("[solve]\npath = true\n[check]\nquiet = true\n", "solve -")),
            answer(run_taut("solve - --path", kRoom)));
  EXPECT_EQ(answer(with("from = \"3,3\"\nto = \"3,1\"\n", "solve -")),
            answer(run_taut("solve - --from 3,3 --to 3,1", kRoom)));
  EXPECT_THAT(with("[compare]\nplanners = \"polyanya,full-visibility\"\n", "compare -").out,
              HasSubstr("full-visibility"));
}

TEST_F(ConfigFile, IsOverruledByTheCommandLine) {
  const std::string expected = answer(run_taut("solve - --to 3,1", kRoom));
  EXPECT_EQ(answer(with("to = \"3,3\"\n", "solve - --to 3,1")), expected);
  EXPECT_EQ(answer(with("to = \"3,3\"\n", "solve - --to=3,1")), expected);
}

TEST_F(ConfigFile, SaysNothingToSubcommandsThatHaveNoSuchOption) {
  EXPECT_EQ(answer(with("samples = 500\nwidth = 3\n", "check -")), answer(run_taut("check -", kRoom)));
}

TEST_F(ConfigFile, IsRefusedWhereItMakesNoSense) {
  const Outcome strange = with("[solve]\ncolour = \"red\"\n", "solve -");
  EXPECT_EQ(strange.code, 2);
  EXPECT_THAT(strange.err, HasSubstr("taut.toml: solve has no option --colour"));
  const Outcome flag = with("path = 3\n", "solve -");
  EXPECT_EQ(flag.code, 2);
  EXPECT_THAT(flag.err, HasSubstr("path is true or false, not '3'"));
  const Outcome value = with("from = \"here\"\n", "solve -");
  EXPECT_EQ(value.code, 2);
  EXPECT_THAT(value.err, HasSubstr("--from"));
  EXPECT_EQ(run_taut("solve - --config absent", kRoom).code, 3);
  EXPECT_EQ(run_taut("solve - --config", kRoom).code, 2);
}

TEST_F(ConfigFile, IsNotNeededToSayWhatTheProgramIsMadeOf) {
  const std::string version = run_taut("--version").out;
  EXPECT_THAT(version, StartsWith("taut "));
  for (const char* part : {"compiler: ", "CGAL ", "Boost ", "GMP ", "options: "}) EXPECT_THAT(version, HasSubstr(part));
}

}  // namespace
}  // namespace taut::test
