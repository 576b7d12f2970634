#include "study/record/same_scenes.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "study/record/database.h"
#include "study/record/shown_scene.h"

namespace fs = std::filesystem;

namespace foveola::study {

namespace {

Error another_scene(const fs::path& database, const std::string& what) {
  return {database.string(), "its sessions saw " + what,
          "go on with what they saw, or begin a new database"};
}

/// Throws Error unless a session saw the scene as it is `now`.
void require_same(const fs::path& database, const ShownScene& now, const std::string& file_sha256,
                  const std::string& shown_as) {
  if (file_sha256 != now.sha256) {
    throw another_scene(database, fmt::format("another file as {} (SHA-256 {}, now {})", now.name,
                                              file_sha256, now.sha256));
  }
  const std::string other = difference(shown_as, now.shown_as);
  if (!other.empty()) {
    throw another_scene(database, fmt::format("{} in another way ({})", now.name, other));
  }
}

}  // namespace

void require_same_scenes(const fs::path& database, const std::vector<ShownScene>& scenes) {
  with_clear_errors(database, [&] {
    SQLite::Database study = open_study_to_read(database);
    SQLite::Statement shown(
        study, "SELECT DISTINCT file_sha256, shown_as FROM session_scene WHERE scene = ?");
    for (const ShownScene& scene : scenes) {
      shown.reset();
      shown.bind(1, scene.name);
      while (shown.executeStep()) {
        require_same(database, scene, shown.getColumn(0).getString(),
                     shown.getColumn(1).getString());
      }
    }
  });
}

}  // namespace foveola::study
