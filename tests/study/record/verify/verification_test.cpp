#include <map>
#include <random>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <zlib.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "study/record/log/hash_chain.h"
#include "study/record/schema.h"
#include "study/record/write/table_rows.h"
#include "tests/matchers.h"
#include "tests/study/record/study_file.h"

namespace foveola::study {
namespace {

/// P01's session is complete, P02's was excluded, P03's goes on.
class VerifiedStudy : public StudyFile {
 protected:
  VerifiedStudy() {
    StudyStore store(path_, thorough_protocol());
    run_whole_session(store, "P01");
    run_thorough_session(store, "P02");
    PlayedSession third(store, facts_of("P03"), thorough_plan(), thorough_protocol());
    third.begin_thoroughly();
  }

  std::vector<RecordFault> faults_after(const std::string& sql) {
    tamper(path_, sql);
    return verify_study(path_).faults;
  }
};

TEST_F(VerifiedStudy, IsWhole) {
  const auto before = folder_.content();
  const Verification found = verify_study(path_);
  EXPECT_THAT(found.faults, IsEmpty());
  EXPECT_EQ(found.sessions, 3U);
  EXPECT_EQ(found.chunks, 4U * 3U + 2U);
  EXPECT_EQ(folder_.content(), before);
  EXPECT_EQ(std::to_string(found.events), query(path_, "SELECT count(*) FROM event"));
}

TEST_F(VerifiedStudy, TellsWhatIsNotComplete) {
  const std::vector<RecordFault> gaps = verify_study(path_).gaps;
  EXPECT_THAT(gaps, Contains(FieldsAre("P03", "is not over: choosing_object")));
  EXPECT_THAT(gaps, Contains(FieldsAre("P02", "trial 1, attempt 2 has no frames")));
  EXPECT_THAT(gaps, Not(Contains(FieldsAre("P02", "trial 1, attempt 1 has no frames"))));
  EXPECT_THAT(gaps, Not(Contains(testing::Field(&RecordFault::participant, "P01"))));
}

TEST_F(VerifiedStudy, ExpectsNoFramesOfAPredictedSession) {
  tamper(path_, R"(UPDATE session SET devices = '{"simulation":{"predicted":true}}' WHERE id = 2)");
  EXPECT_THAT(verify_study(path_).gaps,
              Not(Contains(testing::Field(&RecordFault::what, HasSubstr("frames")))));
}

TEST_F(VerifiedStudy, NamesTheFirstEventThatWasChangedOrTakenOut) {
  EXPECT_THAT(faults_after("UPDATE event SET payload = '{\"time_ns\":5}'"
                           " WHERE session = 2 AND type = 'marked' AND sequence < 14"),
              ElementsAre(FieldsAre("P02", "event 12 is not what was written")));
  EXPECT_THAT(faults_after("DELETE FROM event WHERE session = 2 AND sequence = 9"),
              Contains(FieldsAre("P02", HasSubstr("event 9 "))));
}

/// Of the session and its plan, and of what was measured.
TEST_F(VerifiedStudy, FindsWhateverElseWasChanged) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"UPDATE session SET state = 'withdrawn' WHERE id = 1",
       "its state is withdrawn, and its events lead to completed"},
      {"UPDATE session SET seed = '2' WHERE id = 1", "event 1, the study, the session or its plan"},
      {"UPDATE planned_trial SET method = 'mask:file=a.png' WHERE session = 1 AND trial = 0",
       "event 1, the study, the session or its plan"},
      {"UPDATE study SET protocol_text = 'x'", "the protocol is not the one"},
      {"UPDATE study_profile SET toml = 'x' WHERE device = 'tracker'", "tracker camera is not"},
      {"UPDATE frame_chunk SET data = x'00' WHERE session = 1 AND trial = 0 AND first_frame = 0",
       "trial 0, attempt 1: frame_chunk from 0 on is missing or not what was written"},
      {"DELETE FROM frame_chunk WHERE session = 1 AND trial = 0 AND first_frame = 0",
       "trial 0, attempt 1: frame_chunk from 0 on"},
      {"UPDATE frame_chunk SET frame_count = 61 WHERE session = 1 AND trial = 1"
       " AND first_frame = 0",
       "trial 1, attempt 1: frame_chunk from 0 on"},
      {"UPDATE frame_chunk SET data_sha256 = '" + std::string(64, '0') + "' WHERE first_frame = 60",
       "frame_chunk from 60 on"},
      {"UPDATE gaze_chunk SET first_sample = 1 WHERE session = 1 AND trial = 3",
       "trial 3, attempt 1: gaze_chunk from 0 on"},
      {"UPDATE film_hash SET film_sha256 = '" + std::string(64, '3') + "'",
       "its film hashes are not those that were written"},
      {"UPDATE film_hash SET frame = 98", "its film hashes are not those that were written"}};
  const std::string whole = folder_.content().at("study.sqlite");
  for (const auto& [sql, words] : cases) {
    folder_.write("study.sqlite", whole);
    EXPECT_THAT(faults_after(sql), Contains(testing::Field(&RecordFault::what, HasSubstr(words))))
        << sql;
  }
}

/// By somebody who knows how the chain is made.
TEST_F(VerifiedStudy, FindsAnEventThatSaysMoreThanFoveolaWrites) {
  const auto of_last = [&](const std::string& column, int before_last = 0) {
    return query(path_, fmt::format("SELECT {} FROM event WHERE session = 1 ORDER BY sequence DESC"
                                    " LIMIT 1 OFFSET {}",
                                    column, before_last));
  };
  std::string payload = of_last("payload");
  payload.replace(payload.size() - 1, 1, ",\"note\":1}");
  const std::string hash = hash_of(of_last("hash", 1),
                                   {.sequence = std::stoll(of_last("sequence")),
                                    .time_ns = std::stoll(of_last("time_ns")),
                                    .utc = of_last("utc"),
                                    .type = of_last("type"),
                                    .payload = payload},
                                   study_schema_version);
  EXPECT_THAT(
      faults_after(fmt::format("UPDATE event SET payload = '{}', hash = '{}'"
                               " WHERE session = 1 AND sequence = {}",
                               payload, hash, of_last("sequence"))),
      ElementsAre(FieldsAre("P01", "its events say more than this program writes of them")));
}

TEST_F(VerifiedStudy, FindsReferencesToWhatIsNotThere) {
  EXPECT_THAT(
      faults_after("PRAGMA foreign_keys = OFF; DELETE FROM planned_trial WHERE session = 1"),
      Contains(FieldsAre("", HasSubstr("a row of frame_chunk refers to one of planned_trial"))));
}

TEST_F(VerifiedStudy, FindsWhatWasMeasuredInAnAttemptThatNeverBegan) {
  const std::string whole = folder_.content().at("study.sqlite");
  for (const char* table : {"frame_chunk", "gaze_chunk", "film_hash"}) {
    folder_.write("study.sqlite", whole);
    const std::vector<std::string> columns = query_column(
        path_, fmt::format("SELECT name FROM pragma_table_info('{}') WHERE cid > 2", table));
    EXPECT_THAT(faults_after(fmt::format("INSERT INTO {0} SELECT session, trial, 7, {1} FROM {0}"
                                         " WHERE session = 1 AND trial = 3 LIMIT 1",
                                         table, fmt::join(columns, ", "))),
                Contains(FieldsAre(
                    "P01", "trial 3, attempt 7: has frames, gaze or films, and never began")))
        << table;
  }
}

/// A study of schema 4, which has tables of what follows from the log; written by Foveola 0.1.0.
class VerifiedOlderStudy : public StudyFile {
 protected:
  const std::string whole_ = read_file(fs::path(TEST_DATA_DIR) / "schema-4/study.sqlite");
};

TEST_F(VerifiedOlderStudy, FindsWhateverDoesNotFollowFromTheLog) {
  folder_.write("study.sqlite", whole_);
  EXPECT_THAT(verify_study(path_).faults, IsEmpty());
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"UPDATE mark SET time_ns = time_ns - 1 WHERE session = 1 AND trial = 2", "rows in mark"},
      {"DELETE FROM mark WHERE session = 1 AND trial = 2 AND kind = 'material'", "rows in mark"},
      {"UPDATE mark SET censored = 1 WHERE session = 1 AND trial = 0", "rows in mark"},
      {"UPDATE rating SET value = 5.0 WHERE session = 1 AND trial = 3", "rows in rating"},
      {"UPDATE attempt SET outcome = 'retimed' WHERE session = 1 AND trial = 0", "rows in attempt"},
      {"UPDATE attempt SET object = 'x' WHERE session = 1 AND trial = 0", "rows in attempt"},
      {"UPDATE questionnaire_answer SET number = 32 WHERE session = 1 AND question = 'age'",
       "rows in questionnaire_answer"},
      {"UPDATE reaction SET pressed_ns = pressed_ns + 1 WHERE session = 1", "rows in reaction"},
      {"UPDATE gaze_run SET accuracy_deg = 0.1 WHERE session = 1", "rows in gaze_run"},
      {"UPDATE gaze_target SET samples = 999 WHERE session = 1", "rows in gaze_target"}};
  for (const auto& [sql, words] : cases) {
    folder_.write("study.sqlite", whole_);
    tamper(path_, sql);
    EXPECT_THAT(verify_study(path_).faults,
                Contains(FieldsAre("PROGRAM-1", HasSubstr(words + " do not follow"))))
        << sql;
  }
  folder_.write("study.sqlite", whole_);
  tamper(path_, "PRAGMA foreign_keys = OFF; DELETE FROM attempt WHERE session = 1");
  EXPECT_THAT(verify_study(path_).faults,
              Contains(FieldsAre("", HasSubstr("a row of mark refers to one of attempt"))));
}

TEST_F(VerifiedStudy, NamesWhatStandsBesideItsSchema) {
  const std::string whole = folder_.content().at("study.sqlite");
  for (const auto& [sql, object] :
       {std::pair("CREATE TRIGGER faster AFTER INSERT ON event BEGIN SELECT 1; END",
                  "trigger faster on event"),
        std::pair("CREATE VIEW marks AS SELECT * FROM mark", "view marks"),
        std::pair("CREATE TABLE other (x)", "table other"),
        std::pair("CREATE INDEX times ON event (time_ns)", "index times on event")}) {
    folder_.write("study.sqlite", whole);
    SQLite::Database(path_, SQLite::OPEN_READWRITE).exec(sql);
    EXPECT_THAT(
        verify_study(path_).faults,
        ElementsAre(FieldsAre("", fmt::format("has the {}, which is not Foveola's", object))));
  }
  folder_.write("study.sqlite", whole);
  SQLite::Database(path_, SQLite::OPEN_READWRITE).exec("ANALYZE");
  EXPECT_THAT(verify_study(path_).faults, IsEmpty()) << "SQLite's own statistics";
}

TEST_F(VerifiedStudy, NoByteIsMissingOrAppended) {
  const std::string whole = folder_.content().at("study.sqlite");
  const std::string page(4096, '\0');
  for (const std::string& changed :
       {whole.substr(0, whole.size() - 1), whole + "x", whole + page}) {
    folder_.write("study.sqlite", changed);
    EXPECT_THAT(
        verify_study(path_).faults,
        Contains(FieldsAre("", AllOf(StartsWith(fmt::format("has {} bytes", changed.size())),
                                     HasSubstr("pages of 4096 bytes")))));
  }
}

/// What a chunk's compressed data say; another stream may say the same.
std::string uncompressed(const std::string& data) {
  std::string bytes(1'000'000, '\0');
  uLongf length = bytes.size();
  const int result = ::uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length,
                                  reinterpret_cast<const Bytef*>(data.data()), data.size());
  return result == Z_OK ? bytes.substr(0, length) : "damaged " + data;
}

/// Everything that the file says by its tables, but for when it was made, which nothing depends on.
std::map<std::string, std::string> content_of(const fs::path& path) {
  SQLite::Database study(path, SQLite::OPEN_READONLY);
  std::map<std::string, std::string> content;
  SQLite::Statement tables(study, "SELECT name FROM sqlite_schema WHERE type = 'table'");
  while (tables.executeStep()) {
    const std::string table = tables.getColumn(0).getString();
    content[table] = digest_of_rows(study, table, "true", {"created_utc", "data"});
  }
  for (const char* table : {"frame_chunk", "gaze_chunk"}) {
    SQLite::Statement chunks(study, fmt::format("SELECT data FROM {} ORDER BY rowid", table));
    while (chunks.executeStep()) {
      content[table] += uncompressed(chunks.getColumn(0).getString());
    }
  }
  return content;
}

// Either it says the same as before, or the damage is reported.
TEST_F(VerifiedStudy, NoFlippedBitGoesUnnoticed) {
  const std::string whole = folder_.content().at("study.sqlite");
  const std::map<std::string, std::string> content = content_of(path_);
  std::mt19937 random(2018);
  int reported = 0;
  int harmless = 0;
  for (int flip = 0; flip < 200; ++flip) {
    std::string bytes = whole;
    const std::size_t place = random() % bytes.size();
    const unsigned bit = random() % 8;
    bytes[place] = static_cast<char>(bytes[place] ^ (1U << bit));
    folder_.write("study.sqlite", bytes);
    try {
      if (verify_study(path_).faults.empty()) {
        for (const auto& [table, said] : content_of(path_)) {
          EXPECT_TRUE(said == content.at(table)) << table << ", byte " << place << ", bit " << bit;
        }
        ++harmless;
        continue;
      }
    } catch (const Error&) {
    }
    ++reported;
  }
  EXPECT_GT(reported, 20);
  EXPECT_GT(harmless, 0) << "free space in pages says nothing";
}

}  // namespace
}  // namespace foveola::study
