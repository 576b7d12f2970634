#include "renderer/base/work/work_scope.h"

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>

#include <pty.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "renderer/base/work/parallel.h"
#include "tests/matchers.h"
#include "tests/scenes/environment.h"

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

/// What `work` writes to a terminal of this kind that is 20 columns wide.
std::string shown_on(const char* kind, const std::function<void()>& work) {
  const scenes::EnvironmentVariable term("TERM", kind);
  int terminal = -1;
  int program = -1;
  const winsize size{.ws_row = 24, .ws_col = 20, .ws_xpixel = 0, .ws_ypixel = 0};
  EXPECT_EQ(::openpty(&terminal, &program, nullptr, nullptr, &size), 0);
  const int before = ::dup(STDERR_FILENO);
  ::dup2(program, STDERR_FILENO);
  work();
  ::dup2(before, STDERR_FILENO);
  ::close(before);
  ::close(program);
  std::string shown;
  std::array<char, 4096> bytes{};
  // Once nobody can write any more, what was written is read to its end.
  for (ssize_t count = 0; (count = ::read(terminal, bytes.data(), bytes.size())) > 0;) {
    shown.append(bytes.data(), static_cast<std::size_t>(count));
  }
  ::close(terminal);
  return shown;
}

void show_progress() {
  Progress progress("Reference images of a long study");
  progress.update(0.5, "meeting-room");
}

TEST(Progress, StaysOnOneLineOfTheTerminal) {
  // One column stays free: some terminals begin a new line behind the last.
  EXPECT_EQ(shown_on("xterm", show_progress), "\rReference images of\033[K\r\033[K");
}

TEST(Progress, HasNoEscapesWhereATerminalKnowsNone) {
  const std::string shown = shown_on("dumb", show_progress);
  EXPECT_THAT(shown, HasSubstr("Reference images of a long study   50 %"));
  EXPECT_THAT(shown, Not(HasSubstr("\033")));
}

TEST(StepProgress, ShowsEachStepOnALineOfItsOwnAfterASecond) {
  const std::string shown = shown_on("xterm", [] {
    StepProgress progress("loading: ");
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    progress.update("textures", 0.5);
    progress.update("ray hierarchy", 0.25);
  });
  EXPECT_EQ(shown,
            "\rloading: textures  \033[K\r\033[K"
            "\rloading: ray hierar\033[K\r\033[K");
}

}  // namespace

}  // namespace foveola
