#include <algorithm>

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include "study/design/participant_code.h"
#include "study/record/read/study_records.h"
#include "study/record/setup/simulated_part.h"
#include "study/record/setup/simulation_kind.h"
#include "tests/study/record/study_file.h"

namespace foveola::study {
namespace {

/// Two sites: a.sqlite has P01 and P02, b.sqlite P03.
class Merging : public testing::Test {
 protected:
  Merging() {
    {
      StudyStore store(a_, thorough_protocol());
      run_thorough_session(store, "P01");
      run_session(store, "P02");
    }
    StudyStore store(b_, thorough_protocol());
    run_thorough_session(store, "P03");
  }

  static void run_session(StudyStore& store, const std::string& participant) {
    PlayedSession session(store, facts_of(participant), small_plan(), thorough_protocol());
    session.begin_thoroughly();
    session.run_trial(ms(100), ms(2000), ms(3000), 2,
                      {FrameChunk{.attempt = {}, .first = 0, .frames = plausible_frames(10)}});
  }

  std::vector<std::string> participants(const fs::path& path) {
    return query_column(path, "SELECT participant FROM session ORDER BY participant");
  }

  TemporaryFolder folder_;
  fs::path a_ = folder_ / "a.sqlite";
  fs::path b_ = folder_ / "b.sqlite";
  fs::path all_ = folder_ / "all.sqlite";
};

TEST_F(Merging, HoldsTheSessionsOfAll) {
  const Merge merge = merge_studies({a_, b_}, all_);
  EXPECT_EQ(merge.sessions_added, 3U);
  EXPECT_THAT(merge.known, IsEmpty());
  EXPECT_THAT(participants(all_), ElementsAre("P01", "P02", "P03"));
  const Verification found = verify_study(all_);
  EXPECT_THAT(found.faults, IsEmpty());
  EXPECT_EQ(found.chunks, 2U + 1U + 2U);
  for (const auto& [site, code] : {std::pair(a_, "P01"), {a_, "P02"}, {b_, "P03"}}) {
    const std::string last =
        std::string(
            "SELECT uuid || hash FROM event JOIN session ON session.id = session"
            " WHERE participant = '") +
        code + "' ORDER BY sequence DESC";
    EXPECT_EQ(query(all_, last), query(site, last));
  }
  EXPECT_EQ(std::ranges::count_if(read_study(all_).trials, StudyRecords::is_result), 12);
  const StudyStore goes_on(all_, thorough_protocol());
}

// What the hash chain covers stays: both have the code P01.
TEST_F(Merging, TellsCodesOfSitesApart) {
  const fs::path other = folder_ / "other.sqlite";
  {
    StudyStore store(other, thorough_protocol());
    run_session(store, "P01");
  }
  EXPECT_THAT(refusal([&] { merge_studies({a_, other}, all_); }),
              HasSubstr("name the sites by --site, once for each file"));
  merge_studies({a_, other}, all_, {.sites = {"BERLIN", "LYON"}});
  EXPECT_THAT(participants(all_), ElementsAre("BERLIN-P01", "BERLIN-P02", "LYON-P01"));
  EXPECT_THAT(verify_study(all_).faults, IsEmpty());
  const std::string last =
      "SELECT uuid || hash FROM event JOIN session ON session.id = session"
      " WHERE participant LIKE '%P01' ORDER BY session DESC, sequence DESC";
  EXPECT_EQ(query(all_, last), query(other, last));
  // Again with others: who has a site keeps it.
  const fs::path again = folder_ / "again.sqlite";
  const Merge merge = merge_studies({all_, b_, other}, again, {.sites = {"X", "OSLO", "LYON"}});
  EXPECT_EQ(merge.known.size(), 1U);
  EXPECT_THAT(participants(again), ElementsAre("BERLIN-P01", "BERLIN-P02", "LYON-P01", "OSLO-P03"));
  EXPECT_EQ(read_study(again).sessions.size(), 4U);
  EXPECT_THAT(verify_study(again).faults, IsEmpty());
  // Another name of a site is another record.
  tamper(again, "UPDATE session SET participant = 'LYON-P07' WHERE participant = 'LYON-P01'");
  EXPECT_EQ(verify_study(again).faults.size(), 1U);
}

TEST_F(Merging, TakesEachSessionOnce) {
  merge_studies({a_, b_}, all_);
  const Merge merge = merge_studies({all_, a_, b_}, folder_ / "again.sqlite");
  EXPECT_EQ(merge.sessions_added, 3U);
  EXPECT_THAT(merge.known, ElementsAre("P01", "P02", "P03"));
}

TEST_F(Merging, RefusesASessionThatDiffers) {
  fs::copy(a_, folder_ / "older.sqlite");
  {
    StudyStore store(a_, thorough_protocol());
    store.record(2, EventEntry{.time = ms(9000), .event = NoteWritten{"late"}});
  }
  EXPECT_THAT(refusal([&] { merge_studies({a_, folder_ / "older.sqlite"}, all_); }),
              AllOf(StartsWith((folder_ / "older.sqlite").string()),
                    HasSubstr("its session of participant P02 differs")));
  EXPECT_FALSE(fs::exists(all_));
}

TEST_F(Merging, RefusesTwoPeopleOfOneCode) {
  const fs::path c = folder_ / "c.sqlite";
  {
    StudyStore store(c, thorough_protocol());
    run_session(store, "P02");
  }
  EXPECT_THAT(refusal([&] { merge_studies({a_, b_, c}, all_); }),
              AllOf(StartsWith(c.string()), HasSubstr("participant P02 is another person")));
  EXPECT_THAT(folder_.entries(), ElementsAre("a.sqlite", "b.sqlite", "c.sqlite"));
}

TEST_F(Merging, RefusesAnotherStudy) {
  const fs::path c = folder_ / "c.sqlite";
  {
    const StudyStore store(c, other_protocol());
  }
  EXPECT_THAT(refusal([&] { merge_studies({a_, c}, all_); }),
              AllOf(StartsWith(c.string()), HasSubstr("is another study than " + a_.string())));
  const fs::path d = folder_ / "d.sqlite";
  {
    const StudyStore store(d, protocol_with_another_tracker());
  }
  EXPECT_THAT(refusal([&] { merge_studies({a_, d}, all_); }),
              HasSubstr("its study_profile differs"));
}

class MergingShards : public Merging {
 protected:
  /// A study with one session, simulated in this way by this program.
  fs::path simulated(const std::string& participant, int design_row, const SimulationKind& kind,
                     const std::string& instructions) const {
    const fs::path path = folder_ / (participant + ".sqlite");
    StudyStore store(path, small_protocol(), OtherProtocol::refuse, RecordDates::virtual_time);
    SessionFacts facts = facts_of(participant);
    facts.design_row = design_row;
    facts.devices = devices_of(kind);
    facts.build.instruction_set = instructions;
    PlayedSession(store, facts, small_plan()).begin();
    return path;
  }
};

TEST_F(MergingShards, OrdersThemByTheirDesign) {
  const fs::path second = simulated("P01", 1, {}, "x86-64-v3");
  const fs::path first = simulated("P10", 0, {}, "x86-64-v3");
  merge_studies({second, first}, all_);
  EXPECT_THAT(query_column(all_, "SELECT participant FROM session ORDER BY id"),
              ElementsAre("P10", "P01"));
  EXPECT_THAT(verify_study(all_).warnings, IsEmpty());
  EXPECT_EQ(query(all_, "SELECT started_utc FROM session WHERE id = 1"),
            "1970-01-01T00:00:00.000Z");
}

/// The second of three participants.
TEST_F(MergingShards, NamesWhoIsMissingInTheWholeThatTheyAreOf) {
  const auto shard = [&](int design_row, const ShardedStudy& whole) {
    const std::string participant = participant_code(design_row);
    const fs::path path = simulated(participant, design_row, {}, "x86-64-v3");
    StudyStore(path, small_protocol()).mark_as_part(whole);
    return path;
  };
  const ShardedStudy whole{.seed = std::to_string(facts_of("P001").seed), .participants = 3};
  const fs::path first = shard(0, whole);
  const fs::path second = shard(1, whole);
  const fs::path third = shard(2, whole);
  EXPECT_THAT(refusal([&] { merge_studies({first, third}, all_); }),
              AllOf(StartsWith(all_.string()),
                    HasSubstr("would lack 1 of 3 simulated participants: P002")));
  EXPECT_FALSE(fs::exists(all_));
  EXPECT_THAT(verify_study(first).faults, IsEmpty());
  EXPECT_THAT(refusal([&] { StudyStore(first, small_protocol()).mark_as_part(std::nullopt); }),
              HasSubstr("is a part of a simulated study of 3 participants"));

  const fs::path part = folder_ / "part.sqlite";
  EXPECT_THAT(merge_studies({first, third}, part, {.missing = MissingParts::note}).missing,
              ElementsAre("P002"));
  EXPECT_EQ(read_study(part).simulation->whole_participants, 3);
  EXPECT_THAT(merge_studies({part, second, first}, all_).known, ElementsAre("P001"));
  EXPECT_FALSE(read_study(all_).simulation->whole_participants);

  const fs::path other = shard(3, {.seed = whole.seed, .participants = 4});
  EXPECT_THAT(refusal([&] { merge_studies({first, other}, folder_ / "no.sqlite"); }),
              AllOf(StartsWith(other.string()), HasSubstr("is a part of 4 simulated")));
}

TEST_F(MergingShards, RefusesOnesOfAnotherProgramOrAnotherKind) {
  const fs::path usual = simulated("P01", 0, {}, "x86-64-v3");
  const fs::path wider = simulated("P02", 1, {}, "x86-64-v4");
  EXPECT_THAT(refusal([&] { merge_studies({usual, wider}, all_); }),
              AllOf(StartsWith(wider.string()), HasSubstr("P02 was simulated by "),
                    HasSubstr("with x86-64-v4, but "), HasSubstr("same instruction set")));
  const fs::path smaller = simulated("P03", 2, {.scale = 4.0}, "x86-64-v3");
  EXPECT_THAT(refusal([&] { merge_studies({usual, smaller}, all_); }),
              AllOf(StartsWith(smaller.string()), HasSubstr("simulated in another way")));
  EXPECT_FALSE(fs::exists(all_));
}

TEST_F(Merging, RefusesADamagedSource) {
  tamper(b_, "UPDATE event SET time_ns = 5 WHERE type = 'marked'");
  EXPECT_THAT(refusal([&] { merge_studies({a_, b_}, all_); }),
              AllOf(StartsWith(b_.string()),
                    HasSubstr("participant P03: event 12 is not what was written")));
  EXPECT_FALSE(fs::exists(all_));
}

TEST_F(Merging, OverwritesNothing) {
  EXPECT_THAT(refusal([&] { merge_studies({a_, b_}, a_); }), HasSubstr("exists already"));
  EXPECT_THAT(refusal([&] { merge_studies({a_, b_}, folder_ / "none/x.sqlite"); }),
              HasSubstr("does not exist"));
}

}  // namespace
}  // namespace foveola::study
