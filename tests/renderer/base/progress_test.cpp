#include "renderer/base/progress.h"

#include <array>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <string>
#include <thread>

#include <pty.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "tests/matchers.h"
#include "tests/scenes/environment.h"

namespace foveola {
namespace {

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
