#include "analysis/convergence/convergence_files.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "renderer/base/text/csv.h"
#include "tests/analysis/convergence/made_up_measurement.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

std::vector<GazeMeasurement> measurements() {
  return {made_up_measurement({{.name = "od", .noise = 5.0, .cost_s = 1e-3},
                               {.name = "od, independent numbers", .noise = 0.5, .cost_s = 3e-3}},
                              2)};
}

std::vector<CsvRow> rows_of(const std::vector<TextFile>& files, const std::string& name) {
  const auto found = std::find_if(files.begin(), files.end(),
                                  [&](const TextFile& file) { return file.name == name; });
  EXPECT_NE(found, files.end()) << name;
  return parse_csv(found->content, name);
}

ConvergencePlan plan() {
  ConvergencePlan plan;
  plan.configurations = make_configurations({"od"}, {"independent"});
  return plan;
}

TEST(ConvergenceCsv, HasEveryPointAndEveryTable) {
  std::vector<GazeMeasurement> measured = measurements();
  measured[0].repetitions[0][0].checkpoints[0].scores[0].error.mse = std::nan("");
  const std::vector<TextFile> files = convergence_csv(measured, tabulate(measured));
  for (const TextFile& file : files) {
    const std::vector<CsvRow> rows = rows_of(files, file.name);
    ASSERT_GT(rows.size(), 1U) << file.name;
    for (const CsvRow& row : rows) {
      EXPECT_EQ(row.size(), rows.front().size()) << file.name;
    }
  }
  const std::vector<CsvRow> points = rows_of(files, "points.csv");
  ASSERT_EQ(points.size(), 1U + 2U * 2U * 7U);
  EXPECT_EQ(points[1][8], "");  // no NaN
  EXPECT_THAT(points[2], ElementsAre("aula", "10,0", "od", "0", "5deg", "2000", "2", "2", "0.0025",
                                     "0.05", "0.005", "0.05", "100", "0", "0", "0", "0"));
  const std::vector<CsvRow> costs = rows_of(files, "costs.csv");
  EXPECT_EQ(costs[2][2], "od, independent numbers");
  EXPECT_NEAR(std::stod(costs[2][6]), 3.0, 1e-12);
}

TEST(ConvergenceJson, HasEstimatesWithTheirIntervals) {
  const std::vector<GazeMeasurement> measured = measurements();
  nlohmann::ordered_json facts = {{"version", "7"}};
  facts.update(plan_facts(plan()));
  const auto json = nlohmann::json::parse(convergence_json(facts, measured, tabulate(measured)));
  EXPECT_EQ(json["version"], "7");
  EXPECT_EQ(json["baseline"], "od");
  EXPECT_EQ(json["plan"]["width"], 1024);
  EXPECT_EQ(json["measured"][0]["repetitions"], 2);
  EXPECT_THAT(json["crops"]["left_to_right"],
              ElementsAre("od", "od, independent numbers", "reference"));
  ASSERT_EQ(json["speed_ups"].size(), 6U);
  const nlohmann::json& row = json["speed_ups"][0];
  EXPECT_EQ(row["level"], "all");
  EXPECT_NEAR(row["samples"]["value"].get<double>(), 10.0, 1e-9);
  EXPECT_NEAR(row["time"]["low"].get<double>(), 10.0 / 3.0, 1e-6);
  EXPECT_NEAR(row["predicted"].get<double>(), 10.0, 1e-9);
  EXPECT_NEAR(json["costs"][1]["ratio"]["value"].get<double>(), 3.0, 1e-9);
}

TEST(ConvergenceJson, WhatDoesNotExistIsNull) {
  const std::vector<GazeMeasurement> measured = {
      made_up_measurement({{.name = "od"}, {.name = "magic", .noise = 1e-4}}, 1)};
  const auto json = nlohmann::json::parse(convergence_json({}, measured, tabulate(measured)));
  EXPECT_TRUE(json["speed_ups"][0]["samples"].is_null());
  EXPECT_TRUE(json["costs"][0]["ratio"]["low"].is_null());
}

}  // namespace
}  // namespace foveola::analysis
