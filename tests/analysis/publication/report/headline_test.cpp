#include <cmath>

#include "analysis/publication/report/summary.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

/// Of the outline with fv.
std::string finding(const study::StudyRecords& records, const study::AnalysisPlan& plan,
                    const FittedModels& models = {}) {
  const StudyTables tables = tabulate_study(records);
  for (const Headline& found : headlines(tables, compare_methods(tables.set, plan, models))) {
    if (found.before == "FV took" && found.after.find("outline") != std::string::npos) {
      return found.sentence();
    }
  }
  return "";
}

study::StudyRecords censored_study() {
  study::StudyRecords records = complete_study(6);
  value_of(records, "P3", "aula", "od", "outline") = right_censored(30.0);
  return records;
}

FittedModels tobit(const std::string& method, const std::string& reference, double ratio) {
  const double low = std::log(ratio / 1.1);
  const double high = std::log(ratio * 1.1);
  return {
      .models = {{.model = "tobit",
                  .measure = "outline",
                  .method = method,
                  .reference = reference,
                  .fit = FittedModel::Fit{std::log(ratio), 0.04, 5.0, Interval{low, high}, 1e-7},
                  .scenes = 2}}};
}

// A mean of complete cases said 78.5 % beside a primary ratio of 59.4 %.
TEST(Headline, IsThePrimaryResult) {
  EXPECT_EQ(
      finding(censored_study(), {}, tobit("fv", "od", 0.594)),
      "FV took 59.4 [54.0, 65.3] % of OD’s time until the outline was visible for scenes like "
      "these, from 2 scenes (Tobit model; right-censored: 1 of 12 times of OD, 0 of 12 of "
      "FV)");
}

TEST(Headline, APlanMayNameThePairTheOtherWayRound) {
  study::AnalysisPlan plan;
  plan.primary = {{"outline", "od", "fv"}};
  plan.scenes = study::SceneEffects::fixed;
  EXPECT_THAT(finding(censored_study(), plan, tobit("od", "fv", 1.0 / 0.594)),
              AllOf(StartsWith("FV took 59.4 [54.0, 65.3] % of OD’s time"),
                    HasSubstr(" in 2 scenes (Tobit model;")));
}

TEST(Headline, SaysWhatStandsInAndWhichScenesAreLeft) {
  study::StudyRecords records = complete_study(6);
  change_values(records, "outline", [&, i = 0](study::Value& value) mutable {
    const study::TrialRow& trial = records.trials[static_cast<std::size_t>(i++)];
    if (trial.scene == 0 && trial.method == 0) {
      value = right_censored(180.0);
    }
  });
  EXPECT_THAT(finding(records, {}),
              AllOf(HasSubstr(" in 1 of 2 scenes (paired t over participants, a stand-in: "),
                    HasSubstr("which biases the ratio"),
                    HasSubstr("right-censored: 6 of 12 times of OD, 0 of 12 of FV")));
}

}  // namespace
}  // namespace foveola::analysis
