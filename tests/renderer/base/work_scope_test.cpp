#include "renderer/base/work_scope.h"

#include <atomic>
#include <chrono>
#include <cstddef>
#include <exception>
#include <optional>
#include <stop_token>
#include <thread>
#include <type_traits>
#include <utility>

#include <gtest/gtest.h>

#include "renderer/base/load_watched.h"
#include "renderer/base/parallel.h"

namespace foveola {
namespace {

static_assert(!std::is_base_of_v<std::exception, WorkStopped>);

TEST(WorkScope, StopsALoopOfWorkersBetweenItsBlocks) {
  for (const int threads : {1, 4}) {
    const Workers workers(threads);
    std::stop_source stop;
    std::atomic<int> done = 0;
    const auto count_to_1000 = [&] {
      workers.for_each_block(1000, 1, [&](std::size_t, std::size_t) {
        if (++done == 10) {
          stop.request_stop();
          EXPECT_THROW(throw_if_work_stopped(), WorkStopped);
        }
      });
    };
    {
      const WorkScope scope(stop.get_token());
      EXPECT_THROW(count_to_1000(), WorkStopped);
      EXPECT_LT(done, 10 + threads);
    }
    done = 10;
    EXPECT_NO_THROW(count_to_1000()) << "outside of the scope";
    EXPECT_EQ(done, 1010);
  }
}

TEST(WorkScope, IsThatOfTheInnermost) {
  std::stop_source outer;
  std::stop_source inner;
  const WorkScope whole(outer.get_token());
  outer.request_stop();
  std::optional<WorkScope> part(std::in_place, inner.get_token());
  EXPECT_FALSE(is_work_stopped());
  inner.request_stop();
  EXPECT_TRUE(is_work_stopped());
  part.reset();
  EXPECT_TRUE(is_work_stopped());
  EXPECT_THROW(throw_if_work_stopped(), WorkStopped);
}

TEST(StuckLoadExit, EndsTheProgramWhereALoadDoesNotObey) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        std::stop_source stop;
        const StuckLoadExit exit(stop.get_token());
        stop.request_stop();
        std::this_thread::sleep_for(std::chrono::hours(1));
      },
      testing::ExitedWithCode(130), "stopped while a scene was loaded");
}

TEST(StuckLoadExit, LeavesALoadThatObeysOrWasNotStopped) {
  std::stop_source stop;
  {
    const StuckLoadExit exit(stop.get_token());
  }
  stop.request_stop();
  EXPECT_EQ(load_or_exit(stop.get_token(), [] { return 7; }), 7);
  EXPECT_THROW(load_or_exit(stop.get_token(),
                            [] {
                              throw_if_work_stopped();
                              return 7;
                            }),
               WorkStopped);
}

}  // namespace
}  // namespace foveola
