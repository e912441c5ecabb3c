#include <taut/search/arc_search.h>

#include <algorithm>
#include <optional>
#include <utility>

#include <taut/geometry/expects.h>
#include <taut/search/detail/arc_a_star.h>
#include <taut/search/detail/arc_hierarchy_query.h>
#include <taut/search/detail/arc_walk.h>
#include <taut/search/detail/radius_walk.h>

namespace taut {

namespace {

using detail::ArcEnds;
using detail::ArcExit;

constexpr std::size_t kUnprepared = 24;  // queries

std::optional<ArcSearchResult> blocked(const TangentWalls& walls, double r, Point p, DiscStatus status) {
  if (walls.space().locate(p).kind == Location::Kind::outside) return ArcSearchResult{status, {}, kNone, 0};
  const std::uint32_t wall = walls.too_near(p, r);
  if (wall == kNone) return std::nullopt;
  return ArcSearchResult{status, {}, wall, 0};
}

/// What takes no search.
std::optional<ArcSearchResult> answered(const TangentWalls& walls, double r, Point s, Point g) {
  if (auto at_start = blocked(walls, r, s, DiscStatus::start_blocked)) return at_start;
  if (auto at_goal = blocked(walls, r, g, DiscStatus::goal_blocked)) return at_goal;
  if (s == g) return ArcSearchResult{DiscStatus::found, {r, s, g, {}, {}}, kNone, 0};
  return std::nullopt;
}

}  // namespace

struct ArcQueries::Impl {
  explicit Impl(TangentGraph of) : tangents(std::move(of)), walk_(tangents.parts()), search_(walk_) {}

  ArcSearchResult find(Point s, Point g) {
    const TangentParts& graph = tangents.parts();
    if (auto known = answered(graph.walls(), graph.r, s, g)) return *known;
    if (!prepared_ && ++queries_ > kUnprepared) prepare();
    const ArcEnds ends = walk_.join(s, g);
    return prepared_ ? prepared_search(s, g, ends) : search_.find(s, g, ends);
  }

  void prepare() {
    if (!prepared_) prepared_ = std::make_unique<Prepared>(detail::turnable(walk_));
  }

 private:
  struct Prepared {
    explicit Prepared(const detail::TurnableGraph& of) : hierarchy(of), query(hierarchy) {}

    detail::ArcHierarchy hierarchy;
    detail::ArcHierarchyQuery query;
  };

  /// Lengths are sums of doubles here: off by less than the enclosures of their pieces are wide.
  ArcSearchResult prepared_search(Point s, Point g, const ArcEnds& ends) {
    const auto doors = [](const std::vector<ArcExit>& all) {
      std::vector<detail::ArcDoor> result;
      result.reserve(all.size());
      for (const ArcExit& door : all) result.push_back({door.node, door.length.middle()});
      return result;
    };
    const detail::ArcHierarchyQuery::Way way = prepared_->query.find(doors(ends.entries), doors(ends.exits));
    const auto apart = std::min_element(
        ends.apart.begin(), ends.apart.end(),
        [](const ArcEnds::Apart& a, const ArcEnds::Apart& b) { return a.length.middle() < b.length.middle(); });
    ArcSearchResult result;
    result.expanded = way.settled;
    if (apart != ends.apart.end() && apart->length.middle() <= way.length)
      result.path = path_apart(walk_, ends, s, g, *apart);
    else if (!way.nodes.empty())
      result.path = path_along(walk_, ends, s, g, ends.entries[way.entry], way.nodes, ends.exits[way.exit]);
    else
      return result;
    result.status = DiscStatus::found;
    return result;
  }

 public:
  TangentGraph tangents;

 private:
  detail::ArcWalk walk_;
  detail::ArcAStar<detail::ArcWalk> search_;
  std::unique_ptr<Prepared> prepared_;
  std::size_t queries_ = 0;
};

ArcQueries::ArcQueries(TangentGraph graph) : impl_(std::make_unique<Impl>(std::move(graph))) {}
ArcQueries::~ArcQueries() = default;
ArcQueries::ArcQueries(ArcQueries&&) noexcept = default;
ArcQueries& ArcQueries::operator=(ArcQueries&&) noexcept = default;

const TangentGraph& ArcQueries::graph() const { return impl_->tangents; }
ArcSearchResult ArcQueries::find(Point s, Point g) { return impl_->find(s, g); }
void ArcQueries::prepare() { impl_->prepare(); }

ArcSearchResult arc_search(const TangentGraph& graph, Point s, Point g) { return ArcQueries(graph).find(s, g); }

ArcSearchResult arc_search(const AllRadii& all, double r, Point s, Point g) {
  TAUT_EXPECTS(r > 0 && r <= World::kLargest);
  const AllRadiiParts& parts = all.parts();
  if (!parts.covers(r)) return arc_search(all.at_radius(r), s, g);
  if (auto known = answered(parts.ground->walls, r, s, g)) return *known;
  detail::RadiusWalk walk(parts, r);
  const ArcEnds ends = walk.join(s, g);
  return detail::ArcAStar<detail::RadiusWalk>(walk).find(s, g, ends);
}

}  // namespace taut
