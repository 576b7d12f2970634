#include "study/person/session_copies.h"

#include <cstdio>
#include <exception>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/file_access.h"
#include "renderer/base/files/files.h"
#include "renderer/base/print.h"
#include "renderer/base/utf8.h"
#include "study/person/consent_receipt.h"
#include "study/record/maintenance.h"

namespace fs = std::filesystem;

namespace foveola::study {

void write_receipt(const RunSettings& settings, const StudyStore& store) {
  if (!settings.receipt) {
    return;
  }
  for (const KnownSession& session : store.sessions()) {
    if (session.participant == settings.participant) {
      if (const auto receipt = consent_receipt(store.protocol_text(), settings.participant,
                                               store.events_of(session.id))) {
        write_file(*settings.receipt, *receipt, FileAccess::own);
      }
    }
  }
}

fs::path copy_if_asked(const StudyStore& store, const RunSettings& settings) {
  if (!settings.backup_folder) {
    return {};
  }
  try {
    fs::path copy = new_backup_in(*settings.backup_folder, settings.database);
    store.back_up(copy);
    return copy;
  } catch (const std::exception& fault) {
    print_text(stderr, "foveola: warning: {}\n",
               printable(fmt::format("{}: no copy of {} was written ({}); mend that, then "
                                     "run foveola study backup --to",
                                     settings.backup_folder->string(), settings.database.string(),
                                     fault.what())));
    return {};
  }
}

fs::path back_up(const StudyStore& store, const RunSettings& settings) {
  fs::path backup;
  try {
    backup = new_backup(settings.database);
    store.back_up(backup);
  } catch (const std::exception& fault) {
    throw Error(fmt::format("all that {} did is in {}, but its backup failed", settings.participant,
                            settings.database.string()),
                fault.what(), "mend that, then run foveola study backup");
  }
  return backup;
}

}  // namespace foveola::study
