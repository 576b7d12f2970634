// Invariances of an analysis: under the order in which people are stored, under other names of
// people, scenes and methods, and under another unit of time.
#include <algorithm>
#include <functional>
#include <optional>
#include <random>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "analysis/dataset/comparisons.h"
#include "analysis/dataset/study_tables.h"
#include "analysis/koskela2018/background.h"
#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

using study::StudyRecords;

struct Analysis {
  StudyTables tables;
  Comparisons comparisons;
  Background background;
};

Analysis analysis_of(const StudyRecords& records) {
  StudyTables tables = tabulate_study(records);
  Comparisons comparisons = compare_methods(tables.set, records.protocol.analysis);
  study::AnalysisPlan stated = records.protocol.analysis;
  stated.primary = {{"outline", records.methods.back(), records.methods.front()}};
  Background background = analyse_background(background_answers(records), stated, tables.set);
  return {std::move(tables), std::move(comparisons), std::move(background)};
}

/// Times without ties and with gaps, of people who answer differently; no person took part.
StudyRecords uneven_study(int participants) {
  StudyRecords records = complete_study(participants);
  std::mt19937 random(7);
  for (std::size_t i = 0; i < records.trials.size(); ++i) {
    study::TrialRow& row = records.trials[i];
    study::Value* const values = &records.values[i * records.measures.size()];
    const double factor = 0.5 + static_cast<double>(random() % 4096) / 4096.0;
    values[outline_index].number *= factor;
    values[material_index].number *= factor * 1.25;
    values[artifacts_index].number = 1.0 + static_cast<double>(random() % 5);
    row.method_position = static_cast<std::uint16_t>(random() % 3);
    row.scene_position = static_cast<std::uint16_t>(random() % 2);
  }
  study::Value& bound = value_of(records, "P2", "aula", "fv", "outline");
  bound = right_censored(bound.number);
  value_of(records, "P3", "barn", "vp", "material") = {};
  return records;
}

constexpr double rounding = 1e-9;  ///< Relative rounding of sums in another order.

void expect_same(const std::optional<double>& a, const std::optional<double>& b, double scale,
                 const std::string& what) {
  ASSERT_EQ(a.has_value(), b.has_value()) << what;
  if (a) {
    EXPECT_NEAR(*a * scale, *b, rounding * std::max(1.0, std::abs(*b))) << what;
  }
}

void expect_same_interval(const std::optional<Interval>& a, const std::optional<Interval>& b,
                          double scale, const std::string& what) {
  ASSERT_EQ(a.has_value(), b.has_value()) << what;
  if (a) {
    expect_same(a->low, b->low, scale, what);
    expect_same(a->high, b->high, scale, what);
  }
}

/// The tables; `seconds` is how many times longer b's times are.
void expect_same_tables(const StudyTables& a, const StudyTables& b, double seconds = 1.0) {
  ASSERT_EQ(a.scene_times.size(), b.scene_times.size());
  for (std::size_t i = 0; i < a.scene_times.size(); ++i) {
    const std::string what = fmt::format("cell {} of Table 2", i);
    const SceneTimes& x = a.scene_times[i];
    const SceneTimes& y = b.scene_times[i];
    expect_same(x.seconds.mean, y.seconds.mean, seconds, what);
    expect_same(x.seconds.standard_deviation, y.seconds.standard_deviation, seconds, what);
    expect_same(x.percent_of_baseline.mean, y.percent_of_baseline.mean, 1.0, what);
    expect_same(x.of_baseline_mean.mean_percent, y.of_baseline_mean.mean_percent, 1.0, what);
    expect_same(x.of_baseline_mean.sd_percent_points, y.of_baseline_mean.sd_percent_points, 1.0,
                what);
    ASSERT_EQ(x.geometric_percent.has_value(), y.geometric_percent.has_value()) << what;
    if (x.geometric_percent) {
      expect_same(x.geometric_percent->value, y.geometric_percent->value, 1.0, what);
      expect_same_interval(x.geometric_percent->interval, y.geometric_percent->interval, 1.0, what);
    }
    EXPECT_EQ(x.censored, y.censored) << what;
    EXPECT_EQ(x.missing, y.missing) << what;
  }
  for (std::size_t i = 0; i < a.method_times.size(); ++i) {
    const std::string what = fmt::format("bar {} of Fig. 5", i);
    ASSERT_TRUE(a.method_times[i].seconds && b.method_times[i].seconds) << what;
    expect_same(a.method_times[i].seconds->value, b.method_times[i].seconds->value, seconds, what);
    expect_same_interval(a.method_times[i].seconds->interval, b.method_times[i].seconds->interval,
                         seconds, what);
  }
  for (std::size_t i = 0; i < a.ratings.size(); ++i) {
    expect_same(a.ratings[i].description.mean, b.ratings[i].description.mean, 1.0, "Fig. 6");
    ASSERT_EQ(a.ratings[i].counts.size(), b.ratings[i].counts.size());
    for (std::size_t point = 0; point < a.ratings[i].counts.size(); ++point) {
      EXPECT_EQ(a.ratings[i].counts[point].count, b.ratings[i].counts[point].count);
    }
  }
}

void expect_same_background(const Background& a, const Background& b) {
  ASSERT_TRUE(a.correlation && b.correlation);
  const auto& x = a.correlation->pearson;
  const auto& y = b.correlation->pearson;
  ASSERT_TRUE(x && y);
  expect_same(x->r, y->r, 1.0, "background");
  expect_same(x->p, y->p, 1.0, "background");
  const auto& x_ranks = a.correlation->spearman;
  const auto& y_ranks = b.correlation->spearman;
  ASSERT_TRUE(x_ranks && y_ranks);
  expect_same(x_ranks->r, y_ranks->r, 1.0, "background's ranks");
  expect_same(x_ranks->p, y_ranks->p, 1.0, "background's ranks");
}

/// Everything but the bootstrap, whose resamples are drawn by position.
void expect_same_comparisons(const Comparisons& a, const Comparisons& b) {
  ASSERT_EQ(a.methods.size(), b.methods.size());
  for (std::size_t i = 0; i < a.methods.size(); ++i) {
    const MethodComparison& x = a.methods[i];
    const MethodComparison& y = b.methods[i];
    const std::string what = fmt::format("comparison {}, {}", i, x.measure);
    EXPECT_EQ(x.n, y.n) << what;
    ASSERT_EQ(x.ratio.has_value(), y.ratio.has_value()) << what;
    if (x.ratio) {
      expect_same(x.ratio->ratio, y.ratio->ratio, 1.0, what);
      expect_same_interval(x.ratio->interval, y.ratio->interval, 1.0, what);
      expect_same(x.ratio->logs.p, y.ratio->logs.p, 1.0, what);
    }
    ASSERT_TRUE(x.ranks && y.ranks) << what;
    EXPECT_DOUBLE_EQ(x.ranks->w_plus, y.ranks->w_plus) << what;
    expect_same(x.ranks->p, y.ranks->p, 1.0, what);
    expect_same(x.p_holm, y.p_holm, 1.0, what);
  }
  ASSERT_EQ(a.omnibus.size(), b.omnibus.size());
  for (std::size_t i = 0; i < a.omnibus.size(); ++i) {
    ASSERT_EQ(a.omnibus[i].variance.has_value(), b.omnibus[i].variance.has_value());
    if (a.omnibus[i].variance) {
      expect_same(a.omnibus[i].variance->f, b.omnibus[i].variance->f, 1.0, "F");
    }
    ASSERT_TRUE(a.omnibus[i].ranks && b.omnibus[i].ranks);
    expect_same(a.omnibus[i].ranks->p, b.omnibus[i].ranks->p, 1.0, "Friedman");
  }
  for (std::size_t i = 0; i < a.order.size(); ++i) {
    ASSERT_EQ(a.order[i].change_per_step.has_value(), b.order[i].change_per_step.has_value());
    if (a.order[i].change_per_step) {
      expect_same(a.order[i].change_per_step->mean, b.order[i].change_per_step->mean, 1.0, "order");
    }
  }
}

/// The whole analysis; `seconds` is how many times longer b's times are.
void expect_same_analysis(const Analysis& a, const Analysis& b, double seconds = 1.0) {
  expect_same_tables(a.tables, b.tables, seconds);
  expect_same_background(a.background, b.background);
  expect_same_comparisons(a.comparisons, b.comparisons);
}

TEST(Invariance, UnderTheOrderInWhichRowsAreStored) {
  const StudyRecords records = uneven_study(9);
  const StudyRecords shuffled = reordered(records, 3);
  ASSERT_NE(shuffled.sessions[0].participant, records.sessions[0].participant);
  const Analysis a = analysis_of(records);
  const Analysis b = analysis_of(shuffled);
  expect_same_analysis(a, b);
  // Not even the bootstrap: participants are analysed in the order of their codes.
  for (std::size_t i = 0; i < a.comparisons.methods.size(); ++i) {
    expect_same_interval(a.comparisons.methods[i].ratio_bca, b.comparisons.methods[i].ratio_bca,
                         1.0, "BCa");
  }
}

/// Renames participants, scenes and methods by three functions.
StudyRecords renamed(StudyRecords records,
                     const std::function<std::string(const std::string&)>& participant,
                     const std::function<std::string(const std::string&)>& scene,
                     const std::function<std::string(const std::string&)>& method) {
  for (study::SessionRow& row : records.sessions) {
    row.participant = participant(row.participant);
  }
  std::ranges::transform(records.scenes, records.scenes.begin(), scene);
  std::ranges::transform(records.methods, records.methods.begin(), method);
  return records;
}

std::string unchanged(const std::string& name) { return name; }

TEST(Invariance, UnderOtherCodesOfParticipants) {
  const StudyRecords records = uneven_study(9);
  // P1 becomes Q8, P9 becomes Q0: the order of the codes is turned around.
  const auto turned = [](const std::string& code) {
    return fmt::format("Q{}", 9 - std::stoi(code.substr(1)));
  };
  const Analysis a = analysis_of(records);
  const Analysis b = analysis_of(renamed(records, turned, unchanged, unchanged));
  EXPECT_EQ(b.tables.set.participants.front(), "Q0");
  expect_same_analysis(a, b);
}

TEST(Invariance, UnderOtherNamesOfScenesAndMethods) {
  const StudyRecords records = uneven_study(9);
  const auto longer = [](const std::string& name) { return "z, \"" + name + "\""; };
  const Analysis a = analysis_of(records);
  const Analysis b = analysis_of(renamed(records, unchanged, longer, longer));
  expect_same_analysis(a, b);
}

TEST(Invariance, UnderTheOrderOfScenes) {
  const StudyRecords records = uneven_study(9);
  StudyRecords turned = records;
  std::ranges::reverse(turned.scenes);
  for (study::TrialRow& row : turned.trials) {
    row.scene = row.scene == 0 ? 1 : 0;
  }
  expect_same_comparisons(analysis_of(records).comparisons, analysis_of(turned).comparisons);
}

TEST(Invariance, UnderTheUnitOfTime) {
  const StudyRecords records = uneven_study(9);
  StudyRecords milliseconds = records;
  for (const char* mark : {"outline", "material"}) {
    change_values(milliseconds, mark, [](study::Value& value) { value.number *= 1000.0; });
  }
  const Analysis a = analysis_of(records);
  const Analysis b = analysis_of(milliseconds);
  expect_same_analysis(a, b, 1000.0);
}

StudyRecords both_of(const StudyRecords& records, const StudyRecords& others) {
  StudyRecords both = records;
  const auto sessions = static_cast<std::uint32_t>(records.sessions.size());
  both.sessions.insert(both.sessions.end(), others.sessions.begin(), others.sessions.end());
  both.values.insert(both.values.end(), others.values.begin(), others.values.end());
  for (study::TrialRow row : others.trials) {
    row.session += sessions;
    both.trials.push_back(row);
  }
  for (study::AnswerRow row : others.answers) {
    row.session += sessions;
    both.answers.push_back(row);
  }
  return both;
}

/// Everybody twice: the same means, narrower intervals, smaller P-values.
TEST(Invariance, OfMeansWhenEverybodyIsThereTwice) {
  const StudyRecords records = uneven_study(9);
  const StudyRecords others =
      renamed(records, [](const std::string& code) { return code + "b"; }, unchanged, unchanged);
  const StudyRecords twice = both_of(records, others);
  const Analysis a = analysis_of(records);
  const Analysis b = analysis_of(twice);
  for (std::size_t i = 0; i < a.tables.scene_times.size(); ++i) {
    expect_same(a.tables.scene_times[i].seconds.mean, b.tables.scene_times[i].seconds.mean, 1.0,
                "Table 2");
    EXPECT_EQ(2 * a.tables.scene_times[i].censored, b.tables.scene_times[i].censored);
  }
  for (std::size_t i = 0; i < a.comparisons.methods.size(); ++i) {
    const MethodComparison& x = a.comparisons.methods[i];
    const MethodComparison& y = b.comparisons.methods[i];
    EXPECT_EQ(2 * x.n, y.n);
    if (x.ratio && y.ratio) {
      expect_same(x.ratio->ratio, y.ratio->ratio, 1.0, "ratio");
      EXPECT_LT(y.ratio->interval.high - y.ratio->interval.low,
                x.ratio->interval.high - x.ratio->interval.low);
      EXPECT_LT(y.ratio->logs.p, x.ratio->logs.p);
    }
  }
}

}  // namespace
}  // namespace foveola::analysis
