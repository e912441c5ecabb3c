// Where the tests' files are.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>

namespace taut::test {

/// data/ of this project.
inline std::filesystem::path data_dir() { return TAUT_DATA_DIR; }

/// tests/corpus: every input that ever gave a wrong answer.
inline std::filesystem::path corpus_dir() { return TAUT_CORPUS_DIR; }

/// The data shared between projects: $TAUT_SHARED_DATA, or shared/data beside the checkout. Nothing where there is
/// none: skip the test.
inline std::optional<std::filesystem::path> shared_data_dir() {
  const char* named = std::getenv("TAUT_SHARED_DATA");
  const std::filesystem::path folder = named != nullptr ? named : TAUT_SHARED_DATA_DIR;
  if (!std::filesystem::is_directory(folder)) return std::nullopt;
  return folder;
}

/// The program `taut` of this build; nothing when it is not built.
inline std::optional<std::filesystem::path> program() {
  const std::filesystem::path file = TAUT_PROGRAM;
  if (file.empty()) return std::nullopt;
  return file;
}

}  // namespace taut::test
