#include "study/person/session_copies.h"

#include <algorithm>
#include <cstdio>
#include <exception>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/files/file_access.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/print.h"
#include "renderer/base/text/utf8.h"
#include "renderer/base/toml/toml_file.h"
#include "study/record/maintain/maintenance.h"
#include "study/record/setup/amendment_note.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

/// Name and consent of a protocol, from its text.
struct ShownProtocol {
  std::string name;
  std::string title;
  std::string consent;
  std::string sha256;
};

ShownProtocol shown_protocol(const std::string& text) {
  const toml::table table = parse_toml("the study's protocol", text, "restore the study's file");
  return {.name = table["name"].value_or(std::string()),
          .title = table["title"].value_or(std::string()),
          .consent = table["texts"]["consent"].value_or(std::string()),
          .sha256 = sha256(std::string_view(text))};
}

/// shown: the study's protocol and the amendments up to the consent. Older records do not name the
/// text that was agreed to; the last one is taken for them.
std::string consent_part(const std::vector<ShownProtocol>& shown, const ConsentGiven& consent) {
  const auto agreed_to =
      std::find_if(shown.rbegin(), shown.rend(), [&](const ShownProtocol& protocol) {
        return consent.text_sha256.empty() || sha256(protocol.consent) == consent.text_sha256;
      });
  if (agreed_to == shown.rend()) {
    return fmt::format("The text, of SHA-256 {}, is not in the session's log.\n",
                       consent.text_sha256);
  }
  return fmt::format("{}\n\nProtocol {}, SHA-256 {}\n", agreed_to->consent, agreed_to->name,
                     agreed_to->sha256);
}

}  // namespace

std::optional<std::string> consent_receipt(const std::string& begun_with,
                                           const std::string& participant,
                                           const std::vector<LoggedEvent>& events) {
  std::vector<ShownProtocol> shown = {shown_protocol(begun_with)};
  std::string consents;
  for (const LoggedEvent& logged : events) {
    if (const auto* note = std::get_if<NoteWritten>(&logged.event)) {
      if (const std::optional<Amendment> amendment = amendment_in(note->text)) {
        shown.push_back(shown_protocol(amendment->text));
      }
    } else if (const auto* consent = std::get_if<ConsentGiven>(&logged.event)) {
      consents += fmt::format("{}Agreed to by participant {} at {} (UTC).\n\n",
                              consent_part(shown, *consent), participant, logged.utc);
    }
  }
  if (consents.empty()) {
    return std::nullopt;
  }
  return fmt::format(
      "{}\n\n{}The study knows you by this code alone. You may ask the experimenter at any time to "
      "delete what was recorded under it.\n",
      shown.front().title, consents);
}

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
