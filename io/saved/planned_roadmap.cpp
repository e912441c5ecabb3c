#include <taut/io/saved/planned_roadmap.h>

#include <memory>
#include <utility>

#include <taut/geometry/errors.h>
#include <taut/io/saved/roadmap_file.h>
#include <taut/roadmaps/verify_roadmap.h>

namespace taut {

namespace {

void refuse(const std::string& name, const SavedRoadmap& saved, const std::optional<RoadmapFault>& fault) {
  if (fault) throw InputError(name, saved.line_of(fault->vertex, fault->is_row), fault->text);
}

}  // namespace

std::string saved_text(const RoadmapKind& kind, const PlannedRoadmap& planned, const FreeSpace& space) {
  return roadmap_file({kind.name, planned.how, {}, *planned.roadmap}, space);
}

LoadedRoadmap load_roadmap(std::string_view bytes, const std::string& name, const FreeSpace& space) {
  SavedRoadmap saved = read_roadmap_file(bytes, name, space);
  LoadedRoadmap loaded{roadmap_kind(saved.kind), {}};
  if (!loaded.kind || loaded.kind->keeping == RoadmapKind::Keeping::none)
    throw InputError(name, 0,
                     "is a saved roadmap of the kind '" + saved.kind + "', which cannot be loaded; known are " +
                         roadmap_kind_names());
  if (loaded.kind->keeping == RoadmapKind::Keeping::rebuilt) {
    loaded.planned = loaded.kind->build(space, {});
    refuse(name, saved, difference(saved.roadmap, *loaded.planned.roadmap));
  } else {
    refuse(name, saved, verify_roadmap(saved.roadmap, space));
    loaded.planned = planned_prm(space, std::make_shared<const Roadmap>(std::move(saved.roadmap)));
  }
  loaded.planned.how = std::move(saved.how);
  return loaded;
}

}  // namespace taut
