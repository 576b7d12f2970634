// What is injected in a study has to be found by its analysis, and nothing where nothing is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/hall.h"

namespace foveola::test {
namespace {

constexpr int participants = 12;

/// A study of the hall with three methods, in which `effect` is injected, and what its analysis
/// says.
class InjectedEffectsStudy : public testing::Test, protected Hall {
 protected:
  InjectedEffectsStudy() {
    folder.write("share/protocols/injected.toml", R"(
name = "injected"
title = "A study with a known effect"
scenes = ["hall"]
methods = ["od", "vp", "fv"]
method_order = "williams"

[analysis]
primary = [{ measure = "outline", method = "fv", baseline = "od" }]

[timing]
mark_timeout_s = 120
)" + std::string(small_tables));
  }

  nlohmann::json analysis_of(const std::string& effect) {
    const std::string database = (folder / "study.sqlite").string();
    const ProgramResult simulated =
        run({"study", "simulate", "injected", "--db", database, "--participants",
             std::to_string(participants), "--seed", "1", "--predicted", "--inject", effect});
    EXPECT_EQ(simulated.exit_code, 0) << simulated.errors;
    const ProgramResult analysed =
        run_foveola({"analyze", database, "-o", (folder / "out").string(), "--json"});
    EXPECT_EQ(analysed.exit_code, 0) << analysed.errors;
    return nlohmann::json::parse(analysed.output);
  }
};

/// The comparison of method with reference in `mark`.
nlohmann::json comparison(const nlohmann::json& analysis, const std::string& mark,
                          const std::string& method, const std::string& reference) {
  for (const nlohmann::json& row : analysis["tables"]["comparisons"]) {
    if (row["measure"] == mark && row["method"] == method && row["reference"] == reference) {
      return row;
    }
  }
  ADD_FAILURE() << "no comparison of " << method << " with " << reference << " in " << mark;
  return {};
}

/// That the interval of these columns has the true value in it.
void expect_within(const nlohmann::json& row, const std::string& low, const std::string& high,
                   double truth) {
  EXPECT_LE(row.at(low).get<double>(), truth) << row;
  EXPECT_GE(row.at(high).get<double>(), truth) << row;
}

TEST_F(InjectedEffectsStudy, TheRatiosThatWereInjectedLieInTheIntervals) {
  const nlohmann::json analysis = analysis_of("faster:fv:2.5,faster:vp:1.6,order:1.05");
  EXPECT_EQ(analysis["participant_kind"], "simulated");
  EXPECT_EQ(analysis["participants"], participants);
  const std::vector<std::tuple<std::string, std::string, double>> truths = {
      {"vp", "od", 1.0 / 1.6}, {"fv", "od", 1.0 / 2.5}, {"fv", "vp", 1.6 / 2.5}};
  for (const std::string mark : {"outline", "material"}) {
    for (const auto& [method, reference, truth] : truths) {
      SCOPED_TRACE(mark + ", " + method + " against " + reference);
      const nlohmann::json row = comparison(analysis, mark, method, reference);
      expect_within(row, "ci95_low_percent", "ci95_high_percent", 100.0 * truth);
      expect_within(row, "pseudo_median_low_ratio_percent", "pseudo_median_high_ratio_percent",
                    100.0 * truth);
      EXPECT_LT(row["p_t"].get<double>(), 0.01);
      EXPECT_EQ(row["n"], participants);
    }
  }
  const nlohmann::json planned = comparison(analysis, "outline", "fv", "od");
  EXPECT_EQ(planned["status"], "primary");
  EXPECT_EQ(planned["p_holm"], planned["p_t"]) << "the only planned one";
  EXPECT_LT(analysis["tables"]["omnibus"].at(0)["p_greenhouse_geisser"].get<double>(), 1e-4);
  const nlohmann::json by_trial = analysis["tables"]["order_effects"].at(0);
  EXPECT_EQ(by_trial["per"], "trial in the session");
  expect_within(by_trial, "ci95_low_percent", "ci95_high_percent", 5.0);
}

TEST_F(InjectedEffectsStudy, NothingIsFoundWhereNothingWasInjected) {
  // Times are drawn, as with an effect, which "none" would leave to the eye.
  const nlohmann::json analysis = analysis_of("order:1");
  for (const std::string mark : {"outline", "material"}) {
    SCOPED_TRACE(mark);
    for (const char* method : {"vp", "fv"}) {
      const nlohmann::json row = comparison(analysis, mark, method, "od");
      expect_within(row, "ci95_low_percent", "ci95_high_percent", 100.0);
      EXPECT_GT(row["p_wilcoxon"].get<double>(), 0.05);
    }
  }
  for (const std::size_t of_times : {0, 1}) {
    const nlohmann::json& row = analysis["tables"]["omnibus"].at(of_times);
    EXPECT_GT(row["p_greenhouse_geisser"].get<double>(), 0.05) << row["measure"];
    EXPECT_GT(row["p_friedman"].get<double>(), 0.05) << row["measure"];
  }
  for (const nlohmann::json& row : analysis["tables"]["order_effects"]) {
    if (!row["change_percent"].is_null()) {
      expect_within(row, "ci95_low_percent", "ci95_high_percent", 0.0);
    }
  }
}

}  // namespace
}  // namespace foveola::test
