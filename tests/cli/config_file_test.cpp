// Options from a file: --config.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
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
  void expect_refusal(const std::string& settings, int code, const std::string& why) {
    const Outcome run = with(settings, "solve -");
    EXPECT_EQ(run.code, code) << settings;
    EXPECT_EQ(run.out, "");
    EXPECT_THAT(run.err, HasSubstr(why));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
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
  const std::string settings = folder.file("to.toml", "to = 3,1\n");
  EXPECT_EQ(answer(run_taut("solve --config " + settings + " -- -", kRoom)), expected);
}

TEST_F(ConfigFile, SaysNothingToSubcommandsThatHaveNoSuchOption) {
  EXPECT_EQ(answer(with("samples = 500\nweight = 3\n", "check -")), answer(run_taut("check -", kRoom)));
}

TEST_F(ConfigFile, IsRefusedWhereItMakesNoSense) {
  expect_refusal("[solve]\ncolour = \"red\"\n", 2, "taut.toml:2: taut solve has no option colour");
  expect_refusal("path = 3\n", 2, "taut.toml:1: path is true or false, not '3'");
  EXPECT_EQ(run_taut("solve - --config absent", kRoom).code, 3);
  EXPECT_EQ(run_taut("solve - --config " + folder.path().string(), kRoom).code, 3);
  EXPECT_EQ(run_taut("solve - --config", kRoom).code, 2);
  EXPECT_EQ(run_taut("solve - --config a --config b", kRoom).code, 2);
}

TEST_F(ConfigFile, NamesTheLineOfANameThatNobodyKnows) {
  expect_refusal("# all\n\nsamlpes = 3\n", 2,
                 "taut.toml:3: no subcommand has an option samlpes; did you mean 'samples'?");
  expect_refusal("[slove]\npath = true\n", 2, "taut.toml:2: [slove] is no subcommand; did you mean 'solve'?");
  expect_refusal("[check]\nsvgs = \"a\"\n", 2, "taut.toml:2: taut check has no option svgs");
  expect_refusal("[grid]\npath = true\n", 2, "taut.toml:2: taut grid has no option path");
  expect_refusal("config = \"b.toml\"\n", 2, "taut.toml:1: no subcommand has an option config");
}

TEST_F(ConfigFile, NamesTheLineOfAValueThatIsNone) {
  expect_refusal("samples = \"abc\"\n", 2, "taut.toml:1: --samples: 'abc' is not a whole number");
  expect_refusal("\nsamples = 5\n", 2, "taut.toml:2: --samples makes no sense with the roadmap visibility");
  expect_refusal("from = [1, 2]\n", 2, "taut.toml:1: from has one value, not [1, 2]");
  expect_refusal("lazy = true\neager = true\n", 2, "taut.toml:1: --lazy excludes --eager");
}

TEST_F(ConfigFile, NamesTheLineThatIsNoSetting) {
  expect_refusal("path = true\npath\n", 3, "taut.toml:2: 'path' is neither `name = value` nor a [section]");
  expect_refusal("path = true\n\npath = false\n", 3, "taut.toml:3: path is in line 1 already");
  expect_refusal("[solve\npath = true\n", 3, "taut.toml:1: '[solve' is no section like [grid.solve]");
  expect_refusal("[solve] path = true\n", 3, "taut.toml:1: 'path = true' after the section [solve]");
  expect_refusal("path =\n", 3, "taut.toml:1: path has no value");
  expect_refusal("--path = true\n", 3, "taut.toml:1: '--path': names stand here without dashes");
  expect_refusal("= true\n", 3, "taut.toml:1: '' is not the name of an option");
  expect_refusal("from = \"1,2\n", 3, "taut.toml:1: a text that begins with \" does not end on its line");
  expect_refusal("from = \"1,2\" 3\n", 3, "taut.toml:1: '3' after the value of from");
  expect_refusal("from = \"1\\,2\"\n", 3, "taut.toml:1: '\\,' means nothing in a text");
  expect_refusal("from = [1,\n2]\n", 3, "taut.toml:1: the list of from does not end on its line");
  expect_refusal("from = ['1' '2']\n", 3, "taut.toml:1: the list of from needs a comma before ''2']'");
}

TEST_F(ConfigFile, MayBeEmptyAndHoldCommentsAndWordsWithoutQuotes) {
  EXPECT_EQ(answer(with("", "solve -")), answer(run_taut("solve -", kRoom)));
  EXPECT_EQ(answer(with("\xEF\xBB\xBF# none\r\n; none\r\n", "solve -")), answer(run_taut("solve -", kRoom)));
  const std::string expected = answer(run_taut("solve - --from 3,3 --to 3,1 --path", kRoom));
  EXPECT_EQ(answer(with("from = 3,3  # there\nto = '3,1'\r\nsolve.path = true", "solve -")), expected);
  EXPECT_EQ(answer(with("from = [\"3,3\"]\nto=3,1\n [ solve ] ; only\npath = true\n", "solve -")), expected);
}

TEST_F(ConfigFile, SaysInASectionWhatOverrulesTheRest) {
  const std::string expected = answer(run_taut("solve - --to 3,1", kRoom));
  EXPECT_EQ(answer(with("to = 3,3\n[solve]\nto = 3,1\n", "solve -")), expected);
}

TEST_F(ConfigFile, LetsAnOptionStandAloneThatMay) {
  const std::string film = in_folder("film.svg");
  EXPECT_EQ(with("tradeoff = true\nanimate = true\nsvg = " + film + "\n", "solve -").code, 0);
  EXPECT_THAT(contents(film), HasSubstr("<animate"));
}

TEST_F(ConfigFile, IsNotNeededToSayWhatTheProgramIsMadeOf) {
  const std::string version = run_taut("--version").out;
  EXPECT_THAT(version, StartsWith("taut "));
  for (const char* part : {"compiler: ", "CGAL ", "Boost ", "GMP ", "options: "}) EXPECT_THAT(version, HasSubstr(part));
}

}  // namespace
}  // namespace taut::test
