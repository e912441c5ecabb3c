// An index beside cones of sight, with landmarks, and the search from bend to bend: CPU a query, path included, on mazes
// of 512 x 512 cells with a fifth of their walls opened and on grid maps of others where they are present; and what it
// takes to build one, in time and bytes. Every hundredth path of the index is compared with that of the cones, exactly.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <taut/io/worlds/read_world.h>
#include <taut/search/index.h>
#include <taut/search/polyanya.h>

#include "mazes.h"
#include "shared_data.h"

namespace {

using namespace taut;

constexpr std::size_t kPairs = 1000;

struct Case {
  explicit Case(World world) : space(std::move(world)) {
    const Box box = space.world().box();
    std::mt19937_64 engine(1);
    const auto below = [&](double size) {
      return static_cast<double>(engine() % static_cast<std::uint64_t>(size)) + 0.5;
    };
    while (places.size() < 2 * kPairs) {
      const double x = box.min.x + below(box.max.x - box.min.x), y = box.min.y + below(box.max.y - box.min.y);
      if (space.locate({x, y}).kind != Location::Kind::outside) places.push_back({x, y});
    }
  }

  FreeSpace space;
  std::vector<Point> places;
};

using Make = std::function<std::shared_ptr<const Case>()>;

template <class Search>
void ask(benchmark::State& state, const Case& on, Search& search) {
  std::size_t i = 0;
  for (auto _ : state) {
    search.find(on.places[i], on.places[i + 1]);
    benchmark::DoNotOptimize(search.points().data());
    i = i + 2 == on.places.size() ? 0 : i + 2;
  }
}

bool is_right(const Case& on, IndexSearch& index) {
  PolyanyaSearch cones{Polyanya(on.space)};
  for (std::size_t i = 0; i < on.places.size(); i += 200) {
    if (index.find(on.places[i], on.places[i + 1]) != cones.find(on.places[i], on.places[i + 1])) return false;
    if (Length(index.points()) != Length(cones.points())) return false;
  }
  return true;
}

void build(benchmark::State& state, const Make& make, std::size_t memory) {
  const auto on = make();
  std::size_t bytes = 0, bends = 0;
  for (auto _ : state) {
    const Index index(on->space, memory);
    bytes = index.bytes().size();
    bends = index.bend_count();
  }
  state.counters["MB"] = static_cast<double>(bytes) / 1e6;
  state.counters["bends"] = static_cast<double>(bends);
}

void query(benchmark::State& state, const Make& make, std::size_t memory) {
  const auto on = make();
  IndexSearch search{Index(on->space, memory)};
  if (!is_right(*on, search)) return state.SkipWithError("not the exact length");
  ask(state, *on, search);
}

void register_case(const std::string& name, const Make& made, std::size_t memory) {
  const Make make = [made, kept = std::make_shared<std::shared_ptr<const Case>>()] {
    if (!*kept) *kept = made();
    return *kept;
  };
  const auto add = [&](const char* what, const std::function<void(benchmark::State&)>& run, benchmark::TimeUnit unit) {
    benchmark::RegisterBenchmark(("BM_" + std::string(what) + "/" + name).c_str(), run)->Unit(unit);
  };
  const auto cones = [=](const std::function<Polyanya(const Polyanya&)>& with) {
    return [=](benchmark::State& state) {
      const auto on = make();
      PolyanyaSearch search(with(Polyanya(on->space)));
      ask(state, *on, search);
    };
  };
  add(
      "Build", [=](benchmark::State& state) { build(state, make, memory); }, benchmark::kMillisecond);
  add(
      "Index", [=](benchmark::State& state) { query(state, make, memory); }, benchmark::kMicrosecond);
  add("Cones", cones([](const Polyanya& p) { return p; }), benchmark::kMicrosecond);
  add("Landmarks", cones([](const Polyanya& p) { return p.with_landmarks(); }), benchmark::kMicrosecond);
  add("BendsLandmarks", cones([](const Polyanya& p) { return p.with_graph().with_landmarks(); }),
      benchmark::kMicrosecond);
}

void register_all() {
  constexpr std::size_t kMega = 1000000;
  const auto maze = [](int cells, int wide) {
    return [=] { return std::make_shared<const Case>(bench::opened_block_maze(cells, wide, 0.2)); };
  };
  register_case("wide8-opened", maze(57, 8), 8 * kMega);
  register_case("wide1-opened", maze(255, 1), 20 * kMega);
  const std::filesystem::path maps = bench::shared_data("movingai");
  for (const auto& [name, memory] : std::map<std::string, std::size_t>{
           {"maze512-8-0-braid20", 8 * kMega}, {"brc202d", 4 * kMega}, {"orz900d", 7 * kMega}}) {
    const std::filesystem::path file = maps / (name + ".map.gz");
    if (!maps.empty() && std::filesystem::exists(file))
      register_case(
          name, [file] { return std::make_shared<const Case>(read_world_file(file.string(), {})); }, memory);
  }
}

[[maybe_unused]] const bool kRegistered = (register_all(), true);

}  // namespace
