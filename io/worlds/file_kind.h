// What a file is, for those who were given another than they wanted.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace taut {

/// What can be told from the first lines.
enum class FileKind : std::uint8_t {
  unknown,
  world,          ///< any of Format
  cost_map,       ///< sections N C R T M: read_chase_map
  roadblock_map,  ///< read_roadblock_map
  grid_csv,       ///< read_grid_csv
  scenarios,      ///< of MovingAI: read_movingai_scenarios
  certificate,    ///< of a micromouse: read_certificate
  saved_roadmap,  ///< read_roadmap_file
  result,         ///< JSON that the program wrote
};

/// By content alone; says nothing about whether the rest can be read.
FileKind file_kind(std::string_view bytes);

/// `a cost map`
std::string_view name(FileKind kind);

/// How messages call a file: `<stdin>` for `-`, else its name with `?` for control characters.
std::string source_name(const std::string& path);

}  // namespace taut
