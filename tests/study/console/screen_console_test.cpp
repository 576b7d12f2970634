#include "study/console/screen_console.h"

#include <array>
#include <cstdlib>
#include <functional>

#include <gmock/gmock.h>
#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/waiting.h"

namespace foveola::study {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr winsize usual_size{.ws_row = 24, .ws_col = 80, .ws_xpixel = 0, .ws_ypixel = 0};

/// A process in a terminal of its own, whose keys and eyes are the test's.
class AtTerminal {
 public:
  /// body: what the process does; returns its exit code.
  AtTerminal(const char* kind, const std::function<int()>& body) {
    winsize size = usual_size;
    process_ = ::forkpty(&terminal_, nullptr, nullptr, &size);
    if (process_ == 0) {
      ::setenv("TERM", kind, 1);
      ::_exit(body());
    }
  }
  ~AtTerminal() {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
    ::close(terminal_);
  }
  AtTerminal(const AtTerminal&) = delete;
  AtTerminal& operator=(const AtTerminal&) = delete;

  void type(const std::string& keys) const {
    ASSERT_EQ(::write(terminal_, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
  }

  /// What is painted over something else comes in pieces; as a whole only where the size changes.
  /// Throws std::runtime_error if it never comes.
  void wait_for(const std::string& words) {
    winsize size = usual_size;
    test::wait_until(words, [&] {
      size.ws_row = size.ws_row == usual_size.ws_row ? usual_size.ws_row + 1 : usual_size.ws_row;
      ::ioctl(terminal_, TIOCSWINSZ, &size);
      read();
      return seen_.find(words) != std::string::npos;
    });
  }

  /// Returns what waitpid says of the process's end, for which nothing is read meanwhile.
  int wait_without_reading() const {
    int status = -1;
    test::wait_until("its end", [&] { return ::waitpid(process_, &status, WNOHANG) != 0; });
    return status;
  }

  /// All that was painted and written until the process has ended.
  std::string all_seen() {
    test::wait_until("its end", [&] { return !read(); });
    return seen_;
  }

 private:
  /// What there is. Returns false once nobody is at the other end.
  bool read() {
    std::array<char, 4096> bytes{};
    pollfd input{.fd = terminal_, .events = POLLIN, .revents = 0};
    while (::poll(&input, 1, 100) > 0) {
      const ssize_t count = ::read(terminal_, bytes.data(), bytes.size());
      if (count <= 0) {
        return false;
      }
      seen_.append(bytes.data(), static_cast<std::size_t>(count));
    }
    return true;
  }

  int terminal_ = -1;
  pid_t process_ = -1;
  std::string seen_;
};

/// Shows a session until it is asked to quit; answers each line by saying it.
int run_until_quit() {
  LineWriter output(STDOUT_FILENO);
  const std::unique_ptr<ScreenConsole> console = ScreenConsole::open(output);
  if (console == nullptr) {
    return 3;
  }
  console->show({.participant = "P42", .now = "rating"});
  while (true) {
    for (const std::string& line : console->take()) {
      if (line == "quit") {
        return 0;
      }
      console->say("asked for: " + line);
    }
    ::usleep(1000);
  }
}

TEST(ScreenConsole, ShowsTheSessionAndTakesKeys) {
  AtTerminal terminal("xterm", run_until_quit);
  terminal.wait_for("Foveola, participant P42");
  terminal.wait_for("rating");
  terminal.type("nit rings \xc3\xbc\r");
  terminal.wait_for("asked for: note it rings \xc3\xbc");
  terminal.type("x\x1b");  // begun, and let go
  terminal.type("p");
  terminal.wait_for("asked for: pause");
  terminal.type("?");
  terminal.wait_for("the timing failed");
  terminal.type("q");
  terminal.wait_for("Interrupt the session?");
  terminal.type("\r");
  EXPECT_THAT(terminal.all_seen(), Not(HasSubstr("asked for: exclude")));
}

TEST(ScreenConsole, NeitherCtrlSNorCtrlZHoldsItUp) {
  AtTerminal terminal("xterm", run_until_quit);
  terminal.wait_for("rating");
  terminal.type("\x13\x1ap");
  terminal.wait_for("asked for: pause");
}

TEST(ScreenConsole, LeavesTheTerminalWithAllThatWasSaid) {
  AtTerminal terminal("xterm", run_until_quit);
  terminal.wait_for("rating");
  terminal.type("pq\r");
  constexpr const char* leaves_alternate_screen = "\x1b[?1049l";
  const std::string seen = terminal.all_seen();
  const std::size_t left = seen.rfind(leaves_alternate_screen);
  ASSERT_NE(left, std::string::npos);
  EXPECT_THAT(seen.substr(left), EndsWith("asked for: pause\r\n"));
}

TEST(ScreenConsole, ATerminalThatCannotBePaintedOnHasNone) {
  AtTerminal terminal("dumb-and-unheard-of", [] { return run_until_quit() == 3 ? 0 : 1; });
  EXPECT_EQ(terminal.wait_without_reading(), 0);
}

TEST(ScreenConsole, ATerminalThatTakesNothingDoesNotHoldItUp) {
  const AtTerminal terminal("xterm", [] {
    LineWriter output(STDOUT_FILENO);
    const std::unique_ptr<ScreenConsole> console = ScreenConsole::open(output);
    for (int i = 0; i < 100; ++i) {
      console->say(std::string(80 * 24, static_cast<char>('a' + i % 26)));
      ::usleep(20'000);
    }
    return 0;
  });
  EXPECT_EQ(terminal.wait_without_reading(), 0);
}

TEST(ScreenConsole, WhereThereIsNoTerminalThereIsNone) {
  // Standard input is made a file, as it is where nobody types.
  const int input = ::dup(STDIN_FILENO);
  ASSERT_NE(std::freopen("/dev/null", "r", stdin), nullptr);
  LineWriter output(STDERR_FILENO);
  EXPECT_EQ(ScreenConsole::open(output), nullptr);
  if (input >= 0) {
    ::dup2(input, STDIN_FILENO);
    ::close(input);
  }
}

}  // namespace
}  // namespace foveola::study
