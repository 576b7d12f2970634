#include "analysis/monte_carlo/model_coverage.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "renderer/base/error.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

/// Models as R would have fitted them, with this interval of every estimate, and a P-value that
/// agrees with it.
ModelFitter fitter(Interval interval) {
  return [=](const std::vector<study::StudyRecords>& studies) {
    std::vector<FittedModels> all;
    for (const study::StudyRecords& records : studies) {
      const study::PlannedComparison& planned = records.protocol.analysis.primary.front();
      FittedModels models;
      for (const char* name : {"crossed", "tobit", "ordinal"}) {
        models.models.push_back(
            {.model = name,
             .measure = planned.measure,
             .method = planned.method,
             .reference = planned.baseline,
             .fit =
                 FittedModel::Fit{.estimate = std::log(0.5),
                                  .standard_error = 0.1,
                                  .degrees_of_freedom = 15.0,
                                  .interval = interval,
                                  .p = interval.low <= 0.0 && interval.high >= 0.0 ? 0.5 : 0.001}});
      }
      for (const char* name : {"R", "lme4", "lmerTest", "survival", "ordinal"}) {
        models.versions.emplace_back(name, "1");
      }
      all.push_back(std::move(models));
    }
    return all;
  };
}

std::vector<CoverageFigure> measure(const ModelCell& cell, const ModelCoverageSettings& settings,
                                    const ModelFitter& fit) {
  return measure_model_coverage(cell, settings, fit, {});
}

const ModelCoverageSettings few = {.studies = 50, .threads = 2};

TEST(ModelCells, AreNineteenWithNamesAndStreamsOfTheirOwn) {
  const std::vector<ModelCell> cells = model_cells();
  std::set<std::string> names;
  std::set<std::uint64_t> streams;
  for (const ModelCell& cell : cells) {
    names.insert(cell.name);
    streams.insert(cell.stream);
    EXPECT_EQ(cell.expected.protocol.analysis.primary.size(), 1U);
  }
  EXPECT_EQ(names.size(), 19U);
  EXPECT_EQ(streams.size(), 19U);
}

bool is_separated(const ModelCell& cell) { return cell.name.ends_with("separated ratings"); }
bool is_of_equivalence(const ModelCell& cell) { return cell.name.starts_with("equivalence"); }

TEST(ModelCoverage, CountsTheStudiesWhoseIntervalCovers) {
  for (const ModelCell& cell : model_cells()) {
    if (is_of_equivalence(cell) || is_separated(cell)) {
      continue;
    }
    const auto wide = measure(cell, few, fitter({-2.0, 2.0}));
    const auto beside = measure(cell, few, fitter({3.0, 4.0}));
    EXPECT_EQ(wide.front().studies, cell.is_rating ? 20U : 50U) << cell.name;
    EXPECT_TRUE(wide.front().required) << cell.name;
    EXPECT_FALSE(wide.back().required) << cell.name;
    EXPECT_GT(wide.front().percent, 95.0) << cell.name;
    // Without anything that is censored, the planned analysis needs no R.
    EXPECT_LT(beside.front().percent, 15.0) << cell.name;
    EXPECT_FALSE(beside.front().is_met()) << cell.name;
    EXPECT_EQ(wide.front().mean_ratio.has_value(), !cell.is_rating) << cell.name;
  }
}

// A model that is sure of a ratio of 0.5 declares nothing equivalent within 25 %; without R nothing
// is declared where times are right-censored.
TEST(ModelCoverage, CountsTheStudiesInWhichThePrimaryModelDeclaresEquivalence) {
  for (const ModelCell& cell : model_cells()) {
    if (is_of_equivalence(cell) && cell.expected.protocol.timing.mark_timeout_s < 1e6) {
      const auto figures = measure(cell, few, fitter({-0.8, -0.6}));
      EXPECT_EQ(figures.front().studies, 50U) << cell.name;
      EXPECT_EQ(figures.front().hits, 0U) << cell.name;
      EXPECT_EQ(figures.back().hits, 0U) << cell.name;
    }
  }
}

TEST(ModelCoverage, CountsTheStudiesInWhichASeparationIsFound) {
  const std::vector<ModelCell> cells = model_cells();
  const auto separated = std::find_if(cells.begin(), cells.end(), is_separated);
  const auto missed = measure(*separated, few, fitter({-2.0, 2.0}));
  EXPECT_EQ(missed.front().studies, 3U);
  EXPECT_EQ(missed.front().hits, 0U);
  EXPECT_FALSE(missed.front().is_met());
  EXPECT_EQ(missed.back().hits, 3U);  // by Wilcoxon's test
  EXPECT_EQ(measure(*separated, few, fitter({2.0, 3.0})).front().hits, 3U);
}

// With a third of the baseline's times out, those that are left make it look faster than it is.
TEST(ModelCoverage, OfWhatStandsInWithoutRIsBiased) {
  const ModelCell tobit = model_cells()[6];
  const auto figures = measure(tobit, {.studies = 200}, fitter({-2.0, 2.0}));
  EXPECT_EQ(figures.back().claim, "covers without R");
  EXPECT_GT(*figures.back().mean_ratio, 0.52);
}

TEST(ModelCoverage, MissingPackagesAreAnError) {
  const auto without_r = [](const std::vector<study::StudyRecords>& studies) {
    return std::vector<FittedModels>(studies.size(), {.missing = "R is not installed"});
  };
  try {
    (void)measure(model_cells().back(), few, without_r);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("R is not installed"));
  }
}

TEST(ModelCoverage, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(
      measure_model_coverage(model_cells().back(), few, fitter({}), stop.get_token()).empty());
}

TEST(ExpectedSeconds, TimesOneOfAHundredStudies) {
  std::size_t timed = 0;
  (void)expected_seconds(model_cells(), {.studies = 500, .threads = 1},
                         [&](const std::vector<study::StudyRecords>& studies) {
                           timed += studies.size();
                           return std::vector<FittedModels>(studies.size());
                         });
  EXPECT_EQ(timed, 85U);
}

}  // namespace
}  // namespace foveola::analysis
