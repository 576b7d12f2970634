#include "analysis/publication/data_files.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>

#include <nlohmann/json.hpp>

#include "analysis/dataset/wording.h"

namespace foveola::analysis {
namespace {

/// Psych-DS allows letters and digits in the values of a file's name, which no file system takes at
/// any length.
std::string file_word(const std::string& name) {
  std::string word;
  std::copy_if(name.begin(), name.end(), std::back_inserter(word),
               [](unsigned char c) { return c < 0x80 && std::isalnum(c) != 0; });
  constexpr std::size_t max_length = 64;
  return word.empty() ? "study" : word.substr(0, max_length);
}

/// Every column of the data files once: Psych-DS forbids columns that are not described.
std::vector<Column> all_columns(const TrialColumns& trials,
                                const ParticipantColumns& participants) {
  std::vector<Column> columns = trials.columns();
  std::set<std::string> described;
  for (const Column& column : columns) {
    described.insert(column.name);
  }
  for (const Column& column : participants.columns()) {
    if (described.insert(column.name).second) {
      columns.push_back(column);
    }
  }
  return columns;
}

std::string dataset_description(const StudyTables& tables, const TrialColumns& trials,
                                const ParticipantColumns& participants) {
  nlohmann::ordered_json variables = nlohmann::ordered_json::array();
  for (const Column& column : all_columns(trials, participants)) {
    nlohmann::ordered_json entry = {
        {"@type", "PropertyValue"}, {"name", column.name}, {"description", column.description}};
    if (!column.unit.empty()) {
      entry["unitText"] = column.unit;
    }
    variables.push_back(std::move(entry));
  }
  const std::string warning = data_warning(tables);
  const nlohmann::ordered_json json = {
      {"@context", "https://schema.org/"},
      {"@type", "Dataset"},
      {"name", tables.protocol_title.empty() ? tables.protocol_name : tables.protocol_title},
      {"description",
       (warning.empty() ? "" : warning + " ") +
           "Times and ratings of progressive previews, one row per trial and one per participant; "
           "protocol " +
           tables.protocol_name + ", SHA-256 " + tables.protocol_sha256},
      {"variableMeasured", variables}};
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace

PsychDs psych_ds(const StudyTables& tables, const TrialColumns& trials,
                 const ParticipantColumns& participants) {
  const std::string data = "psych-ds/data/study-" + file_word(tables.protocol_name);
  return {{"psych-ds/dataset_description.json", dataset_description(tables, trials, participants)},
          data + "_type-trials_data.csv",
          data + "_type-participants_data.csv"};
}

}  // namespace foveola::analysis
