// What long work tells while it goes on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <taut/geometry/parallel.h>
#include <taut/geometry/progress.h>
#include <taut/io/results/visibility_stream.h>
#include <taut/io/worlds/read_world.h>
#include <taut/roadmaps/all_radii.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/index.h>
#include <taut/search/roadmap_kinds.h>

namespace taut {
namespace {

using testing::ElementsAre;
using testing::Pair;

/// What was told, unit by unit, as it has to be: from nothing to all, never falling.
class Listener {
 public:
  TellProgress tell() {
    return [this](const Progress& progress) { hear(progress); };
  }
  const std::map<std::string, std::size_t>& whole() const { return whole_; }
  std::size_t calls() const { return calls_; }

  void expect_all_done() const { EXPECT_EQ(last_.done, last_.all); }

 private:
  void hear(const Progress& progress) {
    ++calls_;
    EXPECT_LE(progress.done, progress.all);
    if (std::string_view(progress.unit) != last_.unit) {
      EXPECT_EQ(last_.done, last_.all) << last_.unit;
      EXPECT_EQ(progress.done, 0U);
    } else {
      EXPECT_GE(progress.done, last_.done);
    }
    whole_[progress.unit] = progress.all;
    last_ = progress;
  }

  Progress last_;
  std::map<std::string, std::size_t> whole_;
  std::size_t calls_ = 0;
};

FreeSpace maze() { return FreeSpace(read_world_file(TAUT_DATA_DIR "/maze_5x7.txt")); }

TEST(Progress, OfAVoronoiDiagramIsOfItsSites) {
  Listener listener;
  const VoronoiRoadmap map(maze(), 2, listener.tell());
  EXPECT_THAT(listener.whole(), ElementsAre(Pair("sites", map.sites().size())));
  listener.expect_all_done();
}

TEST(Progress, OfAVisibilityGraphIsOfItsVertices) {
  for (const unsigned jobs : {1U, 3U}) {
    Listener listener;
    const VisibilityGraph graph(maze(), VisibilityKind::full, jobs, listener.tell());
    EXPECT_THAT(listener.whole(), ElementsAre(Pair("corners", graph.roadmap().vertex_count())));
    EXPECT_EQ(listener.calls(), 1 + graph.roadmap().vertex_count());
    listener.expect_all_done();
  }
}

TEST(Progress, OfAStreamedVisibilityGraphIsOfItsVertices) {
  Listener listener;
  const VisibilityRows rows(maze(), VisibilityKind::reduced);
  stream_visibility(
      rows, [](std::string_view) {}, listener.tell());
  EXPECT_THAT(listener.whole(), ElementsAre(Pair("corners", rows.vertices().sectors.size())));
  listener.expect_all_done();
}

TEST(Progress, OfTangentsIsOfTheirCircles) {
  Listener one, all;
  const TangentGraph graph(maze(), 0.2, one.tell());
  EXPECT_THAT(one.whole(), ElementsAre(Pair("circles", graph.corner_count())));
  one.expect_all_done();
  const AllRadii radii(maze(), all.tell());
  EXPECT_THAT(all.whole(), ElementsAre(Pair("corners", radii.corner_count())));
  all.expect_all_done();
}

TEST(Progress, OfAnIndexIsOfCornersThenOfBends) {
  Listener listener;
  const Index index(maze(), Index::kMemory, listener.tell());
  EXPECT_THAT(listener.whole(), ElementsAre(Pair("bends", index.bend_count()), Pair("corners", index.bend_count())));
  listener.expect_all_done();
}

TEST(Progress, OfAProbabilisticRoadmapKnowsNoEnd) {
  const FreeSpace space = maze();
  std::vector<Progress> told;
  BuildRequest request{.from = space.world().start(), .to = space.world().goal()};
  request.tell = [&](const Progress& progress) { told.push_back(progress); };
  request.prm.connection = PrmConnection{PrmConnection::Rule::nearest, 1};
  request.prm.samples = 2000;
  roadmap_kind("prm")->build(space, request);
  ASSERT_FALSE(told.empty());
  EXPECT_STREQ(told.back().unit, "samples");
  EXPECT_EQ(told.back().all, 0U);
  EXPECT_GT(told.back().done, 0U);
}

TEST(Progress, IsToldOneCallAtATimeByAnyNumberOfThreads) {
  Listener listener;  // which has no lock of its own
  const TellProgress tell = listener.tell();
  ProgressCount done("items", 1000, tell);
  each_in_parallel(1000, {4}, [&](std::size_t) { done.add(); });
  EXPECT_EQ(listener.calls(), 1001U);
  listener.expect_all_done();
}

TEST(Progress, IsNotAskedForWhereNobodyListens) {
  const TellProgress nobody;
  ProgressCount done("items", 3, nobody);
  done.add(3);
}

}  // namespace
}  // namespace taut
