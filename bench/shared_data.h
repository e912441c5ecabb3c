// Data of others that some benches run on beside the project's own.
#pragma once

#include <cstdlib>
#include <filesystem>

namespace taut::bench {

/// A file or folder in what $TAUT_SHARED_DATA names; without it, or where there is no such file, an empty path.
inline std::filesystem::path shared_data(const std::filesystem::path& name) {
  const char* folder = std::getenv("TAUT_SHARED_DATA");
  if (folder == nullptr || !std::filesystem::exists(folder / name)) return {};
  return folder / name;
}

}  // namespace taut::bench
