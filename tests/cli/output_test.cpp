// Files written whole or not at all.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kRoom = "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 3\nstart 1 2\ngoal 3 2\n";

class Output : public ProgramTest {
 protected:
  std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(folder.path()), {}); }
};

TEST_F(Output, IsWrittenBesideTheLine) {
  const Outcome run =
      run_taut("solve - --svg " + (folder / "a.svg").string() + " --json " + (folder / "a.json").string(), kRoom);
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out, StartsWith("<stdin>: length"));
  EXPECT_THAT(contents(folder / "a.svg"), StartsWith("<svg "));
  EXPECT_THAT(contents(folder / "a.json"), HasSubstr("\"status\": \"found\""));
  EXPECT_EQ(files(), 2);
}

TEST_F(Output, TakesThePlaceOfTheLineOnStandardOutput) {
  EXPECT_THAT(run_taut("solve - --json -", kRoom).out, StartsWith("{\n"));
  EXPECT_THAT(run_taut("solve - --svg -", kRoom).out, StartsWith("<svg "));
  EXPECT_THAT(run_taut("solve - -q --svg /dev/stdout | cat", kRoom).out, StartsWith("<svg "));
  EXPECT_EQ(run_taut("solve - --quiet", kRoom).out, "");
}

TEST_F(Output, LeavesTheOldFileAloneWhenTheInputIsWrong) {
  const std::string old = folder.file("a.svg", "old");
  for (const char* bytes : {"", "0 0 1 nan\n", "hello\n"}) {
    EXPECT_EQ(run_taut("solve - --svg " + old + " --json " + old, bytes).code, 3);
    EXPECT_EQ(run_taut("convert - --as wkt " + old, bytes).code, 3);
    EXPECT_EQ(contents(old), "old");
  }
  EXPECT_EQ(run_taut("generate --size 5 --as maz -o " + old).code, 2);
  EXPECT_EQ(contents(old), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(Output, IsRefusedWhenTwoWouldHaveOneName) {
  const std::string a = (folder / "a").string(), again = (folder / "." / "a").string();
  const Outcome run = run_taut("solve - --svg " + a + " --json " + again, kRoom);
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("two outputs have this name"));
  EXPECT_EQ(files(), 0);
  EXPECT_EQ(run_taut("solve - --svg /dev/null --json /dev/null", kRoom).code, 0);
}

TEST_F(Output, IsRefusedInThePlaceOfWhatIsRead) {
  const std::string world = folder.file("room.txt", kRoom), again = (folder / "." / "room.txt").string();
  for (const std::string option : {"--svg ", "--json ", "--certificate ", "--geojson "}) {
    const Outcome run = run_taut("solve " + world + " " + option + again);
    EXPECT_EQ(run.code, 3) << option;
    EXPECT_THAT(run.err, HasSubstr("cannot write: it is read"));
    EXPECT_EQ(contents(world), kRoom);
  }
  EXPECT_EQ(run_taut("convert " + world + " " + again + " --as wkt").code, 0);
  EXPECT_THAT(contents(world), HasSubstr("LINESTRING"));
}

TEST_F(Output, LeavesTheOldFileAloneWhenStopped) {
  const std::string old = folder.file("a.svg", "old"), endless = (folder / "endless").string();
  ASSERT_EQ(mkfifo(endless.c_str(), 0600), 0);
  EXPECT_EQ(run_taut("solve - --max-seconds 0.1 --svg " + old + " <>" + endless).code, 4);
  EXPECT_EQ(contents(old), "old");
}

TEST_F(Output, LeavesTheOldFileAloneWhenTheDiskIsFull) {
  const std::string old = folder.file("a.svg", "old");
  const std::string maze = folder.file("maze.txt", run_taut("generate --size 40").out);
  // A limit on the size of files, of 512 or 1024 bytes, stands for a full disk.
  const Outcome run = run_script("trap '' XFSZ; ulimit -f 1; exec \"$taut\" solve -q " + maze + " --svg " + old);
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.err, HasSubstr("a.svg: cannot write"));
  EXPECT_EQ(contents(old), "old");
  EXPECT_EQ(files(), 2);
}

TEST_F(Output, ReplacesAnOldFileAndKeepsItsPermissions) {
  const std::string old = folder.file("a.svg", "old");
  fs::permissions(old, fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(run_taut("solve - --svg " + old, kRoom).code, 0);
  EXPECT_THAT(contents(old), StartsWith("<svg "));
  EXPECT_EQ(fs::status(old).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(files(), 1);
}

TEST_F(Output, FollowsLinks) {
  const std::string target = folder.file("target", "old");
  fs::create_symlink("target", folder / "link");
  EXPECT_EQ(run_taut("solve - --svg " + (folder / "link").string(), kRoom).code, 0);
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_THAT(contents(target), StartsWith("<svg "));
}

TEST_F(Output, IsRefusedWhereLinksLeadInACircle) {
  fs::create_symlink("there", folder / "here");
  fs::create_symlink("here", folder / "there");
  const Outcome run = run_taut("solve - --svg " + (folder / "here").string(), kRoom);
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("here: cannot write: Too many levels of symbolic links"));
  EXPECT_TRUE(fs::is_symlink(folder / "here"));
}

TEST_F(Output, ShowsTheBeginningAndTheEndOfALongCulprit) {
  const Outcome run = run_taut("solve - --snap " + std::string(5000, 'a') + "z", kRoom);
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("aaa...aaa"));
  EXPECT_THAT(run.err, HasSubstr("az"));
  EXPECT_LT(run.err.size(), 400U);
}

TEST_F(Output, CutsALongCulpritBetweenItsLetters) {
  std::string letters;
  for (int i = 0; i < 1000; ++i) letters += "\u00e9\u20ac";
  const Outcome run = run_taut("solve - --snap " + letters, kRoom);
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("..."));
  EXPECT_NO_THROW(static_cast<void>(nlohmann::json(run.err).dump()));  // refuses what is no UTF-8
}

TEST_F(Output, IsRefusedBeforeTheWorkBeginsWhenItCannotBeMade) {
  for (const std::string& target :
       {folder.path().string(), (folder / "no/such/a.svg").string(), folder.path().string() + "/"}) {
    const Outcome run = run_taut("solve - --svg " + target, kRoom);
    EXPECT_EQ(run.code, 3);
    EXPECT_EQ(run.out, "");
    EXPECT_THAT(run.err, StartsWith("taut: " + target + ": cannot write"));
  }
}

TEST_F(Output, GoesToDevicesDirectly) {
  EXPECT_EQ(run_taut("solve - --svg /dev/null", kRoom).code, 0);
  EXPECT_FALSE(fs::is_regular_file("/dev/null"));
  EXPECT_EQ(run_taut("solve - --svg /dev/full", kRoom).code, 4);
}

}  // namespace
}  // namespace taut::test
