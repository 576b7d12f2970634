#include "study/record/study_records.h"

#include <gtest/gtest.h>

#include "study_file.h"

namespace foveola::study {
namespace {

class Records : public StudyFile {
 protected:
  PlayedSession session_of(const std::string& participant) {
    PlayedSession session(store_, facts_of(participant), small_plan());
    session.begin();
    return session;
  }

  StudyStore store_{path_, small_protocol()};
};

TEST_F(Records, OfACompletedSession) {
  PlayedSession session = session_of("P01");
  session.run_trial(ms(1000), ms(500), ms(1500), 1);
  session.run_trial(ms(11'000), ms(4000), ms(9250), 4);
  session.run_trial(ms(31'000), ms(2000), ms(2000), 3);
  session.run_trial(ms(41'000), ms(250), ms(750), 5);
  const StudyRecords records = read_study(path_);

  EXPECT_EQ(records.protocol_name, "small");
  EXPECT_EQ(records.protocol_title, "A small study");
  EXPECT_EQ(records.protocol_sha256, small_protocol().sha256);
  EXPECT_THAT(records.scenes, ElementsAre("box", "hall"));
  EXPECT_THAT(records.methods, ElementsAre("od", "fv", "mask:file=a.png"));
  EXPECT_THAT(records.sessions, ElementsAre(FieldsAre("P01", "simulated", "completed", 7, "")));
  EXPECT_THAT(records.trials,
              ElementsAre(FieldsAre("P01", "hall", "fv", 0, 0, 1, 0.5, 1.5, false, false, 1),
                          FieldsAre("P01", "hall", "od", 0, 1, 1, 4.0, 9.25, false, false, 4),
                          FieldsAre("P01", "box", "od", 1, 0, 1, 2.0, 2.0, false, false, 3),
                          FieldsAre("P01", "box", "fv", 1, 1, 1, 0.25, 0.75, false, false, 5)));
  EXPECT_THAT(records.background,
              ElementsAre(FieldsAre("P01", "age", 31.0), FieldsAre("P01", "cg_experience", 4.0)));
}

TEST_F(Records, GiveTheLastAttempt) {
  PlayedSession session = session_of("P01");
  session.choose_and_start(ms(20));
  session.happen(ms(1000), FirstFramePresented{ms(1000)});
  session.happen(ms(2000), Marked{ms(2000)});
  session.happen(ms(3000), Marked{ms(3000)});
  session.happen(ms(3100), RetimeRequested{});
  session.choose_and_start(ms(4000));
  session.happen(ms(5000), FirstFramePresented{ms(5000)});
  session.happen(ms(5250), Marked{ms(5250)});
  EXPECT_THAT(read_study(path_).trials.at(0), FieldsAre("P01", "hall", "fv", 0, 0, 2, 0.25,
                                                        std::nullopt, false, false, std::nullopt));
  session.happen(ms(5500), Marked{ms(5500)});
  session.happen(ms(5600), rated(2));
  EXPECT_THAT(read_study(path_).trials.at(0),
              FieldsAre("P01", "hall", "fv", 0, 0, 2, 0.25, 0.5, false, false, 2));
  EXPECT_EQ(query(path_, "SELECT group_concat(time_ns) FROM mark"),
            "1000000000,2000000000,250000000,500000000");
}

TEST_F(Records, TellCensoredMarksFromMeasuredOnes) {
  PlayedSession session = session_of("P01");
  session.choose_and_start(ms(20));
  session.happen(ms(1000), FirstFramePresented{ms(1000)});
  session.happen(ms(121'000), TimedOut{ms(121'000)});
  session.happen(ms(121'500), Marked{ms(121'500)});
  session.happen(ms(121'600), rated(5));
  session.choose_and_start(ms(121'700));
  session.happen(ms(122'000), FirstFramePresented{ms(122'000)});
  session.happen(ms(123'000), Marked{ms(123'000)});
  session.happen(ms(243'000), TimedOut{ms(243'000)});
  const StudyRecords records = read_study(path_);
  EXPECT_THAT(records.trials.at(0),
              FieldsAre("P01", "hall", "fv", 0, 0, 1, 120.0, 120.5, true, false, 5));
  EXPECT_THAT(records.trials.at(1),
              FieldsAre("P01", "hall", "od", 0, 1, 1, 1.0, 121.0, false, true, std::nullopt));
}

TEST_F(Records, HoldInterruptedSessionsWithWhatTheyReached) {
  PlayedSession session = session_of("P01");
  session.run_trial(ms(1000), ms(500), ms(1500), 1);
  session.choose_and_start(ms(5000));
  session.happen(ms(6000), FirstFramePresented{ms(6000)});
  session.happen(ms(7000), Interrupted{});
  const StudyRecords records = read_study(path_);
  EXPECT_EQ(records.sessions.at(0).state, "interrupted");
  ASSERT_THAT(records.trials, testing::SizeIs(4));
  EXPECT_EQ(records.trials[0].artifact_rating, 1);
  EXPECT_EQ(records.trials[1].attempts, 1);
  EXPECT_EQ(records.trials[1].outline_s, std::nullopt);
  EXPECT_EQ(records.trials[2].attempts, 0);
}

TEST_F(Records, LeaveOutWhatAParticipantTookBack) {
  PlayedSession withdrawn = session_of("P01");
  withdrawn.run_trial(ms(1000), ms(500), ms(1500), 1);
  withdrawn.happen(ms(5000), Withdrawn{});
  session_of("P02");
  const StudyRecords records = read_study(path_);
  EXPECT_THAT(records.sessions,
              ElementsAre(FieldsAre("P01", "simulated", "withdrawn", 7, ""),
                          FieldsAre("P02", "simulated", "choosing_object", 7, "")));
  EXPECT_THAT(records.trials, testing::Each(testing::Field(&TrialRow::participant, "P02")));
  EXPECT_THAT(records.trials, testing::SizeIs(4));
  EXPECT_THAT(records.background,
              testing::Each(testing::Field(&BackgroundRow::participant, "P02")));
}

TEST_F(Records, HoldTestTrialsOnly) {
  const fs::path path = folder_ / "thorough.sqlite";
  StudyStore store(path, thorough_protocol());
  run_thorough_session(store, "P01");
  const StudyRecords records = read_study(path);
  EXPECT_THAT(records.sessions,
              ElementsAre(FieldsAre("P01", "simulated", "excluded", 7, "the tracker was lost")));
  EXPECT_THAT(records.trials,
              ElementsAre(FieldsAre("P01", "hall", "fv", 0, 0, 3, 0.3, 0.4, false, false, 4),
                          FieldsAre("P01", "hall", "od", 0, 1, 1, 0.5, 0.6, false, false, 3),
                          FieldsAre("P01", "box", "od", 1, 0, 1, 0.5, 0.6, false, false, 3),
                          FieldsAre("P01", "box", "fv", 1, 1, 1, 0.5, 0.6, false, false, 3)));
}

TEST_F(Records, HoldNumbersOfTheBackgroundOnly) {
  const fs::path path = folder_ / "thorough.sqlite";
  StudyStore store(path, thorough_protocol());
  run_thorough_session(store, "P01",
                       QuestionnaireAnswered{.questionnaire = "debrief",
                                             .answers = {{.question = "sickness", .value = 2.0}}});
  EXPECT_THAT(read_study(path).background,
              ElementsAre(FieldsAre("P01", "age", 31.0), FieldsAre("P01", "cg_experience", 4.0)));
}

TEST_F(Records, SayWhetherAnySessionWasSimulated) {
  SessionFacts human = facts_of("P01");
  human.kind = SessionKind::human;
  SessionFacts pilot = facts_of("P02");
  pilot.kind = SessionKind::pilot;
  store_.begin_session(human, small_plan());
  store_.begin_session(pilot, small_plan());
  EXPECT_FALSE(read_study(path_).has_simulated());
  EXPECT_THAT(read_study(path_).sessions, ElementsAre(FieldsAre("P01", "human", "created", 7, ""),
                                                      FieldsAre("P02", "pilot", "created", 7, "")));
  store_.begin_session(facts_of("P03"), small_plan());
  EXPECT_TRUE(read_study(path_).has_simulated());
}

TEST_F(Records, SayHowSessionsWereSimulated) {
  SessionFacts human = facts_of("P01");
  human.kind = SessionKind::human;
  store_.begin_session(human, small_plan());
  EXPECT_FALSE(read_study(path_).simulation);
  SessionFacts predicted = facts_of("P02");
  predicted.devices =
      R"({"simulation": {"scale": 36.0, "predicted": true, "injected": "none", "people_sha256": ""}})";
  store_.begin_session(predicted, small_plan());
  EXPECT_EQ(read_study(path_).simulation,
            (SimulationFacts{.scale = 36.0, .predicted = true, .injected = ""}));
}

TEST_F(Records, TellWhatWasInjected) {
  SessionFacts injected = facts_of("P01");
  injected.devices =
      R"({"simulation": {"scale": 1.0, "predicted": false, "injected": "faster:fv:2"}})";
  store_.begin_session(injected, small_plan());
  EXPECT_EQ(read_study(path_).simulation,
            (SimulationFacts{.scale = 1.0, .predicted = false, .injected = "faster:fv:2"}));
}

TEST_F(Records, ReadInjectedEffectsOfEarlierVersions) {
  SessionFacts earlier = facts_of("P01");
  earlier.devices = R"({"simulation": {"scale": 1.0, "predicted": false, "plant": "faster:fv:2"}})";
  store_.begin_session(earlier, small_plan());
  EXPECT_EQ(read_study(path_).simulation->injected, "faster:fv:2");
}

TEST_F(Records, OfANewStudyAreEmpty) {
  const StudyRecords records = read_study(path_);
  EXPECT_TRUE(records.sessions.empty());
  EXPECT_TRUE(records.trials.empty());
  EXPECT_FALSE(records.has_simulated());
}

}  // namespace
}  // namespace foveola::study
