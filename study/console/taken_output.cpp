#include "study/console/taken_output.h"

#include <poll.h>
#include <unistd.h>

namespace foveola::study {

std::size_t write_taken(int descriptor, std::string_view text, std::chrono::milliseconds longest) {
  const std::string_view next = text.substr(0, most_taken_at_once);
  pollfd output{.fd = descriptor, .events = POLLOUT, .revents = 0};
  if (::poll(&output, 1, static_cast<int>(longest.count())) == 0) {
    return 0;
  }
  const ssize_t written = ::write(descriptor, next.data(), next.size());
  return written < 0 ? text.size() : static_cast<std::size_t>(written);
}

}  // namespace foveola::study
