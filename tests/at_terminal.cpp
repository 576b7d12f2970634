#include "tests/at_terminal.h"

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/waiting.h"

namespace foveola::test {
namespace {

constexpr winsize default_size{.ws_row = 24, .ws_col = 80, .ws_xpixel = 0, .ws_ypixel = 0};

}  // namespace

AtTerminal::AtTerminal(const char* kind, const std::function<int()>& body) {
  // What is not written yet must not be written twice.
  std::fflush(nullptr);
  winsize size = default_size;
  process_ = ::forkpty(&terminal_, nullptr, nullptr, &size);
  if (process_ == 0) {
    ::setenv("TERM", kind, 1);
    ::_exit(body());
  }
}

AtTerminal::~AtTerminal() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  ::close(terminal_);
}

void AtTerminal::type(const std::string& keys) const {
  if (::write(terminal_, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size())) {
    throw std::runtime_error("the terminal takes no keys");
  }
}

void AtTerminal::wait_for(const std::string& words) {
  winsize size = default_size;
  const auto has_come = [&] {
    size.ws_row =
        size.ws_row == default_size.ws_row ? default_size.ws_row + 1 : default_size.ws_row;
    ::ioctl(terminal_, TIOCSWINSZ, &size);
    const bool goes_on = read();
    if (seen_.find(words) != std::string::npos) {
      return true;
    }
    if (!goes_on) {
      throw std::runtime_error("it ended without '" + words + "':\n" + seen_);
    }
    return false;
  };
  try {
    wait_until(words, has_come);
  } catch (const std::runtime_error& in_vain) {
    throw std::runtime_error(std::string(in_vain.what()) + "; seen:\n" + seen_);
  }
}

std::string AtTerminal::all_seen() {
  wait_until("its end", [&] { return !read(); });
  return seen_;
}

int AtTerminal::wait_without_reading() {
  int status = -1;
  wait_until("its end", [&] { return ::waitpid(process_, &status, WNOHANG) != 0; });
  process_ = -1;
  return status;
}

int AtTerminal::close_and_wait() {
  ::close(std::exchange(terminal_, -1));
  return wait_without_reading();
}

bool AtTerminal::read() {
  constexpr int moment_ms = 100;
  std::array<char, 4096> bytes{};
  pollfd input{.fd = terminal_, .events = POLLIN, .revents = 0};
  while (::poll(&input, 1, moment_ms) > 0) {
    const ssize_t count = ::read(terminal_, bytes.data(), bytes.size());
    if (count <= 0) {
      return false;
    }
    seen_.append(bytes.data(), static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace foveola::test
