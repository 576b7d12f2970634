#include "renderer/vision/castle_csf.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace foveola {
namespace {

const DVec3 d65_step(0.6855, 0.2951, 0.0194);
const DVec3 d65_background(0.6991, 0.3009, 0.0198);

struct CheckValue {
  CsfStimulus stimulus;
  double of_d65;
  CastleSensitivity sensitivity;
};

/// By another program that was written from the paper and its authors' program.
const std::vector<CheckValue> check_values = {
    {{1, 0, 100, 1, 0, 180}, 51.4831, {51.4673, 151.507, 17.3962}},
    {{4, 0, 100, 1, 0, 180}, 134.312, {134.278, 148.895, 14.7594}},
    {{4, 8, 100, 1, 0, 180}, 76.0099, {75.9905, 75.9423, 5.16858}},
    {{1, 0, 10, 19.635, 20, 180}, 21.3578, {21.3521, 0.0589772, 15.7911}},
    {{1, 0, 10, 19.635, 20, 0}, 27.2785, {27.2713, 16.2203, 15.3828}},
    {{2, 0, 30, 3.1416, 10, 0}, 38.9779, {38.9677, 49.9936, 12.5471}},
    {{8, 0, 100, 1, 5, 180}, 29.3794, {29.3721, 5.53e-6, 3.27068}},
    {{1, 0, 0.005, 1, 0, 180}, 3.77709, {3.77614, 2.41711, 0.435471}},
    {{16, 16, 100, 0.1, 0, 180}, 7.04288, {7.04106, 9.27598, 0.500624}},
};

TEST(CastleCsf, HasTheCheckValues) {
  for (const CheckValue& check : check_values) {
    const CastleSensitivity found = castle_sensitivity(check.stimulus);
    const CastleSensitivity& expected = check.sensitivity;
    const double tolerance = 1e-4;
    EXPECT_NEAR(found.achromatic / expected.achromatic, 1.0, tolerance);
    EXPECT_NEAR(found.red_green / expected.red_green, 1.0,
                expected.red_green < 1e-4 ? 0.01 : tolerance);
    EXPECT_NEAR(found.yellow_violet / expected.yellow_violet, 1.0, tolerance);
    EXPECT_NEAR(castle_sensitivity(check.stimulus, d65_step, d65_background) / check.of_d65, 1.0,
                tolerance);
  }
}

struct Row {
  std::string data_set;
  bool is_disc;
  CsfStimulus stimulus;
  double radius_deg;
  DVec3 background;
  DVec3 step;
  double sensitivity;
};

std::vector<Row> published_rows() {
  std::ifstream file(CASTLE_CSF_FILE);
  std::string line;
  std::getline(file, line);
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::vector<std::string> texts;
    for (std::string cell; std::getline(cells, cell, ',');) {
      texts.push_back(cell);
    }
    std::vector<double> v;
    for (std::size_t i = 2; i < texts.size(); ++i) {
      v.push_back(std::stod(texts[i]));
    }
    rows.push_back({.data_set = texts[0],
                    .is_disc = texts[1] == "disk",
                    .stimulus = {.frequency_cpd = v[0],
                                 .temporal_frequency_hz = v[1],
                                 .luminance_cd_m2 = v[6] + v[7],
                                 .area_deg2 = v[2],
                                 .eccentricity_deg = v[4],
                                 .visual_field_deg = v[5]},
                    .radius_deg = v[3],
                    .background = {v[6], v[7], v[8]},
                    .step = {v[9], v[10], v[11]},
                    .sensitivity = v[12]});
  }
  return rows;
}

/// A disc is seen at its most visible frequency (as the authors predict it).
double predicted(const Row& row) {
  if (!row.is_disc) {
    return castle_sensitivity(row.stimulus, row.step, row.background);
  }
  CsfStimulus stimulus = row.stimulus;
  stimulus.area_deg2 = 2.42437;
  double largest = 0.0;
  for (int i = 0; i < 64; ++i) {
    stimulus.frequency_cpd = 0.125 * std::pow(128.0, i / 63.0);
    largest = std::max(largest, castle_sensitivity(stimulus, row.step, row.background));
  }
  return largest * std::pow(row.radius_deg, 1.0 / 3.01142);
}

/// In decibels.
struct Errors {
  double sum = 0.0;
  double squares = 0.0;
  double count = 0.0;

  void add(double error) {
    sum += error;
    squares += error * error;
    count += 1.0;
  }
  double bias() const { return sum / count; }
  double rms() const { return std::sqrt(squares / count); }
  double squares_after_one_factor() const { return squares - sum * sum / count; }
};

TEST(CastleCsf, ErrsAsPublishedOverThePublishedData) {
  std::map<std::string, Errors> all;
  std::map<std::string, Errors> eccentric;
  const std::vector<Row> rows = published_rows();
  ASSERT_EQ(rows.size(), 2305U);
  for (const Row& row : rows) {
    const double error_db = 20.0 * std::log10(predicted(row) / row.sensitivity);
    all[row.data_set].add(error_db);
    if (row.stimulus.eccentricity_deg > 0.0) {
      eccentric[row.data_set].add(error_db);
    }
  }
  double squares = 0.0;
  for (const auto& [name, errors] : all) {
    squares += errors.squares_after_one_factor();
  }
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(rows.size())), 3.57, 0.05)
      << "3.59 in the paper";

  struct Expected {
    const char* data_set;
    double count, bias_db, rms_db, rms_after_one_factor_db;
  };
  for (const Expected& expected :
       {Expected{"virsu1979", 25, -3.39, 5.68, 4.55}, Expected{"virsu1982", 55, 0.13, 3.53, 3.53},
        Expected{"wright1983", 115, 1.80, 3.18, 2.61},
        Expected{"hansen2009", 25, 1.46, 6.59, 6.43}}) {
    const Errors& found = eccentric.at(expected.data_set);
    EXPECT_EQ(found.count, expected.count) << expected.data_set;
    EXPECT_NEAR(found.bias(), expected.bias_db, 0.05) << expected.data_set;
    EXPECT_NEAR(found.rms(), expected.rms_db, 0.05) << expected.data_set;
    EXPECT_NEAR(std::sqrt(found.squares_after_one_factor() / found.count),
                expected.rms_after_one_factor_db, 0.05)
        << expected.data_set;
  }
}

TEST(CastleCsf, IsFiniteInTheDarkAndFarAside) {
  for (const double luminance : {1e-6, 1e-3, 1e6}) {
    for (const double eccentricity : {0.0, 90.0, 180.0}) {
      const CastleSensitivity found = castle_sensitivity({.frequency_cpd = 60.0,
                                                          .temporal_frequency_hz = 60.0,
                                                          .luminance_cd_m2 = luminance,
                                                          .eccentricity_deg = eccentricity});
      for (const double sensitivity : {found.achromatic, found.red_green, found.yellow_violet}) {
        EXPECT_GE(sensitivity, 0.0);
        EXPECT_TRUE(std::isfinite(sensitivity));
      }
    }
  }
}

}  // namespace
}  // namespace foveola
