#include <taut/search/passage_index.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/expects.h>
#include <taut/geometry/segment_distance.h>
#include <taut/geometry/written.h>
#include <taut/roadmaps/exact/exact_gates.h>
#include <taut/search/detail/bottleneck.h>
#include <taut/search/detail/disc_ends.h>
#include <taut/search/detail/face_finder.h>

namespace taut {

namespace {

using detail::Bottleneck;

/// Every piece of a gate joins the faces beside it; the widest first.
Bottleneck bottleneck_of(const detail::PassageFaces& faces) {
  std::vector<Bottleneck::Edge> edges;
  const auto& pieces = faces.pieces();
  for (auto i = static_cast<std::uint32_t>(pieces.size()); i-- > 0;) {
    const std::uint32_t half_edge = 2 * (faces.first_gate_edge() + i);
    edges.push_back({faces.face(half_edge), faces.face(half_edge + 1), pieces[i].gate + 1});
  }
  return {faces.face_count(), edges};
}

bool all_plain(const std::vector<Point>& points) {
  return std::all_of(points.begin(), points.end(),
                     [](Point p) { return written::is_plain(p.x) && written::is_plain(p.y); });
}

/// Do r and the next double mean what they are? Else the largest double may be a neighbour.
bool both_plain(double r) { return written::is_plain(r) && written::is_plain(std::nextafter(r, HUGE_VAL)); }

/// The largest discs through each gate; many gates are alike.
std::vector<double> radii_of(const std::vector<Rational>& squares) {
  std::vector<double> radii;
  radii.reserve(squares.size());
  for (std::size_t i = 0; i < squares.size(); ++i)
    radii.push_back(i > 0 && squares[i] == squares[i - 1] ? radii.back() : detail::root_below(squares[i] / 4));
  return radii;
}

}  // namespace

struct PassageIndex::Impl {
  explicit Impl(Gates all)
      : gates(std::move(all)),
        finder(gates),
        tree(bottleneck_of(finder.faces())),
        radii(radii_of(gates.exact().squared)),
        plain(all_plain(gates.space().triangulation().points)) {}

  Gates gates;
  detail::FaceFinder finder;
  Bottleneck tree;
  std::vector<double> radii;  // of gates
  bool plain;                 // all vertices mean the doubles they are

  Segment wall(std::uint32_t c) const { return gates.exact().walls.segment(c); }
  Rational squared(const PassagePlace& p) const {
    return detail::squared_distance(p.point, wall(finder.nearest_wall(p)));
  }

  /// The sign of the distance at p less r.
  int compare(const PassagePlace& p, double r) const {
    const Interval wanted = written::enclosure(r);
    if (p.on_wall) return -1;
    if (p.constraint == kNone || p.distance.lo >= wanted.hi) return p.distance.lo > wanted.hi ? 1 : 0;
    if (p.distance.hi < wanted.lo) return -1;
    return cmp(squared(p), meaning(r) * meaning(r));
  }

  /// Is gate i narrower than 2 r?
  bool is_narrower(std::uint32_t i, double r) const {
    // Its radius is the largest double that passes, and doubles mean numbers in their own order.
    return radii[i] < r;
  }

  /// The sign of the distances' difference.
  int compare(const PassagePlace& p, const PassagePlace& q) const {
    if (const auto told = taut::compare(p.distance, q.distance)) return *told;
    return cmp(squared(p), squared(q));
  }

  /// Is gate i narrower than the largest disc at p?
  bool is_narrower(std::uint32_t i, const PassagePlace& p) const {
    const double r = radii[i];
    if (std::nextafter(r, HUGE_VAL) * (1 + 0x1p-50) < p.distance.lo) return true;
    if (r * (1 - 0x1p-50) > p.distance.hi) return false;
    return gates.exact().squared[i] < 4 * squared(p);
  }

  double radius_at(const PassagePlace& p) const {
    if (p.on_wall) return 0;
    if (p.constraint == kNone) return HUGE_VAL;
    const std::uint32_t c = finder.nearest_wall(p);
    if (plain && written::is_plain(p.point.x) && written::is_plain(p.point.y))
      if (const auto quick = detail::quick_distance_below(p.point, wall(c)); quick && both_plain(*quick)) return *quick;
    return detail::root_below(detail::squared_distance(p.point, wall(c)));
  }
};

PassageIndex::PassageIndex(Gates gates) : impl_(std::make_shared<const Impl>(std::move(gates))) {}

const Gates& PassageIndex::gates() const { return impl_->gates; }
PassagePlace PassageIndex::place(Point p) const { return impl_->finder.find(p); }
double PassageIndex::gate_radius(std::uint32_t i) const { return impl_->radii[i]; }
double PassageIndex::radius_at(const PassagePlace& p) const { return impl_->radius_at(p); }

DiscStatus PassageIndex::passes(const PassagePlace& s, const PassagePlace& g, double r) const {
  if (s.outside || impl_->compare(s, r) < 0) return DiscStatus::start_blocked;
  if (g.outside || impl_->compare(g, r) < 0) return DiscStatus::goal_blocked;
  if (s.component != g.component) return DiscStatus::none;
  const std::uint32_t gate = bottleneck(s, g);
  return gate != kNone && impl_->is_narrower(gate, r) ? DiscStatus::none : DiscStatus::found;
}

std::uint32_t PassageIndex::bottleneck(const PassagePlace& s, const PassagePlace& g) const {
  if (s.component != g.component || s.face == kNone || g.face == kNone) return kNone;
  const std::uint32_t rank = impl_->tree.between(s.face, g.face);
  return rank == kNone || rank == 0 ? kNone : rank - 1;
}

std::optional<WidestPassage> PassageIndex::widest(const PassagePlace& s, const PassagePlace& g) const {
  using Limit = WidestPassage::Limit;
  if (s.outside || g.outside) return std::nullopt;
  if (s.on_wall || g.on_wall) {
    if (!detail::share_component(gates().space(), s.point, g.point)) return std::nullopt;
    const PassagePlace& on = s.on_wall ? s : g;
    return WidestPassage{s.on_wall ? Limit::start : Limit::goal, 0, kNone, impl_->finder.nearest_wall(on), {}};
  }
  if (s.component != g.component) return std::nullopt;
  if (s.constraint == kNone) return WidestPassage{Limit::none, HUGE_VAL, kNone, kNone, {}};
  const bool goal = impl_->compare(g, s) < 0;
  const PassagePlace& least = goal ? g : s;
  const std::uint32_t gate = bottleneck(s, g);
  if (gate != kNone && impl_->is_narrower(gate, least))
    return WidestPassage{Limit::gate, impl_->radii[gate], gate, kNone, {}};
  return WidestPassage{
      goal ? Limit::goal : Limit::start, impl_->radius_at(least), kNone, impl_->finder.nearest_wall(least), {}};
}

Ring PassageIndex::outline(std::uint32_t face) const {
  const detail::PassageFaces& faces = impl_->finder.faces();
  const std::uint32_t first = faces.walk(face);
  Ring ring{faces.from(first)};
  for (std::uint32_t at = faces.next(first); at != first; at = faces.next(at)) ring.push_back(faces.from(at));
  return ring;
}

std::vector<PassageIndex::Reach> PassageIndex::reach(const PassagePlace& p) const {
  std::vector<Reach> reached;
  if (p.face == kNone) return reached;
  for (std::uint32_t face = 0; face < impl_->finder.faces().face_count(); ++face) {
    const std::uint32_t rank = impl_->tree.between(p.face, face);
    if (rank != 0) reached.push_back({face, rank == kNone ? kNone : rank - 1});
  }
  return reached;
}

std::vector<std::array<std::uint32_t, 2>> PassageIndex::sides(std::uint32_t gate) const {
  const detail::PassageFaces& faces = impl_->finder.faces();
  const auto& pieces = faces.pieces();
  std::vector<std::array<std::uint32_t, 2>> result;
  auto at = std::partition_point(pieces.begin(), pieces.end(), [&](const auto& piece) { return piece.gate < gate; });
  for (; at != pieces.end() && at->gate == gate; ++at) {
    const std::uint32_t half_edge = 2 * (faces.first_gate_edge() + static_cast<std::uint32_t>(at - pieces.begin()));
    result.push_back({faces.face(half_edge), faces.face(half_edge + 1)});
  }
  return result;
}

}  // namespace taut
