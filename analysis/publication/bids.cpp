#include "analysis/publication/bids.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <numeric>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/publication/trial_data.h"
#include "analysis/publication/wording.h"
#include "renderer/base/csv.h"

namespace foveola::analysis {
namespace {

using BidsJson = nlohmann::ordered_json;

constexpr const char* bids_version = "1.11.1";

std::string bids_json(const BidsJson& json) {
  return json.dump(2, ' ', false, BidsJson::error_handler_t::replace) + "\n";
}

/// A row of tab-separated values: BIDS has no quotes, and writes missing values as "n/a".
std::string tsv_row(const std::vector<std::string>& fields) {
  std::string row;
  for (const std::string& field : fields) {
    std::string text = field.empty() ? "n/a" : field;
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
    row += (row.empty() ? "" : "\t") + text;
  }
  return row + "\n";
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

std::string participants_tsv(const StudyTables& tables,
                             const std::vector<study::BackgroundRow>& answers,
                             const std::vector<std::string>& labels) {
  std::map<std::string, std::map<std::string, double>> given;
  std::set<std::string> questions;
  for (const study::BackgroundRow& row : answers) {
    given[row.participant][row.question] = row.value;
    questions.insert(row.question);
  }
  std::vector<std::string> heading = {"participant_id", "participant_code", "participant_kind"};
  for (const std::string& question : questions) {
    heading.push_back("background_" + question);
  }
  std::string text = tsv_row(heading);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const std::string& code = tables.set.participants[i];
    std::vector<std::string> row = {"sub-" + labels[i], code, tables.set.kind};
    const std::map<std::string, double>& own = given[code];
    for (const std::string& question : questions) {
      const auto answer = own.find(question);
      row.push_back(answer == own.end() ? "" : csv_number(answer->second));
    }
    text += tsv_row(row);
  }
  return text;
}

std::string participants_json(const std::vector<study::BackgroundRow>& answers) {
  BidsJson json;
  json["participant_code"]["Description"] = "Code of the participant in the study's file";
  BidsJson& kind = json["participant_kind"];
  kind["Description"] = "Who took part";
  kind["Levels"]["human"] = "a person";
  kind["Levels"]["pilot"] = "a person trying out the procedure";
  kind["Levels"]["simulated"] = "a simulated participant, not a person";
  for (const study::BackgroundRow& row : answers) {
    json["background_" + row.question]["Description"] =
        "Answer to the background question " + row.question + ", as a number";
  }
  return bids_json(json);
}

/// The columns of a behavioural file: those of the long table but for the participant's.
constexpr std::size_t first_trial_variable = 2;

std::string behaviour_json(const RatingScale& scale) {
  BidsJson json;
  json["TaskName"] = "preview";
  const std::vector<Variable> variables = trial_variables(scale);
  for (std::size_t i = first_trial_variable; i < variables.size(); ++i) {
    BidsJson entry;
    entry["Description"] = variables[i].description;
    if (!variables[i].unit.empty()) {
      entry["Units"] = variables[i].unit;
    }
    json[variables[i].name] = std::move(entry);
  }
  return bids_json(json);
}

std::string behaviour_tsv(const AnalysisSet& set, std::size_t participant) {
  std::vector<std::string> heading;
  for (const Variable& variable : trial_variables(set.rating_scale)) {
    heading.push_back(variable.name);
  }
  const auto trial_fields = [](const std::vector<std::string>& row) {
    return std::vector<std::string>(row.begin() + first_trial_variable, row.end());
  };
  const std::size_t trials = set.scenes.size() * set.methods.size();
  std::vector<std::size_t> order(trials);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const auto position = [&](std::size_t trial) {
      return set.cells[participant * trials + trial].trial_position;
    };
    return position(a) < position(b);
  });
  std::string text = tsv_row(trial_fields(heading));
  for (const std::size_t trial : order) {
    text += tsv_row(trial_fields(
        trial_row(set, participant, trial / set.methods.size(), trial % set.methods.size())));
  }
  return text;
}

std::string readme(const StudyTables& tables) {
  const std::string warning = data_warning(tables);
  return fmt::format(
      "{}\n\n{}The task \"preview\": participants looked at scenes while they were rendered, and "
      "marked when the\noutline of an object and when its material was visible.\n\n"
      "*_beh.tsv has a row for each trial of an analysed participant.\n"
      "*_run-<index>_recording-eye1_physio.tsv.gz, where gaze was recorded, has the gaze of one "
      "timing of a\ntrial; runs count these in the order of the session, trials that were timed "
      "again and practice included.\nIts .json says which trial it is, and "
      "*_physioevents.tsv.gz has the first frame, the marks and the eye's\nmovements.\n",
      tables.protocol_title.empty() ? tables.protocol_name : tables.protocol_title,
      warning.empty() ? "" : warning + "\n\n");
}

}  // namespace

std::vector<std::string> bids_labels(const AnalysisSet& set) {
  std::set<std::string> taken;
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

std::vector<TextFile> bids_files(const StudyTables& tables,
                                 const std::vector<study::BackgroundRow>& answers) {
  const std::vector<std::string> labels = bids_labels(tables.set);
  std::vector<TextFile> files = {
      {"bids/README", readme(tables)},
      {"bids/dataset_description.json", description_json(tables)},
      {"bids/participants.tsv", participants_tsv(tables, answers, labels)},
      {"bids/participants.json", participants_json(answers)},
      {"bids/task-preview_beh.json", behaviour_json(tables.set.rating_scale)}};
  for (std::size_t i = 0; i < labels.size(); ++i) {
    files.push_back({fmt::format("bids/sub-{0}/beh/sub-{0}_task-preview_beh.tsv", labels[i]),
                     behaviour_tsv(tables.set, i)});
  }
  return files;
}

}  // namespace foveola::analysis
