#include "study/person/line_writer.h"

#include <csignal>
#include <sstream>
#include <utility>

#include <poll.h>
#include <unistd.h>

#include "renderer/base/utf8.h"

namespace foveola::study {
namespace {

/// A terminal that has room for any has room for so many; a pipe for more.
constexpr std::size_t most_at_once = 256;

}  // namespace

LineWriter::LineWriter(int descriptor) : descriptor_(descriptor), thread_([this] { run(); }) {}

LineWriter::~LineWriter() {
  {
    const std::scoped_lock lock(mutex_);
    is_closing_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void LineWriter::write(const std::string& text) {
  std::istringstream lines(text);
  const std::scoped_lock lock(mutex_);
  for (std::string line; std::getline(lines, line);) {
    text_ += printable(line) + "\n";
  }
  changed_.notify_one();
}

void LineWriter::run() {
  // Writing to a pipe that nobody reads is then an error instead of the program's end.
  sigset_t broken_pipe;
  ::sigemptyset(&broken_pipe);
  ::sigaddset(&broken_pipe, SIGPIPE);
  ::pthread_sigmask(SIG_BLOCK, &broken_pipe, nullptr);

  using SteadyTime = std::chrono::steady_clock::time_point;
  SteadyTime last_taken = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return is_closing_ || !text_.empty(); });
    const SteadyTime now = std::chrono::steady_clock::now();
    if (text_.empty() || (is_closing_ && now - last_taken > patience)) {
      return;
    }
    const std::string next = text_.substr(written_, most_at_once);
    lock.unlock();
    const std::size_t taken = write_some(next);
    lock.lock();
    written_ += taken;
    if (written_ == text_.size()) {
      text_.clear();
      written_ = 0;
    }
    if (taken > 0 || !is_closing_) {
      last_taken = std::chrono::steady_clock::now();
    }
  }
}

std::size_t LineWriter::write_some(std::string_view text) const {
  constexpr int moment_ms = 50;
  pollfd output{.fd = descriptor_, .events = POLLOUT, .revents = 0};
  if (::poll(&output, 1, moment_ms) == 0) {
    return 0;
  }
  const ssize_t written = ::write(descriptor_, text.data(), text.size());
  return written < 0 ? text.size() : static_cast<std::size_t>(written);
}

}  // namespace foveola::study
