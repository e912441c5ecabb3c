#include <taut/roadmaps/visibility_rows.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>

#include <taut/geometry/parallel.h>
#include <taut/roadmaps/detail/sight.h>

namespace taut {

namespace {

using Vertex = Roadmap::Vertex;
using detail::DoubleSight;
using detail::LatticeSight;
using detail::SightRow;
using detail::SightStep;

template <class Sight>
using Steps = std::vector<SightStep<typename Sight::Place>>;

}  // namespace

VisibilityVertices::VisibilityVertices(const Triangulation& tri, VisibilityKind kind)
    : vertex_of_sector(tri.sectors.size(), kNone) {
  for (std::uint32_t s = 0; s < tri.sectors.size(); ++s) {
    if (tri.sectors[s].full || (kind == VisibilityKind::reduced && !tri.sectors[s].reflex)) continue;
    vertex_of_sector[s] = static_cast<Vertex>(sectors.size());
    sectors.push_back(s);
  }
}

std::vector<Point> VisibilityVertices::points(const Triangulation& tri) const {
  std::vector<Point> points;
  points.reserve(sectors.size());
  for (const std::uint32_t s : sectors) points.push_back(tri.points[tri.sectors[s].vertex]);
  return points;
}

struct VisibilityRows::Impl {
  Impl(FreeSpace of, VisibilityKind as) : space(std::move(of)), kind(as), vertices(space.triangulation(), kind) {
    const Triangulation& tri = space.triangulation();
    if (tri.lattice.empty())
      steps = detail::sight_steps(tri, DoubleSight(tri), vertices.vertex_of_sector);
    else
      steps = detail::sight_steps(tri, LatticeSight(tri), vertices.vertex_of_sector);
  }

  FreeSpace space;
  VisibilityKind kind;
  VisibilityVertices vertices;
  std::variant<Steps<LatticeSight>, Steps<DoubleSight>> steps;
};

VisibilityRows::VisibilityRows(const FreeSpace& space, VisibilityKind kind)
    : impl_(std::make_shared<const Impl>(space, kind)) {}

const FreeSpace& VisibilityRows::space() const { return impl_->space; }

const VisibilityVertices& VisibilityRows::vertices() const { return impl_->vertices; }

struct VisibilityRows::Finder::Impl {
  using Row = std::variant<SightRow<LatticeSight, false>, SightRow<LatticeSight, true>, SightRow<DoubleSight, false>,
                           SightRow<DoubleSight, true>>;

  explicit Impl(std::shared_ptr<const VisibilityRows::Impl> of) : rows(std::move(of)), row(row_of(*rows)) {}

  static Row row_of(const VisibilityRows::Impl& rows) {
    if (const auto* steps = std::get_if<Steps<LatticeSight>>(&rows.steps)) return row_of<LatticeSight>(rows, *steps);
    return row_of<DoubleSight>(rows, std::get<Steps<DoubleSight>>(rows.steps));
  }

  template <class Sight>
  static Row row_of(const VisibilityRows::Impl& rows, const Steps<Sight>& steps) {
    const Triangulation& tri = rows.space.triangulation();
    if (rows.kind == VisibilityKind::full) return SightRow<Sight, false>(tri, Sight(tri), steps, rows.vertices.sectors);
    return SightRow<Sight, true>(tri, Sight(tri), steps, rows.vertices.sectors);
  }

  std::shared_ptr<const VisibilityRows::Impl> rows;
  Row row;
};

VisibilityRows::Finder::Finder(const VisibilityRows& rows) : impl_(std::make_unique<Impl>(rows.impl_)) {}
VisibilityRows::Finder::Finder(Finder&&) noexcept = default;
VisibilityRows::Finder::~Finder() = default;

std::span<const Vertex> VisibilityRows::Finder::row(Vertex v) {
  return std::visit([v](auto& row) -> std::span<const Vertex> { return row.find(v); }, impl_->row);
}

namespace {

/// The edges as they are found, by left end: one list for each block of vertices, all in one for one thread.
struct FoundEdges {
  FoundEdges(const VisibilityRows& rows, unsigned jobs, const TellProgress& tell)
      : lengths(rows.vertices().sectors.size()), block(block_length(lengths.size(), jobs, 32)) {
    others.resize((lengths.size() + block - 1) / block);
    ProgressCount done("corners", lengths.size(), tell);
    each_in_parallel(others.size(), {jobs}, [&] {
      auto finder = std::make_shared<VisibilityRows::Finder>(rows);
      return [this, finder, &done](std::size_t i) { find(*finder, i, done); };
    });
  }

  void find(VisibilityRows::Finder& finder, std::size_t i, ProgressCount& done) {
    const std::size_t last = std::min(lengths.size(), (i + 1) * block);
    for (std::size_t v = i * block; v < last; ++v) {
      const auto row = finder.row(static_cast<Vertex>(v));
      lengths[v] = static_cast<std::uint32_t>(row.size());
      others[i].insert(others[i].end(), row.begin(), row.end());
      done.add();
    }
  }

  template <class Visit>
  void each(Visit visit) const {
    for (std::size_t i = 0; i < others.size(); ++i) {
      auto other = others[i].begin();
      for (auto v = static_cast<Vertex>(i * block); v < std::min(lengths.size(), (i + 1) * block); ++v)
        for (std::uint32_t k = 0; k < lengths[v]; ++k, ++other) visit(std::min(v, *other), std::max(v, *other));
    }
  }

  std::vector<std::uint32_t> lengths;
  std::size_t block;
  std::vector<std::vector<Vertex>> others;
};

/// Compressed rows while they are filled.
struct Rows {
  explicit Rows(std::vector<std::uint64_t> lengths) : starts(std::move(lengths)) {
    std::uint64_t sum = 0;
    for (std::uint64_t& start : starts) sum += std::exchange(start, sum);
    starts.push_back(sum);
    next.assign(starts.begin(), starts.end() - 1);
    targets.resize(sum);
  }
  void add(Vertex row, Vertex target) { targets[next[row]++] = target; }

  std::vector<std::uint64_t> starts, next;
  std::vector<Vertex> targets;
};

/// Each vertex with its neighbours above it, in no order.
Rows neighbours_above(const FoundEdges& found, std::vector<std::uint64_t>& degrees) {
  std::vector<std::uint64_t> lengths(found.lengths.size());
  found.each([&](Vertex low, Vertex high) { ++lengths[low], ++degrees[low], ++degrees[high]; });
  Rows above(std::move(lengths));
  found.each([&](Vertex low, Vertex high) { above.add(low, high); });
  return above;
}

}  // namespace

Roadmap roadmap_of(const VisibilityRows& rows, unsigned jobs, const TellProgress& tell) {
  std::vector<std::uint64_t> degrees(rows.vertices().sectors.size());
  const Rows above = neighbours_above(FoundEdges(rows, jobs, tell), degrees);
  // Vertices that put themselves into their neighbours' rows in order leave ascending rows behind: first those below
  // each vertex, and then, out of these, those above it.
  Rows all(std::move(degrees));
  const auto n = static_cast<Vertex>(all.next.size());
  for (Vertex v = 0; v < n; ++v)
    for (auto i = above.starts[v]; i < above.starts[v + 1]; ++i) all.add(above.targets[i], v);
  const std::vector<std::uint64_t> below_end = all.next;
  for (Vertex v = 0; v < n; ++v)
    for (auto i = all.starts[v]; i < below_end[v]; ++i) all.add(all.targets[i], v);
  return Roadmap(rows.vertices().points(rows.space().triangulation()), std::move(all.starts), std::move(all.targets));
}

}  // namespace taut
