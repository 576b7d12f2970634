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
  for (const nlohmann::json& row : analysis["comparisons"]) {
    if (row["measure"] == mark && row["method"] == method && row["reference"] == reference) {
      return row;
    }
  }
  ADD_FAILURE() << "no comparison of " << method << " with " << reference << " in " << mark;
  return {};
}

void expect_within(const nlohmann::json& interval, double truth) {
  EXPECT_LE(interval.at(0).get<double>(), truth) << interval;
  EXPECT_GE(interval.at(1).get<double>(), truth) << interval;
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
      expect_within(row["times"]["ci95"], truth);
      expect_within(row["pseudo_median"]["ci95"], truth);
      EXPECT_LT(row["times"]["p"].get<double>(), 0.01);
      EXPECT_EQ(row["n"], participants);
    }
  }
  const nlohmann::json planned = comparison(analysis, "outline", "fv", "od");
  EXPECT_EQ(planned["status"], "primary");
  EXPECT_EQ(planned["p_holm"], planned["times"]["p"]) << "the only planned one";
  EXPECT_LT(analysis["omnibus"].at(0)["anova"]["p_greenhouse_geisser"].get<double>(), 1e-4);
  const nlohmann::json by_trial = analysis["order_effects"].at(0);
  EXPECT_EQ(by_trial["per"], "trial in the session");
  expect_within(by_trial["change_percent"]["ci95"], 5.0);
}

TEST_F(InjectedEffectsStudy, NothingIsFoundWhereNothingWasInjected) {
  // Times are drawn, as with an effect, which "none" would leave to the eye.
  const nlohmann::json analysis = analysis_of("order:1");
  for (const std::string mark : {"outline", "material"}) {
    SCOPED_TRACE(mark);
    for (const char* method : {"vp", "fv"}) {
      const nlohmann::json row = comparison(analysis, mark, method, "od");
      expect_within(row["times"]["ci95"], 1.0);
      EXPECT_GT(row["wilcoxon"]["p"].get<double>(), 0.05);
    }
  }
  for (const std::size_t of_times : {0, 1}) {
    const nlohmann::json& row = analysis["omnibus"].at(of_times);
    EXPECT_GT(row["anova"]["p_greenhouse_geisser"].get<double>(), 0.05) << row["measure"];
    EXPECT_GT(row["friedman"]["p"].get<double>(), 0.05) << row["measure"];
  }
  for (const nlohmann::json& row : analysis["order_effects"]) {
    expect_within(row["change_percent"]["ci95"], 0.0);
  }
}

}  // namespace
}  // namespace foveola::test
