// The rows of a CSV file by the names of their columns.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "renderer/base/files/files.h"
#include "renderer/base/text/csv.h"

namespace foveola::test {

using NamedFields = std::map<std::string, std::string>;

inline std::vector<NamedFields> rows_of_csv(const std::filesystem::path& file) {
  const std::vector<CsvRow> lines = parse_csv(read_file(file), file.string());
  std::vector<NamedFields> rows;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    NamedFields& row = rows.emplace_back();
    for (std::size_t column = 0; column < lines[i].size(); ++column) {
      row[lines[0][column]] = lines[i][column];
    }
  }
  return rows;
}

}  // namespace foveola::test
