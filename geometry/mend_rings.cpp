#include <taut/geometry/mend_rings.h>

#include <algorithm>
#include <map>
#include <utility>

#include <taut/geometry/detail/coordinate_gate.h>
#include <taut/geometry/detail/polygon_mend.h>
#include <taut/geometry/detail/polygon_validation.h>

namespace taut {

namespace {

using detail::Flaw;

const char* meaning(Flaw::Kind kind) {
  switch (kind) {
    case Flaw::repeat: return "taken once";
    case Flaw::flat: return "left out";
    case Flaw::spike: return "what has no width is left out";
    case Flaw::touch:
    case Flaw::overlap: return "taken as its inside";
    case Flaw::crossing: return "taken by the even-odd rule";
    case Flaw::along:
    case Flaw::reach: return "taken as the outer ring without its holes";
  }
  return "";
}

class Mending {
 public:
  Mending(const std::string& source, Crossings crossings) : source_(source), crossings_(crossings) {}

  void mend(std::vector<Area>& areas) {
    std::vector<Area> result;
    result.reserve(areas.size());
    for (Area& area : areas) {
      detail::CoordinateGate(source_, area.line).admit(area.polygon);
      std::vector<Flaw> flaws;
      for (Polygon& polygon : mended(area, flaws)) result.push_back({std::move(polygon), area.line});
      for (const Flaw& flaw : flaws) note(flaw, area.line);
    }
    areas = std::move(result);
  }

  std::vector<std::string> remarks() const {
    std::vector<std::string> lines;
    for (const auto& [kind, seen] : seen_) {
      std::string line = seen.line > 0 ? "line " + std::to_string(seen.line) + ": " : "";
      line += seen.message + ": " + meaning(kind);
      if (seen.count > 1) line += "; " + std::to_string(seen.count - 1) + " more like it";
      lines.push_back(std::move(line));
    }
    return lines;
  }

 private:
  struct Seen {
    std::string message;
    int line = 0;
    std::size_t count = 0;
  };

  std::vector<Polygon> mended(Area& area, std::vector<Flaw>& flaws) const try {
    return detail::admit(std::move(area.polygon), flaws, crossings_);
  } catch (const TooFine& error) {
    throw InputError(source_, area.line, error.what());
  }

  void note(const Flaw& flaw, int line) {
    if (flaw.is_ambiguous() && crossings_ == Crossings::refuse)
      throw AmbiguousRing(source_, line, flaw.message, meaning(flaw.kind));
    Seen& seen = seen_.try_emplace(flaw.kind, Seen{flaw.message, line, 0}).first->second;
    ++seen.count;
  }

  const std::string& source_;
  Crossings crossings_;
  std::map<Flaw::Kind, Seen> seen_;
};

}  // namespace

std::vector<std::string> mend_rings(WorldParts& parts, Crossings crossings) {
  Mending mending(parts.source, crossings);
  const int line = parts.areas.empty() ? 0 : parts.areas.front().line;
  const bool given = !parts.areas.empty();
  mending.mend(parts.areas);
  if (given && parts.areas.empty()) throw InputError(parts.source, line, "no polygon of the floor plan has an area");
  mending.mend(parts.solids);
  return mending.remarks();
}

std::vector<Area> even_odd_areas(const std::vector<Area>& areas, const std::string& source) {
  if (areas.empty()) return {};
  std::vector<Polygon> polygons;
  for (const Area& area : areas) {
    detail::CoordinateGate(source, area.line).admit(area.polygon);
    polygons.push_back(area.polygon);
  }
  const int line = areas.front().line;
  try {
    std::vector<Area> result;
    for (Polygon& polygon : detail::even_odd(polygons)) result.push_back({std::move(polygon), line});
    return result;
  } catch (const TooFine& error) {
    throw InputError(source, line, error.what());
  }
}

}  // namespace taut
