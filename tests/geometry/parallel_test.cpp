#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include <taut/geometry/parallel.h>

namespace taut {
namespace {

using Work = std::function<void(std::size_t)>;

class ParallelLoop : public testing::TestWithParam<unsigned> {
 protected:
  Parallel jobs() const { return {GetParam()}; }
};

INSTANTIATE_TEST_SUITE_P(OfJobs, ParallelLoop, testing::Values(0U, 1U, 2U, 5U, 16U));

TEST_P(ParallelLoop, DoesEachItemOnce) {
  std::vector<std::atomic<int>> times(1000);
  each_in_parallel(times.size(), jobs(), [&](std::size_t i) { ++times[i]; });
  for (const std::atomic<int>& count : times) EXPECT_EQ(count.load(), 1);
  each_in_parallel(0, jobs(), [](std::size_t) { FAIL() << "there is none"; });
}

TEST_P(ParallelLoop, TellsWhatIsFinishedInOrderWithWhatItWrote) {
  std::vector<std::size_t> squares(500), told;
  Parallel how = jobs();
  how.finished = [&](std::size_t over) {
    told.push_back(over);
    for (std::size_t i = 0; i < over; ++i) ASSERT_EQ(squares[i], i * i);
  };
  each_in_parallel(squares.size(), how, [&](std::size_t i) { squares[i] = i * i; });
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(std::set(told.begin(), told.end()).size(), told.size());
  EXPECT_EQ(told.back(), squares.size());
}

TEST_P(ParallelLoop, ThrowsWhatTheLowestItemThrewWithAllBeforeItDone) {
  for (int round = 0; round < 50; ++round) {
    std::vector<std::atomic<int>> times(300);
    try {
      each_in_parallel(times.size(), jobs(), [&](std::size_t i) {
        ++times[i];
        if (i >= 100 && i % 7 == 0) throw std::out_of_range(std::to_string(i));
      });
      FAIL() << "nothing was thrown";
    } catch (const std::out_of_range& error) {
      ASSERT_STREQ(error.what(), "105");
    }
    for (std::size_t i = 0; i <= 105; ++i) ASSERT_EQ(times[i].load(), 1);
    ASSERT_EQ(times.back().load(), 0);
  }
}

TEST_P(ParallelLoop, EndsWhenItsCallerSaysSo) {
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<std::size_t> done{0};
  Parallel how = jobs();
  how.is_over = [&] {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    return done > 20;
  };
  each_in_parallel(100'000'000, how, [&](std::size_t) { ++done; });
  EXPECT_GT(done, 20U);
  EXPECT_LT(done, 100'000'000U);
}

TEST_P(ParallelLoop, PassesOnWhatItsListenersThrow) {
  Parallel how = jobs();
  how.finished = [](std::size_t over) {
    if (over >= 10) throw std::length_error("enough");
  };
  EXPECT_THROW(each_in_parallel(100, how, [](std::size_t) {}), std::length_error);
  how.finished = {};
  how.is_over = []() -> bool { throw std::domain_error("asked"); };
  EXPECT_THROW(each_in_parallel(100, how, [](std::size_t) {}), std::domain_error);
}

TEST_P(ParallelLoop, GivesEachThreadMemoryOfItsOwn) {
  std::mutex mutex;
  std::set<std::thread::id> makers;
  std::atomic<std::size_t> sum{0};
  each_in_parallel(1000, jobs(), [&]() -> Work {
    const std::lock_guard lock(mutex);
    EXPECT_TRUE(makers.insert(std::this_thread::get_id()).second) << "one each";
    auto own = std::make_shared<std::vector<std::size_t>>();
    return [&, own, maker = std::this_thread::get_id()](std::size_t i) {
      EXPECT_EQ(std::this_thread::get_id(), maker);
      own->push_back(i);
      sum += own->back();
    };
  });
  EXPECT_EQ(sum, 999U * 1000 / 2);
  EXPECT_LE(makers.size(), std::max(1U, GetParam()));
}

TEST_P(ParallelLoop, MayHoldAnother) {
  std::vector<std::size_t> sums(20);
  each_in_parallel(sums.size(), jobs(), [&](std::size_t i) {
    std::vector<std::size_t> terms(50);
    each_in_parallel(terms.size(), jobs(), [&](std::size_t k) { terms[k] = i * k; });
    sums[i] = std::accumulate(terms.begin(), terms.end(), std::size_t{0});
  });
  for (std::size_t i = 0; i < sums.size(); ++i) EXPECT_EQ(sums[i], i * 49 * 50 / 2);
}

TEST(ParallelLoopOfOneJob, StaysInItsThreadAndInOrder) {
  std::vector<std::size_t> order;
  each_in_parallel(100, {}, [&, self = std::this_thread::get_id()](std::size_t i) {
    EXPECT_EQ(std::this_thread::get_id(), self);
    order.push_back(i);
  });
  EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
  EXPECT_EQ(order.size(), 100U);
}

// Both wait until the other one has begun; alone, either would wait for ever.
TEST(ParallelLoopOfTwoJobs, RunsTwoItemsAtOnceOnAnyMachine) {
  std::atomic<int> begun{0};
  each_in_parallel(2, {2}, [&](std::size_t) {
    ++begun;
    while (begun < 2) std::this_thread::yield();
  });
  EXPECT_EQ(begun, 2);
}

TEST(Blocks, AreOneForOneJobAndManyForMore) {
  EXPECT_EQ(block_length(1000, 1, 10), 1000U);
  EXPECT_EQ(block_length(0, 1, 10), 1U);
  EXPECT_EQ(block_length(1000, 2, 10), 32U);
  EXPECT_EQ(block_length(100, 8, 10), 10U);
}

}  // namespace
}  // namespace taut
