// Where the tests' files are.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace taut::test {

/// data/ of this project.
inline std::filesystem::path data_dir() { return TAUT_DATA_DIR; }

/// tests/corpus: every input that ever gave a wrong answer.
inline std::filesystem::path corpus_dir() { return TAUT_CORPUS_DIR; }

/// Data of others, in the folder that $TAUT_SHARED_DATA names. Without it nothing: no test needs it, those that know it
/// read it beside what the project made itself.
inline std::optional<std::filesystem::path> shared_data_dir() {
  const char* named = std::getenv("TAUT_SHARED_DATA");
  if (named == nullptr || *named == '\0') return std::nullopt;
  return named;
}

/// All files in a folder of the shared data and below, sorted; none without it.
inline std::vector<std::filesystem::path> shared_files(const char* folder) {
  std::vector<std::filesystem::path> files;
  if (const auto shared = shared_data_dir())
    for (const auto& entry : std::filesystem::recursive_directory_iterator(*shared / folder))
      if (entry.is_regular_file() && entry.path().extension() != ".md") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// The mazes of data/ with start and goal, sorted.
inline std::vector<std::filesystem::path> own_mazes() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(data_dir())) {
    const std::string kind = entry.path().extension().string();
    if (kind == ".txt" || kind == ".cells" || kind == ".maz" || kind == ".num" || kind == ".maze")
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The program `taut` of this build; nothing when it is not built.
inline std::optional<std::filesystem::path> program() {
  const std::filesystem::path file = TAUT_PROGRAM;
  if (file.empty()) return std::nullopt;
  return file;
}

}  // namespace taut::test
