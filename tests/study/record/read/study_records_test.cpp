#include "study/record/read/study_records.h"

#include <utility>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "tests/matchers.h"
#include "tests/study/record/study_file.h"

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

/// "P01 hall fv 0.0 attempt 1 counts [rated]: 0.5 1.5 1"; a bound is ">120", words are quoted,
/// and what is missing is "-".
std::string line_of(const StudyRecords& records, std::size_t row) {
  const TrialRow& trial = records.trials[row];
  std::string line =
      fmt::format("{} {} {} {}.{} {} attempt {}{} [{}]:", records.participant_of(trial),
                  records.scenes[trial.scene], records.methods[trial.method], trial.scene_position,
                  trial.method_position, name_of(trial.kind), trial.attempt,
                  trial.counts ? "" : " not", records.words[trial.outcome]);
  for (std::size_t measure = 0; measure < records.measures.size(); ++measure) {
    const Value& value = records.value(row, measure);
    switch (value.state) {
      case Value::State::missing:
        line += " -";
        break;
      case Value::State::right_censored:
        line += fmt::format(" >{:g}", value.number);
        break;
      case Value::State::measured:
        line += fmt::format(" {:g}", value.number);
        break;
      case Value::State::in_words:
        line += fmt::format(" '{}'", records.words[value.words]);
        break;
    }
  }
  return line;
}

std::vector<std::string> lines_of(const StudyRecords& records) {
  std::vector<std::string> lines;
  for (std::size_t row = 0; row < records.trials.size(); ++row) {
    lines.push_back(line_of(records, row));
  }
  return lines;
}

/// "P01 background.age 31" for each answer.
std::vector<std::string> answers_of(const StudyRecords& records) {
  std::vector<std::string> lines;
  for (const AnswerRow& row : records.answers) {
    lines.push_back(fmt::format("{} {}.{} {}", records.sessions[row.session].participant,
                                records.questionnaire_of(row), records.question_of(row),
                                row.value.is_measured() ? fmt::format("{:g}", row.value.number)
                                                        : records.words[row.value.words]));
  }
  return lines;
}

TEST_F(Records, OfACompletedSession) {
  PlayedSession session = session_of("P01");
  session.run_trial(ms(1000), ms(500), ms(1500), 1);
  session.run_trial(ms(11'000), ms(4000), ms(9250), 4);
  session.run_trial(ms(31'000), ms(2000), ms(2000), 3);
  session.run_trial(ms(41'000), ms(250), ms(750), 5);
  const StudyRecords records = read_study(path_);

  EXPECT_EQ(records.protocol.name, "small");
  EXPECT_EQ(records.protocol.title, "A small study");
  EXPECT_EQ(records.protocol.sha256, small_protocol().sha256);
  EXPECT_EQ(records.display_profile, "goggles");
  EXPECT_EQ(records.tracker_profile, "camera");
  EXPECT_THAT(records.scenes, ElementsAre("box", "hall"));
  EXPECT_THAT(records.methods, ElementsAre("od", "fv", "mask:file=a.png"));
  ASSERT_EQ(records.measures.size(), 3U);
  EXPECT_EQ(records.measures[0].id(), "outline");
  EXPECT_EQ(records.measures[2].id(), "artifacts");
  EXPECT_EQ(records.measures[2].kind, MeasureKind::rating);
  EXPECT_THAT(records.sessions, ElementsAre(FieldsAre("P01", "simulated", "completed", 7, "")));
  EXPECT_THAT(lines_of(records), ElementsAre("P01 hall fv 0.0 test attempt 1 [rated]: 0.5 1.5 1",
                                             "P01 hall od 0.1 test attempt 1 [rated]: 4 9.25 4",
                                             "P01 box od 1.0 test attempt 1 [rated]: 2 2 3",
                                             "P01 box fv 1.1 test attempt 1 [rated]: 0.25 0.75 5"));
  EXPECT_EQ(records.words.at(records.trials.front().object), "vase");
  EXPECT_THAT(answers_of(records),
              ElementsAre("P01 background.age 31", "P01 background.cg_experience 4"));
}

TEST_F(Records, HaveTheResponseTimesOfWhomTheyWereMeasured) {
  session_of("P01").run_trial(ms(1000), ms(500), ms(1500), 1);
  EXPECT_EQ(read_study(path_).measures.size(), 3U) << "nobody's";
  PlayedSession session(store_, facts_of("P02"), small_plan());
  session.happen(ms(0), SessionStarted{});
  session.happen(
      ms(10), QuestionnaireAnswered{.questionnaire = "background",
                                    .answers = {{"age", 31.0, ms(2500)}, {"cg_experience", 4.0}}});
  session.choose_and_start(ms(20));
  session.happen(ms(1000), FirstFramePresented{ms(1000)});
  session.happen(ms(2000), Marked{ms(2000)});
  session.happen(ms(3000), Marked{ms(3000)});
  session.happen(ms(9000),
                 Rated{.answers = {{"artifacts", 4.0, ms(750)}}, .looked_around = ms(5250)});
  const StudyRecords records = read_study(path_);
  ASSERT_EQ(records.measures.size(), 5U);
  EXPECT_EQ(records.measures[2].id(), "looking_around");
  EXPECT_EQ(records.measures[3].id(), "artifacts_response");
  EXPECT_EQ(line_of(records, 0), "P01 hall fv 0.0 test attempt 1 [rated]: 0.5 1.5 - - 1");
  EXPECT_EQ(line_of(records, 4), "P02 hall fv 0.0 test attempt 1 [rated]: 1 2 5.25 0.75 4");
  EXPECT_EQ(records.answers[0].response_s, std::nullopt);
  EXPECT_EQ(records.answers[2].response_s, 2.5);
  EXPECT_EQ(records.answers[3].response_s, std::nullopt);
}

TEST_F(Records, HoldEveryTimingAndSayWhichCounts) {
  PlayedSession session = session_of("P01");
  session.choose_and_start(ms(20));
  session.happen(ms(1000), FirstFramePresented{ms(1000)});
  session.happen(ms(2000), Marked{ms(2000)});
  session.happen(ms(3000), Marked{ms(3000)});
  session.happen(ms(3100), RetimeRequested{});
  session.choose_and_start(ms(4000));
  session.happen(ms(5000), FirstFramePresented{ms(5000)});
  session.happen(ms(5250), Marked{ms(5250)});
  const StudyRecords timed = read_study(path_);
  EXPECT_THAT(line_of(timed, 0), "P01 hall fv 0.0 test attempt 1 not [retimed]: 1 2 -");
  EXPECT_THAT(line_of(timed, 1), EndsWith(": 0.25 - -"));
  EXPECT_FALSE(StudyRecords::is_result(timed.trials[0]));
  EXPECT_TRUE(StudyRecords::is_result(timed.trials[1]));
  session.happen(ms(5500), Marked{ms(5500)});
  session.happen(ms(5600), rated(2));
  EXPECT_THAT(line_of(read_study(path_), 1), "P01 hall fv 0.0 test attempt 2 [rated]: 0.25 0.5 2");
}

TEST_F(Records, DistinguishCensoredMarksFromMeasuredOnes) {
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
  EXPECT_THAT(line_of(records, 0), EndsWith(": >120 120.5 5"));
  EXPECT_THAT(line_of(records, 1), EndsWith(": 1 >121 -"));
}

TEST_F(Records, HoldInterruptedSessionsWithWhatTheyReached) {
  PlayedSession session = session_of("P01");
  session.run_trial(ms(1000), ms(500), ms(1500), 1);
  session.choose_and_start(ms(5000));
  session.happen(ms(6000), FirstFramePresented{ms(6000)});
  session.happen(ms(7000), Interrupted{});
  const StudyRecords records = read_study(path_);
  EXPECT_EQ(records.sessions.at(0).state, "interrupted");
  ASSERT_THAT(records.trials, SizeIs(4));
  EXPECT_EQ(records.value(0, 2).number, 1.0);
  EXPECT_EQ(records.trials[1].attempt, 1);
  EXPECT_EQ(records.value(1, 0).state, Value::State::missing);
  EXPECT_EQ(records.trials[2].attempt, 0);
  EXPECT_TRUE(records.trials[2].counts);
}

TEST_F(Records, LeaveOutWhatAParticipantTookBackUnlessItIsAskedFor) {
  PlayedSession withdrawn = session_of("P01");
  withdrawn.run_trial(ms(1000), ms(500), ms(1500), 1);
  withdrawn.happen(ms(5000), Withdrawn{});
  PlayedSession other = session_of("P02");
  other.run_trial(ms(1000), ms(600), ms(1600), 2);
  const StudyRecords records = read_study(path_);
  EXPECT_THAT(records.sessions, ElementsAre(FieldsAre("P01", "simulated", "withdrawn", 7, ""),
                                            FieldsAre("P02", "simulated", testing::_, 7, "")));
  EXPECT_THAT(records.trials, Each(testing::Field(&TrialRow::session, 1U)));
  EXPECT_THAT(records.trials, SizeIs(4));
  EXPECT_THAT(line_of(records, 0), "P02 hall fv 0.0 test attempt 1 [rated]: 0.6 1.6 2");
  EXPECT_THAT(answers_of(records),
              ElementsAre("P02 background.age 31", "P02 background.cg_experience 4"));

  const StudyRecords all = read_study(path_, WithdrawnSessions::with_data);
  ASSERT_THAT(all.trials, SizeIs(8));
  EXPECT_THAT(line_of(all, 0), "P01 hall fv 0.0 test attempt 1 [rated]: 0.5 1.5 1");
  EXPECT_THAT(line_of(all, 4), line_of(records, 0));
  EXPECT_THAT(answers_of(all),
              ElementsAre("P01 background.age 31", "P01 background.cg_experience 4",
                          "P02 background.age 31", "P02 background.cg_experience 4"));
}

TEST_F(Records, HoldTheReasonOfAnExclusionThatStands) {
  PlayedSession other_reason = session_of("P01");
  other_reason.happen(ms(5000), Excluded{.reason = "a slip"});
  other_reason.happen(ms(5001), EndUndone{});
  other_reason.happen(ms(5002), Excluded{.reason = "sees double"});
  PlayedSession undone = session_of("P02");
  undone.happen(ms(5000), Excluded{.reason = "a slip"});
  undone.happen(ms(5001), EndUndone{});
  EXPECT_THAT(read_study(path_).sessions,
              ElementsAre(FieldsAre("P01", "simulated", "excluded", 7, "sees double"),
                          FieldsAre("P02", "simulated", "paused", 7, "")));
}

TEST_F(Records, HoldPracticeCatchTrialsAndEarlierTimings) {
  const fs::path path = folder_ / "thorough.sqlite";
  StudyStore store(path, thorough_protocol());
  run_thorough_session(store, "P01");
  const StudyRecords records = read_study(path);
  EXPECT_THAT(records.sessions,
              ElementsAre(FieldsAre("P01", "simulated", "excluded", 7, "the tracker was lost")));
  std::vector<std::string> results;
  std::vector<std::string> others;
  for (std::size_t row = 0; row < records.trials.size(); ++row) {
    (StudyRecords::is_result(records.trials[row]) ? results : others)
        .push_back(line_of(records, row));
  }
  EXPECT_THAT(results, ElementsAre("P01 hall fv 0.0 test attempt 3 [rated]: 0.3 0.4 4",
                                   "P01 hall od 0.1 test attempt 1 [rated]: 0.5 0.6 3",
                                   "P01 box od 1.0 test attempt 1 [rated]: 0.5 0.6 3",
                                   "P01 box fv 1.1 test attempt 1 [rated]: 0.5 0.6 3"));
  ASSERT_EQ(others.size(), 5U);
  EXPECT_THAT(others[0], "P01 box od 0.0 practice attempt 1 [rated]: 0.1 0.2 5");
  EXPECT_THAT(others[1], StartsWith("P01 hall fv 0.0 test attempt 1 not ["));
  EXPECT_THAT(others[1], EndsWith(": >0.099 - -"));
  EXPECT_THAT(others[2], StartsWith("P01 hall fv 0.0 test attempt 2 not ["));
  EXPECT_THAT(others[3], StartsWith("P01 hall fv 0.0 catch attempt 1 not [interrupted]:"));
  EXPECT_THAT(others[4], "P01 hall fv 0.0 catch attempt 2 [rated]: 0.5 0.6 3");
}

TEST_F(Records, HoldEveryAnswerInNumbersAndInWords) {
  const fs::path path = folder_ / "thorough.sqlite";
  StudyStore store(path, thorough_protocol());
  run_thorough_session(
      store, "P01",
      QuestionnaireAnswered{.questionnaire = "debrief",
                            .answers = {{.question = "sickness", .value = 2.0},
                                        {.question = "comments", .value = "a, \"b\""}}});
  EXPECT_THAT(answers_of(read_study(path)),
              ElementsAre("P01 background.age 31", "P01 background.cg_experience 4",
                          "P01 debrief.sickness 2", "P01 debrief.comments a, \"b\""));
}

/// A study whose rating is answered in words.
TEST_F(Records, HoldRatingsInWords) {
  Protocol protocol = small_protocol();
  protocol.ratings = {{.id = "artifacts", .kind = QuestionKind::text}};
  const std::string rating = "text = \"Artifacts?\"\n";
  protocol.text.insert(protocol.text.find(rating), "kind = \"text\"\n");
  const fs::path path = folder_ / "words.sqlite";
  StudyStore store(path, protocol);
  PlayedSession session(store, facts_of("P01"), small_plan(), protocol);
  session.begin();
  session.choose_and_start(ms(999));
  session.happen(ms(1000), FirstFramePresented{ms(1000)});
  session.happen(ms(1500), Marked{ms(1500)});
  session.happen(ms(2000), Marked{ms(2000)});
  session.happen(ms(2100), Rated{{{.question = "artifacts", .value = "all over"}}});
  const StudyRecords records = read_study(path);
  EXPECT_FALSE(records.measures.at(2).is_numeric());
  EXPECT_THAT(line_of(records, 0), "P01 hall fv 0.0 test attempt 1 [rated]: 0.5 1 'all over'");
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
  // Earlier versions called an injected effect a plant.
  const std::vector<std::pair<std::string, std::optional<SimulationFacts>>> cases = {
      {"{}", std::nullopt},
      {R"({"simulation": {"scale": 36.0, "predicted": true, "injected": "none"}})",
       SimulationFacts{.scale = 36.0, .predicted = true}},
      {R"({"simulation": {"scale": 1.0, "predicted": false, "injected": "faster:fv:2"}})",
       SimulationFacts{.scale = 1.0, .predicted = false, .injected = "faster:fv:2"}},
      {R"({"simulation": {"scale": 1.0, "predicted": false, "plant": "faster:fv:2"}})",
       SimulationFacts{.scale = 1.0, .predicted = false, .injected = "faster:fv:2"}},
      {R"({"simulation": {"scale": 1.0, "samples_per_second": 8e5, "predicted": true, "injected": "none"}})",
       SimulationFacts{.scale = 1.0, .samples_per_second = 8e5, .predicted = true}}};
  for (const auto& [devices, simulation] : cases) {
    const fs::path path = folder_ / (std::to_string(&devices - &cases[0].first) + ".sqlite");
    SessionFacts facts = facts_of("P01");
    facts.devices = devices;
    StudyStore(path, small_protocol()).begin_session(facts, small_plan());
    EXPECT_EQ(read_study(path).simulation, simulation) << devices;
  }
}

TEST_F(Records, OfATrialInAStrangeSceneAreRefused) {
  session_of("P01");
  SQLite::Database file(path_, SQLite::OPEN_READWRITE);
  file.exec("PRAGMA foreign_keys = OFF");
  file.exec("INSERT INTO planned_trial VALUES (1, 99, 'practice', 'elsewhere', 'od', 0, 0)");
  EXPECT_THAT(refusal([&] { read_study(path_); }),
              HasSubstr("the scene 'elsewhere' of a planned trial: is not one of the study's"));
}

}  // namespace
}  // namespace foveola::study
