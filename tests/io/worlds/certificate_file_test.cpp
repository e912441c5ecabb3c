// Certificates of a micromouse as files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include <taut/geometry/maze_generator.h>
#include <taut/io/worlds/certificate_file.h>
#include <taut/robots/micromouse/explorers.h>

#include "support/refusal.h"

namespace taut {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// A certificate, won in a maze of the generator.
struct Won {
  GridMaze maze = [] {
    GridMaze made = generate_backtracker(8, 8, 3);
    open_centre_room(made);
    return made;
  }();
  micromouse::CertifiedRun certified = [this] {
    const auto robot = micromouse::make_explorer(micromouse::Explorer::prove, micromouse::task_of(maze));
    const micromouse::Record record = micromouse::run_trial(maze, *robot);
    return certified_run(*micromouse::certificate(record), record);
  }();
};

TEST(CertificateFile, ReadsBackWhatWasWritten) {
  const Won won;
  const std::string text = certificate_text(won.certified);
  const micromouse::CertifiedRun again = read_certificate(text, "proof.json");
  EXPECT_EQ(again.certificate.task, won.certified.certificate.task);
  EXPECT_EQ(again.certificate.route, won.certified.certificate.route);
  EXPECT_EQ(again.certificate.openings, won.certified.certificate.openings);
  EXPECT_EQ(again.certificate.walls, won.certified.certificate.walls);
  EXPECT_EQ(again.run1, won.certified.run1);
  EXPECT_TRUE(verify_certificate(again, won.maze)) << verify_certificate(again, won.maze).reason;
  EXPECT_EQ(certificate_text(again), text);
}

TEST(CertificateFile, DoesNotVouchForWhatItReads) {
  const Won won;
  micromouse::CertifiedRun other = won.certified;
  other.run1.pop_back();
  EXPECT_FALSE(verify_certificate(read_certificate(certificate_text(other)), won.maze));
}

TEST(CertificateFile, NamesTheLineAndTheKey) {
  const auto message = [](const char* text) { return test::refusal_of([&] { read_certificate(text, "p.json"); }); };
  EXPECT_THAT(message("{\n\"certificate\": 1,\n]"), StartsWith("p.json:3: not valid JSON"));
  EXPECT_THAT(message("{\"certificate\": 1,\n\"width\": 2.5}"),
              HasSubstr("p.json:2: is no certificate: 'width' is not"));
  EXPECT_THAT(message("[]"), HasSubstr("'certificate' is missing"));
}

}  // namespace
}  // namespace taut
