#include <taut/io/saved/all_radii_file.h>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/io/saved/detail/fnv.h>
#include <taut/io/saved/detail/saved_words.h>
#include <taut/io/saved/packed.h>
#include <taut/io/saved/roadmap_file.h>
#include <taut/roadmaps/exact/all_radii_parts.h>

namespace taut {

namespace {

constexpr std::string_view kMagic = "taut radii ";
constexpr std::string_view kVersion = "1";

std::string mark(std::string_view bytes) {
  detail::Fnv fnv;
  fnv.add(bytes);
  return fnv.hex();
}

/// What stands behind the key in the next line.
std::string value(std::string_view& rest, std::string_view key, const std::string& name) {
  const std::size_t end = rest.find('\n');
  if (end == std::string_view::npos || !rest.starts_with(key))
    throw InputError(name, 0, fmt::format("is damaged: '{}' should stand in its head", key));
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end + 1);
  return std::string(line.substr(std::min(line.size(), key.size() + 1)));
}

/// Legs as they are kept: ascending, between sites that there are, by sides that these have.
class Reading {
 public:
  Reading(std::string_view bytes, std::string name, const TangentGround& ground)
      : unpacker_(bytes, name), name_(std::move(name)), ground_(ground) {}

  void read() {
    const std::uint64_t sites = unpacker_.number(), count = unpacker_.number();
    if (sites != ground_.sites.size()) fail();
    for (std::uint64_t i = 0; i < count; ++i) read_leg();
    if (!unpacker_.empty()) fail();
  }

  std::vector<TangentName> legs;
  std::vector<std::uint32_t> first{0};
  std::vector<RadiusSpan> spans;

 private:
  [[noreturn]] void fail() const { throw InputError(name_, 0, "is damaged: its legs are not those of this world"); }

  int side(std::uint64_t word, std::uint32_t site) const {
    const int side = static_cast<int>(word % 4) - 1;
    if (ground_.sites[site].round ? side != 1 && side != -1 : side != 0) fail();
    return side;
  }

  void read_leg() {
    const std::uint64_t from = unpacker_.number(), to = unpacker_.number(), sides = unpacker_.number();
    if (from >= to || to >= ground_.sites.size() || sides >= 16) fail();
    TangentName leg{static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to), 0, 0};
    leg.from_side = side(sides / 4, leg.from);
    leg.to_side = side(sides, leg.to);
    const auto rank = [](const TangentName& t) {
      return std::array<std::int64_t, 4>{t.from, t.to, -t.from_side, -t.to_side};
    };
    if (!legs.empty() && rank(legs.back()) >= rank(leg)) fail();
    legs.push_back(leg);
    for (std::uint64_t left = unpacker_.number(); left > 0; --left) {
      const double low = unpacker_.real(), high = unpacker_.real();
      spans.push_back({low, high, unpacker_.number() == 1});
      if (!(low <= high) || !std::isfinite(high)) fail();
    }
    first.push_back(static_cast<std::uint32_t>(spans.size()));
  }

  Unpacker unpacker_;
  std::string name_;
  const TangentGround& ground_;
};

}  // namespace

std::string all_radii_file(const AllRadii& all) {
  const AllRadiiParts& parts = all.parts();
  Packer packer;
  packer.put(std::uint64_t{parts.ground->sites.size()}).put(std::uint64_t{parts.legs.size()});
  for (std::size_t i = 0; i < parts.legs.size(); ++i) {
    const TangentName& leg = parts.legs[i];
    packer.put(std::uint64_t{leg.from}).put(std::uint64_t{leg.to});
    packer.put(static_cast<std::uint64_t>(4 * (leg.from_side + 1) + leg.to_side + 1));
    packer.put(std::uint64_t{parts.first_span[i + 1] - parts.first_span[i]});
    for (std::uint32_t k = parts.first_span[i]; k < parts.first_span[i + 1]; ++k)
      packer.put(parts.spans[k].from).put(parts.spans[k].to).put(std::uint64_t{parts.spans[k].certain});
  }
  const std::string bytes = std::move(packer).bytes();
  const World& world = all.space().world();
  return fmt::format("{}{}\nsource {}\nworld {}\nmark {}\nend\n{}", kMagic, kVersion, detail::one_line(world.source()),
                     fingerprint(world), mark(bytes), bytes);
}

AllRadii read_all_radii(std::string_view bytes, const std::string& name, const FreeSpace& space) {
  if (!bytes.starts_with(kMagic)) throw InputError(name, 0, "is no saved index of radii");
  const std::string version = value(bytes, kMagic.substr(0, kMagic.size() - 1), name);
  if (version != kVersion)
    throw InputError(name, 0,
                     fmt::format("is a saved index of version {}; this program reads version {}",
                                 detail::one_line(version.substr(0, 20)), kVersion));
  const std::string source = value(bytes, "source", name), world = value(bytes, "world", name),
                    marked = value(bytes, "mark", name);
  value(bytes, "end", name);
  detail::require_same_world(name, space, source, world, detail::robot_text(Footprint::point()));
  if (mark(bytes) != marked) throw InputError(name, 0, "is cut off or damaged");
  auto ground = std::make_shared<const TangentGround>(space);
  Reading reading(bytes, name, *ground);
  reading.read();
  return AllRadii(std::make_shared<const AllRadiiParts>(std::move(ground), std::move(reading.legs),
                                                        std::move(reading.first), std::move(reading.spans)));
}

}  // namespace taut
