#include "renderer/base/files/cache.h"

#include <system_error>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

fs::path digest_file_of(const fs::path& file) {
  fs::path beside = file;
  beside += ".sha256";
  return beside;
}

std::string digest_line(const std::string& digest, const fs::path& file) {
  return fmt::format("{}  {}\n", digest, file.filename().string());
}

/// Whether `file` was kept with this digest, whatever its present content.
bool was_kept_with(const std::string& digest, const fs::path& file) {
  try {
    return read_file(digest_file_of(file)) == digest_line(digest, file);
  } catch (const Error&) {
    return false;
  }
}

/// Whether `file` exists and is readable, with this digest.
bool has_digest(const std::string& digest, const fs::path& file) {
  std::error_code unreachable;
  try {
    return fs::is_regular_file(file, unreachable) && sha256_of_file(file) == digest;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

void make_cache_folder(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) {
    throw Error(folder.string(), "cannot be made: " + failure.message(),
                "set XDG_CACHE_HOME to another folder");
  }
}

bool is_cached(const fs::path& file) {
  std::error_code unreachable;
  try {
    return fs::is_regular_file(file, unreachable) && was_kept_with(sha256_of_file(file), file);
  } catch (const Error&) {
    return false;
  }
}

std::optional<std::string> read_from_cache(const fs::path& file) {
  std::error_code unreachable;
  if (!fs::is_regular_file(file, unreachable)) {
    return std::nullopt;
  }
  try {
    std::string content = read_file(file);
    if (was_kept_with(sha256(std::string_view(content)), file)) {
      return content;
    }
  } catch (const Error&) {
  }
  return std::nullopt;
}

void store_file(const fs::path& file, const std::function<void(const fs::path&)>& write) {
  const TemporaryFile temporary(file);
  write(temporary.path());
  const std::string digest = sha256_of_file(temporary.path());
  if (was_kept_with(digest, file) && has_digest(digest, file)) {
    return;
  }
  write_file(digest_file_of(file), digest_line(digest, file));
  temporary.replace_final();
}

void store_content(const fs::path& file, std::string_view content) {
  store_file(file, [&](const fs::path& temporary) { write_file(temporary, content); });
}

}  // namespace foveola
