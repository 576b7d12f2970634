#include "analysis/koskela2018/published_comparison.h"

#include <algorithm>
#include <cmath>

#include "analysis/koskela2018/background.h"
#include "analysis/koskela2018/own_cells.h"
#include "tests/analysis/golden.h"
#include "tests/analysis/koskela2018/paper.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

/// A paper of two scenes, the second of which has a counterpart, and one question.
PublishedStudy made_up_paper() {
  PublishedStudy made_up = paper();
  made_up.background = {{"offline_rendering", 2.5, 1.0}, {"age", 30.0, 2.0}};
  made_up.times = {{"aula", "", "outline", "od", 12.0, 3.0},
                   {"aula", "", "outline", "fv", 9.0, 3.0},
                   {"unseen", "barn", "outline", "od", 3.0, 1.0},
                   {"unseen", "barn", "outline", "fv", 16.0, 2.0},
                   {"elsewhere", "nowhere", "material", "fv", 10.0, 2.0}};
  return made_up;
}

struct Compared {
  StudyTables tables;
  std::vector<ComparedNumber> numbers;
};

Compared compare(const study::StudyRecords& records, const PublishedStudy& published) {
  Compared compared{tabulate_study(records), {}};
  compared.numbers = compare_with_published(records, compared.tables, published);
  return compared;
}

/// Which number: empty texts stand for any.
struct Wanted {
  std::string source;
  std::string row;
  std::string reading;
  std::string mark;
  std::string method;
};

const ComparedNumber& number_of(const Compared& compared, const Wanted& wanted) {
  const auto is = [](const std::string& text, const std::string& pattern) {
    return pattern.empty() || text == pattern;
  };
  const auto found = std::find_if(
      compared.numbers.begin(), compared.numbers.end(), [&](const ComparedNumber& number) {
        return is(number.source, wanted.source) && is(number.row, wanted.row) &&
               is(number.reading, wanted.reading) && is(number.mark, wanted.mark) &&
               is(number.method, wanted.method);
      });
  if (found == compared.numbers.end()) {
    throw std::out_of_range("no number " + wanted.row);
  }
  return *found;
}

/// A study of these scenes, of which the later ones repeat the values of the first two.
study::StudyRecords study_of(int participants, const std::vector<std::string>& scenes) {
  study::StudyRecords records = complete_study(participants);
  const study::StudyRecords two = records;
  records.scenes = scenes;
  for (std::uint16_t scene = 2; scene < scenes.size(); ++scene) {
    for (std::size_t row = 0; row < two.trials.size(); ++row) {
      if (two.trials[row].scene == scene % 2) {
        study::TrialRow trial = two.trials[row];
        trial.scene = scene;
        std::vector<study::Value> values;
        for (std::size_t measure = 0; measure < two.measures.size(); ++measure) {
          values.push_back(two.value(row, measure));
        }
        records.add_trial(trial, values);
      }
    }
  }
  return records;
}

const std::vector<std::string> real_scenes = {"bmw", "classroom", "conference", "sibenik",
                                              "sponza"};
const std::vector<std::string> counterparts = {"studio-car", "schoolroom", "meeting-room", "church",
                                               "arcade"};

TEST(PublishedComparison, ASceneIsComparedWithItselfOrItsCounterpart) {
  const Compared compared = compare(complete_study(5), made_up_paper());
  const ComparedNumber& own = number_of(compared, {"Table 2", "aula", "", "", "od"});
  EXPECT_EQ(own.own_row, "aula");
  const SceneTimes& aula = compared.tables.scene_times_of(outline_index, 0, 0);
  EXPECT_EQ(own.study->value, aula.seconds.mean);
  EXPECT_EQ(own.study_deviation, aula.seconds.standard_deviation);
  EXPECT_DOUBLE_EQ(difference_of(own).value(), *aula.seconds.mean - 12.0);
  EXPECT_DOUBLE_EQ(times_published(own).value(), *aula.seconds.mean / 12.0);
  EXPECT_DOUBLE_EQ(difference_of_deviations(own).value(), *aula.seconds.standard_deviation - 3.0);
  EXPECT_EQ(own.unit, "s");
  EXPECT_EQ(own.section, "5.2");

  const SceneTimes& barn = compared.tables.scene_times_of(outline_index, 1, 2);
  const ComparedNumber& ratios = number_of(compared, {"Table 2", "unseen", "own ratios", "", "fv"});
  EXPECT_EQ(ratios.own_row, "barn");
  EXPECT_EQ(ratios.study->value, barn.percent_of_baseline.mean);
  EXPECT_EQ(ratios.study_deviation, barn.percent_of_baseline.standard_deviation);
  const ComparedNumber& of_means =
      number_of(compared, {"Table 2", "unseen", "ratio of means", "", "fv"});
  EXPECT_NEAR(of_means.study->value, barn.of_baseline_mean.mean_percent.value(), 1e-9);
  EXPECT_EQ(of_means.study_deviation, barn.of_baseline_mean.sd_percent_points);
}

// Three participants with OD in 10, 20, 30 s and FV in 1, 4, 4 s.
study::StudyRecords study_by_hand() {
  study::StudyRecords records = complete_study(3);
  const double od[] = {10.0, 20.0, 30.0};
  const double fv[] = {1.0, 4.0, 4.0};
  for (int p = 0; p < 3; ++p) {
    const std::string code = "P" + std::to_string(p + 1);
    value_of(records, code, "aula", "od", "outline") = measured(od[p]);
    value_of(records, code, "aula", "fv", "outline") = measured(fv[p]);
  }
  return records;
}

TEST(PublishedComparison, IntervalsAreThoseByHand) {
  const Compared compared = compare(study_by_hand(), made_up_paper());
  const double t2 = 4.302653;  // t(2), 95 %
  // Seconds: mean 20, deviation 10.
  const ComparedNumber& od = number_of(compared, {"Table 2", "aula", "", "", "od"});
  EXPECT_EQ(od.study->n, 3U);
  EXPECT_NEAR(od.study->interval->low, 20.0 - t2 * 10.0 / std::sqrt(3.0), 1e-4);
  EXPECT_NEAR(od.study->interval->high, 20.0 + t2 * 10.0 / std::sqrt(3.0), 1e-4);
  // The published 12 -+ 2.131450 * 3 / 4.
  EXPECT_NEAR(od.published.interval->low, 12.0 - 1.598588, 1e-5);
  EXPECT_NEAR(od.published.interval->high, 12.0 + 1.598588, 1e-5);
  EXPECT_FALSE(is_study_in_published_interval(od).value());
  EXPECT_TRUE(is_published_in_study_interval(od).value());
  // Own ratios: 10, 20, 13.33 %; mean 14.444, deviation 5.0918.
  const ComparedNumber& own = number_of(compared, {"Table 2", "aula", "own ratios", "", "fv"});
  EXPECT_NEAR(own.study->value, 14.44444, 1e-5);
  EXPECT_NEAR(own.study->interval->high, 14.44444 + t2 * 5.091751 / std::sqrt(3.0), 1e-4);
  // Ratio of means: 3 / 20; influences on its logarithm (y - 3)/9 - (x - 20)/60: -0.0556, 0.1111,
  // -0.0556, so s = sqrt(1.5 * 0.018519) = 0.166667.
  const ComparedNumber& ratio =
      number_of(compared, {"Table 2", "aula", "ratio of means", "", "fv"});
  EXPECT_NEAR(ratio.study->value, 15.0, 1e-9);
  EXPECT_NEAR(ratio.study->interval->low, 15.0 * std::exp(-t2 / 6.0), 1e-4);
  EXPECT_NEAR(ratio.study->interval->high, 15.0 * std::exp(t2 / 6.0), 1e-4);
  EXPECT_DOUBLE_EQ(times_published(ratio).value(), 15.0 / 9.0);
}

TEST(PublishedComparison, OverScenesStandTheGeometricMeansOfTable2) {
  const Compared compared = compare(complete_study(5), made_up_paper());
  const StudyTables& tables = compared.tables;
  const ComparedNumber& od = number_of(compared, {"Table 2, all scenes", "", "", "outline", "od"});
  EXPECT_NEAR(od.published.value, 6.0, 1e-12);  // sqrt(12 * 3)
  EXPECT_FALSE(od.published.interval);
  EXPECT_NEAR(od.study->value,
              std::sqrt(*tables.scene_times_of(outline_index, 0, 0).seconds.mean *
                        *tables.scene_times_of(outline_index, 1, 0).seconds.mean),
              1e-9);
  const ComparedNumber& own =
      number_of(compared, {"Table 2, all scenes", "", "own ratios", "outline", "fv"});
  EXPECT_NEAR(own.published.value, 12.0, 1e-12);  // sqrt(9 * 16)
  EXPECT_NEAR(own.study->value,
              std::sqrt(*tables.scene_times_of(outline_index, 0, 2).percent_of_baseline.mean *
                        *tables.scene_times_of(outline_index, 1, 2).percent_of_baseline.mean),
              1e-9);
  EXPECT_TRUE(own.study->interval);
  const ComparedNumber& of_report =
      number_of(compared, {"Table 2, all scenes", "", "geometric mean", "outline", "fv"});
  EXPECT_EQ(of_report.study->value,
            tables.method_times_of(outline_index, 2).percent_of_baseline->value);
}

TEST(PublishedComparison, AStudyWithoutEverySceneHasNoMeanOverThePublishedOnes) {
  PublishedStudy published = made_up_paper();
  published.times.push_back({"third", "cave", "outline", "fv", 10.0, 1.0});
  const Compared compared = compare(complete_study(5), published);
  EXPECT_FALSE(
      number_of(compared, {"Table 2, all scenes", "", "own ratios", "outline", "fv"}).study);
  EXPECT_TRUE(
      number_of(compared, {"Table 2, all scenes", "", "geometric mean", "outline", "fv"}).study);
}

TEST(PublishedComparison, ClaimsOfTheTextAreHeldAgainstGeometricMeans) {
  const Compared compared = compare(study_by_hand(), paper());
  const StudyTables& tables = compared.tables;
  const auto seconds = [&](std::size_t method) {
    return tables.method_times_of(material_index, method).seconds->value;
  };
  const auto claim = [&](const std::string& words) -> const ComparedNumber& {
    return number_of(compared, {"text", words, "", "material", ""});
  };
  EXPECT_EQ(claim("FV’s time, of OD’s").published.value, 10.0);
  EXPECT_NEAR(claim("FV’s time, of OD’s").study->value, 100.0 * seconds(2) / seconds(0), 1e-9);
  EXPECT_EQ(claim("FV faster than OD").published.value, 10.0);
  EXPECT_NEAR(claim("FV faster than OD").study->value, seconds(0) / seconds(2), 1e-9);
  EXPECT_EQ(claim("VP faster than OD").published.value, 3.0);
  EXPECT_NEAR(claim("VP faster than OD").study->value, seconds(0) / seconds(1), 1e-9);
  EXPECT_EQ(claim("FV faster than VP").published.value, 3.0);
  EXPECT_NEAR(claim("FV faster than VP").study->value, seconds(1) / seconds(2), 1e-9);
  const auto percent = tables.method_times_of(material_index, 2).percent_of_baseline;
  EXPECT_NEAR(claim("FV faster than OD").study->interval->low, 100.0 / percent->interval->high,
              1e-9);
}

TEST(PublishedComparison, PIsOfTheSameQuantity) {
  const study::StudyRecords records = golden_study_records();
  const Compared compared = compare(records, paper());
  for (const char* mark : {"outline", "material"}) {
    const ComparedNumber& p = number_of(compared, {"text", "", "Pearson’s r", mark, ""});
    EXPECT_EQ(p.published.value, 0.196);
    EXPECT_EQ(p.section, "5.1");
    EXPECT_GOLDEN(p.study->value, golden_study().at(std::string(mark) + ".fv.p"));
    EXPECT_FALSE(times_published(p)) << "a ratio of P says nothing";
  }
}

TEST(PublishedComparison, ParticipantsAreThoseThatAreAnalysed) {
  study::StudyRecords records = complete_study(4);
  const double plain =
      number_of(compare(records, paper()), {"Table 1", "offline_rendering", "", "", ""})
          .study->value;
  EXPECT_DOUBLE_EQ(plain, (2.0 + 3.0 + 4.0 + 5.0) / 4.0);
  for (const auto& [participant, age, gender] :
       {std::tuple{"P1", 30.0, 5.0}, {"P2", 41.0, 1.0}, {"P3", 19.0, 5.0}}) {
    add_answer(records, participant, "background", "age", age);
    add_answer(records, participant, "background", "gender", gender);
  }
  add_answer(records, "P2", "debrief", "knew_setup", 1.0);
  add_answer(records, "P3", "debrief", "knew_setup", 0.0);
  records.sessions.push_back({"Q", "pilot", "completed", {}, {}});
  add_answer(records, "Q", "background", "offline_rendering", 1.0);
  add_answer(records, "Q", "background", "age", 80.0);
  const Compared compared = compare(records, paper());
  const auto own = [&](const std::string& row, const std::string& source = "text") {
    return number_of(compared, {source, row, "", "", ""}).study->value;
  };
  EXPECT_EQ(own("offline_rendering", "Table 1"), plain);
  EXPECT_EQ(own("participants"), 4.0);
  EXPECT_EQ(own("male"), 1.0);
  EXPECT_EQ(own("female"), 2.0);
  EXPECT_EQ(own("youngest"), 19.0);
  EXPECT_EQ(own("oldest"), 41.0);
  EXPECT_EQ(own("knew the set-up"), 1.0);
  EXPECT_FALSE(number_of(compare(complete_study(2), paper()), {"text", "male", "", "", ""}).study);
}

TEST(PublishedComparison, BackgroundHasIntervalsOnBothSides) {
  const Compared compared = compare(complete_study(4), made_up_paper());
  const ComparedNumber& row = number_of(compared, {"Table 1", "offline_rendering", "", "", ""});
  // 3.5 with a deviation of 1.290994, t(3) = 3.182446; 2.5 -+ 2.131450 / 4.
  EXPECT_NEAR(row.study->interval->low, 3.5 - 3.182446 * 1.290994 / 2.0, 1e-5);
  EXPECT_NEAR(row.published.interval->high, 2.5 + 2.131450 / 4.0, 1e-5);
  EXPECT_FALSE(times_published(row));
  const ComparedNumber& age = number_of(compared, {"Table 1", "age", "", "", ""});
  EXPECT_EQ(age.own_row, "");
  EXPECT_FALSE(difference_of(age));
  EXPECT_FALSE(is_study_in_published_interval(age));
  EXPECT_FALSE(is_published_in_study_interval(age));
}

ReproducedMeans met(const std::vector<ComparedNumber>& numbers, const std::string& means) {
  const std::vector<ReproducedMeans> all = count_reproduced_means(numbers);
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const ReproducedMeans& row) { return row.means == means; });
  if (found == all.end()) {
    throw std::out_of_range(means);
  }
  return *found;
}

TEST(PublishedComparison, EveryNumberOfTheRealScenesIsCompared) {
  const Compared compared = compare(study_of(5, real_scenes), paper());
  const ReproducedMeans others = met(compared.numbers, "Table 2, VP and FV, own ratios");
  EXPECT_EQ(others.published, 20U);
  EXPECT_EQ(others.compared, 20U);
  EXPECT_EQ(met(compared.numbers, "Table 2, OD").compared, 10U);
  EXPECT_EQ(met(compared.numbers, "Table 1").published, 6U);
  EXPECT_FALSE(met(compared.numbers, "Table 1").near);
  for (const ComparedNumber& number : compared.numbers) {
    if (number.source == "Table 2") {
      EXPECT_EQ(number.own_row, number.row);
    }
  }
}

TEST(PublishedComparison, CounterpartsAreNamedBesideThePublishedScenes) {
  const Compared compared = compare(study_of(5, counterparts), paper());
  EXPECT_EQ(met(compared.numbers, "Table 2, VP and FV, ratio of means").compared, 20U);
  const ComparedNumber& cell =
      number_of(compared, {"Table 2", "conference", "own ratios", "material", "fv"});
  EXPECT_EQ(cell.own_row, "meeting-room");
  EXPECT_EQ(cell.published.value, 8.2);
}

/// 1.5 times the published value and two thirds of it are equally far from it.
TEST(PublishedComparison, CountsThoseNearThePublishedValueEitherWay) {
  std::vector<ComparedNumber> numbers;
  const auto add = [&](double published, double own, double half_width) {
    ComparedNumber number;
    number.source = "Table 2";
    number.method = "fv";
    number.reading = "own ratios";
    number.unit = "%";
    number.published = {16, published, Interval{published - 2.0, published + 2.0}};
    number.study = Estimate{16, own, Interval{own - half_width, own + half_width}};
    numbers.push_back(number);
  };
  add(20.8, 22.1, 1.5);  // near; ours in theirs, theirs in ours
  add(11.8, 7.6, 5.0);   // 0.644 times; theirs in ours
  add(41.8, 66.0, 1.0);  // 1.58 times; neither
  add(9.0, 10.5, 1.0);   // near; ours in theirs
  numbers.push_back(numbers.front());
  numbers.back().study.reset();
  const ReproducedMeans found = met(numbers, "Table 2, VP and FV, own ratios");
  EXPECT_EQ(found.published, 5U);
  EXPECT_EQ(found.compared, 4U);
  EXPECT_EQ(found.near, 2U);
  EXPECT_EQ(found.study_in_published_interval, 2U);
  EXPECT_EQ(found.published_in_study_interval, 2U);
  EXPECT_EQ(found.in_both_intervals, 1U);
  EXPECT_EQ(in_words(found),
            "Table 2, VP and FV, own ratios: of 5 published means, 4 of which this study has, 2 "
            "within 1.5 times the published value, 2 of ours in the published interval, 2 of "
            "theirs in ours, 1 in both.");
}

TEST(PublishedComparison, AStudyWithoutOdHasNoTimesToCompare) {
  study::StudyRecords records = complete_study(3);
  records.methods = {"vp", "fv"};
  keep_trials(records, [](const study::TrialRow& row) { return row.method < 2; });
  const Compared compared = compare(records, made_up_paper());
  for (const ComparedNumber& number : compared.numbers) {
    const bool is_of_od =
        number.source.starts_with("Table 2") || number.row.find("OD") != std::string::npos;
    EXPECT_FALSE(is_of_od && number.study) << number.row << ' ' << number.method;
  }
  EXPECT_TRUE(number_of(compared, {"text", "FV faster than VP", "", "outline", ""}).study)
      << "needs no OD";
  EXPECT_EQ(met(compared.numbers, "Table 2, OD").compared, 0U);
}

TEST(PublishedComparison, AnotherBaselineIsNotComparedWithOd) {
  study::StudyRecords records = complete_study(3);
  records.methods = {"vp", "od", "fv"};
  for (study::TrialRow& row : records.trials) {
    row.method = row.method == 2 ? 2 : row.method == 0 ? 1 : 0;
  }
  for (const ComparedNumber& number : compare(records, made_up_paper()).numbers) {
    EXPECT_FALSE(number.source.starts_with("Table 2") && number.study);
  }
}

}  // namespace
}  // namespace foveola::analysis
