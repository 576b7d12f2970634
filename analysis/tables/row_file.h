// Writes a large table as a CSV file, row by row.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "analysis/tables/table.h"

namespace foveola::analysis {

/// Buffers about a megabyte of text. Call close(): rows that are not yet written are lost without
/// it. The file is written in place, so that an unfinished one is left after an error.
class RowFile {
 public:
  /// Makes the file's folder if it is missing; throws std::filesystem::filesystem_error if it
  /// cannot. A file that cannot be opened is reported by close(). texts: see CsvTexts.
  RowFile(std::filesystem::path path, const std::vector<Column>& columns,
          CsvTexts texts = CsvTexts::as_typed);

  /// The row has one field per column.
  void add(const Row& row);
  /// Writes and syncs the rest. Throws Error if the file could not be written completely.
  void close();

 private:
  void flush();

  std::filesystem::path path_;
  CsvTexts texts_;
  std::string text_;
  std::ofstream stream_;
};

}  // namespace foveola::analysis
