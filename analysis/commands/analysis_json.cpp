#include "analysis/commands/analysis_json.h"

#include <nlohmann/json.hpp>

#include "analysis/dataset/wording.h"
#include "analysis/tables/table_formats.h"
#include "study/record/verification_json.h"

namespace foveola::analysis {
namespace {

using json = nlohmann::ordered_json;

json measures(const Dataset& set) {
  json rows = json::array();
  for (const Measure& measure : set.measures) {
    rows.push_back({{"id", measure.id()},
                    {"kind", study::name_of(measure.kind)},
                    {"unit", measure.unit()},
                    {"text", measure.question.text},
                    {"scale", study::scale_in_words(measure)}});
  }
  return rows;
}

/// Those of trials, answers and participants are in their files only.
json tables_of(const AnalysisOutput& output) {
  json tables = json::object();
  for (const Table& table : output.results) {
    if (!is_written_by_rows(table)) {
      tables[table.id] = json_of(table);
    }
  }
  return tables;
}

}  // namespace

std::string analysis_json(const AnalysisOutput& output) {
  const StudyTables& tables = output.tables;
  const std::string notice = data_notice(tables);
  json files = json::array();
  for (const std::filesystem::path& file : output.files) {
    files.push_back(file.string());
  }
  const json result = {
      {"report", output.report.string()},
      {"files", files},
      {"warnings", output.warnings},
      {"protocol", tables.protocol_name},
      {"protocol_sha256", tables.protocol_sha256},
      {"participant_kind", tables.set.kind},
      {"data_notice", notice.empty() ? json(nullptr) : json(notice)},
      {"participants", tables.set.participants.size()},
      {"scenes", tables.set.scenes},
      {"methods", tables.set.methods},
      {"baseline", tables.set.methods.front()},
      {"measures", measures(tables.set)},
      {"tables", tables_of(output)},
      {"record", output.record ? study::verification_json(*output.record) : json(nullptr)},
      {"excluded", tables.set.exclusions.size()}};
  return result.dump(2, ' ', false, json::error_handler_t::replace);
}

}  // namespace foveola::analysis
