#include "tests/analysis/golden.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/files/files.h"

namespace foveola::analysis {

std::vector<CsvRow> golden_rows(const std::string& file) {
  const std::string path = std::string(FOVEOLA_DATA_DIR) + "/golden/" + file;
  std::vector<CsvRow> rows = parse_csv(read_file(path), path);
  rows.erase(rows.begin());
  return rows;
}

namespace {

std::map<std::string, double> values_by_sample(const std::string& file) {
  std::map<std::string, double> values;
  for (const CsvRow& row : golden_rows(file)) {
    values[row.at(0) + "." + row.at(1)] = std::stod(row.at(2));
  }
  return values;
}

}  // namespace

std::map<std::string, double> golden_statistics() {
  return values_by_sample("statistics_values.csv");
}

std::map<std::string, double> golden_inference() {
  return values_by_sample("inference_values.csv");
}

std::map<std::string, double> golden_models() { return values_by_sample("models_values.csv"); }

std::map<std::string, double> golden_outliers() { return values_by_sample("outliers_values.csv"); }

std::map<std::string, double> golden_survival() { return values_by_sample("survival_values.csv"); }

std::map<std::string, GoldenMatrix> golden_matrices(const std::string& file) {
  std::map<std::string, GoldenMatrix> matrices;
  for (const CsvRow& row : golden_rows(file)) {
    const std::size_t participant = std::stoul(row.at(1)) - 1;
    const std::size_t column = std::stoul(row.at(2)) - 1;
    GoldenMatrix& matrix = matrices[row[0]];
    matrix.resize(std::max(matrix.size(), participant + 1));
    matrix[participant].resize(std::max(matrix[participant].size(), column + 1));
    if (!row.at(3).empty()) {
      matrix[participant][column] = std::stod(row[3]);
    }
  }
  return matrices;
}

std::vector<double> golden_column(const GoldenMatrix& matrix, std::size_t column) {
  std::vector<double> values;
  for (const auto& row : matrix) {
    values.push_back(row.at(column).value());
  }
  return values;
}

std::map<std::string, double> golden_study() {
  std::map<std::string, double> values;
  for (const CsvRow& row : golden_rows("study_values.csv")) {
    values[row.at(0)] = std::stod(row.at(1));
  }
  return values;
}

bool agrees(double value, double golden) {
  return std::abs(value - golden) <= 1e-10 * std::abs(golden);
}

}  // namespace foveola::analysis
