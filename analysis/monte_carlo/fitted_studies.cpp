#include "analysis/monte_carlo/fitted_studies.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "analysis/dataset/comparisons.h"
#include "analysis/publication/row_file.h"
#include "analysis/publication/trial_data.h"
#include "analysis/r_models/fit_models.h"
#include "analysis/r_models/models_plan.h"
#include "analysis/r_models/models_script.h"
#include "analysis/tables/table_formats.h"
#include "renderer/base/files.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

bool has_data(const study::StudyRecords& records) {
  return std::any_of(records.sessions.begin(), records.sessions.end(),
                     [](const study::SessionRow& row) { return row.state == "completed"; });
}

void write_study(const study::StudyRecords& records, const fs::path& folder) {
  const Dataset set = select_for_analysis(records);
  const TrialColumns trials(records, set);
  RowFile file(folder / "trials_long.csv", trials.columns());
  for (std::size_t i = 0; i < records.trials.size(); ++i) {
    file.add(trials.row(i));
  }
  file.close();
  const study::AnalysisPlan& plan = records.protocol.analysis;
  write_file(folder / "models_plan.csv",
             csv_of(models_plan(set, planned_pairs(set, plan), plan.scenes, ModelDetail::p_only)));
}

}  // namespace

std::vector<FittedModels> fit_studies(const std::vector<study::StudyRecords>& studies) {
  const ScratchFolder scratch;
  const fs::path script = scratch / "models.R";
  write_file(script, models_script());
  std::vector<fs::path> folders;
  for (const study::StudyRecords& records : studies) {
    if (has_data(records)) {
      folders.push_back(scratch / fmt::format("{}", folders.size()));
      write_study(records, folders.back());
    }
  }
  std::vector<FittedModels> fitted;
  if (!folders.empty()) {
    fitted = fit_models(script, folders);
  }
  std::vector<FittedModels> all;
  auto next = fitted.begin();
  for (const study::StudyRecords& records : studies) {
    all.push_back(has_data(records) ? std::move(*next++)
                                    : FittedModels{.missing = "no session is completed"});
  }
  return all;
}

}  // namespace foveola::analysis
