#include "study/console/line_writer.h"

#include <csignal>
#include <sstream>
#include <utility>

#include <poll.h>
#include <unistd.h>

#include "renderer/base/text/utf8.h"

namespace foveola::study {

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
    text_ += escaped(line) + "\n";
  }
  changed_.notify_one();
}

void LineWriter::run() {
  // Writing to a pipe without a reader must be an error, not the program's end.
  sigset_t broken_pipe;
  ::sigemptyset(&broken_pipe);
  ::sigaddset(&broken_pipe, SIGPIPE);
  ::pthread_sigmask(SIG_BLOCK, &broken_pipe, nullptr);

  constexpr std::chrono::milliseconds moment(50);
  using SteadyTime = std::chrono::steady_clock::time_point;
  SteadyTime last_taken;
  bool has_seen_closing = false;
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return is_closing_ || !text_.empty(); });
    const SteadyTime now = std::chrono::steady_clock::now();
    // Later text has not been offered to the reader yet.
    if (is_closing_ && !std::exchange(has_seen_closing, true)) {
      last_taken = now;
    }
    if (text_.empty() || (is_closing_ && now - last_taken > patience)) {
      return;
    }
    const std::string next = text_.substr(written_, max_taken_at_once);
    lock.unlock();
    const std::size_t taken = write_taken(descriptor_, next, moment);
    lock.lock();
    written_ += taken;
    if (written_ == text_.size()) {
      text_.clear();
      written_ = 0;
    }
    if (taken > 0) {
      last_taken = std::chrono::steady_clock::now();
    }
  }
}

std::size_t write_taken(int descriptor, std::string_view text, std::chrono::milliseconds longest) {
  const std::string_view next = text.substr(0, max_taken_at_once);
  pollfd output{.fd = descriptor, .events = POLLOUT, .revents = 0};
  if (::poll(&output, 1, static_cast<int>(longest.count())) == 0) {
    return 0;
  }
  const ssize_t written = ::write(descriptor, next.data(), next.size());
  return written < 0 ? text.size() : static_cast<std::size_t>(written);
}

}  // namespace foveola::study
