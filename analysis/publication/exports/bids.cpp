#include "analysis/publication/exports/bids.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <strings.h>

#include "analysis/dataset/wording.h"
#include "analysis/tables/table_formats.h"

namespace foveola::analysis {
namespace {

using BidsJson = nlohmann::ordered_json;

constexpr const char* bids_version = "1.11.1";

std::string bids_json(const BidsJson& json) {
  return json.dump(2, ' ', false, BidsJson::error_handler_t::replace) + "\n";
}

std::string letters_and_digits(const std::string& code) {
  std::string label;
  std::copy_if(code.begin(), code.end(), std::back_inserter(label),
               [](unsigned char c) { return c < 0x80 && std::isalnum(c) != 0; });
  return label.empty() ? "x" : label;
}

std::string description_json(const StudyTables& tables) {
  const std::string warning = data_warning(tables);
  const std::string& title =
      tables.protocol_title.empty() ? tables.protocol_name : tables.protocol_title;
  BidsJson generator;
  generator["Name"] = "Foveola";
  BidsJson json;
  json["Name"] = warning.empty() ? title : title + " (" + data_notice(tables) + ")";
  json["BIDSVersion"] = bids_version;
  json["DatasetType"] = "raw";
  json["GeneratedBy"] = BidsJson::array();
  json["GeneratedBy"].push_back(generator);
  return bids_json(json);
}

/// A participant's numeric answers, which participants.tsv has after the label and the code.
struct ParticipantFile {
  std::string tsv;
  std::string json;
};

ParticipantFile participants_file(const Dataset& set, const ColumnsOf<std::size_t>& answers,
                                  const std::vector<std::string>& labels) {
  std::vector<Column> columns = {{"participant_id", ColumnType::text, "", ""},
                                 {"participant_code", ColumnType::text, "", ""},
                                 {"participant_kind", ColumnType::text, "", ""}};
  BidsJson json;
  json["participant_code"]["Description"] = "Code of the participant in the study's file";
  BidsJson& kind = json["participant_kind"];
  kind["Description"] = "Kind of participant";
  kind["Levels"]["human"] = "a person";
  kind["Levels"]["pilot"] = "a person trying out the procedure";
  kind["Levels"]["simulated"] = "a simulated participant, not a person";
  for (const Column& column : columns_in(answers)) {
    json[column.name]["Description"] = column.description;
    columns.push_back(column);
  }
  std::string tsv = tsv_heading(columns);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    Row row = {"sub-" + labels[i], set.participants[i], set.kind};
    std::ranges::move(row_of(answers, i), std::back_inserter(row));
    tsv += tsv_row(row);
  }
  return {std::move(tsv), bids_json(json)};
}

/// Columns of a behavioural file: those of the trials, without the participant's.
ColumnsOf<std::size_t> behaviour_columns(const ColumnsOf<std::size_t>& trials) {
  return {trials.begin() + columns_of_the_participant, trials.end()};
}

std::string behaviour_json(const ColumnsOf<std::size_t>& behaviour) {
  BidsJson json;
  json["TaskName"] = "preview";
  for (const Column& column : columns_in(behaviour)) {
    BidsJson entry;
    entry["Description"] = column.description;
    if (!column.unit.empty()) {
      entry["Units"] = column.unit;
    }
    json[column.name] = std::move(entry);
  }
  return bids_json(json);
}

std::vector<std::string> behaviour_files(const Dataset& set, const study::StudyRecords& records,
                                         const ColumnsOf<std::size_t>& behaviour) {
  std::vector<std::string> files(set.participants.size(), tsv_heading(columns_in(behaviour)));
  for (std::size_t i = 0; i < records.trials.size(); ++i) {
    const study::TrialRow& trial = records.trials[i];
    const auto found = std::lower_bound(set.participants.begin(), set.participants.end(),
                                        records.participant_of(trial));
    if (trial.counts && found != set.participants.end() &&
        *found == records.participant_of(trial)) {
      files[static_cast<std::size_t>(found - set.participants.begin())] +=
          tsv_row(row_of(behaviour, i));
    }
  }
  return files;
}

std::string readme(const StudyTables& tables) {
  const std::string warning = data_warning(tables);
  return fmt::format(
      "{}\n\n{}The task \"preview\": participants looked at scenes while they were rendered, and "
      "marked the moments\nthat the columns of task-preview_beh.json describe.\n\n"
      "*_beh.tsv has a row for each trial of an analysed participant.\n"
      "*_run-<index>_recording-eye1_physio.tsv.gz, where gaze was recorded, has the gaze of one "
      "timing of a\ntrial; runs count these in the order of the session, trials that were timed "
      "again and practice included.\nIts .json says which trial it is, and "
      "*_physioevents.tsv.gz has the first frame, the marks and the eye's\nmovements. Where there "
      "are any, .bidsignore names them, since older validators do not know them. A\n"
      "*_recording-mouse_physio.tsv.gz is of sessions in which the mouse pointer stood for the "
      "eye.\n\n"
      "A value that does not exist is n/a; an answer that somebody typed as n/a is 'n/a, with an\n"
      "apostrophe. NA, None or null are answers: read with na.strings = \"n/a\" in R, with\n"
      "keep_default_na=False, na_values=[\"n/a\"] in pandas.\n\n"
      "Before you publish these files, add their Authors and License to "
      "dataset_description.json.\n",
      tables.protocol_title.empty() ? tables.protocol_name : tables.protocol_title,
      warning.empty() ? "" : warning + "\n\n");
}

}  // namespace

std::vector<std::string> bids_labels(const Dataset& set) {
  // Many file systems take names for one that differ in letter case only.
  const auto precedes = [](const std::string& a, const std::string& b) {
    return ::strcasecmp(a.c_str(), b.c_str()) < 0;
  };
  std::set<std::string, decltype(precedes)> taken;
  std::vector<std::string> labels;
  for (const std::string& code : set.participants) {
    const std::string plain = letters_and_digits(code);
    std::string label = plain;
    for (int number = 2; !taken.insert(label).second; ++number) {
      label = fmt::format("{}n{}", plain, number);
    }
    labels.push_back(label);
  }
  return labels;
}

std::vector<TextFile> bids_files(const StudyTables& tables, const study::StudyRecords& records,
                                 const ColumnsOf<std::size_t>& trials,
                                 const ColumnsOf<std::size_t>& answers) {
  const std::vector<std::string> labels = bids_labels(tables.set);
  const ParticipantFile participants = participants_file(tables.set, answers, labels);
  const ColumnsOf<std::size_t> behaviour = behaviour_columns(trials);
  std::vector<TextFile> files = {{"bids/README", readme(tables)},
                                 {"bids/dataset_description.json", description_json(tables)},
                                 {"bids/participants.tsv", participants.tsv},
                                 {"bids/participants.json", participants.json},
                                 {"bids/task-preview_beh.json", behaviour_json(behaviour)}};
  std::vector<std::string> trials_of = behaviour_files(tables.set, records, behaviour);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    files.push_back({fmt::format("bids/sub-{0}/beh/sub-{0}_task-preview_beh.tsv", labels[i]),
                     std::move(trials_of[i])});
  }
  return files;
}

}  // namespace foveola::analysis
