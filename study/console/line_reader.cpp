#include "study/console/line_reader.h"

#include <array>
#include <utility>

#include <poll.h>
#include <unistd.h>

namespace foveola::study {

LineReader::LineReader(int descriptor)
    : thread_([this, descriptor](const std::stop_token& stop) { read(descriptor, stop); }) {}

std::vector<std::string> LineReader::take_lines() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(lines_, {});
}

void LineReader::read(int descriptor, const std::stop_token& stop) {
  constexpr int patience_ms = 50;
  std::array<char, 4096> bytes{};
  while (!stop.stop_requested()) {
    pollfd input{.fd = descriptor, .events = POLLIN, .revents = 0};
    if (::poll(&input, 1, patience_ms) <= 0) {
      continue;
    }
    const ssize_t count = ::read(descriptor, bytes.data(), bytes.size());
    if (count <= 0) {
      return;
    }
    keep({bytes.data(), static_cast<std::size_t>(count)});
  }
}

void LineReader::keep(std::string_view bytes) {
  unfinished_ += bytes;
  for (std::size_t end = unfinished_.find('\n'); end != std::string::npos;
       end = unfinished_.find('\n')) {
    const std::scoped_lock lock(mutex_);
    lines_.push_back(unfinished_.substr(0, end));
    unfinished_.erase(0, end + 1);
  }
}

}  // namespace foveola::study
