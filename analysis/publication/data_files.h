// The data as files for other programs: a folder as Psych-DS lays it out, large CSV files, and gzip
// (RFC 1952).
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/dataset/study_tables.h"
#include "analysis/publication/trial_data.h"
#include "analysis/tables/table.h"
#include "analysis/tables/text_file.h"

namespace foveola::analysis {

/// A folder as Psych-DS 1 describes it: its description, and the names of its data files, which
/// hold the trials that count and the participants.
struct PsychDs {
  TextFile description;
  std::string trials_name;
  std::string participants_name;
};
PsychDs psych_ds(const StudyTables& tables, const TrialColumns& trials,
                 const ParticipantColumns& participants);

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

/// The whole file. The same text gives the same bytes: it holds no name and no time.
std::string gzip(std::string_view text);

}  // namespace foveola::analysis
