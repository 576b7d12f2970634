// Writes a large table as a CSV file, row by row.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "analysis/tables/table.h"

namespace foveola::analysis {

/// Buffers at most a megabyte of the file.
class RowFile {
 public:
  /// Makes the file's folder if it is missing.
  RowFile(std::filesystem::path path, const std::vector<Column>& columns,
          CsvTexts texts = CsvTexts::as_typed);

  void add(const Row& row);
  /// Throws Error if the file could not be written completely.
  void close();

 private:
  void flush();

  std::filesystem::path path_;
  CsvTexts texts_;
  std::string text_;
  std::ofstream stream_;
};

}  // namespace foveola::analysis
