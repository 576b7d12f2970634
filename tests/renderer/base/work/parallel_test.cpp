#include "renderer/base/work/parallel.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <map>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sched.h>

#include "tests/temporary_folder.h"

namespace foveola {
namespace {

TEST(Workers, CoverEveryItemOnce) {
  for (const int threads : {1, 2, 4}) {
    const Workers workers(threads);
    EXPECT_EQ(workers.threads(), threads);
    for (const std::size_t count : {0U, 1U, 7U, 64U, 1001U}) {
      std::vector<int> visits(count, 0);
      workers.for_each_block(count, 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          ++visits[i];
        }
      });
      EXPECT_EQ(visits, std::vector<int>(count, 1));
    }
  }
}

TEST(Workers, ShrinkingBlocksCoverEveryItemOnce) {
  constexpr BlockSizes sizes = {.smallest = 16, .largest = 128};
  for (const int threads : {1, 2, 4}) {
    const Workers workers(threads);
    for (const std::size_t count : {0U, 1U, 16U, 63U, 1001U, 20000U}) {
      std::mutex mutex;
      std::map<std::size_t, std::size_t> end_of;  // by begin
      workers.for_each_shrinking_block(count, sizes, [&](std::size_t begin, std::size_t end) {
        const std::lock_guard lock(mutex);
        end_of[begin] = end;
      });
      std::size_t covered = 0;
      std::size_t previous = sizes.largest;
      for (const auto& [begin, end] : end_of) {
        EXPECT_EQ(begin, covered);
        EXPECT_LE(end - begin, previous) << "it never grows";
        EXPECT_GE(end - begin, end == count ? 1U : sizes.smallest);
        covered = end;
        previous = end - begin;
      }
      EXPECT_EQ(covered, count);
    }
  }
}

TEST(Workers, TheLastShrinkingBlocksAreShort) {
  const Workers workers(2);
  std::atomic<std::size_t> last = 0;
  std::atomic<std::size_t> first = 0;
  constexpr std::size_t count = 20000;
  workers.for_each_shrinking_block(count, {.smallest = 16, .largest = 512},
                                   [&](std::size_t begin, std::size_t end) {
                                     if (begin == 0) {
                                       first = end;
                                     } else if (end == count) {
                                       last = end - begin;
                                     }
                                   });
  EXPECT_EQ(first, 512U);
  EXPECT_LE(last, 16U);
}

TEST(Workers, OneThreadTakesBlocksFromFirstToLast) {
  const Workers workers(1);
  std::vector<std::size_t> begins;
  workers.for_each_block(1000, 10,
                         [&](std::size_t begin, std::size_t) { begins.push_back(begin); });
  EXPECT_EQ(begins.size(), 100U);
  EXPECT_TRUE(std::is_sorted(begins.begin(), begins.end()));
}

TEST(Workers, PassOnExceptions) {
  const Workers workers(2);
  EXPECT_THROW(workers.for_each_block(100, 1,
                                      [](std::size_t begin, std::size_t) {
                                        if (begin == 50) {
                                          throw std::runtime_error("failed");
                                        }
                                      }),
               std::runtime_error);
}

// Embree asks for it; outside the loops the caller's arithmetic is left alone.
TEST(Workers, FlushDenormalsInsideTheLoopsOnly) {
  volatile float smallest = std::numeric_limits<float>::min();
  const auto half_is_zero = [&] { return smallest * 0.5F == 0.0F; };
  const Workers workers(2);
  std::atomic<int> kept = 0;
  workers.for_each_block(100, 1, [&](std::size_t, std::size_t) { kept += half_is_zero() ? 0 : 1; });
#if defined(__SSE2__)
  EXPECT_EQ(kept, 0);
#endif
  EXPECT_FALSE(half_is_zero());
}

// The files' form: https://docs.kernel.org/admin-guide/cgroup-v2.html, "$MAX $PERIOD" in
// microseconds.
TEST(Cores, AQuotaOfTimeIsWorthCores) {
  const test::TemporaryFolder mount;
  EXPECT_FALSE(cgroup_cores(mount.path(), ""));
  mount.write("cpu.max", "max 100000\n");
  mount.write("user/cpu.max", "400000 100000\n");
  mount.write("user/job/cpu.max", "75000 50000\n");
  mount.write("user/job/step/cpu.max", "max 100000\n");
  EXPECT_FALSE(cgroup_cores(mount.path(), "other"));
  EXPECT_EQ(cgroup_cores(mount.path(), "user"), 4.0);
  EXPECT_EQ(cgroup_cores(mount.path(), "user/job/step"), 1.5);
}

// The files' form: https://docs.kernel.org/scheduler/sched-bwc.html.
TEST(Cores, AQuotaOfVersion1IsWorthCores) {
  const test::TemporaryFolder mount;
  mount.write("cpu.cfs_quota_us", "-1\n");
  mount.write("cpu.cfs_period_us", "100000\n");
  EXPECT_FALSE(cgroup_cores(mount.path(), ""));
  mount.write("job/cpu.cfs_quota_us", "20000\n");
  mount.write("job/cpu.cfs_period_us", "10000\n");
  EXPECT_EQ(cgroup_cores(mount.path(), "job/step"), 2.0);
}

TEST(Cores, AreThoseOfTheAffinity) {
  cpu_set_t before;
  ASSERT_EQ(::sched_getaffinity(0, sizeof before, &before), 0);
  int first = 0;
  while (!CPU_ISSET(first, &before)) {
    ++first;
  }
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(first, &one);
  ASSERT_EQ(::sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(usable_cores(), 1);
  ASSERT_EQ(::sched_setaffinity(0, sizeof before, &before), 0);
  EXPECT_LE(usable_cores(), CPU_COUNT(&before));
}

}  // namespace

}  // namespace foveola
