#include "tests/fuzz/study_input.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <zlib.h>

#include "analysis/dataset/study_tables.h"
#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"
#include "study/record/log/chunk.h"
#include "study/record/log/encodings.h"
#include "study/record/log/event_log.h"
#include "study/record/log/hash_chain.h"
#include "study/record/maintain/maintenance.h"
#include "study/record/read/data_quality_records.h"
#include "study/record/read/recorded_frames.h"
#include "study/record/read/recorded_gaze.h"
#include "study/record/read/recorded_session.h"
#include "study/record/read/study_records.h"
#include "study/record/schema.h"
#include "study/record/sqlite/prepared_statements.h"
#include "study/record/verify/verification_json.h"
#include "study/record/write/study_store.h"
#include "study/tables/session_summary.h"
#include "tests/study/record/small_study.h"
#include "tests/temporary_folder.h"

namespace foveola::test {
namespace fs = std::filesystem;
namespace {

constexpr unsigned makes_hashes_anew = 1;
constexpr unsigned changes_bytes = 2;

constexpr const char* devices = R"({"display":{"horizontal_fov_deg":100,"vertical_fov_deg":80,)"
                                R"("lens":[0.1,0.2,0.05,0.01]},"tracker":{"profile":"camera"},)"
                                R"("simulation":{"scale":1.0,"predicted":false,)"
                                R"("injected":"none","people_sha256":""}})";
constexpr const char* shown_as =
    R"({"camera":{"position":[0,1.5,0],"azimuth_rad":0,"elevation_rad":0},"exposure_stops":0,)"
    R"("objects":[{"name":"vase","position":[0.5,1,-2],"radius_deg":4}],"added":{}})";

void seal_texts(SQLite::Database& study) {
  for (const auto& [table, text] : {std::pair("study", "protocol"), {"study_profile", "toml"}}) {
    const std::string column = table == std::string("study") ? "protocol_text" : text;
    SQLite::Statement rows(study, fmt::format("SELECT rowid, {} FROM {}", column, table));
    while (rows.executeStep()) {
      SQLite::Statement seal(
          study, fmt::format("UPDATE {} SET {}_sha256 = ? WHERE rowid = ?", table, text));
      SQLite::bind(seal, sha256(rows.getColumn(1).getString()), rows.getColumn(0).getInt64());
      seal.exec();
    }
  }
}

/// The bytes of a chunk; empty if it is none any more.
std::string inflated(const std::string& data) {
  std::string bytes(std::size_t{1} << 16, '\0');
  uLongf size = bytes.size();
  const int result = ::uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                                  reinterpret_cast<const Bytef*>(data.data()), data.size());
  bytes.resize(result == Z_OK ? size : 0);
  return bytes;
}

void seal_chunks(SQLite::Database& study) {
  for (const char* table : {"frame_chunk", "gaze_chunk"}) {
    SQLite::Statement rows(study, fmt::format("SELECT rowid AS row, {} FROM {}",
                                              study::columns_of_chunk(study, table), table));
    while (rows.executeStep()) {
      const study::StoredChunk chunk = study::stored_chunk(rows);
      SQLite::Statement seal(study,
                             fmt::format("UPDATE {} SET data_sha256 = ? WHERE rowid = ?", table));
      SQLite::bind(seal, sha256(chunk.place + inflated(chunk.data)),
                   rows.getColumn("row").getInt64());
      seal.exec();
    }
  }
}

void seal_films(SQLite::Database& study) {
  SQLite::Statement rows(study,
                         "SELECT film_hash.rowid, uuid, trial, attempt, frame, film_sha256"
                         " FROM film_hash JOIN session ON session.id = session");
  while (rows.executeStep()) {
    SQLite::Statement seal(study, "UPDATE film_hash SET row_sha256 = ? WHERE rowid = ?");
    SQLite::bind(
        seal,
        study::film_row_sha256(rows.getColumn(1).getString(), rows.getColumn(2).getInt64(),
                               rows.getColumn(3).getInt(),
                               {.frame = static_cast<std::uint64_t>(rows.getColumn(4).getInt64()),
                                .sha256 = rows.getColumn(5).getString()}),
        rows.getColumn(0).getInt64());
    seal.exec();
  }
}

void seal_events(SQLite::Database& study) {
  study::PreparedStatements statements(study);
  SQLite::Statement sessions(study, "SELECT id FROM session");
  while (sessions.executeStep()) {
    const std::int64_t session = sessions.getColumn(0).getInt64();
    std::string hash = study::hash_before_events(statements, session);
    SQLite::Statement events(
        study, "SELECT rowid AS row, * FROM event WHERE session = ? ORDER BY sequence");
    events.bind(1, session);
    while (events.executeStep()) {
      study::LogLine line = study::log_line(events, study::study_schema_version);
      if (!line.measured.empty()) {
        line.measured = study::measured_in(statements, session, line.trial.value_or(0),
                                           line.attempt.value_or(0));
      }
      hash = study::hash_of(hash, line, study::study_schema_version);
      SQLite::Statement seal(
          study, "UPDATE event SET hash = ?1, measured = nullif(?2, '') WHERE rowid = ?3");
      SQLite::bind(seal, hash, line.measured, events.getColumn("row").getInt64());
      seal.exec();
    }
  }
}

/// Whoever changes a file can make its hashes hold, except for values of which no hash can be made:
/// a BLOB in a JSON array.
void seal(SQLite::Database& study) {
  for (void (*seal_part)(SQLite::Database&) : {seal_texts, seal_chunks, seal_films, seal_events}) {
    try {
      seal_part(study);
    } catch (const SQLite::Exception&) {
      continue;
    }
  }
}

struct ColumnName {
  std::string table;
  std::string column;
};

/// A study of two sessions in which everything happens, and the same without what keeps values from
/// being changed.
class SmallStudy {
 public:
  SmallStudy() {
    const TemporaryFolder folder;
    const fs::path path = folder / "study.sqlite";
    {
      study::StudyStore store(path, study::thorough_protocol(), study::OtherProtocol::refuse,
                              study::RecordDates::virtual_time);
      study::run_thorough_session(store, "P01");
      study::run_thorough_session(
          store, "P02",
          study::QuestionnaireAnswered{.questionnaire = "debrief",
                                       .answers = {{.question = "sickness", .value = 2.0},
                                                   {.question = "comments", .value = "none"}}});
    }
    SQLite::Database study(path, SQLite::OPEN_READWRITE);
    study.execAndGet("PRAGMA journal_mode = DELETE");
    loosen(study);
    SQLite::Statement facts(study, "UPDATE session SET devices = ?");
    SQLite::bind(facts, devices);
    facts.exec();
    SQLite::Statement scenes(study, "UPDATE session_scene SET shown_as = ?");
    SQLite::bind(scenes, shown_as);
    scenes.exec();
    seal(study);
    loose_ = read_file(path);
    read_columns(study);
  }

  const std::string& loose_bytes() const { return loose_; }
  const std::vector<ColumnName>& columns() const { return columns_; }

  /// Brings back what loosen() took.
  void tighten(SQLite::Database& study) const {
    study.exec("PRAGMA writable_schema = ON");
    for (const auto& [name, sql] : tables_) {
      SQLite::Statement table(study, "UPDATE sqlite_schema SET sql = ? WHERE name = ?");
      SQLite::bind(table, sql, name);
      table.exec();
    }
    study.exec("PRAGMA writable_schema = RESET");
    for (const std::string& sql : triggers_) {
      study.exec(sql);
    }
  }

 private:
  void loosen(SQLite::Database& study) {
    SQLite::Statement objects(study,
                              "SELECT type, name, sql FROM sqlite_schema"
                              " WHERE type = 'trigger' OR sql GLOB '*) STRICT'");
    while (objects.executeStep()) {
      if (objects.getColumn(0).getString() == "trigger") {
        triggers_.push_back(objects.getColumn(2).getString());
      } else {
        tables_[objects.getColumn(1).getString()] = objects.getColumn(2).getString();
      }
    }
    objects.reset();
    study.exec(
        "PRAGMA writable_schema = ON;"
        " DELETE FROM sqlite_schema WHERE type = 'trigger';"
        " UPDATE sqlite_schema SET sql = replace(sql, ') STRICT', ')');"
        " PRAGMA writable_schema = RESET");
  }

  void read_columns(SQLite::Database& study) {
    SQLite::Statement rows(study,
                           "SELECT object.name, info.name FROM sqlite_schema AS object"
                           " JOIN pragma_table_info(object.name) AS info"
                           " WHERE object.type = 'table' ORDER BY 1, info.cid");
    while (rows.executeStep()) {
      columns_.push_back({rows.getColumn(0).getString(), rows.getColumn(1).getString()});
    }
  }

  std::map<std::string, std::string> tables_;
  std::vector<std::string> triggers_;
  std::string loose_;
  std::vector<ColumnName> columns_;
};

/// Puts bytes into others, at a place that the input names.
std::string spliced(std::string bytes, Bytes& input) {
  const std::size_t place = take_number(input, 2) % (bytes.size() + 1);
  const std::size_t replaced = take_number(input, 1);
  const Bytes more = take(input, take_number(input, 1));
  return bytes.replace(place, replaced, {reinterpret_cast<const char*>(more.data()), more.size()});
}

/// A place in a study whose value is changed.
class Cell {
 public:
  Cell(SQLite::Database& study, const ColumnName& where, std::uint64_t row)
      : study_(study), where_(where) {
    SQLite::Statement rows(study, fmt::format("SELECT rowid, {0} FROM {1} LIMIT 1 OFFSET"
                                              " ? % (SELECT max(1, count(*)) FROM {1})",
                                              where.column, where.table));
    SQLite::bind(rows, static_cast<std::int64_t>(row));
    is_there_ = rows.executeStep();
    if (is_there_) {
      row_ = rows.getColumn(0).getInt64();
      value_ = rows.getColumn(1).getString();
    }
  }

  void change(Bytes& input) {
    const std::uint64_t kind = take_number(input, 1);
    if (!is_there_) {
      return;
    }
    if (kind == 0) {
      set(static_cast<std::int64_t>(take_number(input, 8)));
    } else if (kind == 1) {
      set(std::bit_cast<double>(take_number(input, 8)));
    } else if (kind == 2 || kind == 3) {
      const Bytes bytes = take(input, take_number(input, 1));
      set_bytes({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, kind == 3);
    } else if (kind == 4) {
      set(nullptr);
    } else if (where_.column == "data") {
      set_chunk(spliced(inflated(value_), input));
    } else {
      set_bytes(spliced(value_, input), false);
    }
  }

 private:
  SQLite::Statement update() const {
    return {study_,
            fmt::format("UPDATE {} SET {} = ?2 WHERE rowid = ?1", where_.table, where_.column)};
  }
  template <typename Value>
  void set(const Value& value) const {
    SQLite::Statement row = update();
    row.bind(1, row_);
    if constexpr (std::is_same_v<Value, std::nullptr_t>) {
      row.bind(2);
    } else {
      row.bind(2, value);
    }
    execute(row);
  }
  void set_bytes(const std::string& bytes, bool is_blob) const {
    SQLite::Statement row = update();
    row.bind(1, row_);
    if (is_blob) {
      row.bind(2, bytes.data(), static_cast<int>(bytes.size()));
    } else {
      row.bind(2, bytes);
    }
    execute(row);
  }
  /// With a number of records that holds.
  void set_chunk(const std::string& bytes) const {
    const bool is_gaze = where_.table == "gaze_chunk";
    const std::int64_t each =
        is_gaze ? study::bytes_per_gaze_sample : study::bytes_per_frame(study::frame_encoding_name);
    std::string data(::compressBound(bytes.size()), '\0');
    uLongf size = data.size();
    ::compress(reinterpret_cast<Bytef*>(data.data()), &size,
               reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    data.resize(size);
    SQLite::Statement row(
        study_, fmt::format("UPDATE {} SET data = ?, {} = ? WHERE rowid = ?", where_.table,
                            is_gaze ? "sample_count" : "frame_count"));
    row.bind(1, data.data(), static_cast<int>(data.size()));
    row.bind(2, std::ssize(bytes) / each);
    row.bind(3, row_);
    execute(row);
  }
  /// What a key forbids is left out.
  static void execute(SQLite::Statement& row) {
    try {
      row.exec();
    } catch (const SQLite::Exception&) {
      row.tryReset();
    }
  }

  SQLite::Database& study_;
  ColumnName where_;
  bool is_there_ = false;
  std::int64_t row_ = 0;
  std::string value_;
};

void write_changed_study(const fs::path& path, Bytes input) {
  static const SmallStudy small;
  const std::uint64_t how = take_number(input, 1);
  std::string bytes = small.loose_bytes();
  std::ofstream(path, std::ios::binary) << bytes;
  {
    SQLite::Database study(path, SQLite::OPEN_READWRITE);
    study.exec(
        "PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF;"
        " PRAGMA ignore_check_constraints = ON; BEGIN");
    while ((how & changes_bytes) == 0 && !input.empty()) {
      const ColumnName& where = small.columns()[take_number(input, 1) % small.columns().size()];
      Cell(study, where, take_number(input, 1)).change(input);
    }
    if ((how & makes_hashes_anew) != 0) {
      seal(study);
    }
    study.exec("COMMIT");
    small.tighten(study);
  }
  if ((how & changes_bytes) != 0) {
    bytes = read_file(path);
    while (!input.empty()) {
      const std::size_t place = take_number(input, 3) % bytes.size();
      const Bytes more = take(input, take_number(input, 1));
      std::copy_n(more.begin(), std::min(more.size(), bytes.size() - place),
                  bytes.begin() + static_cast<std::ptrdiff_t>(place));
    }
    std::ofstream(path, std::ios::binary) << bytes;
  }
}

/// What commands do; each may be refused, and the others are done all the same.
class Reading {
 public:
  explicit Reading(fs::path study) : study_(std::move(study)) {}

  bool is_sound() {
    attempt([&] { verify(); });
    attempt([&] { tabulate(); });
    attempt([&] { study::read_data_quality(study_); });
    attempt([&] { study::visit_gaze(study_, [](const study::AttemptGaze&) {}); });
    for (const char* participant : {"P01", "P02"}) {
      attempt([&] { study::session_summary(study_, participant); });
      attempt([&] { read_frames_of(participant); });
    }
    return is_sound_;
  }

 private:
  void attempt(const std::function<void()>& work) {
    try {
      work();
    } catch (const Error&) {
      is_sound_ = false;
    }
  }

  void verify() {
    const study::Verification found = study::verify_study(study_);
    study::verification_table(found);
    study::verification_json(found);
    is_sound_ = is_sound_ && found.faults.empty();
  }
  void tabulate() const {
    const study::StudyRecords records =
        study::read_study(study_, study::WithdrawnSessions::with_data);
    study::status_table(records, study::status_of(records));
    analysis::tabulate_study(study::read_study(study_));
  }
  void read_frames_of(const std::string& participant) const {
    const study::RecordedSession session = study::read_session(study_, participant);
    for (const study::RecordedAttempt& attempt : session.attempts) {
      study::read_frames(study_, session.known, attempt);
    }
  }

  fs::path study_;
  bool is_sound_ = true;
};

}  // namespace

bool read_study_input(const fs::path& folder, Bytes input) {
  const fs::path study = folder / "study.sqlite";
  write_changed_study(study, input);
  return Reading(study).is_sound();
}

}  // namespace foveola::test
