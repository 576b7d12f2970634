#include "tests/analysis/golden.h"

#include <cmath>

#include "renderer/base/files.h"

namespace foveola::analysis {

std::vector<CsvRow> golden_rows(const std::string& file) {
  const std::string path = std::string(FOVEOLA_DATA_DIR) + "/golden/" + file;
  std::vector<CsvRow> rows = parse_csv(read_file(path), path);
  rows.erase(rows.begin());
  return rows;
}

std::map<std::string, double> golden_statistics() {
  std::map<std::string, double> values;
  for (const CsvRow& row : golden_rows("statistics_values.csv")) {
    values[row.at(0) + "." + row.at(1)] = std::stod(row.at(2));
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
