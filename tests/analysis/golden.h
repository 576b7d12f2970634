// What R computed, read from data/golden.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "renderer/base/csv.h"

namespace foveola::analysis {

/// The rows of data/golden/`file` without its heading.
std::vector<CsvRow> golden_rows(const std::string& file);

/// "sample.quantity" to value, from statistics_values.csv; key to value, from study_values.csv.
std::map<std::string, double> golden_statistics();
std::map<std::string, double> golden_study();

/// Whether two numbers agree to a relative difference of 1e-10: the same algorithm as R's.
bool agrees(double value, double golden);

}  // namespace foveola::analysis

/// EXPECT that `value` agrees with `golden`, and print both if not.
#define EXPECT_GOLDEN(value, golden) \
  EXPECT_PRED2(::foveola::analysis::agrees, static_cast<double>(value), golden)
