// The results of R, read from data/golden.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/text/csv.h"

namespace foveola::analysis {

/// The rows of data/golden/`file` without its heading.
std::vector<CsvRow> golden_rows(const std::string& file);

/// "sample.quantity" to value, from statistics_values.csv; key to value, from study_values.csv.
std::map<std::string, double> golden_statistics();
std::map<std::string, double> golden_study();

/// "sample" to rows of columns, with nothing where a cell is missing, from a file as
/// data/golden/inference_samples.csv.
using GoldenMatrix = std::vector<std::vector<std::optional<double>>>;
std::map<std::string, GoldenMatrix> golden_matrices(
    const std::string& file = "inference_samples.csv");

/// "sample.quantity" to value, from inference_values.csv, models_values.csv and
/// survival_values.csv.
std::map<std::string, double> golden_inference();
std::map<std::string, double> golden_models();
std::map<std::string, double> golden_outliers();
std::map<std::string, double> golden_survival();

/// One column of a matrix without gaps.
std::vector<double> golden_column(const GoldenMatrix& matrix, std::size_t column);

/// Whether two numbers agree to a relative difference of 1e-10: the same algorithm as R's.
bool agrees(double value, double golden);

}  // namespace foveola::analysis

/// EXPECT that `value` agrees with `golden`, and print both if not.
#define EXPECT_GOLDEN(value, golden) \
  EXPECT_PRED2(::foveola::analysis::agrees, static_cast<double>(value), golden)
