// Every reader of worlds: whatever the bytes are, a world or one line of refusal; and a world that is written again is
// read again, to the same walls.
#include <taut/io/saved/roadmap_file.h>
#include <taut/io/worlds/read_world.h>
#include <taut/io/worlds/write_world.h>

#include "fuzz/fuzzed.h"

namespace {

using namespace taut;

constexpr Format kWritten[] = {Format::segments, Format::wkt, Format::geojson};

// A picture or a map of many cells takes its time, which is no finding.
bool is_small(const World& world) { return world.walls().size() + world.solids().size() < 200; }

void write_and_read(const World& world) {
  for (const Format format : kWritten) {
    std::string text;
    try {
      text = write_world(world, format);
    } catch (const InputError&) {
      continue;  // the format cannot say it
    }
    ReadOptions options;
    options.format = format;
    options.snap = Snap{};
    try {
      const World again = read_world(text, options);
      fuzz::require(again.walls().size() == world.walls().size(),
                    "walls are lost in " + std::string(name(format)) + ":\n" + text);
    } catch (const InputError& error) {
      fuzz::found("what was written as " + std::string(name(format)) + " is refused: " + error.what() + "\n" + text);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider bytes(data, size);
  ReadOptions options;
  const auto wish = bytes.ConsumeIntegralInRange<unsigned>(0, 31);
  if (wish < 12) options.format = static_cast<Format>(wish);
  const auto flags = bytes.ConsumeIntegral<std::uint8_t>();
  if ((flags & 1U) != 0) options.polygons = ReadOptions::Polygons::obstacles;
  if ((flags & 2U) != 0) options.polygons = ReadOptions::Polygons::nested;
  if ((flags & 4U) != 0) options.crossings = Crossings::even_odd;
  if ((flags & 8U) != 0) options.unknown_is_free = true;
  if ((flags & 16U) != 0) options.resolution = 0.05;
  if ((flags & 32U) != 0) options.wall_thickness = 0.25;
  if ((flags & 64U) != 0) options.project = true;
  options.folder = "/nonexistent";
  const std::string text = bytes.ConsumeRemainingBytesAsString();
  fuzz::read([&] {
    const World world = read_world(text, options);
    if (is_small(world) && !options.project) write_and_read(world);
  });
  return 0;
}
