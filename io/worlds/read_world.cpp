#include <taut/io/worlds/read_world.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <utility>

#include <taut/geometry/occupancy_world.h>
#include <taut/io/worlds/detail/formats.h>
#include <taut/io/worlds/detail/read_shapes.h>
#include <taut/io/worlds/detail/text_input.h>
#include <taut/io/worlds/detail/wkt_table.h>
#include <taut/io/worlds/gzip.h>
#include <taut/io/worlds/movingai.h>
#include <taut/io/worlds/raster.h>
#include <taut/io/worlds/ros_map.h>

namespace taut {

namespace {

constexpr std::array<std::pair<Format, std::string_view>, 13> kNames{{
    {Format::segments, "segments"},
    {Format::cell_values, "cells"},
    {Format::drawing, "drawing"},
    {Format::maz, "maz"},
    {Format::num, "num"},
    {Format::wkt, "wkt"},
    {Format::geojson, "geojson"},
    {Format::movingai, "movingai"},
    {Format::ros_map, "ros"},
    {Format::picture, "picture"},
    {Format::blocks, "blocks"},
    {Format::svg, "svg"},
    {Format::integers, "integers"},
}};

bool is_text(std::string_view bytes) {
  return std::none_of(bytes.begin(), bytes.end(), [](char c) {
    return (static_cast<unsigned char>(c) < ' ' && !(c >= '\t' && c <= '\r') && c != '\x1e') || c == 0x7f;
  });
}

bool is_empty(std::string_view bytes) {
  return std::all_of(bytes.begin(), bytes.end(), [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); });
}

std::string first_word(std::string_view line) {
  std::string word;
  for (char c : line) {
    if (!std::isalpha(static_cast<unsigned char>(c))) break;
    word += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return word;
}

std::size_t count_fields(std::string_view line) {
  std::size_t n = 0;
  bool inside = false;
  for (char c : line) {
    const bool separator = c == ',' || c == ' ' || c == '\t';
    n += !separator && !inside;
    inside = !separator;
  }
  return n;
}

// Of a line that says something.
std::optional<Format> format_of_line(std::string_view line) {
  if (line.starts_with("<?xml") || line.starts_with("<svg") || line.starts_with("<!")) return Format::svg;
  if (line[0] == '{' || line[0] == '[' || line[0] == '\x1e') return Format::geojson;
  if (detail::is_row_of_posts(line)) return Format::drawing;
  const std::string word = first_word(line);
  if (detail::begins_wkt(line)) return Format::wkt;
  if (word == "TYPE" || word == "HEIGHT" || word == "WIDTH") return Format::movingai;
  if (word == "START" || word == "GOAL" || word == "BOUNDARY" || detail::is_header_of_segments(line))
    return Format::segments;
  const bool number =
      std::isdigit(static_cast<unsigned char>(line[0])) || line[0] == '-' || line[0] == '+' || line[0] == '.';
  if (!number && word != "NAN" && word != "INF") return std::nullopt;
  switch (count_fields(line.substr(0, line.find('#')))) {
    case 1: return Format::cell_values;
    case 6: return Format::num;
    default: return Format::segments;
  }
}

// Comments of the formats that have any; a drawing's are met by its reader.
bool is_comment(std::string_view line) { return line[0] == '#' || line[0] == '/' || line[0] == '*' || line[0] == ';'; }

// A line `image: ...` among the first ones.
bool looks_like_ros_map(std::string_view bytes) {
  for (detail::Lines lines(bytes); lines.next() && lines.number() <= 100;)
    if (lines.line().starts_with("image:")) return true;
  return false;
}

// Any bytes of that length could be one: believed when neighbours and border agree.
void require_maz(std::string_view bytes, const std::string& source) {
  try {
    detail::read_maz(bytes, {});
  } catch (const InputError& error) {
    throw InputError(source, 0,
                     "binary data of " + std::to_string(bytes.size()) + " bytes, but no .maz maze: " + error.what());
  }
}

bool looks_like_wkb(std::string_view bytes) {
  return bytes.size() > 8 && bytes[0] == 1 && bytes[1] >= 1 && bytes[1] <= 7 && bytes[2] == 0 && bytes[3] == 0;
}

void check_not_utf16(std::string_view bytes, const std::string& source) {
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
    throw InputError(source, 0, "text in UTF-16; save it as UTF-8");
}

World read_grid(GridMaze maze, const ReadOptions& options) {
  return world_of(std::make_shared<const GridMaze>(std::move(maze)), options.cell_size, options.source);
}

World read_picture(std::string_view bytes, const ReadOptions& options) {
  if (!options.resolution)
    throw InputError(options.source, 0, "is a picture: how many metres is a pixel (--resolution)?");
  RosMapInfo info;
  info.resolution = *options.resolution;
  return ros_world(occupancy(read_raster(bytes, options.source), info, options.unknown_is_free), info, options.source);
}

World read_ros_map(std::string_view bytes, const ReadOptions& options, ReadNotes& notes) {
  RosMapInfo info = read_ros_map_info(bytes, options.source);
  if (options.resolution) info.resolution = *options.resolution;
  const std::string file = (std::filesystem::path(options.folder) / info.image).string();
  const Raster raster = read_raster(read_bytes(file), detail::printable_name(file));
  const OccupancyGrid grid = occupancy(raster, info, options.unknown_is_free);
  if (info.yaw != 0)
    notes.remarks.push_back(fmt::format("turned by the map's yaw, {}; corners are off by at most {:.0e} m", info.yaw,
                                        turning_error(grid, info)));
  return ros_world(grid, info, options.source);
}

// What the bytes say, as the options ask for it.
World changed(World world, const ReadOptions& options) {
  if (options.wall_thickness) world = world.with_wall_thickness(*options.wall_thickness);
  if (options.start || options.goal) world = world.with_ends(options.start, options.goal);
  return world;
}

void require_projectable(Format format, const std::string& source) {
  if (format == Format::segments || format == Format::wkt || format == Format::geojson) return;
  throw InputError(
      source, 0,
      fmt::format("is {}: --project takes longitude and latitude in GeoJSON, WKT or segments", name(format)));
}

/// `size`: how many bytes are expected.
std::string drain(std::istream& in, std::size_t size = 0) {
  std::string bytes;
  bytes.reserve(size);
  std::array<char, 1 << 16> block;
  while (in.read(block.data(), block.size()) || in.gcount() > 0)
    bytes.append(block.data(), static_cast<std::size_t>(in.gcount()));
  return bytes;
}

std::string unpacked(std::string bytes, const std::string& source) {
  return is_gzip(bytes) ? gunzip(bytes, source) : std::move(bytes);
}

}  // namespace

std::string_view name(Format format) {
  return std::find_if(kNames.begin(), kNames.end(), [&](const auto& entry) { return entry.first == format; })->second;
}

std::optional<Format> format_named(std::string_view word) {
  for (const auto& [format, its_name] : kNames)
    if (its_name == word) return format;
  return std::nullopt;
}

Format detect_format(std::string_view bytes, const std::string& source) {
  if (is_empty(detail::stripped(bytes))) throw InputError(source, 0, "file is empty");
  check_not_utf16(bytes, source);
  if (is_png(bytes) || is_pgm(bytes)) return Format::picture;
  if (!is_text(detail::stripped(bytes))) {
    if (detail::is_maz_size(bytes.size())) {
      require_maz(bytes, source);
      return Format::maz;
    }
    if (looks_like_wkb(bytes)) throw InputError(source, 0, "holds a geometry as WKB: write it as WKT");
    throw InputError(
        source, 0,
        "binary data of " + std::to_string(bytes.size()) + " bytes; the only binary format, .maz, has 256 or 1024");
  }
  if (detail::has_hex_wkb_column(bytes))
    throw InputError(source, 0, "holds geometries as WKB in hexadecimal: write them as WKT (ST_AsText, .wkt, to_wkt)");
  if (detail::wkt_column(bytes)) return Format::wkt;
  if (detail::looks_like_blocks(bytes)) return Format::blocks;
  if (looks_like_ros_map(bytes)) return Format::ros_map;
  bool comment = false;
  for (detail::Lines lines(bytes); lines.next();) {
    const std::string_view line = detail::trimmed(lines.line());
    if (line.empty()) continue;
    if (is_comment(line)) {
      comment = true;
      continue;
    }
    if (const std::optional<Format> format = format_of_line(line)) return *format;
    detail::SourceLine{source, lines.number()}.fail("no known format begins with " + detail::quoted(line));
  }
  throw InputError(source, 0, comment ? "file holds nothing but comments" : "file is empty");
}

World read_world(std::string_view bytes, const ReadOptions& options, ReadNotes* notes) {
  if (is_empty(detail::stripped(bytes))) throw InputError(options.source, 0, "file is empty");
  ReadNotes local;
  ReadNotes& seen = notes ? *notes : local;
  seen = {options.format ? *options.format : detect_format(bytes, options.source)};
  if (options.project) require_projectable(seen.format, options.source);
  switch (seen.format) {
    case Format::segments:
      return detail::read_shapes(detail::read_segments(bytes, options.source), options, seen, notes);
    case Format::cell_values:
      return changed(read_grid(detail::read_cell_values(bytes, options.source), options), options);
    case Format::drawing:
      return changed(read_grid(detail::read_drawing(bytes, options.source, seen.unknown_walls), options), options);
    case Format::maz: return changed(read_grid(detail::read_maz(bytes, options.source), options), options);
    case Format::num: return changed(read_grid(detail::read_num(bytes, options.source), options), options);
    case Format::wkt: return detail::read_shapes(detail::read_wkt(bytes, options, seen), options, seen, notes);
    case Format::geojson: return detail::read_shapes(detail::read_geojson(bytes, options, seen), options, seen, notes);
    case Format::ros_map: return changed(read_ros_map(bytes, options, seen), options);
    case Format::picture: return changed(read_picture(bytes, options), options);
    case Format::svg: return detail::read_shapes(detail::read_svg(bytes, options, seen), options, seen, notes);
    case Format::blocks: return detail::joined(detail::read_blocks(bytes, options.source), options, notes);
    case Format::movingai: return changed(world_of(read_movingai_map(bytes, options.source), options.source), options);
    case Format::integers: throw InputError(options.source, 0, "integers are written, not read: give the world itself");
  }
  throw InputError(options.source, 0, "unknown format");
}

World read_world(std::istream& in, const ReadOptions& options, ReadNotes* notes) {
  return read_world(unpacked(drain(in), options.source), options, notes);
}

World read_world_file(const std::string& path, ReadOptions options, ReadNotes* notes) {
  options.source = path == "-" ? "<stdin>" : detail::printable_name(path);
  options.folder = path == "-" ? "" : std::filesystem::path(path).parent_path().string();
  return read_world(read_bytes(path), options, notes);
}

std::string read_bytes(const std::string& path) {
  if (path == "-") return unpacked(drain(std::cin), "<stdin>");
  const std::string shown = path.empty() ? "''" : detail::printable_name(path);
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw InputError(shown, 0, "is a directory, not a file");
  if (!std::filesystem::exists(path, error)) throw InputError(shown, 0, "no such file");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(shown, 0, std::string("cannot be opened: ") + std::strerror(errno));
  const std::uintmax_t size = std::filesystem::file_size(path, error);  // of a pipe there is none
  std::string bytes = drain(in, error ? 0 : size);
  if (in.bad()) throw InputError(shown, 0, "cannot be read");
  return unpacked(std::move(bytes), shown);
}

}  // namespace taut
