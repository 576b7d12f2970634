#include "study/record/setup/same_protocol.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "study/protocol/amendment.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

/// Throws Error if the protocol differs in more than words and time-outs.
Amendment amendment_of(const std::string& begun_with, const fs::path& path,
                       const Protocol& protocol) {
  ProtocolChanges changes = changes_between(begun_with, protocol.text, protocol.path);
  if (!changes.of_design.empty()) {
    throw Error(path.string(),
                fmt::format("was begun with another design than {}: {} differ",
                            protocol.path.string(), fmt::join(changes.of_design, ", ")),
                "only words and time-outs can be amended; begin a new file");
  }
  return {.sha256 = protocol.sha256,
          .changed = std::move(changes.of_words_and_times),
          .text = protocol.text};
}

std::optional<Amendment> require_protocol(SQLite::Database& database, const fs::path& path,
                                          const Protocol& protocol, OtherProtocol other) {
  SQLite::Statement study(database, "SELECT protocol_sha256, protocol_text FROM study");
  study.executeStep();
  if (study.getColumn(0).getString() == protocol.sha256) {
    return std::nullopt;
  }
  if (other == OtherProtocol::refuse) {
    throw Error(path.string(),
                fmt::format("was begun with another protocol than {}", protocol.path.string()),
                "use the protocol it was begun with, or a new file; where only words or time-outs "
                "have changed, study run takes --amended-protocol");
  }
  return amendment_of(study.getColumn(1).getString(), path, protocol);
}

/// One file a method for the whole of a study: results on two would be taken for one.
void require_method_files(SQLite::Database& database, const fs::path& path,
                          const Protocol& protocol) {
  SQLite::Statement known(
      database, "SELECT file_sha256 FROM study_method_file WHERE method = ? AND file_name = ?");
  for (const MethodFile& file : protocol.method_files) {
    known.reset();
    SQLite::bind(known, file.method, file.file);
    const std::string begun_with = known.executeStep() ? known.getColumn(0).getString() : "none";
    if (begun_with != file.sha256) {
      throw Error(path.string(),
                  fmt::format("was begun with another file as {} (SHA-256 {}, now {})", file.file,
                              begun_with, file.sha256),
                  "go on with that file, or begin a new database");
    }
  }
}

/// Throws Error if a questionnaire's file differs in more than words.
void amend_questionnaire(const std::string& begun_with, const fs::path& path,
                         const NamedProfile& file, Amendment& amendment) {
  const ProtocolChanges changes = changes_of_questionnaire(begun_with, file.toml, file.name);
  if (!changes.of_design.empty()) {
    throw Error(path.string(),
                fmt::format("was begun with other questions: {} differ",
                            fmt::join(changes.of_design, ", ")),
                "only words can be amended; begin a new file");
  }
  amendment.changed.insert(amendment.changed.end(), changes.of_words_and_times.begin(),
                           changes.of_words_and_times.end());
  amendment.files.emplace(file.name, file.toml);
}

/// Throws Error unless both have the same display, the same tracker and the same questions, but for
/// their words if these may be amended.
void require_profiles(SQLite::Database& database, const fs::path& path, const Protocol& protocol,
                      OtherProtocol other, std::optional<Amendment>& amendment) {
  SQLite::Statement known(database, "SELECT toml FROM study_profile WHERE device = ? AND name = ?");
  for (const NamedProfile& profile : named_profiles(protocol)) {
    known.reset();
    SQLite::bind(known, profile.device, profile.name);
    const bool is_known = known.executeStep();
    if (is_known && known.getColumn(0).getString() == profile.toml) {
      continue;
    }
    const bool has_words = is_known && profile.device == "questionnaire";
    if (!has_words || other == OtherProtocol::refuse) {
      throw Error(path.string(),
                  fmt::format("was begun with another {} than {}, as its file is now",
                              profile.device, profile.name),
                  has_words
                      ? "use the file it was begun with, or a new database; where only words have "
                        "changed, study run takes --amended-protocol"
                      : "go on with that profile, or begin a new database");
    }
    if (!amendment) {
      amendment = Amendment{.sha256 = protocol.sha256, .changed = {}, .text = protocol.text};
    }
    amend_questionnaire(known.getColumn(0).getString(), path, profile, *amendment);
  }
}

}  // namespace

std::optional<Amendment> require_same_protocol(SQLite::Database& database, const fs::path& path,
                                               const Protocol& protocol, OtherProtocol other) {
  std::optional<Amendment> amendment = require_protocol(database, path, protocol, other);
  require_method_files(database, path, protocol);
  require_profiles(database, path, protocol, other, amendment);
  return amendment;
}

}  // namespace foveola::study
