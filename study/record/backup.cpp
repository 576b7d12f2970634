#include <SQLiteCpp/SQLiteCpp.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "study/record/database.h"
#include "study/record/maintenance.h"
#include "study/record/temporary_database.h"

namespace fs = std::filesystem;

namespace foveola::study {

fs::path backup_folder(const fs::path& study) { return study.string() + ".backups"; }

std::vector<fs::path> backups_of(const fs::path& study) {
  std::vector<fs::path> backups;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(backup_folder(study), ignored)) {
    const fs::path& file = entry.path();
    if (entry.is_regular_file() && file.extension() == ".sqlite" &&
        !file.filename().string().starts_with('.')) {
      backups.push_back(file);
    }
  }
  return backups;
}

fs::path new_backup(const fs::path& study) {
  const fs::path folder = backup_folder(study);
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) {
    throw Error(folder.string(), "cannot be made: " + failure.message(),
                "check the permissions of the folder above it");
  }
  sync_to_disk(folder_of(folder));  // else the folder could go, and every backup with it
  fs::path path;
  do {
    path = folder / (date_in_file_name() + ".sqlite");
  } while (fs::exists(path));
  return path;
}

fs::path back_up_study(const fs::path& study) {
  fs::path path;
  with_clear_errors(study, [&] {
    require_study(study);
    SQLite::Database database = open_as_it_is(study);
    path = new_backup(study);
    copy_checked(database, path);
  });
  return path;
}

}  // namespace foveola::study
