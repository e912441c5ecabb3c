#include <taut/roadmaps/detail/navmesh_blocks.h>

#include <algorithm>

namespace taut::detail {

namespace {

class Blocks {
 public:
  explicit Blocks(Navmesh& mesh) : mesh_(mesh), order_(mesh.polygon_count(), kNone), low_(mesh.polygon_count()) {
    mesh.blocks.above.assign(mesh.polygon_count(), kNone);
    mesh.blocks.depth.assign(mesh.polygon_count(), 0);
    mesh.blocks.top.clear();
    mesh.blocks.bridge.clear();
  }

  void run() {
    for (std::uint32_t p = 0; p < mesh_.polygon_count(); ++p)
      if (order_[p] == kNone) search(p);
    // Polygons in the order they were found: the top of a block is older than the others in it.
    for (const std::uint32_t p : found_)
      if (const std::uint32_t b = mesh_.blocks.above[p]; b != kNone)
        mesh_.blocks.depth[p] = mesh_.blocks.depth[mesh_.blocks.top[b]] + 1;
  }

 private:
  struct Visit {
    std::uint32_t polygon;
    std::uint32_t came_by;  // the corner in this polygon, kNone at the root
    std::uint32_t corner;   // the next to look across
  };

  void enter(std::uint32_t polygon, std::uint32_t came_by) {
    order_[polygon] = low_[polygon] = static_cast<std::uint32_t>(found_.size());
    found_.push_back(polygon);
    visits_.push_back({polygon, came_by, mesh_.first[polygon]});
  }

  void search(std::uint32_t root) {
    enter(root, kNone);
    while (!visits_.empty()) {
      Visit& now = visits_.back();
      if (now.corner == mesh_.first[now.polygon + 1]) {
        leave();
        continue;
      }
      const std::uint32_t c = now.corner++, across = mesh_.corners[c].across;
      if (across == kNone || c == now.came_by) continue;
      const std::uint32_t from = now.polygon, to = mesh_.corners[across].polygon;
      if (order_[to] == kNone) {
        portals_.push_back(c);
        enter(to, across);
      } else if (order_[to] < order_[from]) {
        portals_.push_back(c);
        low_[from] = std::min(low_[from], order_[to]);
      }
    }
  }

  void leave() {
    const Visit done = visits_.back();
    visits_.pop_back();
    if (visits_.empty()) return;
    const std::uint32_t parent = visits_.back().polygon;
    low_[parent] = std::min(low_[parent], low_[done.polygon]);
    if (low_[done.polygon] >= order_[parent]) close_block(parent, mesh_.corners[done.came_by].across);
  }

  /// All portals found since `last` make up a block.
  void close_block(std::uint32_t top, std::uint32_t last) {
    const std::uint32_t block = static_cast<std::uint32_t>(mesh_.blocks.top.size());
    mesh_.blocks.top.push_back(top);
    mesh_.blocks.bridge.push_back(portals_.back() == last ? last : kNone);
    for (std::uint32_t c = kNone; c != last;) {
      c = portals_.back();
      portals_.pop_back();
      const std::uint32_t across = mesh_.corners[c].across;
      mesh_.corners[c].block = mesh_.corners[across].block = block;
      // A tree portal leads to a polygon whose way up is this block; a back portal to one that is older.
      const std::uint32_t from = mesh_.corners[c].polygon, to = mesh_.corners[across].polygon;
      if (order_[to] > order_[from]) mesh_.blocks.above[to] = block;
    }
  }

  Navmesh& mesh_;
  std::vector<std::uint32_t> order_, low_, found_, portals_;
  std::vector<Visit> visits_;
};

}  // namespace

void find_blocks(Navmesh& mesh) { Blocks(mesh).run(); }

}  // namespace taut::detail
