#include "analysis/publication/comparisons.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/publication/analysis_plan.h"
#include "analysis/publication/comparison_tables.h"
#include "analysis/publication/study_tables.h"
#include "renderer/base/csv.h"
#include "tests/analysis/golden.h"
#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

using study::StudyRecords;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

const char* const fv_planned =
    "methods = [\"od\", \"vp\", \"fv\"]\n[[analysis.primary]]\nmeasure = \"outline\"\n"
    "method = \"fv\"\n[analysis.equivalence_margins]\nartifacts = 1\noutline = 1.5\n";

Comparisons compare(const StudyRecords& records, const std::string& protocol = "") {
  return compare_methods(select_for_analysis(records), plan_of(protocol));
}

const MethodComparison& find(const Comparisons& comparisons, const std::string& measure,
                             const std::string& method, const std::string& reference) {
  const auto found = std::find_if(
      comparisons.methods.begin(), comparisons.methods.end(), [&](const MethodComparison& row) {
        return row.measure == measure && row.method == method && row.reference == reference;
      });
  if (found == comparisons.methods.end()) {
    throw std::out_of_range(measure + method + reference);
  }
  return *found;
}

TEST(Comparisons, EveryPairOfMethodsInEveryMeasure) {
  const Comparisons comparisons = compare(complete_study(5));
  EXPECT_EQ(comparisons.methods.size(), 3U * 3U);
  EXPECT_EQ(comparisons.omnibus.size(), 3U);
  EXPECT_EQ(comparisons.order.size(), 4U);
  EXPECT_NO_THROW((void)find(comparisons, "artifacts", "fv", "vp"));
}

TEST(Comparisons, RatiosAreThoseOfFigure5) {
  const auto golden = golden_study();
  const Comparisons comparisons = compare(golden_study_records());
  const MethodComparison& fv = find(comparisons, "outline", "fv", "od");
  EXPECT_GOLDEN(100.0 * fv.ratio->ratio, golden.at("outline.fv.geometric_mean_percent"));
  EXPECT_GOLDEN(100.0 * fv.ratio->interval.low, golden.at("outline.fv.low_percent"));
  EXPECT_LT(100.0 * fv.ratio_bca->low, golden.at("outline.fv.geometric_mean_percent"));
  EXPECT_GT(100.0 * fv.ratio_bca->high, golden.at("outline.fv.geometric_mean_percent"));
  EXPECT_DOUBLE_EQ(fv.ranks->p, 2.0 / 256.0);
  EXPECT_DOUBLE_EQ(fv.ranks->rank_biserial, -1.0);
}

TEST(Comparisons, ThePlanSaysWhatIsPrimary) {
  const Comparisons comparisons = compare(golden_study_records(), fv_planned);
  for (const MethodComparison& row : comparisons.methods) {
    EXPECT_EQ(row.primary, row.measure == "outline" && row.method == "fv" && row.reference == "od");
  }
  // Alone in its family: nothing to adjust. The other two share the exploratory one.
  const MethodComparison& planned = find(comparisons, "outline", "fv", "od");
  EXPECT_EQ(planned.p_holm, planned.ratio->logs.p);
  const MethodComparison& vp = find(comparisons, "outline", "vp", "od");
  const MethodComparison& other = find(comparisons, "outline", "fv", "vp");
  const double smaller = std::min(vp.ratio->logs.p, other.ratio->logs.p);
  EXPECT_DOUBLE_EQ(std::min(*vp.p_holm, *other.p_holm), 2.0 * smaller);
  EXPECT_TRUE(planned.equivalent);
  EXPECT_GT(planned.equivalent->p, 0.99);
  EXPECT_FALSE(find(comparisons, "material", "fv", "od").equivalent);
}

TEST(Comparisons, APlanMayNameThePairTheOtherWayRound) {
  const Comparisons comparisons =
      compare(complete_study(4),
              "methods = [\"od\"]\n[[analysis.primary]]\nmeasure = \"material\"\n"
              "method = \"od\"\nbaseline = \"vp\"\n");
  EXPECT_TRUE(find(comparisons, "material", "vp", "od").primary);
}

// An estimate from bounds of right-censored times was biased, and its intervals far too short.
TEST(Comparisons, AreOfTheScenesWithoutRightCensoredTimes) {
  StudyRecords records = complete_study(6);
  trial_of(records, "P3", "aula", "od").outline_censored = true;
  const Comparisons with_one_run_out = compare(records);
  const MethodComparison& fv = find(with_one_run_out, "outline", "fv", "od");
  EXPECT_EQ(fv.n, 6U);
  for (const CsvRow& row : parse_csv(comparisons_csv(with_one_run_out, "human"), "comparisons")) {
    EXPECT_THAT(row, Not(Contains(HasSubstr("bounded"))));
  }
  for (const char* method : {"od", "vp", "fv"}) {
    trial_of(records, "P3", "aula", method).outline_s = std::nullopt;
  }
  EXPECT_EQ(fv.ratio->ratio, find(compare(records), "outline", "fv", "od").ratio->ratio);
}

TEST(Comparisons, UnitsAndTheOrderOfParticipantsDoNotMatter) {
  StudyRecords records = golden_study_records();
  const Comparisons plain = compare(records);
  for (study::TrialRow& row : records.trials) {
    for (auto* time : {&row.outline_s, &row.material_s}) {
      if (*time) {
        **time *= 1000.0;
      }
    }
  }
  std::reverse(records.trials.begin(), records.trials.end());
  std::reverse(records.sessions.begin(), records.sessions.end());
  const Comparisons other = compare(records);
  for (std::size_t i = 0; i < plain.methods.size(); ++i) {
    EXPECT_EQ(plain.methods[i].ranks->p, other.methods[i].ranks->p);
    if (plain.methods[i].ratio) {
      EXPECT_GOLDEN(other.methods[i].ratio->logs.p, plain.methods[i].ratio->logs.p);
      EXPECT_GOLDEN(other.methods[i].ratio->ratio, plain.methods[i].ratio->ratio);
    }
  }
  for (std::size_t i = 0; i < plain.omnibus.size(); ++i) {
    EXPECT_GOLDEN(other.omnibus[i].ranks->p, plain.omnibus[i].ranks->p);
  }
}

TEST(Comparisons, LearningIsFoundInTheOrderOfTrials) {
  StudyRecords records = complete_study(6);
  int shift = 0;
  for (study::TrialRow& row : records.trials) {
    // Every participant in another order; each trial a tenth faster than the one before.
    const int scene = row.scene == "aula" ? 0 : 1;
    const int method = row.method == "od" ? 0 : row.method == "vp" ? 1 : 2;
    row.scene_position = (scene + shift / 6) % 2;
    row.method_position = (method + shift / 6) % 3;
    row.outline_s = std::pow(0.9, row.scene_position * 3 + row.method_position) *
                    (5.0 + (shift % 7) * 0.01) * (1.0 + method) * (1.0 + scene);
    ++shift;
  }
  const Comparisons comparisons = compare(records);
  const OrderTest& test = comparisons.order.front();
  EXPECT_EQ(test.of, "trial in the session");
  EXPECT_NEAR(test.change_per_step->mean, std::log(0.9), 0.01);
}

TEST(Comparisons, FewParticipantsHaveWhatCanBeComputed) {
  const Comparisons one = compare(complete_study(1));
  const MethodComparison& fv = find(one, "outline", "fv", "od");
  EXPECT_EQ(fv.n, 1U);
  EXPECT_FALSE(fv.ratio || fv.ratio_bca);
  EXPECT_EQ(fv.ranks->p, 1.0);
  EXPECT_FALSE(fv.p_holm);
  StudyRecords alone = complete_study(3);
  alone.methods = {"od"};
  EXPECT_TRUE(compare(alone).methods.empty());
}

TEST(ComparisonTables, EveryRowHasEveryColumnAndSaysWhoTookPart) {
  for (const int participants : {1, 2, 6}) {
    const Comparisons comparisons = compare(complete_study(participants), fv_planned);
    for (const std::string& text :
         {comparisons_csv(comparisons, "simulated"), omnibus_csv(comparisons, "simulated"),
          order_csv(comparisons, "simulated")}) {
      const std::vector<CsvRow> rows = parse_csv(text, "table");
      EXPECT_THAT(rows, Each(SizeIs(rows.front().size())));
      EXPECT_EQ(rows.front().back(), "participant_kind");
      EXPECT_EQ(rows.back().back(), "simulated");
      EXPECT_THAT(text, testing::Not(testing::HasSubstr("nan")));
    }
  }
}

TEST(ComparisonTables, NumbersAreInFullPrecision) {
  const Comparisons comparisons = compare(golden_study_records());
  const std::vector<CsvRow> rows = parse_csv(comparisons_csv(comparisons, "human"), "table");
  const MethodComparison& first = comparisons.methods.front();
  EXPECT_EQ(rows.at(0).at(5), "ratio_percent");
  EXPECT_EQ(std::stod(rows.at(1).at(5)), 100.0 * first.ratio->ratio);
}

}  // namespace
}  // namespace foveola::analysis
