// A large table as a CSV file, written row by row.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "analysis/tables/table.h"

namespace foveola::analysis {

/// Keeps a megabyte of the file in memory at most.
class RowFile {
 public:
  /// Makes the file's folder if need be.
  RowFile(std::filesystem::path path, const std::vector<Column>& columns,
          CsvTexts texts = CsvTexts::as_typed);

  void add(const Row& row);
  /// Throws Error if not everything could be written.
  void close();

 private:
  void flush();

  std::filesystem::path path_;
  CsvTexts texts_;
  std::string text_;
  std::ofstream stream_;
};

}  // namespace foveola::analysis
