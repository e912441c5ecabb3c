#include <taut/io/worlds/file_kind.h>

#include <array>
#include <cctype>
#include <optional>

#include <taut/geometry/errors.h>
#include <taut/io/worlds/detail/text_input.h>
#include <taut/io/worlds/movingai.h>
#include <taut/io/worlds/read_world.h>

namespace taut {

namespace {

constexpr std::size_t kLinesLookedAt = 200;  // comments, then roadblocks, come before a roadblock map's `grid`

std::string lower(std::string_view text) {
  std::string out;
  for (const char c : text) out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

bool is_section_n(std::string_view line) {
  const std::string word = lower(line.substr(0, line.find_first_of(" \t,")));
  return word == "n";
}

FileKind kind_of_first(const std::string& line) {
  if (line.starts_with("taut roadmap ")) return FileKind::saved_roadmap;
  if (line.starts_with("version") || looks_like_scenario(line)) return FileKind::scenarios;
  if (line.starts_with("start,") || line.starts_with("goal,")) return FileKind::grid_csv;
  if (is_section_n(line)) return FileKind::cost_map;
  return FileKind::unknown;
}

bool is_certificate(std::string_view bytes) {
  return bytes.find("\"max_steps\"") != std::string_view::npos && bytes.find("\"run1\"") != std::string_view::npos;
}

FileKind kind_of_json(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, 4000);
  if (is_certificate(bytes)) return FileKind::certificate;
  return head.find("\"program\": \"taut\"") == std::string_view::npos ? FileKind::unknown : FileKind::result;
}

bool is_roadblock_line(const std::string& line) { return line.starts_with("grid ") || line.starts_with("roadblock "); }

FileKind kind_of_lines(std::string_view bytes) {
  FileKind kind = FileKind::unknown;
  bool is_first = true;
  detail::Lines lines(bytes);
  for (std::size_t i = 0; i < kLinesLookedAt && lines.next(); ++i) {
    const std::string line = lower(detail::trimmed(lines.line()));
    if (line.empty() || line[0] == '#') continue;
    if (is_roadblock_line(line)) return FileKind::roadblock_map;
    if (is_first) kind = line[0] == '{' ? kind_of_json(bytes) : kind_of_first(line);
    is_first = false;
  }
  return kind;
}

}  // namespace

FileKind file_kind(std::string_view bytes) {
  const FileKind kind = kind_of_lines(bytes);
  if (kind != FileKind::unknown) return kind;
  try {
    detect_format(bytes);
    return FileKind::world;
  } catch (const InputError&) {
    return FileKind::unknown;
  }
}

std::string_view name(FileKind kind) {
  constexpr std::array<std::string_view, 9> kNames{"a file of no known kind",  "a world",         "a cost map",
                                                   "a roadblock map",          "a grid map",      "a scenario file",
                                                   "a micromouse certificate", "a saved roadmap", "a result of taut"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string source_name(const std::string& path) { return path == "-" ? "<stdin>" : detail::printable_name(path); }

}  // namespace taut
