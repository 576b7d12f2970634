#include <gtest/gtest.h>

#include "analysis/dataset/mark_survival.h"
#include "analysis/monte_carlo/expected_study.h"
#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

TEST(OutlyingTimes, ATimeTenTimesTooLongIsNamed) {
  study::StudyRecords records = draw_study(example_study(), 16, 5);
  const std::string participant = records.sessions[3].participant;
  const std::string scene = records.scenes[2];
  const std::string method = records.methods[1];
  Value& time = value_of(records, participant, scene, method, "material");
  time.number *= 10.0;
  const std::vector<OutlyingTime> found = outlying_times(select_for_analysis(records));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].mark, "material");
  EXPECT_EQ(found[0].participant, participant);
  EXPECT_EQ(found[0].scene, scene);
  EXPECT_EQ(found[0].method, method);
  EXPECT_NEAR(found[0].seconds, time.number, 1e-9 * time.number);
  EXPECT_GT(found[0].ratio_to_expected, 3.0);
  EXPECT_LT(found[0].ratio_to_expected, 40.0);
}

}  // namespace
}  // namespace foveola::analysis
