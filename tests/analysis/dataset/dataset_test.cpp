#include "analysis/dataset/dataset.h"

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

using study::StudyRecords;

/// "participant/scene/method/measure: reason" for each exclusion.
std::vector<std::string> exclusions_of(const StudyRecords& records) {
  std::vector<std::string> texts;
  for (const Exclusion& row : select_for_analysis(records).exclusions) {
    texts.push_back(row.participant + "/" + row.scene + "/" + row.method + "/" + row.measure +
                    ": " + row.reason);
  }
  return texts;
}

auto selecting(const StudyRecords& records) {
  return [&records] { (void)select_for_analysis(records); };
}

TEST(Dataset, ACompleteStudyExcludesNothing) {
  const Dataset set = select_for_analysis(complete_study(3));
  EXPECT_THAT(set.participants, ElementsAre("P1", "P2", "P3"));
  EXPECT_THAT(set.exclusions, IsEmpty());
  EXPECT_EQ(set.kind, "human");
  EXPECT_TRUE(set.is_complete(2, 1, material_index));
}

TEST(Dataset, EveryGapIsListed) {
  EXPECT_THAT(
      exclusions_of(golden_study_records()),
      ElementsAre(
          "P02/aula/vp/: no trial recorded",
          "P03/aula/od/outline: right-censored: the time-out is only a lower bound of the time",
          "P03/aula/od/material: right-censored: the time-out is only a lower bound of the time",
          "P04/barn/fv/material: no time recorded", "P05/cave/od/artifacts: no rating recorded",
          "P09///: session interrupted"));
}

TEST(Dataset, TimesKnowWhetherTheyWereMeasured) {
  const Dataset set = select_for_analysis(golden_study_records());
  EXPECT_EQ(set.value(2, 0, 0, outline_index).state, Value::State::right_censored);
  EXPECT_EQ(set.value(1, 0, 1, outline_index).state, Value::State::missing);
  EXPECT_EQ(set.value(0, 0, 0, outline_index).state, Value::State::measured);
  EXPECT_FALSE(set.is_complete(2, 0, outline_index));
  EXPECT_TRUE(set.is_complete(3, 1, outline_index));
  EXPECT_FALSE(set.is_complete(3, 1, material_index));
}

TEST(Dataset, KindsOfSessionsAreNeverMixed) {
  StudyRecords records = complete_study(3);
  records.sessions[0].kind = "simulated";
  records.sessions[1].kind = "pilot";
  const Dataset people = select_for_analysis(records);
  EXPECT_THAT(people.participants, ElementsAre("P3"));
  EXPECT_THAT(exclusions_of(records),
              ElementsAre("P1///: simulated session; only human sessions are analysed together",
                          "P2///: pilot session; only human sessions are analysed together"));
  records.sessions[2].state = "withdrawn";
  EXPECT_THAT(select_for_analysis(records).participants, ElementsAre("P2"));
  records.sessions[1].state = "interrupted";
  EXPECT_THAT(select_for_analysis(records).participants, ElementsAre("P1"));
}

TEST(Dataset, SessionsThatAreNotCompletedAreListedWithWhy) {
  StudyRecords records = complete_study(5);
  records.sessions[0].state = "paused";
  records.sessions[1].state = "interrupted";
  records.sessions[2].state = "excluded";
  records.sessions[2].reason = "asleep";
  records.sessions[3].state = "withdrawn";
  EXPECT_THAT(select_for_analysis(records).participants, ElementsAre("P5"));
  EXPECT_THAT(
      exclusions_of(records),
      ElementsAre("P1///: session interrupted: in its state paused", "P2///: session interrupted",
                  "P3///: session excluded: asleep", "P4///: session withdrawn"));
}

TEST(Dataset, RatingsOnAnyScaleAreTaken) {
  StudyRecords records = complete_study(1);
  records.measures[artifacts_index].question.minimum = 0;
  records.measures[artifacts_index].question.maximum = 100;
  value_of(records, "P1", "aula", "od", "artifacts") = measured(38);
  const Dataset set = select_for_analysis(records);
  EXPECT_THAT(set.exclusions, IsEmpty());
  EXPECT_EQ(set.value(0, 0, 0, artifacts_index).number, 38.0);
}

TEST(Dataset, RatingsInWordsAreKeptAndNotCountedAmongThoseInNumbers) {
  StudyRecords records = complete_study(1);
  records.measures[artifacts_index].question.kind = study::QuestionKind::text;
  records.words.emplace_back("all over");
  change_values(records, "artifacts",
                [](Value& value) { value = {.state = Value::State::in_words, .words = 3}; });
  const Dataset set = select_for_analysis(records);
  EXPECT_THAT(set.ratings(), IsEmpty());
  EXPECT_THAT(set.exclusions, IsEmpty());
  EXPECT_EQ(set.value(0, 1, 2, artifacts_index).state, Value::State::in_words);
}

TEST(Dataset, OnlyTheLastTimingOfATestTrialIsTaken) {
  StudyRecords records = complete_study(1);
  study::TrialRow earlier = records.trials.front();
  earlier.counts = false;
  records.add_trial(earlier, {measured(99), measured(99), measured(5)});
  study::TrialRow other = records.trials.front();
  other.kind = study::TrialKind::practice;
  records.add_trial(other, {measured(88), measured(88), measured(5)});
  other.kind = study::TrialKind::catch_trial;
  records.add_trial(other, {measured(77), measured(77), measured(5)});
  trial_of(records, "P1", "aula", "od").attempt = 2;
  const Dataset set = select_for_analysis(records);
  EXPECT_LT(set.value(0, 0, 0, outline_index).number, 20.0);
  EXPECT_EQ(set.trial(0, 0, 0).attempts, 2);
  EXPECT_THAT(set.exclusions, IsEmpty());
}

TEST(Dataset, NothingCompletedIsAnErrorWithARemedy) {
  StudyRecords records = complete_study(2);
  records.sessions[0].state = "interrupted";
  records.sessions[1].state = "withdrawn";
  EXPECT_THAT(selecting(records),
              ThrowsMessage<Error>(AllOf(HasSubstr("none of its 2 sessions is completed"),
                                         HasSubstr("foveola study simulate"))));
  EXPECT_THAT(selecting(complete_study(0)),
              ThrowsMessage<Error>(HasSubstr("none of its 0 sessions")));
}

TEST(Dataset, AProtocolWithoutScenesOrMethodsIsAnError) {
  StudyRecords records = complete_study(1);
  records.scenes.clear();
  EXPECT_THAT(selecting(records),
              ThrowsMessage<Error>(HasSubstr("protocol without scenes or methods")));
}

// As a key that is held down when a trial begins leaves it.
TEST(Dataset, ATimeWithoutLogarithmIsLeftOutAndNamed) {
  for (const double impossible : {0.0, -2.5}) {
    StudyRecords records = complete_study(2);
    value_of(records, "P2", "barn", "fv", "material") = measured(impossible);
    EXPECT_THAT(exclusions_of(records),
                ElementsAre(fmt::format("P2/barn/fv/material: a time of {} s has no logarithm",
                                        impossible)));
    const Dataset set = select_for_analysis(records);
    EXPECT_EQ(set.value(1, 1, 2, material_index).state, Value::State::missing);
    EXPECT_TRUE(set.value(1, 1, 2, outline_index).is_measured());
  }
}

TEST(Dataset, ARatingOutsideTheScaleIsNamed) {
  for (const double impossible : {0.0, 6.0, 2.5}) {
    StudyRecords records = complete_study(2);
    value_of(records, "P1", "aula", "vp", "artifacts") = measured(impossible);
    EXPECT_THAT(selecting(records),
                ThrowsMessage<Error>(
                    HasSubstr("participant P1, scene aula, method vp, rating artifacts: is ")));
  }
}

TEST(Dataset, ARowTwiceIsNamed) {
  StudyRecords records = complete_study(2);
  records.add_trial(study::TrialRow(records.trials.front()), {{}, {}, {}});
  EXPECT_THAT(selecting(records),
              ThrowsMessage<Error>(AllOf(HasSubstr("participant P1, scene aula, method od"),
                                         HasSubstr("appears twice"))));
}

TEST(Dataset, WhatAnInterruptedSessionHoldsIsNotChecked) {
  StudyRecords records = golden_study_records();
  value_of(records, "P09", "aula", "od", "outline") = measured(-1.0);
  EXPECT_NO_THROW((void)select_for_analysis(records));
}

}  // namespace
}  // namespace foveola::analysis
