// The command line: whatever the words are, a subcommand, a text, or one complaint. No file is touched.
#include <taut/cli/program.h>

#include "fuzz/fuzzed.h"

namespace {

using namespace taut;

// Words of the program, so that what comes behind them is reached.
constexpr const char* kKnown[] = {
    "solve",     "check",     "verify",   "audit",     "roadmap",      "compare",  "passage",       "reach",
    "generate",  "convert",   "space",    "batch",     "matrix",       "grid",     "diff",          "mouse",
    "chase",     "bug",       "drive",    "help",      "run",          "speed",    "scenario",      "heuristics",
    "--from",    "--to",      "--robot",  "disc:0.5",  "square:1",     "1,2",      "0.5",           "-",
    "--svg",     "--json",    "--stats",  "--quiet",   "--seed",       "7",        "--max-seconds", "--max-memory",
    "500M",      "--planner", "prm",      "voronoi",   "--size",       "9x9",      "--as",          "man",
    "--version", "--help",    "--format", "--widest",  "--arcs",       "--snap",   "auto",          "--snap-ends",
    "--jobs",    "--shard",   "1/2",      "--sampler", "--resolution", "--method", "--animate",     "maze.txt"};

std::vector<std::string> drawn_words(FuzzedDataProvider& bytes) {
  std::vector<std::string> words;
  while (bytes.remaining_bytes() > 0 && words.size() < 16) {
    std::string word =
        bytes.ConsumeBool() ? bytes.PickValueInArray(kKnown) : bytes.ConsumeRandomLengthString(24).c_str();
    if (!word.starts_with("--config")) words.push_back(std::move(word));
  }
  return words;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider bytes(data, size);
  fuzz::read([&] {
    try {
      const cli::Asked asked = cli::Program().parse(drawn_words(bytes));
      fuzz::require(asked.command || !asked.text.empty(), "neither a subcommand nor a text");
    } catch (const cli::UsageError& error) {
      fuzz::require(std::string(error.what()).find("; see `taut") != std::string::npos, "no way to the help");
    }
  });
  return 0;
}
