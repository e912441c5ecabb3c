// taut mouse check, as its users run it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/mouse/mazes.h"
#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class MouseCheck : public ProgramTest {};

TEST_F(MouseCheck, AcceptsACertificateAndRefusesOnesThatWereTamperedWith) {
  const std::string file = in_folder("proof.json"),
                    check = "mouse check " + data_file("mouse_12.cells") + " --certificate ";
  ASSERT_EQ(
      run_taut("mouse run --quick -q --explorer prove " + data_file("mouse_12.cells") + " --certificate " + file).code,
      0);
  const Outcome valid = run_taut(check + file);
  EXPECT_EQ(valid.code, 0) << valid.err;
  EXPECT_THAT(valid.out, HasSubstr(": valid: no run 2 has fewer than "));
  const json proof = json::parse(contents(file));
  const auto expect_refusal = [&](const char* what, const json& other) {
    SCOPED_TRACE(what);
    const Outcome run = run_taut(check + folder.file("other.json", other.dump()));
    EXPECT_EQ(run.code, 1) << run.out << run.err;
    EXPECT_THAT(run.out, HasSubstr("not valid: "));
  };
  json other = proof;
  other["steps"] = proof["steps"].get<int>() - 1;
  expect_refusal("fewer steps", other);
  other = proof;
  other["walls"].erase(0);
  expect_refusal("a wall missing", other);
  other = proof;
  other["walls"][0]["step"] = proof["walls"][0]["step"].get<int>() + 1;
  expect_refusal("another step", other);
  other = proof;
  other["run1"].erase(1);
  expect_refusal("a step of run 1 missing", other);
  other = proof;
  other["route"][1] = {7, 7};
  expect_refusal("another route", other);
  other = proof;
  other["openings"][0]["cell"] = {-5, 900000};
  expect_refusal("an opening nowhere", other);
  EXPECT_EQ(run_taut("mouse check " + data_file("mouse_16.maz") + " --certificate " + file).code, 1);
}

TEST_F(MouseCheck, NamesWhatIsWrongWithACertificateFile) {
  const std::string check = "mouse check " + data_file("mouse_12.cells") + " --certificate ";
  const auto expect_error = [&](const std::string& bytes, const char* says) {
    const Outcome run = run_taut(check + folder.file("bad.json", bytes));
    EXPECT_EQ(run.code, 3) << bytes;
    EXPECT_THAT(run.err, HasSubstr(says));
  };
  expect_error("", "not valid JSON");
  expect_error("{\n\"certificate\": 1,\n]", "bad.json:3: not valid JSON");
  expect_error("[]", "'certificate' is missing");
  expect_error("{\"certificate\": 2}", "a format other than 1");
  expect_error("{\"certificate\": 1, \"width\": 1.5}", "'width' is not a whole number");
  expect_error("{\"certificate\": 1, \"width\": 99999999999}", "'width' is out of range");
  expect_error("{\"certificate\": 1e400}", "bad.json:1: not valid JSON");
  expect_error(std::string(100000, '['), "nested more than 64 deep");
}

TEST_F(MouseCheck, WritesNoCertificateWhereNothingIsProven) {
  const Outcome run = run_taut("mouse run --quick --explorer flood --certificate " + in_folder("none.json") + " " +
                               data_file("mouse_16.maz"));
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.err, HasSubstr("does not prove"));
  EXPECT_FALSE(std::filesystem::exists(in_folder("none.json")));
}

TEST_F(MouseCheck, NamesEachViolationOnALine) {
  const Outcome run = run_taut("mouse check -", kBend);
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, HasSubstr("<stdin>: not legal: size 2 x 2"));
  EXPECT_THAT(run.out, HasSubstr("the goal is not the room in the middle"));
  const Outcome open = run_taut("mouse check -", "o---o---o\n|     G |\no   o   o\n  S     |\no---o---o\n");
  EXPECT_THAT(open.out, HasSubstr("the outer wall is open at (0,0) west"));
  EXPECT_THAT(open.out, HasSubstr("the start (0,0) is open to the right (east)"));
  EXPECT_THAT(open.out, HasSubstr("no wall touches the post at the upper right of (0,0)"));
  const Outcome sealed = run_taut("mouse check --json - -", kSealed);
  EXPECT_EQ(sealed.code, 1);
  EXPECT_THAT(json::parse(sealed.out)["result"]["faults"].dump(),
              HasSubstr("there is no way from the start to the goal"));
}

void expect_legal(const std::string& file) {
  const Outcome run = run_taut("mouse check " + file);
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_THAT(run.out, HasSubstr(": legal, "));
}

/// By the rules of small mazes whose posts may stand free, which its size tells, and not by those of contests.
void expect_legal_with_free_posts_only(const std::string& file) {
  EXPECT_EQ(run_taut("mouse check --rules free-posts " + file).code, 0);
  EXPECT_THAT(run_taut("mouse check " + file).out, HasSubstr("posts may stand free"));
  EXPECT_EQ(run_taut("mouse check --rules competition " + file).code, 1);
}

TEST_F(MouseCheck, AcceptsMazesByTheRulesThatTheyWereMadeFor) {
  expect_legal(data_file("mouse_32.maze"));
  const std::string perfect = in_folder("perfect.maz"), small = in_folder("small.cells");
  ASSERT_EQ(run_taut("generate --kind backtracker --size 16 --seed 1 --as maz -o " + perfect).code, 0);
  expect_legal(perfect);
  ASSERT_EQ(run_taut("generate --kind backtracker --size 12 --seed 1 --as cells -o " + small).code, 0);
  expect_legal_with_free_posts_only(small);
  EXPECT_THAT(run_taut("mouse check -", "3\n1,5,6\n2,2,10\n9,13,12\n").out, HasSubstr("not legal: size 3 x 3"));
  if (const auto shared = shared_data_dir()) {
    for (const char* name : {"japan2008ef.maz", "us96.maz", "apec2013.txt", "32MM2016HX.maze", "uk2012f.maz"})
      expect_legal((*shared / "micromouse/competition" / name).string());
    expect_legal_with_free_posts_only((*shared / "micromouse/test_maze_01.txt").string());
  }
}

}  // namespace
}  // namespace taut::test
