// What is injected in a study has to be found by its analysis, and nothing where nothing is.
#include <nlohmann/json.hpp>

#include "tests/end_to_end/hall.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

constexpr int participants = 12;

/// A study of the hall with three methods, in which `effect` is injected, and what its analysis
/// says.
class InjectedEffectsStudy : public testing::Test, protected Hall {
 protected:
  InjectedEffectsStudy() { write_protocol(""); }

  void write_protocol(const std::string& measures) {
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
)" + measures + small_tables);
  }

  ProgramResult simulate(const std::string& effect, int seed, const std::string& database) const {
    return run({"study", "simulate", "injected", "--db", database, "--participants",
                std::to_string(participants), "--seed", std::to_string(seed), "--predicted",
                "--inject", effect});
  }

  nlohmann::json analysis_of(const std::string& effect, int seed = 1) const {
    const std::string name = "study-" + std::to_string(seed);
    const std::string database = (folder / (name + ".sqlite")).string();
    succeeded(simulate(effect, seed, database));
    const ProgramResult analysed =
        succeeded(run_foveola({"analyze", database, "-o", (folder / name).string(), "--json"}));
    return nlohmann::json::parse(analysed.output);
  }
};

/// Three marks, and ratings of 0 to 100 and of 1 to 5.
constexpr const char* other_measures = R"(
[[mark]]
id = "outline"
instruction = "When is it there?"

[[mark]]
id = "sharp"
instruction = "When is it sharp?"

[[mark]]
id = "third"
instruction = "Now."

[[rating]]
id = "comfort"
text = "How comfortable?"
minimum = 0
maximum = 100

[[rating]]
id = "effort"
text = "How hard?"
)";

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
  EXPECT_EQ(planned["status"], "planned");
  EXPECT_EQ(planned["p_holm"], planned["p"]) << "the only planned one";
  EXPECT_LT(analysis["tables"]["omnibus"].at(0)["p_greenhouse_geisser"].get<double>(), 1e-4);
  const nlohmann::json by_trial = analysis["tables"]["order_effects"].at(0);
  EXPECT_EQ(by_trial["per"], "trial in the session");
  expect_within(by_trial, "ci95_low_percent", "ci95_high_percent", 5.0);
}

/// A 95 % interval misses the truth in one of twenty studies; that more than 4 of 24 do has a
/// probability below 1 % (binomial, as if they were independent).
TEST_F(InjectedEffectsStudy, EffectsOnAnyMarkAndRatingLieInTheIntervals) {
  write_protocol(other_measures);
  std::vector<std::string> missed;
  const auto take = [&](const nlohmann::json& row, const std::string& unit, double truth) {
    if (row.at("ci95_low_" + unit).get<double>() > truth ||
        row.at("ci95_high_" + unit).get<double>() < truth) {
      missed.push_back(row.dump());
    }
  };
  for (const int seed : {1, 2, 3}) {
    const nlohmann::json analysis = analysis_of(
        "faster:fv:2,faster-mark:third:fv:1.5,shift-rating:comfort:fv:+10,"
        "shift-rating:effort:vp:-1",
        seed);
    take(comparison(analysis, "outline", "fv", "od"), "percent", 100.0 / 2.0);
    take(comparison(analysis, "sharp", "fv", "od"), "percent", 100.0 / 2.0);
    take(comparison(analysis, "third", "fv", "od"), "percent", 100.0 / 3.0);
    take(comparison(analysis, "third", "vp", "od"), "percent", 100.0);
    take(comparison(analysis, "comfort", "fv", "od"), "points", 10.0);
    take(comparison(analysis, "comfort", "vp", "od"), "points", 0.0);
    take(comparison(analysis, "effort", "fv", "od"), "points", 0.0);
    take(comparison(analysis, "effort", "vp", "od"), "points", -1.0);
    EXPECT_LT(comparison(analysis, "third", "fv", "od")["p_t"].get<double>(), 0.01);
  }
  EXPECT_LE(missed.size(), 4U) << testing::PrintToString(missed);
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
