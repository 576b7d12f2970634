#include "tests/openxr/runtime/log.h"

namespace foveola::test::openxr {

void Log::open(const std::filesystem::path& file) {
  if (file == file_) {
    return;
  }
  file_ = file;
  stream_.close();
  stream_.clear();
  if (!file.empty()) {
    stream_.open(file, std::ios::app);
  }
}

void Log::write(const nlohmann::json& line) {
  if (stream_.is_open()) {
    // One string, which is written by one call: lines of several processes stay whole.
    stream_ << line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n'
            << std::flush;
  }
}

}  // namespace foveola::test::openxr
