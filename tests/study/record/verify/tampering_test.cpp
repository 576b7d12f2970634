// Changes to a finished study's file by somebody who knows how it is made: verify sees them, or a
// head that was written down before does, or nothing that is read has changed.
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <zlib.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "study/record/log/hash_chain.h"
#include "study/record/schema.h"
#include "study/record/setup/study_head.h"
#include "tests/matchers.h"
#include "tests/study/record/study_file.h"

namespace foveola::study {
namespace {

/// Sessions 1 and 2, of P01 and P02, are complete.
class Tampering : public StudyFile {
 protected:
  Tampering() {
    {
      StudyStore store(path_, thorough_protocol());
      run_whole_session(store, "P01");
      run_whole_session(store, "P02");
    }
    whole_ = folder_.content().at("study.sqlite");
    head_ = read_head(path_).sessions;
  }

  void restore() { folder_.write("study.sqlite", whole_); }

  /// What verify says; also what it refuses with.
  std::string findings() const {
    std::string texts;
    try {
      for (const RecordFault& fault : verify_study(path_).faults) {
        texts += fmt::format("{}: {}\n", fault.participant, fault.what);
      }
    } catch (const Error& error) {
      texts = error.what();
    }
    return texts;
  }

  std::string findings_after(const std::string& sql) {
    restore();
    tamper(path_, sql);
    return findings();
  }

  /// Makes the chain of a session's events anew, as the program would have.
  void forge_chain(std::int64_t session) const {
    SQLite::Database study(path_, SQLite::OPEN_READWRITE);
    const std::string guard =
        study.execAndGet("SELECT sql FROM sqlite_schema WHERE name = 'event_is_fixed'").getString();
    study.exec("DROP TRIGGER event_is_fixed");
    PreparedStatements statements(study);
    std::string hash = hash_before_events(statements, session);
    SQLite::Statement rows(study, "SELECT * FROM event WHERE session = ? ORDER BY sequence");
    rows.bind(1, session);
    while (rows.executeStep()) {
      const LogLine line = log_line(rows, study_schema_version);
      hash = hash_of(hash, line, study_schema_version);
      study.exec(fmt::format("UPDATE event SET hash = '{}' WHERE session = {} AND sequence = {}",
                             hash, session, line.sequence));
    }
    study.exec(guard);
  }

  std::string whole_;
  std::vector<SessionHead> head_;
};

struct SqlChange {
  const char* sql;
  const char* words;  ///< of what verify finds
};

/// Numbers of sessions and trials are exchanged by way of others, since rows have keys.
const SqlChange changes[] = {
    // The session.
    {"UPDATE session SET participant = 'P03' WHERE id = 2", "P03: event 1"},
    {"UPDATE session SET kind = 'pilot' WHERE id = 1", "P01: event 1"},
    {"UPDATE session SET state = 'marking' WHERE id = 1", "its state is marking"},
    // The log.
    {"UPDATE event SET payload = '{\"time_ns\":5}' WHERE session = 1 AND type = 'marked'",
     "is not what was written"},
    {"UPDATE event SET utc = '2020' || substr(utc, 5) WHERE session = 1 AND sequence = 5",
     "event 5 is not"},
    {"UPDATE event SET payload = '{' WHERE session = 1 AND sequence = 5",
     "a value cannot be read (malformed JSON)"},
    {"UPDATE session SET devices = '{' WHERE id = 1", "a value cannot be read (malformed JSON)"},
    {"UPDATE event SET trial = 1 WHERE session = 1 AND trial = 0", "is not what was written"},
    {"UPDATE event SET measured = NULL WHERE session = 1", "is not what was written"},
    // The study's facts.
    {"UPDATE study SET created_utc = '2020-01-01T00:00:00.000Z'", "its date is not"},
    {"UPDATE study SET protocol_text = protocol_text || ' '", "the protocol is not the one"},
    {"UPDATE session SET study_created_utc = 'x' WHERE id = 2", "P02: event 1"},
    // Frames, gaze and films.
    {"DELETE FROM frame_chunk WHERE session = 1 AND trial = 1", "frames, gaze or films are not"},
    {"DELETE FROM frame_chunk", "frames, gaze or films are not"},
    {"DELETE FROM gaze_chunk WHERE session = 1 AND trial = 1", "frames, gaze or films are not"},
    {"DELETE FROM gaze_chunk", "frames, gaze or films are not"},
    {"DELETE FROM film_hash WHERE session = 2 AND trial = 3", "frames, gaze or films are not"},
    {"UPDATE gaze_chunk SET session = session + 10; UPDATE gaze_chunk SET session = 13 - session",
     "gaze_chunk from 0 on is missing or not what was written"},
    {"UPDATE gaze_chunk SET trial = trial + 10 WHERE session = 1 AND trial < 2;"
     " UPDATE gaze_chunk SET trial = 11 - trial WHERE trial >= 10",
     "gaze_chunk from 0 on is missing or not what was written"},
    {"UPDATE frame_chunk SET trial = trial + 10 WHERE session = 1 AND trial < 2;"
     " UPDATE frame_chunk SET trial = 11 - trial WHERE trial >= 10",
     "frame_chunk from 0 on is missing or not what was written"},
    {"UPDATE frame_chunk SET data = (SELECT data FROM frame_chunk WHERE first_frame = 60)"
     " WHERE session = 1 AND trial = 0 AND first_frame = 0",
     "frame_chunk from 0 on is missing or not what was written"},
    {"UPDATE film_hash SET session = session + 10; UPDATE film_hash SET session = 13 - session",
     "its film hashes are not those that were written"},
    {"DELETE FROM frame_chunk WHERE first_frame = 60", "frames, gaze or films are not"},
    {"UPDATE gaze_chunk SET data = CAST(data || x'6d6f7265' AS BLOB) WHERE session = 1",
     "gaze_chunk from 0 on is missing or not what was written"},
    {"UPDATE gaze_chunk SET encoding = 'gaze-2'", "CHECK constraint failed in gaze_chunk"},
    // The schema.
    {"CREATE TABLE other (x)", "has the table other"},
    {"CREATE TABLE simulated_part (seed TEXT NOT NULL, participants INTEGER NOT NULL) STRICT;"
     " INSERT INTO simulated_part VALUES ('7', 2)",
     "simulated_part holds what Foveola does not write"},
    {"INSERT INTO forgotten SELECT hex(zeroblob(32)), 1, hex(zeroblob(32)), 'a message'",
     "a session that was forgotten has the date a message"},
    {"CREATE VIEW marks AS SELECT * FROM mark", "has the view marks"},
    {"CREATE INDEX times ON event (time_ns)", "has the index times"},
    {"PRAGMA application_id = 7", "is no study"},
    {"PRAGMA user_version = 4", "is missing or was changed"},
    {"PRAGMA user_version = 6", "has schema 6"},
    {"PRAGMA writable_schema = ON; UPDATE sqlite_schema SET sql = replace(sql,"
     " ' CHECK (frame >= 0)', '') WHERE name = 'film_hash'",
     "film_hash is missing or was changed"},
};

TEST_F(Tampering, IsSeen) {
  ASSERT_EQ(findings(), "");
  for (const SqlChange& change : changes) {
    EXPECT_THAT(findings_after(std::string("PRAGMA ignore_check_constraints = ON; ") + change.sql),
                HasSubstr(change.words))
        << change.sql;
  }
}

TEST_F(Tampering, IsSeenWhereTheChainIsForged) {
  const SqlChange forged[] = {
      {"UPDATE event SET trial = 1 WHERE session = 1 AND trial = 0", "in another attempt than"},
      {"UPDATE event SET attempt = 2 WHERE session = 1 AND trial = 0", "in another attempt than"},
      {"UPDATE event SET trial = NULL, attempt = NULL WHERE session = 1",
       "in another attempt than"},
      {"UPDATE event SET measured = NULL WHERE session = 1", "frames, gaze or films are not"},
      {"UPDATE event SET measured = '{}' WHERE session = 1 AND type = 'marked'",
       "frames, gaze or films are not"},
      {"UPDATE session SET participant = 'P03' WHERE id = 1; UPDATE study SET protocol_text = 'x'",
       "the protocol is not the one"},
      {"UPDATE session SET study_created_utc = '2020-01-01T00:00:00.000Z'", "its date is not"}};
  for (const SqlChange& change : forged) {
    restore();
    tamper(path_, change.sql);
    forge_chain(1);
    EXPECT_THAT(findings(), HasSubstr(change.words)) << change.sql;
  }
}

/// A chunk's own hash, by schema.sql.
TEST_F(Tampering, IsSeenWhereTheChunksHashIsForged) {
  const std::string uuid = query(path_, "SELECT uuid FROM session WHERE id = 1");
  const std::string bytes(100 * 24, '\0');
  std::vector<Bytef> compressed(::compressBound(bytes.size()));
  uLongf size = compressed.size();
  ASSERT_EQ(::compress(compressed.data(), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                       bytes.size()),
            Z_OK);
  std::string hex;
  for (std::size_t i = 0; i < size; ++i) {
    hex += fmt::format("{:02x}", compressed[i]);
  }
  const std::string hash = sha256(uuid + "\n0\n1\n0\n100\ngaze-1\n" + bytes);
  EXPECT_THAT(findings_after(fmt::format("UPDATE gaze_chunk SET data = x'{}', data_sha256 = '{}'"
                                         " WHERE session = 1 AND trial = 0",
                                         hex, hash)),
              "P01: trial 0, attempt 1: its frames, gaze or films are not those that event 14"
              " states\n");
}

TEST_F(Tampering, OfBytesThatNoTableHasIsSeen) {
  const auto findings_with = [&](std::size_t place, const std::string& bytes) {
    restore();
    std::string changed = whole_;
    changed.replace(place, bytes.size(), bytes);
    folder_.write("study.sqlite", changed);
    return findings();
  };
  // By https://www.sqlite.org/fileformat2.html, section 1.3.
  EXPECT_THAT(findings_with(72, "hidden"), HasSubstr("its header holds"));
  EXPECT_THAT(findings_with(24, "\x7f"), HasSubstr("its header holds"));
  restore();
  tamper(path_, "CREATE TABLE t (x); INSERT INTO t VALUES (zeroblob(20000)); DROP TABLE t");
  EXPECT_EQ(findings(), "") << "free pages of zeros";
  tamper(path_,
         "PRAGMA secure_delete = OFF; CREATE TABLE t (x);"
         " INSERT INTO t VALUES (replace(hex(zeroblob(10000)), '00', 'secret')); DROP TABLE t");
  EXPECT_THAT(findings(), HasSubstr("its free pages hold what no table has"));
  restore();
  tamper(path_, "PRAGMA page_size = 8192; VACUUM");
  EXPECT_EQ(findings(), "") << "another page size says nothing else";
}

/// Everything that follows from it was changed with it.
TEST_F(Tampering, AsAWholeIsSeenAgainstAHeadAlone) {
  EXPECT_THAT(compare_with_head(path_, head_).faults, IsEmpty());
  const std::vector<std::function<void()>> forgeries = {
      [&] {
        tamper(path_,
               "UPDATE event SET payload = replace(payload, ':2.0', ':4.0')"
               " WHERE session = 1 AND type = 'rated'");
        forge_chain(1);
      },
      [&] {
        tamper(path_,
               "UPDATE session SET study_created_utc = '2020-01-01T00:00:00.000Z';"
               "UPDATE study SET created_utc = '2020-01-01T00:00:00.000Z'");
        forge_chain(1);
        forge_chain(2);
      }};
  for (const std::function<void()>& forge : forgeries) {
    restore();
    forge();
    EXPECT_EQ(findings(), "");
    EXPECT_THAT(compare_with_head(path_, head_).faults,
                Contains(HasSubstr(" is another up to event ")));
  }
}

TEST_F(Tampering, ByRemovingIsSeenAgainstAHeadAlone) {
  std::string without_session;
  for (const std::string& table :
       query_column(path_,
                    "SELECT m.name FROM sqlite_schema m JOIN pragma_table_info(m.name) c"
                    " WHERE m.type = 'table' AND c.name = 'session'")) {
    without_session += fmt::format("DELETE FROM {} WHERE session = 2;", table);
  }
  tamper(path_, without_session + "DELETE FROM session WHERE id = 2");
  EXPECT_EQ(findings(), "");
  EXPECT_THAT(compare_with_head(path_, head_).faults, ElementsAre(HasSubstr(" is missing")));

  const std::string last = query(path_, "SELECT max(sequence) FROM event WHERE session = 1");
  restore();
  tamper(path_, "DELETE FROM event WHERE session = 2 AND sequence = " + last +
                    "; UPDATE session SET state = 'questionnaire' WHERE id = 2");
  EXPECT_EQ(findings(), "");
  EXPECT_THAT(compare_with_head(path_, head_).faults,
              ElementsAre(HasSubstr(" has no event " + last)));
}

TEST_F(Tampering, OfSessionsNumbersChangesNothing) {
  std::string exchange;
  for (const std::string& table :
       query_column(path_,
                    "SELECT m.name FROM sqlite_schema m JOIN pragma_table_info(m.name) c"
                    " WHERE m.type = 'table' AND c.name = 'session'")) {
    exchange += fmt::format(
        "UPDATE {0} SET session = session + 10; UPDATE {0} SET session = 13 -"
        " session;",
        table);
  }
  tamper(path_, exchange + "UPDATE session SET id = id + 10; UPDATE session SET id = 13 - id");
  EXPECT_EQ(findings(), "");
  EXPECT_THAT(compare_with_head(path_, head_).faults, IsEmpty());
}

/// A merge would leave out a session that another file says was forgotten.
TEST_F(Tampering, AsForgettingASessionThatIsThereIsSeen) {
  const std::string uuid = query(path_, "SELECT uuid FROM session WHERE id = 2");
  tamper(path_, fmt::format("INSERT INTO forgotten SELECT '{}', 1, '{}', created_utc FROM study",
                            sha256(uuid), std::string(64, '0')));
  EXPECT_EQ(findings(), fmt::format(": says that session {} was forgotten, which it has\n", uuid));
}

/// Whoever can write the file can say that a session was forgotten; that is told.
TEST_F(Tampering, AsForgettingIsToldWithAHead) {
  forget_participant(path_, "P02");
  const HeadComparison comparison = compare_with_head(path_, head_);
  EXPECT_THAT(comparison.faults, IsEmpty());
  EXPECT_THAT(comparison.forgotten, ElementsAre(HasSubstr(" was forgotten")));
  EXPECT_EQ(findings(), "");
  const std::vector<SessionHead> tombstones = read_head(path_).forgotten;
  EXPECT_THAT(compare_with_head(path_, tombstones).faults, IsEmpty());
  tamper(path_, "UPDATE forgotten SET last_hash = '" + std::string(64, '0') + "'");
  EXPECT_THAT(compare_with_head(path_, head_).faults, ElementsAre(HasSubstr(" is missing")));
  tamper(path_, "DELETE FROM forgotten");
  EXPECT_THAT(compare_with_head(path_, tombstones).faults,
              ElementsAre(HasSubstr(", of a session that was forgotten, is missing")));
}

TEST_F(Tampering, AHeadHoldsAfterMoreSessionsAndMerges) {
  const fs::path other = folder_ / "other.sqlite";
  {
    StudyStore store(path_, thorough_protocol());
    run_thorough_session(store, "P03");
    StudyStore second(other, thorough_protocol());
    run_thorough_session(second, "P04");
  }
  merge_studies({other, path_}, folder_ / "all.sqlite");
  for (const fs::path& file : {path_, folder_ / "all.sqlite"}) {
    EXPECT_THAT(compare_with_head(file, head_).faults, IsEmpty()) << file;
  }
  EXPECT_THAT(compare_with_head(other, head_).faults,
              ElementsAre(HasSubstr(" is missing"), HasSubstr(" is missing")));
  const StudyHead all = read_head(folder_ / "all.sqlite");
  merge_studies({path_, other}, folder_ / "again.sqlite");
  EXPECT_EQ(read_head(folder_ / "again.sqlite").sha256, all.sha256) << "whatever their order";
}

}  // namespace
}  // namespace foveola::study
