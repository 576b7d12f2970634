#include "study/record/setup/same_scenes.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "study/record/setup/shown_scene.h"
#include "study/record/sqlite/database.h"

namespace fs = std::filesystem;

namespace foveola::study {

namespace {

/// What a session of `version` saw. Built-in scenes may change with versions.
struct SeenScene {
  std::string file_sha256;
  std::string shown_as;
  std::string version;
};

Error another_scene(const fs::path& database, const SeenScene& seen, const std::string& what) {
  return {database.string(), "its sessions saw " + what,
          fmt::format("continue with what they saw in Foveola {}, or begin a new database",
                      seen.version)};
}

/// Throws Error unless a session saw the scene as it is `now`.
void require_same(const fs::path& database, const ShownScene& now, const SeenScene& seen) {
  if (seen.file_sha256 != now.sha256) {
    throw another_scene(database, seen,
                        fmt::format("another file as {} (SHA-256 {}, now {})", now.name,
                                    seen.file_sha256, now.sha256));
  }
  const std::string other = difference(seen.shown_as, now.shown_as);
  if (!other.empty()) {
    throw another_scene(database, seen, fmt::format("{} in another way ({})", now.name, other));
  }
}

}  // namespace

void require_same_scenes(const fs::path& database, const std::vector<ShownScene>& scenes) {
  with_clear_errors(database, [&] {
    SQLite::Database study = open_study_to_read(database);
    SQLite::Statement shown(
        study,
        "SELECT DISTINCT file_sha256, shown_as, program_version FROM session_scene "
        "JOIN session ON session.id = session_scene.session WHERE scene = ?");
    for (const ShownScene& scene : scenes) {
      shown.reset();
      shown.bind(1, scene.name);
      while (shown.executeStep()) {
        require_same(database, scene,
                     {.file_sha256 = shown.getColumn(0).getString(),
                      .shown_as = shown.getColumn(1).getString(),
                      .version = shown.getColumn(2).getString()});
      }
    }
  });
}

}  // namespace foveola::study
