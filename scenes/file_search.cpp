#include "scenes/file_search.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/files/files.h"

namespace fs = std::filesystem;

namespace foveola::scenes {
namespace {

std::vector<fs::path> scene_path() {
  std::vector<fs::path> folders;
  const char* value = std::getenv("FOVEOLA_SCENE_PATH");
  std::istringstream list(value != nullptr ? value : "");
  for (std::string folder; std::getline(list, folder, ':');) {
    if (!folder.empty()) {
      folders.emplace_back(folder);
    }
  }
  return folders;
}

class Searcher {
 public:
  explicit Searcher(std::string file_name) : file_name_(std::move(file_name)) {}

  /// Searches `folder`, then its subfolders in order of their names, unless the file is found
  /// already.
  void search(const fs::path& folder) {
    look_into(folder);
    if (found_.file) {
      return;
    }
    for (const fs::path& subfolder : subfolders(folder)) {
      look_into(subfolder);
    }
  }

  FileSearch result() && {
    if (found_.file) {
      found_.obstacles.clear();
    }
    return std::move(found_);
  }

 private:
  /// An unreadable folder is met twice: when listed and when searched.
  void note(std::string obstacle) {
    std::vector<std::string>& noted = found_.obstacles;
    if (std::ranges::find(noted, obstacle) == noted.end()) {
      noted.push_back(std::move(obstacle));
    }
  }

  void note(const fs::path& folder, const std::error_code& failure) {
    note(fmt::format("{}: {}", folder.string(), failure.message()));
  }

  std::vector<fs::path> subfolders(const fs::path& folder) {
    std::vector<fs::path> result;
    std::error_code failure;
    fs::directory_iterator entry(folder, failure);
    for (; !failure && entry != fs::directory_iterator(); entry.increment(failure)) {
      std::error_code ignored;
      if (entry->is_directory(ignored)) {
        result.push_back(entry->path());
      }
    }
    if (failure) {
      note(folder, failure);
    }
    std::ranges::sort(result);
    return result;
  }

  void look_into(const fs::path& folder) {
    if (found_.file) {
      return;
    }
    const fs::path file = folder / file_name_;
    std::error_code failure;
    const fs::file_status status = fs::status(file, failure);
    std::error_code ignored;
    if (fs::is_regular_file(status)) {
      found_.file = file;
    } else if (failure == std::errc::permission_denied) {
      note(folder, failure);
    } else if (fs::is_directory(status)) {
      note(file.string() + " is a folder");
    } else if (fs::exists(status)) {
      note(file.string() + " is not a regular file");
    } else if (fs::is_symlink(fs::symlink_status(file, ignored))) {
      note(file.string() + " is a broken link");
    }
  }

  std::string file_name_;
  FileSearch found_;
};

}  // namespace

bool is_called_like_scene(const fs::path& file) {
  return std::ranges::find(scene_extensions, lower_case_extension(file)) != scene_extensions.end();
}

FileSearch search_folder(const fs::path& folder, const std::string& file_name) {
  Searcher searcher(file_name);
  searcher.search(folder);
  return std::move(searcher).result();
}

FileSearch search_scene_path(const std::string& file_name) {
  Searcher searcher(file_name);
  for (const fs::path& folder : scene_path()) {
    searcher.search(folder);
  }
  std::error_code nothing_was_fetched;
  if (fs::symlink_status(fetched_folder(), nothing_was_fetched).type() !=
      fs::file_type::not_found) {
    searcher.search(fetched_folder());
  }
  return std::move(searcher).result();
}

fs::path fetched_folder() { return data_folder() / "scenes"; }

std::string in_brackets(const std::vector<std::string>& obstacles) {
  return obstacles.empty() ? "" : fmt::format(" ({})", fmt::join(obstacles, "; "));
}

}  // namespace foveola::scenes
