// All planners of shortest paths beside an exact arrangement that shares no code with them: small worlds full of coincidences, whole
// numbers and decimals, sloped walls, ends on walls, on their ends and on their crossings. TAUT_RANDOM_WORLDS says how many worlds.
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <taut/io/saved/planned_roadmap.h>
#include <taut/search/distance_matrix.h>
#include <taut/search/no_path.h>
#include <taut/search/polyanya.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

#include "support/exact_arrangement.h"
#include "support/small_world.h"

namespace taut {
namespace {

using test::RationalPoint;
using test::RationalWall;

int worlds(int usual) {
  const char* asked = std::getenv("TAUT_RANDOM_WORLDS");
  return asked ? std::atoi(asked) : usual;
}

/// Walls between points of a lattice of `side` steps, `unit` of them to 1: 1, 2, 10 or 100.
class Drawn {
 public:
  explicit Drawn(unsigned seed) : engine_(seed) {
    constexpr std::array kUnits{1, 1, 2, 10, 100};
    unit_ = kUnits[engine_() % kUnits.size()];
    side_ = between(3, 9);
    const bool is_straight = between(0, 3) == 0;
    for (int n = between(1, 7); n > 0; --n) {
      const Step a{between(0, side_), between(0, side_)};
      Step b{between(0, side_), between(0, side_)};
      if (is_straight) (between(0, 1) ? b.x : b.y) = between(0, 1) ? a.x : a.y;
      if (is_straight && a.x != b.x) b.y = a.y;
      if (a.x != b.x || a.y != b.y) walls_.push_back({a, b});
    }
    start = any_place();
    goal = any_place();
  }

  World world() const {
    test::SmallWorld small{.area = test::box_ring(0, 0, double(side_) / unit_, double(side_) / unit_)};
    for (const Wall& wall : walls_) small.walls.push_back({point(wall.a), point(wall.b)});
    return World(small.parts()).with_ends(start.point, goal.point);
  }

  std::optional<double> exact_length() const {
    const Rational side = Rational(side_) / unit_;
    std::vector<RationalWall> walls;
    for (const Wall& wall : walls_) walls.push_back({rational(wall.a), rational(wall.b)});
    return test::arrangement_path(side, side, walls, start.exact, goal.exact);
  }

  std::string text() const {
    const Point corner = point({side_, side_});
    std::string all = fmt::format("boundary 0 0 {} {}\nstart {} {}\ngoal {} {}", corner.x, corner.y, start.point.x,
                                  start.point.y, goal.point.x, goal.point.y);
    for (const Wall& wall : walls_)
      all += fmt::format("\n{} {} {} {}", point(wall.a).x, point(wall.a).y, point(wall.b).x, point(wall.b).y);
    return all;
  }

  struct Place {
    Point point;
    RationalPoint exact;
  };
  Place start, goal;

 private:
  struct Step {
    int x, y;
  };
  struct Wall {
    Step a, b;
  };

  int between(int a, int b) { return a + static_cast<int>(engine_() % static_cast<unsigned>(b - a + 1)); }
  Point point(Step p) const { return {double(p.x) / unit_, double(p.y) / unit_}; }
  RationalPoint rational(Step p) const { return {Rational(p.x) / unit_, Rational(p.y) / unit_}; }

  /// Where it can be written: in at most twelve decimals.
  std::optional<Place> written(const RationalPoint& p) const {
    const auto number = [](const Rational& v) -> std::optional<double> {
      const Rational scaled = v * Rational("1000000000000");
      if (denominator(scaled) != 1) return std::nullopt;
      return std::strtod((text_of(numerator(scaled)) + "e-12").c_str(), nullptr);
    };
    const auto x = number(p.x), y = number(p.y);
    if (!x || !y) return std::nullopt;
    return Place{{*x, *y}, p};
  }

  std::optional<Place> crossing() {
    const Wall& s = walls_[engine_() % walls_.size()];
    const Wall& t = walls_[engine_() % walls_.size()];
    const int dx = s.b.x - s.a.x, dy = s.b.y - s.a.y, ex = t.b.x - t.a.x, ey = t.b.y - t.a.y;
    const int area = dx * ey - dy * ex;
    if (area == 0) return std::nullopt;
    const Rational along = Rational((t.a.x - s.a.x) * ey - (t.a.y - s.a.y) * ex) / area;
    if (along < 0 || along > 1) return std::nullopt;
    return written({(s.a.x + along * dx) / unit_, (s.a.y + along * dy) / unit_});
  }

  Place any_place() {
    const int kind = between(0, 4);
    if (kind == 0 && !walls_.empty())
      if (const auto place = crossing()) return *place;
    if (kind == 1 && !walls_.empty()) {
      const Wall& wall = walls_[engine_() % walls_.size()];
      return *written({Rational(wall.a.x + wall.b.x) / (2 * unit_), Rational(wall.a.y + wall.b.y) / (2 * unit_)});
    }
    if (kind == 2)
      return *written({Rational(between(0, 8 * side_)) / (8 * unit_), Rational(between(0, 8 * side_)) / (8 * unit_)});
    return *written(rational({between(0, side_), between(0, side_)}));
  }

  std::mt19937 engine_;
  int unit_ = 1;
  int side_ = 3;
  std::vector<Wall> walls_;
};

using Answer = std::function<std::optional<Path>()>;

std::optional<Path> path_of(const GraphSearchResult& result) {
  return result.status == SearchStatus::found ? std::optional(result.path) : std::nullopt;
}

/// One world with all that can answer a query in it.
class Opinions {
 public:
  explicit Opinions(const Drawn& drawn)
      : space(drawn.world()),
        from(drawn.start.point),
        to(drawn.goal.point),
        polyanya_(space),
        graph_(std::make_shared<VisibilityGraph>(space)) {
    const Goal goal{to, {}};
    add("one query", [this] { return shortest_path(space, from, to); });
    add("one query, back", [this] { return back(shortest_path(space, to, from)); });
    add("batch", [this, goal] { return path_of(shortest_path(polyanya_, from, goal)); });
    add("batch, back", [this] { return back(path_of(shortest_path(polyanya_, to, Goal{from, {}}))); });
    add("landmarks", [this, goal] { return path_of(shortest_path(polyanya_.with_landmarks(), from, goal)); });
    add("bends", [this, goal] { return path_of(shortest_path(polyanya_.with_graph(), from, goal)); });
    add("bends and landmarks",
        [this, goal] { return path_of(shortest_path(polyanya_.with_graph().with_landmarks(), from, goal)); });
    add("each", [this] { return PolyanyaSearch(polyanya_).find_each(from, std::array{to}).front(); });
    add("tree", [this] { return ShortestPathTree(graph_, from).path_to(to); });
    for (const char* kind : {"visibility", "full", "visibility-brute"}) add_roadmap(kind, goal);
  }

  void add_roadmap(const std::string& name, const Goal& goal) {
    const RoadmapKind& kind = *roadmap_kind(name);
    const PlannedRoadmap planned = kind.build(space, {});
    add(name, [=, this] { return path_of(planned.search(from, goal, {})); });
    add(name + ", dijkstra", [=, this] { return path_of(planned.search(from, goal, {GraphAlgorithm::dijkstra})); });
    if (kind.keeping == RoadmapKind::Keeping::none) return;
    add(name + ", loaded", [=, this] {
      return path_of(load_roadmap(saved_text(kind, planned, space), "saved", space).planned.search(from, goal, {}));
    });
  }

  double in_matrix() const { return distance_matrix(space, std::array{from, to})[1]; }

  FreeSpace space;
  Point from, to;
  std::vector<std::pair<std::string, Answer>> answers;

 private:
  void add(std::string name, Answer answer) { answers.emplace_back(std::move(name), std::move(answer)); }

  static std::optional<Path> back(std::optional<Path> path) {
    if (path) std::reverse(path->points.begin(), path->points.end());
    return path;
  }

  Polyanya polyanya_;
  std::shared_ptr<const VisibilityGraph> graph_;
};

/// What is wrong with an answer; empty when nothing is.
std::string wrong(const Opinions& opinions, const std::optional<Path>& path, const std::optional<double>& exact) {
  if (path.has_value() != exact.has_value())
    return path ? fmt::format("a path of {}, there is none", path->length.value()) : "no path";
  if (!path) return "";
  const Verdict verdict = verify(*path, opinions.space, opinions.from, Goal{opinions.to, {}});
  if (!verdict.valid) return verdict.reason;
  return std::abs(path->length.value() - *exact) <= 1e-9 * (1 + *exact) ? ""
                                                                        : fmt::format("{} long", path->length.value());
}

TEST(AllPlanners, AgreeWithTheExactArrangement) {
  const int count = worlds(150);
  int none = 0;
  for (int k = 1; k <= count; ++k) {
    const Drawn drawn(static_cast<unsigned>(k));
    const Opinions opinions(drawn);
    const auto exact = drawn.exact_length();
    const std::string said =
        fmt::format("world {}, exactly {}\n{}\n", k, exact ? fmt::to_string(*exact) : "none", drawn.text());
    for (const auto& [name, answer] : opinions.answers)
      ASSERT_EQ(wrong(opinions, answer(), exact), "") << name << " in " << said;
    ASSERT_NEAR(opinions.in_matrix() < HUGE_VAL ? opinions.in_matrix() : -1, exact.value_or(-1),
                1e-9 * (1 + exact.value_or(1)))
        << said;
    none += !exact;
  }
  EXPECT_GT(none, count / 50);
  EXPECT_LT(none, count / 2);
  RecordProperty("worlds", count);
}

}  // namespace
}  // namespace taut
