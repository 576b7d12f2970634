// Reads a study's trials with what was measured in each of their timings.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "study/record/study_records.h"

namespace SQLite {
class Database;
}

namespace foveola::study {

/// The index in StudyRecords::sessions of each session whose data are read, by its row id.
using SessionIndices = std::unordered_map<std::int64_t, std::uint32_t>;

/// Keeps each text once in StudyRecords::words, the empty one first.
class WordIndices {
 public:
  /// `words` must outlive it.
  explicit WordIndices(std::vector<std::string>& words);
  std::uint32_t index_of(const std::string& text);

 private:
  std::vector<std::string>& words_;
  std::unordered_map<std::string, std::uint32_t> indices_;
};

/// Fills the records' trials and values; their scenes, methods, measures and sessions must be
/// there. Throws what SQLite throws.
void read_trial_rows(SQLite::Database& database, const SessionIndices& sessions, WordIndices& words,
                     StudyRecords& records);

}  // namespace foveola::study
