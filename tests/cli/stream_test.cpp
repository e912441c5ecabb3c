// Outputs that are more than a file: pixels, pipes, files with other names and owners, names that a terminal would obey.
#include <sys/stat.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include <taut/io/pictures/rasterised.h>

#include "support/program_test.h"

namespace taut::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* kBend = "start,0,0\ngoal,0,3\n0,0,1,0\n0,0,1,0\n0,0,0,0\n";

class Stream : public ProgramTest {
 protected:
  std::string pipe(const char* name) const {
    const std::string path = in_folder(name);
    EXPECT_EQ(mkfifo(path.c_str(), 0600), 0);
    return path;
  }
};

TEST_F(Stream, OfANameInPngIsPixels) {
  const std::string png = in_folder("a.png");
  const Outcome run = run_taut("grid solve - --svg " + png, kBend);
  if (!why_not_rasterised().empty()) {
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, HasSubstr("a.png: cannot write a PNG: "));
    EXPECT_FALSE(fs::exists(png));
    return;
  }
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const std::string bytes = contents(png);
  ASSERT_THAT(bytes, StartsWith("\x89PNG\r\n"));
  const auto side = [&](std::size_t at) {
    return static_cast<unsigned char>(bytes[at]) * 256 + static_cast<unsigned char>(bytes[at + 1]);
  };
  EXPECT_EQ(side(18), 2 * 480);  // the width of a page so small, twice
  EXPECT_EQ(run_taut("grid solve - --animate " + png, kBend).code, 2) << "a PNG does not move";
}

TEST_F(Stream, OfAnotherKindOfPictureIsRefused) {
  for (const char* name : {"a.jpg", "a.pdf", "a.gif"})
    EXPECT_EQ(run_taut(std::string("grid solve - --svg ") + name, kBend).code, 2);
}

TEST_F(Stream, ThatNobodyReadsIsLeftWhenTimeIsUpAndTheResultIsWritten) {
  const std::string nobody = pipe("nobody"), file = in_folder("a.json");
  const Outcome run = run_taut("grid solve - --max-seconds 1 --svg " + nobody + " --json " + file, kBend);
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.err, HasSubstr("stopped in stage `write`: --max-seconds 1"));
  const json envelope = json::parse(contents(file));
  EXPECT_EQ(envelope["status"], "stopped");
  EXPECT_EQ(envelope["result"]["cost"], 7);
  EXPECT_EQ(run_taut("grid solve - --max-seconds 1 --json " + nobody, kBend).code, 4);
  EXPECT_EQ(run_taut("grid solve - --svg " + nobody, kBend, 0.5).code, 4) << "interrupted";
}

TEST_F(Stream, IsWrittenToWhoReads) {
  const std::string read = pipe("read"), grid = folder.file("a.csv", kBend);
  const Outcome run = run_script("cat " + read + " & \"$taut\" grid solve -q --json " + read + " " + grid + "; wait");
  EXPECT_EQ(json::parse(run.out)["status"], "found");
}

TEST_F(Stream, OfAFileWithTwoNamesIsSeenByBoth) {
  const std::string a = folder.file("a.json", std::string(100'000, 'x')), b = in_folder("b.json");
  fs::create_hard_link(a, b);
  EXPECT_EQ(run_taut("grid solve - --json " + a, kBend).code, 0);
  EXPECT_EQ(json::parse(contents(b))["status"], "found");
  EXPECT_EQ(fs::hard_link_count(a), 2U);
}

TEST_F(Stream, KeepsOwnerAndMode) {
  const std::string file = folder.file("a.json", "old");
  ASSERT_EQ(chmod(file.c_str(), 0640), 0);
  const bool is_root = geteuid() == 0;
  if (is_root) {
    ASSERT_EQ(chown(file.c_str(), 65534, 65534), 0);
  }
  EXPECT_EQ(run_taut("grid solve - --json " + file, kBend).code, 0);
  struct stat now {};
  ASSERT_EQ(stat(file.c_str(), &now), 0);
  EXPECT_EQ(now.st_mode & 07777, 0640U);
  EXPECT_EQ(now.st_uid, is_root ? 65534U : geteuid());
  EXPECT_EQ(json::parse(contents(file))["status"], "found");
}

TEST_F(Stream, NeverCarriesAFilesNameRawToATerminal) {
  const std::string file = folder.file("a\x1b[31m\n\xc2\x9b.csv", kBend);
  for (const char* command : {"grid solve", "grid compare", "grid heuristics", "bug", "chase compare"}) {
    SCOPED_TRACE(command);
    const Outcome run = run_taut(std::string(command) + " '" + file + "'");
    for (const std::string& text : {run.out, run.err}) {
      EXPECT_THAT(text, Not(HasSubstr("\x1b")));
      EXPECT_THAT(text, Not(HasSubstr("\xc2\x9b")));
      EXPECT_THAT(text, Not(HasSubstr("31m\n")));
    }
  }
  EXPECT_THAT(run_taut("grid solve '" + file + "'").out, HasSubstr("a?[31m??"));
}

}  // namespace
}  // namespace taut::test
