#include "study/record/study_store.h"

#include <array>
#include <random>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include "renderer/base/digest.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "study/record/database.h"
#include "study/record/event_rows.h"
#include "study/record/frame_encoding.h"
#include "study/record/gaze_encoding.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

const char* name_of(SessionKind kind) {
  constexpr std::array names = {"human", "pilot", "simulated"};
  return names.at(static_cast<std::size_t>(kind));
}

/// A random UUID (RFC 4122, section 4.4), so that the records of several sites can be merged.
std::string random_uuid() {
  std::random_device device;
  std::array<std::uint32_t, 4> words{};
  for (std::uint32_t& word : words) {
    word = device();
  }
  constexpr std::uint32_t version_4 = 0x4000;
  constexpr std::uint32_t variant_1 = 0x8000;
  return fmt::format("{:08x}-{:04x}-{:04x}-{:04x}-{:04x}{:08x}", words[0], words[1] >> 16U,
                     version_4 | (words[1] & 0x0FFFU), variant_1 | ((words[2] >> 16U) & 0x3FFFU),
                     words[2] & 0xFFFFU, words[3]);
}

void require_protocol(SQLite::Database& database, const fs::path& path, const Protocol& protocol) {
  if (database.execAndGet("SELECT protocol_sha256 FROM study").getString() != protocol.sha256) {
    throw Error(path.string(),
                fmt::format("was begun with another protocol than {}", protocol.path.string()),
                "use the protocol it was begun with, or a new file");
  }
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

/// Likewise, one display and one tracker.
void require_profiles(SQLite::Database& database, const fs::path& path, const Protocol& protocol) {
  SQLite::Statement known(database, "SELECT toml_sha256 FROM study_profile WHERE device = ?");
  for (const NamedProfile& profile : named_profiles(protocol)) {
    known.reset();
    known.bind(1, profile.device);
    if (!known.executeStep() || known.getColumn(0).getString() != sha256(profile.toml)) {
      throw Error(path.string(),
                  fmt::format("was begun with another {} than {}, as its profile is now",
                              profile.device, profile.name),
                  "go on with that profile, or begin a new database");
    }
  }
}

/// The study at `path`, made or checked, to write.
SQLite::Database open_study(const fs::path& path, const Protocol& protocol) {
  require_writable(path);
  if (!fs::exists(path)) {
    create_study(path, protocol);
  }
  SQLite::Database checked = open_study_to_read(path);
  require_protocol(checked, path, protocol);
  require_method_files(checked, path, protocol);
  require_profiles(checked, path, protocol);
  return open_study_to_write(path);
}

bool has_session_of(SQLite::Database& database, const std::string& participant) {
  SQLite::Statement found(database, "SELECT 1 FROM session WHERE participant = ?");
  found.bind(1, participant);
  return found.executeStep();
}

std::int64_t insert_session(SQLite::Database& database, const SessionFacts& facts) {
  SQLite::Statement session(database,
                            "INSERT INTO session VALUES"
                            " (NULL, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, 'created')");
  SQLite::bind(session, random_uuid(), facts.participant, name_of(facts.kind),
               std::to_string(facts.seed), utc_now(), facts.build.version, facts.build.compiler,
               facts.build.build_type, facts.machine.processor, facts.machine.cores,
               facts.machine.system);
  session.exec();
  return database.getLastInsertRowid();
}

void insert_scenes(SQLite::Database& database, std::int64_t session,
                   const std::vector<ShownScene>& scenes) {
  for (const ShownScene& scene : scenes) {
    SQLite::Statement row(database, "INSERT INTO session_scene VALUES (?, ?, ?, ?, ?)");
    SQLite::bind(row, session, scene.name, scene.file_name, scene.sha256, scene.shown_as);
    row.exec();
  }
}

void insert_plan(SQLite::Database& database, std::int64_t session, const Plan& plan) {
  for (std::size_t i = 0; i < plan.size(); ++i) {
    SQLite::Statement row(database, "INSERT INTO planned_trial VALUES (?, ?, ?, ?, ?, ?)");
    SQLite::bind(row, session, static_cast<std::int64_t>(i), plan[i].scene, plan[i].method,
                 plan[i].scene_position, plan[i].method_position);
    row.exec();
  }
}

/// What is kept of an attempt in large numbers.
struct Chunk {
  const char* table;  ///< of one chunk a row
  const char* encoding;
  std::uint64_t first;  ///< counted from the attempt's start
  std::size_t count;
  std::string data;
};

void insert_chunk(SQLite::Database& database, std::int64_t session, std::size_t trial, int attempt,
                  const Chunk& chunk) {
  SQLite::Statement row(database,
                        fmt::format("INSERT INTO {} VALUES (?, ?, ?, ?, ?, ?, ?, ?)", chunk.table));
  SQLite::bind(row, session, static_cast<std::int64_t>(trial), attempt,
               static_cast<std::int64_t>(chunk.first), static_cast<std::int64_t>(chunk.count),
               chunk.encoding);
  row.bind(7, chunk.data.data(), static_cast<int>(chunk.data.size()));
  row.bind(8, sha256(chunk.data));
  row.exec();
}

}  // namespace

struct StudyStore::Implementation {
  Implementation(const fs::path& path_in, const Protocol& protocol)
      : path(path_in), database(open_study(path_in, protocol)) {}

  /// Runs `work`; all of it is on the disk when this returns, or none if it throws.
  void commit(const std::function<void()>& work) {
    with_clear_errors(path, [&] {
      SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
      work();
      transaction.commit();
    });
  }

  fs::path path;
  SQLite::Database database;
};

StudyStore::StudyStore(const fs::path& path, const Protocol& protocol) {
  with_clear_errors(path,
                    [&] { implementation_ = std::make_unique<Implementation>(path, protocol); });
}

StudyStore::~StudyStore() {
  // If this fails, the log stays beside the file, and whoever opens the study next reads both.
  implementation_->database.tryExec("PRAGMA wal_checkpoint(TRUNCATE)");
}

bool StudyStore::has_participant(const std::string& code) const {
  bool found = false;
  with_clear_errors(implementation_->path,
                    [&] { found = has_session_of(implementation_->database, code); });
  return found;
}

std::int64_t StudyStore::begin_session(const SessionFacts& facts, const Plan& plan) {
  std::int64_t session = 0;
  SQLite::Database& database = implementation_->database;
  implementation_->commit([&] {
    if (has_session_of(database, facts.participant)) {
      throw Error(implementation_->path.string(),
                  fmt::format("participant {} already has a session", facts.participant),
                  "choose another code");
    }
    session = insert_session(database, facts);
    insert_scenes(database, session, facts.scenes);
    insert_plan(database, session, plan);
  });
  return session;
}

void StudyStore::record_event(std::int64_t session, Nanoseconds time, const Event& event,
                              const SessionState& before, const SessionState& after) {
  implementation_->commit(
      [&] { insert_event_rows(implementation_->database, session, time, event, before, after); });
}

void StudyStore::record_frames(std::int64_t session, std::size_t trial, int attempt,
                               std::uint64_t first_frame, const std::vector<FrameRow>& frames) {
  const Chunk chunk{.table = "frame_chunk",
                    .encoding = frame_encoding_name,
                    .first = first_frame,
                    .count = frames.size(),
                    .data = encode_frames(frames)};
  implementation_->commit(
      [&] { insert_chunk(implementation_->database, session, trial, attempt, chunk); });
}

void StudyStore::record_gaze(std::int64_t session, std::size_t trial, int attempt,
                             std::uint64_t first_sample, const std::vector<GazeSample>& samples) {
  const Chunk chunk{.table = "gaze_chunk",
                    .encoding = gaze_encoding_name,
                    .first = first_sample,
                    .count = samples.size(),
                    .data = encode_gaze(samples)};
  implementation_->commit(
      [&] { insert_chunk(implementation_->database, session, trial, attempt, chunk); });
}

}  // namespace foveola::study
