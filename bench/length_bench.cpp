// What an exact comparison of lengths costs, by the number of legs on each side and by how hard it is.
// The peer is the plain comparison of two sums of std::hypot, which is wrong on the lines marked near and tie.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

#include <taut/geometry/length.h>

namespace {

using taut::Point;
using taut::Segment;

enum class Kind { far_apart, shuffled_grid_tie, collinear_grid_tie, decimal_tie, near_miss };

std::vector<Segment> random_legs(std::size_t count, std::mt19937_64& draw, double unit, std::uint64_t range) {
  std::vector<Segment> legs(count);
  for (Segment& s : legs) {
    const auto coordinate = [&] { return static_cast<double>(draw() % range) * unit; };
    const double ax = coordinate(), ay = coordinate(), bx = coordinate(), by = coordinate();
    s = {{ax, ay}, {bx, by}};
  }
  return legs;
}

struct Sides {
  std::vector<Segment> a, b;
  int expected = 0;
};

Sides sides(Kind kind, std::size_t count) {
  std::mt19937_64 draw(count);
  Sides s;
  switch (kind) {
    case Kind::far_apart:
      s.a = s.b = random_legs(count, draw, 1.0 / 1024, 1 << 20);
      s.b[0].b.x += 1e6;
      s.expected = -1;
      break;
    case Kind::shuffled_grid_tie:
      s.a = random_legs(count, draw, 1, 12);
      s.b.assign(s.a.rbegin(), s.a.rend());
      break;
    case Kind::collinear_grid_tie:
      // k(1, 2) in one leg against two.
      for (std::size_t i = 0; i < count; ++i) {
        const auto k = static_cast<double>(2 + i % 7);
        s.a.push_back({{0, 0}, {k, 2 * k}});
        s.b.push_back({{0, 0}, {1, 2}});
        s.b.push_back({{1, 2}, {k, 2 * k}});
      }
      break;
    case Kind::decimal_tie:
      s.a = random_legs(count, draw, 0.1, 100000);
      s.b.assign(s.a.rbegin(), s.a.rend());
      break;
    case Kind::near_miss:
      // The last bit of one coordinate.
      s.a = s.b = random_legs(count, draw, 0.1, 100000);
      s.a[0] = {{0, 0}, {0.7, 0.3}};
      s.b[0] = {{0, 0}, {0.7, std::nextafter(0.3, 1)}};
      s.expected = -1;
      break;
  }
  return s;
}

int sign(std::strong_ordering order) { return order < 0 ? -1 : order > 0; }

void compare(benchmark::State& state, Kind kind) {
  const Sides s = sides(kind, static_cast<std::size_t>(state.range(0)));
  if (sign(taut::compare_lengths(s.a, s.b)) != s.expected) std::abort();
  for (auto _ : state) benchmark::DoNotOptimize(taut::compare_lengths(s.a, s.b));
}

void peer_hypot(benchmark::State& state) {
  const Sides s = sides(Kind::far_apart, static_cast<std::size_t>(state.range(0)));
  const auto sum = [](const std::vector<Segment>& legs) {
    double length = 0;
    for (const Segment& leg : legs) length += std::hypot(leg.a.x - leg.b.x, leg.a.y - leg.b.y);
    return length;
  };
  for (auto _ : state) benchmark::DoNotOptimize(sum(s.a) < sum(s.b));
}

void distance_interval(benchmark::State& state) {
  std::mt19937_64 draw(1);
  const auto legs = random_legs(1024, draw, state.range(0) == 0 ? 1.0 : 0.1, 1 << 16);
  for (auto _ : state)
    for (const Segment& s : legs) benchmark::DoNotOptimize(taut::distance_interval(s.a, s.b));
  state.SetItemsProcessed(state.iterations() * 1024);
}

void peer_hypot_distance(benchmark::State& state) {
  std::mt19937_64 draw(1);
  const auto legs = random_legs(1024, draw, 1, 1 << 16);
  for (auto _ : state)
    for (const Segment& s : legs) benchmark::DoNotOptimize(std::hypot(s.a.x - s.b.x, s.a.y - s.b.y));
  state.SetItemsProcessed(state.iterations() * 1024);
}

void value(benchmark::State& state) {
  std::mt19937_64 draw(7);
  taut::Length length;
  for (const Segment& s : random_legs(static_cast<std::size_t>(state.range(0)), draw, 0.1, 1000)) length.add(s.a, s.b);
  for (auto _ : state) benchmark::DoNotOptimize(length.value());
}

BENCHMARK(distance_interval)->ArgName("decimal")->Arg(0)->Arg(1);
BENCHMARK(peer_hypot_distance);
BENCHMARK_CAPTURE(compare, far_apart, Kind::far_apart)->Arg(1)->Arg(4)->Arg(16)->Arg(50);
BENCHMARK_CAPTURE(compare, shuffled_grid_tie, Kind::shuffled_grid_tie)->Arg(1)->Arg(4)->Arg(16)->Arg(50);
BENCHMARK_CAPTURE(compare, collinear_grid_tie, Kind::collinear_grid_tie)->Arg(1)->Arg(4)->Arg(16)->Arg(50);
BENCHMARK_CAPTURE(compare, decimal_tie, Kind::decimal_tie)->Arg(1)->Arg(4)->Arg(16)->Arg(50);
BENCHMARK_CAPTURE(compare, near_miss, Kind::near_miss)->Arg(1)->Arg(4)->Arg(16)->Arg(50);
BENCHMARK(peer_hypot)->Arg(1)->Arg(4)->Arg(16)->Arg(50);
BENCHMARK(value)->Arg(1)->Arg(16)->Arg(50);

}  // namespace
