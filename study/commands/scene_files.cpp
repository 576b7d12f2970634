#include "study/commands/scene_files.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "study/record/database.h"

namespace fs = std::filesystem;

namespace foveola::study {

void require_same_files(const fs::path& database, const std::vector<ShownScene>& scenes) {
  with_clear_errors(database, [&] {
    SQLite::Database study = open_study_to_read(database);
    SQLite::Statement shown(
        study, "SELECT file_sha256 FROM session_scene WHERE scene = ? AND file_sha256 <> ?");
    for (const ShownScene& scene : scenes) {
      shown.reset();
      shown.bind(1, scene.name);
      shown.bind(2, scene.sha256);
      if (shown.executeStep()) {
        throw Error(database.string(),
                    fmt::format("its sessions saw another file as {} (SHA-256 {}, now {})",
                                scene.name, shown.getColumn(0).getString(), scene.sha256),
                    "go on with that file, or begin a new database");
      }
    }
  });
}

}  // namespace foveola::study
