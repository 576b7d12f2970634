#include "renderer/base/work/ordered_jobs.h"

#include <algorithm>
#include <atomic>
#include <barrier>
#include <numeric>
#include <stdexcept>

#include "tests/matchers.h"

namespace foveola {
namespace {

std::vector<std::size_t> taken_by(int jobs, std::size_t count) {
  OrderedJobs<std::size_t> work(count, 4, [](std::size_t index) { return index * index; });
  std::vector<std::size_t> taken;
  work.run(jobs, [&](std::size_t index, std::size_t result) {
    EXPECT_EQ(index, taken.size());
    taken.push_back(result);
    return true;
  });
  return taken;
}

TEST(OrderedJobs, ResultsAreTakenInOrderByAnyNumberOfThreads) {
  EXPECT_THAT(taken_by(1, 5), ElementsAre(0, 1, 4, 9, 16));
  EXPECT_THAT(taken_by(3, 5), ElementsAre(0, 1, 4, 9, 16));
  EXPECT_TRUE(taken_by(2, 0).empty());
}

TEST(OrderedJobs, PiecesRunSideBySide) {
  std::barrier meeting(2);  // nobody passes alone
  OrderedJobs<int> work(2, 2, [&](std::size_t index) {
    meeting.arrive_and_wait();
    return static_cast<int>(index);
  });
  int taken = 0;
  work.run(2, [&](std::size_t, int) { return ++taken > 0; });
  EXPECT_EQ(taken, 2);
}

TEST(OrderedJobs, BeginsNoMoreThanMayWait) {
  constexpr std::size_t ahead = 3;
  std::atomic<std::size_t> begun = 0;
  OrderedJobs<int> work(50, ahead, [&](std::size_t) {
    ++begun;
    return 0;
  });
  work.run(4, [&](std::size_t index, int) {
    EXPECT_LE(begun, index + ahead);
    return true;
  });
  EXPECT_EQ(begun, 50U);
}

TEST(OrderedJobs, NothingIsBegunOnceNoMoreIsTaken) {
  std::atomic<std::size_t> begun = 0;
  OrderedJobs<int> work(50, 2, [&](std::size_t) {
    ++begun;
    return 0;
  });
  std::size_t taken = 0;
  work.run(2, [&](std::size_t index, int) {
    ++taken;
    return index < 3;
  });
  EXPECT_EQ(taken, 4U);
  EXPECT_LE(begun, 5U);
}

TEST(OrderedJobs, TheFirstFaultInOrderComesOut) {
  OrderedJobs<int> work(10, 10, [](std::size_t index) -> int {
    if (index >= 2) {
      throw std::runtime_error("piece " + std::to_string(index));
    }
    return 0;
  });
  std::size_t taken = 0;
  EXPECT_THAT([&] { work.run(2, [&](std::size_t, int) { return ++taken > 0; }); },
              ThrowsMessage<std::runtime_error>("piece 2"));
  EXPECT_EQ(taken, 2U);
}

}  // namespace
}  // namespace foveola
