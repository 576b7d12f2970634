#include "renderer/base/output_guard.h"

#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace foveola {
namespace {

struct GuardedOutput {
  std::string option;
  fs::path path;
  dev_t device;
  ino_t inode;
};

std::vector<GuardedOutput>& guarded_outputs() {
  static std::vector<GuardedOutput> outputs;
  return outputs;
}

}  // namespace

void guard_output(const std::string& option, const fs::path& path) {
  // Open until the program ends, so that no other file gets the inode once this one is replaced.
  const int descriptor = ::open(path.c_str(), O_PATH | O_CLOEXEC);
  if (descriptor < 0) {
    return;
  }
  struct stat status{};
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
    ::close(descriptor);
    return;
  }
  guarded_outputs().push_back(
      {.option = option, .path = path, .device = status.st_dev, .inode = status.st_ino});
}

void require_no_output(const fs::path& input) {
  struct stat status{};
  if (guarded_outputs().empty() || ::stat(input.c_str(), &status) != 0) {
    return;
  }
  for (const GuardedOutput& output : guarded_outputs()) {
    if (output.device == status.st_dev && output.inode == status.st_ino) {
      throw OutputIsInput(output.option,
                          fmt::format("{} is read by the command, too", output.path.string()),
                          "name another file");
    }
  }
}

}  // namespace foveola
