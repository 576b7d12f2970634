#include "renderer/base/text/print.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "renderer/base/error.h"
#include "renderer/base/text/utf8.h"

namespace foveola {
namespace {

/// To be called with the errno of the last write.
void require_printed() {
  if (std::ferror(stdout) != 0) {
    throw Error("standard output", "cannot be written: " + std::generic_category().message(errno),
                "make room there, or print to another place");
  }
}

}  // namespace

void print_escaped(std::FILE* stream, std::string_view text) {
  const std::string harmless = escaped(text);
  std::fwrite(harmless.data(), 1, harmless.size(), stream);
  if (stream == stdout) {
    require_printed();
  }
}

void print_notes(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) {
    print_text(stderr, "foveola: note: {}\n", printable(note));
  }
}

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    print_text(stderr, "foveola: warning: {}\n", printable(warning));
  }
}

void finish_printing() {
  std::fflush(stdout);
  require_printed();
}

void hold_closed_streams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
    if (::fcntl(stream, F_GETFD) == -1) {
      // It gets the lowest free number. Reading a closed output fails here, too, and vice versa.
      ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
  }
}

}  // namespace foveola
