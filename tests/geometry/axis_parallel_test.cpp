// Axis-parallel worlds by sorting and one sweep, against the roads that every world can take.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include <taut/geometry/detail/axis_sweep.h>
#include <taut/geometry/detail/noding.h>
#include <taut/geometry/detail/rank_set.h>
#include <taut/geometry/detail/triangulate.h>
#include <taut/geometry/predicates.h>
#include <taut/geometry/written.h>

namespace taut {
namespace {

using detail::Edge;
using detail::Mesh;
using detail::Noded;

/// Walls, blocks, blocks in blocks, walls on one another and walls without length, on few lines, so that they meet in
/// all ways; in units of halves, tenths and thousands.
class Mess {
 public:
  explicit Mess(unsigned seed) : random_(seed) {
    side_ = any(1, 12);
    const int kind = any(0, 4);
    unit_ = std::array{1.0, 0.5, 0.1, 1000.0, 0.01}[static_cast<std::size_t>(kind)];
    offset_ = std::array{0, 0, 3, -7, 12345}[static_cast<std::size_t>(any(0, 4))];
    const int walls = any(0, 16), blocks = any(0, 5);
    for (int i = 0; i < walls; ++i) add_wall(static_cast<std::uint32_t>(i));
    for (int i = 0; i < blocks; ++i) add_block(any(0, 3) == 0 ? -1 : 1);
  }

  const std::vector<Edge>& edges() const { return edges_; }

 private:
  int any(int least, int most) { return least + static_cast<int>(random_() % static_cast<unsigned>(most - least + 1)); }
  Point place(int x, int y) const { return {written::times(x + offset_, unit_), written::times(y - offset_, unit_)}; }
  void add_wall(std::uint32_t number) {
    const int x = any(0, side_), y = any(0, side_), to = any(0, side_);
    edges_.push_back({place(x, y), any(0, 1) ? place(to, y) : place(x, to), 0, number});
  }
  void add_block(int turn) {
    const int x = any(0, side_), y = any(0, side_), u = any(0, side_), v = any(0, side_);
    const auto [x0, x1] = std::minmax(x, u);
    const auto [y0, y1] = std::minmax(y, v);
    const Point ring[] = {place(x0, y0), place(x1, y0), place(x1, y1), place(x0, y1)};
    for (std::size_t i = 0; i < 4; ++i) edges_.push_back({ring[i], ring[(i + 1) % 4], turn, kNone});
  }

  std::mt19937 random_;
  int side_ = 1, offset_ = 0;
  double unit_ = 1;
  std::vector<Edge> edges_;
};

const DecimalUnit kUnit(Box{{-1e7, -1e7}, {1e7, 1e7}});
constexpr unsigned kMesses = 4000;

bool equal(const std::vector<Edge>& a, const std::vector<Edge>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Edge& e, const Edge& f) {
    return e.a == f.a && e.b == f.b && e.turn == f.turn && e.wall == f.wall;
  });
}

double doubled_area(const Triangulation& tri) {
  double sum = 0;
  for (const auto& [a, b, c] : tri.triangles) sum += ring_area({tri.points[a], tri.points[b], tri.points[c]});
  return sum;
}

/// Each triangle turns left, neighbours know each other along the same side, and sides are constrained where the edges
/// are.
void expect_sound(const Mesh& mesh, const std::vector<Edge>& edges) {
  const Triangulation& tri = mesh.triangulation;
  std::set<std::pair<Point, Point>> along;
  for (std::uint32_t t = 0; t < tri.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const Point a = tri.points[tri.triangles[t][Triangulation::ccw(i)]],
                  b = tri.points[tri.triangles[t][Triangulation::cw(i)]];
      EXPECT_GT(written::orientation(tri.points[tri.triangles[t][i]], a, b), 0);
      const std::uint32_t n = tri.neighbours[t][i], edge = mesh.edge_of[3 * t + static_cast<std::uint32_t>(i)];
      EXPECT_EQ(tri.is_constrained(t, i), edge != kNone);
      if (edge != kNone) {
        EXPECT_EQ(std::minmax(a, b), std::minmax(edges[edge].a, edges[edge].b));
        along.insert(std::minmax(a, b));
      }
      if (n == kNone) continue;
      const int j = tri.mirror(t, i);
      EXPECT_EQ(tri.neighbours[n][j], t);
      EXPECT_EQ(tri.points[tri.triangles[n][Triangulation::ccw(j)]], b);
      EXPECT_EQ(tri.points[tri.triangles[n][Triangulation::cw(j)]], a);
      if (edge == kNone) {
        const auto& v = tri.triangles[t];
        EXPECT_LE(written::side_of_circle(tri.points[v[0]], tri.points[v[1]], tri.points[v[2]],
                                          tri.points[tri.triangles[n][j]]),
                  0);
      }
    }
  EXPECT_EQ(along.size(), edges.size());
}

TEST(AxisParallelNoding, SplitsAsTheGeneralOneDoes) {
  for (unsigned seed = 0; seed < kMesses; ++seed) {
    const std::vector<Edge> edges = Mess(seed).edges();
    const Noded quick = detail::node(edges, kUnit), general = detail::node_general(edges, kUnit);
    ASSERT_TRUE(equal(quick.edges, general.edges)) << "seed " << seed;
    ASSERT_EQ(quick.displacement, 0);
  }
}

TEST(AxisParallelNoding, CountsAPlaceWhereWallsCrossOnce) {
  const std::vector<Edge> edges{{{0, 2}, {9, 2}, 0, 0}, {{1, 0}, {1, 9}, 0, 1}, {{3, 0}, {3, 2}, 0, 2}};
  const Noded noded = detail::node(edges, kUnit);
  EXPECT_EQ(noded.crossings, 1U);  // the other is an end
  EXPECT_EQ(noded.edges.size(), 6U);
}

TEST(AxisParallelTriangulation, IsAsSoundAsTheGeneralOneAndAsLarge) {
  int with_area = 0;
  for (unsigned seed = 0; seed < kMesses; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<Edge> edges = detail::node(Mess(seed).edges(), kUnit).edges;
    if (edges.empty()) continue;
    const std::optional<Mesh> quick = detail::triangulate_axis_parallel(edges);
    ASSERT_TRUE(quick);
    const Mesh general = detail::triangulate_general(edges);
    ASSERT_EQ(quick->triangulation.triangles.size(), general.triangulation.triangles.size());
    if (general.triangulation.triangles.empty()) continue;
    ++with_area;
    const double area = doubled_area(general.triangulation);
    ASSERT_NEAR(doubled_area(quick->triangulation), area, 1e-9 * area);
    expect_sound(*quick, edges);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(with_area, static_cast<int>(kMesses) / 2);
}

TEST(AxisParallelTriangulation, FindsTheSameWindingNumbers) {
  for (unsigned seed = 0; seed < kMesses; ++seed) {
    const std::vector<Edge> edges = detail::node(Mess(seed).edges(), kUnit).edges;
    if (edges.empty()) continue;
    const Mesh general = detail::triangulate_general(edges);
    const auto by_winding = [&](const Mesh& mesh) {
      std::map<int, double> areas;
      const std::vector<int> winding = detail::winding_numbers(mesh, edges, 0);
      for (std::size_t t = 0; t < winding.size(); ++t) {
        const auto& [a, b, c] = mesh.triangulation.triangles[t];
        const auto& p = mesh.triangulation.points;
        areas[winding[t]] += std::round(ring_area({p[a], p[b], p[c]}) * 1e4);
      }
      return areas;
    };
    ASSERT_EQ(by_winding(*detail::triangulate_axis_parallel(edges)), by_winding(general)) << "seed " << seed;
  }
}

TEST(AxisParallelTriangulation, LeavesSlopesAndWhatIsOnNoLatticeToTheGeneralOne) {
  EXPECT_FALSE(detail::triangulate_axis_parallel(std::vector<Edge>{{{0, 0}, {2, 1}, 0, 0}}));
  const double root = std::sqrt(2.0);
  EXPECT_FALSE(detail::triangulate_axis_parallel(std::vector<Edge>{{{0, 0}, {root, 0}, 0, 0}}));
  EXPECT_FALSE(detail::triangulate_axis_parallel({}));
}

TEST(AxisParallelTriangulation, TurnsNoMoreSidesThanAllowed) {
  const std::vector<detail::LatticePoint> points{{0, 0}, {30, 0}, {2, 1}, {2, 2}, {28, 3}, {28, 4}};
  std::vector<detail::AxisStar> stars(points.size());
  stars[0].east = stars[1].west = 0;
  stars[2].north = stars[3].south = 1;
  stars[4].north = stars[5].south = 2;
  std::vector<detail::RawTriangle> mesh = detail::sweep(points, stars, 3);
  EXPECT_FALSE(detail::make_delaunay(mesh, points, 0));
  EXPECT_TRUE(detail::make_delaunay(mesh, points, 100));
}

TEST(RankSet, KnowsTheOneBeforeAndAllBetween) {
  std::mt19937 random(1);
  const auto any = [&](std::uint32_t least, std::uint32_t most) {
    return least + static_cast<std::uint32_t>(random() % (most - least + 1));
  };
  detail::RankSet set(10000);
  std::set<std::uint32_t> all{0};
  set.insert(0);
  for (int step = 0; step < 20000; ++step) {
    const std::uint32_t i = any(1, 9999), from = any(0, 9999), to = any(from, 9999);
    random() % 3 == 0 ? (set.erase(i), all.erase(i)) : (set.insert(i), all.insert(i).second);
    const std::uint32_t at = any(1, 9999);
    ASSERT_EQ(set.before(at), *std::prev(all.lower_bound(at)));
    std::vector<std::uint32_t> between;
    set.each(from, to, [&](std::uint32_t k) { between.push_back(k); });
    ASSERT_TRUE(std::equal(between.begin(), between.end(), all.lower_bound(from), all.upper_bound(to)));
  }
}

}  // namespace
}  // namespace taut
