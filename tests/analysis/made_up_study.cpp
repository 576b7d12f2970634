#include "tests/analysis/made_up_study.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "tests/analysis/golden.h"

namespace foveola::analysis {
namespace {

using study::StudyRecords;
using study::TrialRow;

std::optional<double> seconds(const std::string& field) {
  return field.empty() ? std::nullopt : std::optional(std::stod(field));
}

}  // namespace

StudyRecords golden_study_records() {
  StudyRecords records;
  records.protocol_name = "golden";
  records.protocol_title = "A made-up study";
  records.protocol_sha256 = std::string(64, 'a');
  records.scenes = {"aula", "barn", "cave"};
  records.methods = {"od", "vp", "fv"};
  for (int i = 1; i <= 9; ++i) {
    records.sessions.push_back(
        {fmt::format("P0{}", i), "human", i == 9 ? "interrupted" : "completed"});
  }
  for (const CsvRow& row : golden_rows("study_trials.csv")) {
    TrialRow trial;
    trial.participant = row.at(0);
    trial.scene = row.at(1);
    trial.method = row.at(2);
    trial.attempts = 1;
    trial.outline_s = seconds(row.at(3));
    trial.material_s = seconds(row.at(4));
    trial.outline_censored = row.at(5) == "1";
    trial.material_censored = row.at(6) == "1";
    if (!row.at(7).empty()) {
      trial.artifact_rating = std::stoi(row.at(7));
    }
    records.trials.push_back(trial);
  }
  for (const CsvRow& row : golden_rows("study_background.csv")) {
    records.background.push_back({row.at(0), row.at(1), std::stod(row.at(2))});
  }
  return records;
}

StudyRecords complete_study(int participants) {
  StudyRecords records;
  records.protocol_name = "complete";
  records.protocol_title = "A complete study";
  records.protocol_sha256 = std::string(64, 'c');
  records.scenes = {"aula", "barn"};
  records.methods = {"od", "vp", "fv"};
  for (int p = 1; p <= participants; ++p) {
    const std::string code = fmt::format("P{}", p);
    records.sessions.push_back({code, "human", "completed"});
    records.background.push_back({code, "offline_rendering", 1.0 + p % 5});
    records.background.push_back({code, "graphics_3d", 1.0 + p * p % 3});
    for (std::size_t scene = 0; scene < records.scenes.size(); ++scene) {
      for (std::size_t method = 0; method < records.methods.size(); ++method) {
        TrialRow trial;
        trial.participant = code;
        trial.scene = records.scenes[scene];
        trial.method = records.methods[method];
        trial.attempts = 1;
        const double outline = (10.0 + 0.5 * p + 4.0 * static_cast<double>(scene)) /
                               (1.0 + 2.0 * static_cast<double>(method) + 0.1 * p);
        trial.outline_s = outline;
        trial.material_s = 1.5 * outline;
        trial.artifact_rating = 1 + (p + static_cast<int>(method)) % 3;
        records.trials.push_back(trial);
      }
    }
  }
  return records;
}

TrialRow& trial_of(StudyRecords& records, const std::string& participant, const std::string& scene,
                   const std::string& method) {
  const auto found =
      std::find_if(records.trials.begin(), records.trials.end(), [&](const TrialRow& row) {
        return row.participant == participant && row.scene == scene && row.method == method;
      });
  if (found == records.trials.end()) {
    throw std::out_of_range("no such trial");
  }
  return *found;
}

}  // namespace foveola::analysis
