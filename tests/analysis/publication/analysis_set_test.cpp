#include "analysis/publication/analysis_set.h"

#include <limits>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/publication/comparisons.h"
#include "renderer/base/error.h"
#include "study/protocol/analysed_measures.h"
#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

using study::StudyRecords;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

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

TEST(AnalysisSet, ACompleteStudyExcludesNothing) {
  const AnalysisSet set = select_for_analysis(complete_study(3));
  EXPECT_THAT(set.participants, ElementsAre("P1", "P2", "P3"));
  EXPECT_THAT(set.exclusions, IsEmpty());
  EXPECT_EQ(set.kind, "human");
  EXPECT_TRUE(set.is_complete(2, 1, Mark::material));
}

TEST(AnalysisSet, EveryGapIsListed) {
  EXPECT_THAT(
      exclusions_of(golden_study_records()),
      ElementsAre(
          "P02/aula/vp/: no trial recorded",
          "P03/aula/od/outline: right-censored: the time-out is only a lower bound of the time",
          "P03/aula/od/material: right-censored: the time-out is only a lower bound of the time",
          "P04/barn/fv/material: no time recorded", "P05/cave/od/artifacts: no rating recorded",
          "P09///: session interrupted"));
}

TEST(AnalysisSet, TimesKnowWhetherTheyWereMeasured) {
  const AnalysisSet set = select_for_analysis(golden_study_records());
  EXPECT_EQ(set.cell(2, 0, 0).time(Mark::outline).state, MarkTime::State::censored);
  EXPECT_EQ(set.cell(1, 0, 1).time(Mark::outline).state, MarkTime::State::missing);
  EXPECT_EQ(set.cell(0, 0, 0).time(Mark::outline).state, MarkTime::State::measured);
  EXPECT_FALSE(set.is_complete(2, 0, Mark::outline));
  EXPECT_TRUE(set.is_complete(3, 1, Mark::outline));
  EXPECT_FALSE(set.is_complete(3, 1, Mark::material));
}

TEST(AnalysisSet, KindsOfSessionsAreNeverMixed) {
  StudyRecords records = complete_study(3);
  records.sessions[0].kind = "simulated";
  records.sessions[1].kind = "pilot";
  const AnalysisSet people = select_for_analysis(records);
  EXPECT_THAT(people.participants, ElementsAre("P3"));
  EXPECT_THAT(exclusions_of(records),
              ElementsAre("P1///: simulated session; only human sessions are analysed together",
                          "P2///: pilot session; only human sessions are analysed together"));
  records.sessions[2].state = "withdrawn";
  EXPECT_THAT(select_for_analysis(records).participants, ElementsAre("P2"));
  records.sessions[1].state = "interrupted";
  EXPECT_THAT(select_for_analysis(records).participants, ElementsAre("P1"));
}

TEST(AnalysisSet, SessionsThatAreNotCompletedAreListedWithWhy) {
  StudyRecords records = complete_study(5);
  records.sessions[0].state = "paused";
  records.sessions[1].state = "interrupted";
  records.sessions[2].state = "excluded";
  records.sessions[2].reason = "asleep";
  records.sessions[3].state = "withdrawn";
  EXPECT_THAT(select_for_analysis(records).participants, ElementsAre("P5"));
  EXPECT_THAT(exclusions_of(records),
              ElementsAre("P1///: session paused", "P2///: session interrupted",
                          "P3///: session excluded: asleep", "P4///: session withdrawn"));
}

TEST(AnalysisSet, AnalysedMeasuresAreThoseThatProtocolChecksName) {
  const AnalysisSet set = select_for_analysis(complete_study(3));
  std::set<std::string> compared;
  for (const MethodComparison& row : compare_methods(set, {}).methods) {
    compared.insert(row.measure);
  }
  std::set<std::string> analysed(study::analysed_marks.begin(), study::analysed_marks.end());
  analysed.insert(study::analysed_rating);
  EXPECT_EQ(compared, analysed);
}

TEST(AnalysisSet, RatingsOnAnotherScaleAreLeftOutAndTimesAreNot) {
  StudyRecords records = complete_study(1);
  records.protocol_text =
      "[[rating]]\nid = \"artifacts\"\ntext = \"?\"\nminimum = 0\nmaximum = 100\n";
  trial_of(records, "P1", "aula", "od").artifact_rating = 38;
  const AnalysisSet set = select_for_analysis(records);
  EXPECT_TRUE(set.is_complete(0, 0, Mark::outline));
  EXPECT_EQ(set.exclusions.size(), set.cells.size());
  for (std::size_t method = 0; method < set.methods.size(); ++method) {
    EXPECT_FALSE(set.cell(0, 0, method).rating);
  }
  EXPECT_THAT(exclusions_of(records),
              testing::Each(HasSubstr("/artifacts: rated on another scale than from 1 to 5")));
}

TEST(AnalysisSet, RowsOutsideTheProtocolAreListed) {
  StudyRecords records = complete_study(1);
  records.trials.push_back(records.trials.front());
  records.trials.back().scene = "elsewhere";
  EXPECT_THAT(exclusions_of(records), ElementsAre("P1/elsewhere/od/: not in the protocol"));
}

TEST(AnalysisSet, NothingCompletedIsAnErrorWithARemedy) {
  StudyRecords records = complete_study(2);
  records.sessions[0].state = "interrupted";
  records.sessions[1].state = "withdrawn";
  EXPECT_THAT(selecting(records),
              ThrowsMessage<Error>(AllOf(HasSubstr("none of its 2 sessions is completed"),
                                         HasSubstr("foveola study simulate"))));
  EXPECT_THAT(selecting(complete_study(0)),
              ThrowsMessage<Error>(HasSubstr("none of its 0 sessions")));
}

TEST(AnalysisSet, AProtocolWithoutScenesOrMethodsIsAnError) {
  StudyRecords records = complete_study(1);
  records.scenes.clear();
  EXPECT_THAT(selecting(records), ThrowsMessage<Error>(HasSubstr("no scene or no method")));
}

TEST(AnalysisSet, ATimeWithoutLogarithmIsNamed) {
  for (const double impossible : {0.0, -2.5, std::numeric_limits<double>::infinity()}) {
    StudyRecords records = complete_study(2);
    trial_of(records, "P2", "barn", "fv").material_s = impossible;
    EXPECT_THAT(selecting(records),
                ThrowsMessage<Error>(
                    HasSubstr("participant P2, scene barn, method fv, material time: is ")));
  }
}

TEST(AnalysisSet, ARatingOutsideTheScaleIsNamed) {
  for (const int impossible : {0, 6}) {
    StudyRecords records = complete_study(2);
    trial_of(records, "P1", "aula", "vp").artifact_rating = impossible;
    EXPECT_THAT(selecting(records),
                ThrowsMessage<Error>(HasSubstr("participant P1, scene aula, method vp, artifact")));
  }
}

TEST(AnalysisSet, ARowTwiceIsNamed) {
  StudyRecords records = complete_study(2);
  records.trials.push_back(records.trials.front());
  EXPECT_THAT(selecting(records),
              ThrowsMessage<Error>(AllOf(HasSubstr("participant P1, scene aula, method od"),
                                         HasSubstr("appears twice"))));
}

TEST(AnalysisSet, WhatAnInterruptedSessionHoldsIsNotChecked) {
  StudyRecords records = golden_study_records();
  trial_of(records, "P09", "aula", "od").outline_s = -1.0;
  EXPECT_NO_THROW((void)select_for_analysis(records));
}

}  // namespace
}  // namespace foveola::analysis
