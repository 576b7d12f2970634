#include <functional>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "study/record/maintain/maintenance.h"
#include "study/record/sqlite/database.h"
#include "study/record/sqlite/temporary_database.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

fs::path back_up(const fs::path& study, const std::function<fs::path()>& new_name) {
  fs::path path;
  with_clear_errors(study, [&] {
    require_study(study);
    SQLite::Database database = open_as_it_is(study);
    path = new_name();
    copy_checked(database, path);
  });
  return path;
}

}  // namespace

fs::path backup_folder(const fs::path& study) { return study.string() + ".backups"; }

std::vector<fs::path> backups_of(const fs::path& study) {
  std::vector<fs::path> backups;
  std::error_code ignored;
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(backup_folder(study), ignored)) {
    const fs::path& file = entry.path();
    if (entry.is_regular_file() && file.extension() == ".sqlite" &&
        !file.filename().string().starts_with('.')) {
      backups.push_back(file);
    }
  }
  return backups;
}

fs::path new_backup_in(const fs::path& folder, const fs::path& study) {
  fs::path path;
  do {
    path = folder / fmt::format("{}.{}.sqlite", study.stem().string(), date_in_file_name());
  } while (fs::exists(path));
  return path;
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
  return back_up(study, [&] { return new_backup(study); });
}

fs::path back_up_study_to(const fs::path& folder, const fs::path& study) {
  return back_up(study, [&] { return new_backup_in(folder, study); });
}

bool is_on_disk_of(const fs::path& folder, const fs::path& study) {
  struct stat of_folder{};
  struct stat of_study{};
  return ::stat(folder.c_str(), &of_folder) == 0 &&
         ::stat(folder_of(study).c_str(), &of_study) == 0 && of_folder.st_dev == of_study.st_dev;
}

}  // namespace foveola::study
