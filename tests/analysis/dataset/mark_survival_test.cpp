#include "analysis/dataset/mark_survival.h"

#include <algorithm>

#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

TEST(MarkSurvival, WithoutTimeOutsTheRestrictedMeanIsTheMean) {
  study::StudyRecords records = complete_study(4);
  double sum = 0.0;
  double longest = 0.0;
  std::size_t count = 0;
  const Dataset set = select_for_analysis(records);
  for (std::size_t participant = 0; participant < 4; ++participant) {
    for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
      for (std::size_t method = 0; method < 3; ++method) {
        const double time = set.value(participant, scene, method, outline_index).number;
        longest = std::max(longest, time);
        if (method == 0) {
          sum += time;
          ++count;
        }
      }
    }
  }
  const std::vector<MarkSurvival> survival = mark_survival(set);
  ASSERT_EQ(survival.size(), 2U * 3U);
  EXPECT_EQ(survival[0].mark, "outline");
  EXPECT_EQ(survival[0].method, "od");
  EXPECT_EQ(survival[0].curve.n, count);
  EXPECT_EQ(survival[0].curve.censored, 0U);
  EXPECT_NEAR(survival[0].restricted->mean, sum / static_cast<double>(count), 1e-9);
  EXPECT_EQ(survival[0].restricted->horizon, longest);
  EXPECT_THAT(unreached_in_words(survival), IsEmpty());
}

TEST(MarkSurvival, WhatWasNeverReachedIsSaid) {
  study::StudyRecords records = complete_study(4);
  for (const char* participant : {"P1", "P2", "P3", "P4"}) {
    value_of(records, participant, "aula", "od", "outline") = right_censored(180.0);
  }
  value_of(records, "P1", "barn", "od", "outline") = {};
  const std::vector<MarkSurvival> survival = mark_survival(select_for_analysis(records));
  EXPECT_THAT(unreached_in_words(survival),
              ElementsAre("OD did not reach the mark outline within 180 s in 4 of 7 trials."));
  EXPECT_EQ(survival[0].curve.censored, 4U);
  EXPECT_FALSE(survival[0].curve.median);
  // The same horizon for all methods of the mark.
  EXPECT_EQ(survival[0].restricted->horizon, 180.0);
  EXPECT_EQ(survival[2].restricted->horizon, 180.0);
  EXPECT_LT(survival[2].restricted->mean, survival[0].restricted->mean);
  EXPECT_NE(survival[3].restricted->horizon, 180.0);
}

TEST(MarkSurvival, AMethodThatNeverCameToAnEndHasNoMedian) {
  study::StudyRecords records = complete_study(3);
  for (std::size_t i = 0; i < records.trials.size(); ++i) {
    if (records.trials[i].method == 0) {
      records.values[i * records.measures.size()] = right_censored(60.0);
    }
  }
  const std::vector<MarkSurvival> survival = mark_survival(select_for_analysis(records));
  EXPECT_EQ(survival[0].curve.events, 0U);
  EXPECT_FALSE(survival[0].curve.median);
  EXPECT_EQ(survival[0].restricted->mean, 60.0);
}

}  // namespace
}  // namespace foveola::analysis
