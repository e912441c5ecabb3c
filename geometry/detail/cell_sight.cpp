#include <taut/geometry/detail/cell_sight.h>

#include <taut/geometry/contact.h>

namespace taut::detail {

bool sees_among_cells(const CellPlan& plan, Point p, Point q, std::optional<Point> towards) {
  const CellPlan::Around at_p = plan.around(p);
  if (at_p.free == 0 || plan.around(q).free == 0) return false;
  if (p == q) return !towards || at_p.towards(p, *towards) != 0;
  std::vector<Constraint> pieces;
  plan.append_along({p, q}, pieces);
  std::vector<std::uint32_t> touching;
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    const Contact kind = contact({p, q}, pieces[i]);
    if (kind == Contact::cross) return false;
    if (kind == Contact::touch) touching.push_back(i);
  }
  const Star star = star_at(p, pieces, touching);
  Sectors sectors = star.free_sectors();
  if (towards && *towards != p)
    std::erase_if(sectors, [&](std::uint32_t s) { return star.leave({s}, *towards) == kNoSide; });
  return !pass({p, q}, sectors, pieces, touching).blocked;
}

}  // namespace taut::detail
