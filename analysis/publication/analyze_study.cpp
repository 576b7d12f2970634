#include "analysis/publication/analyze_study.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "analysis/publication/analysis_plan.h"
#include "analysis/publication/bids.h"
#include "analysis/publication/bids_eye_tracking.h"
#include "analysis/publication/comparison_tables.h"
#include "analysis/publication/figures.h"
#include "analysis/publication/latex_tables.h"
#include "analysis/publication/methods_paragraph.h"
#include "analysis/publication/output_folder.h"
#include "analysis/publication/published_means.h"
#include "analysis/publication/report.h"
#include "analysis/publication/summary.h"
#include "analysis/publication/table_files.h"
#include "analysis/publication/trial_data.h"
#include "analysis/publication/wording.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

/// The findings of `foveola study verify`. Throws Error if the verification fails, unless
/// unverified files are wanted.
study::Verification verified(const fs::path& database, bool takes_broken) {
  study::Verification found = study::verify_study(database);
  if (!found.faults.empty() && !takes_broken) {
    const study::RecordFault& first = found.faults.front();
    throw Error(database.string(),
                fmt::format("is not what was written ({}, the first: {}{}{})",
                            counted(found.faults.size(), "fault"), first.participant,
                            first.participant.empty() ? "" : ": ", first.what),
                "restore it from a backup (foveola study verify lists the faults), or analyse it "
                "as it is with --unverified");
  }
  return found;
}

std::vector<std::string> warnings_about(const AnalysisOutput& output) {
  const StudyTables& tables = output.tables;
  std::vector<std::string> warnings;
  if (output.record && !output.record->faults.empty()) {
    warnings.push_back(fmt::format(
        "The study's file is not what was written ({}): any number may be wrong; foveola study "
        "verify lists what is.",
        counted(output.record->faults.size(), "fault")));
  }
  if (const std::string warning = data_warning(tables); !warning.empty()) {
    warnings.push_back(warning);
  }
  if (tables.set.methods.size() < 2) {
    warnings.emplace_back("The protocol has one method: nothing can be compared.");
  }
  if (tables.set.participants.size() < 2) {
    warnings.emplace_back("One participant: no standard deviations and no intervals.");
  }
  if (const std::size_t missing = planned_without_tables(output.comparisons.plan); missing > 0) {
    warnings.push_back(fmt::format(
        "The protocol plans {} of measures that are in the record only: Holm's adjustment is for "
        "the others alone.",
        counted(missing, "comparison")));
  }
  if (!tables.set.rating_scale.is_analysed() && tables.set.rating_scale.question) {
    warnings.emplace_back(
        "Artifacts were rated on another scale than from 1 to 5: the ratings are in the record "
        "only.");
  }
  for (const DataQualityCheck& check : output.checks.checks) {
    if (check.verdict == Verdict::flagged && check.found != data_warning(tables)) {
      warnings.push_back(
          fmt::format("A data-quality limit was missed: {}: {}.", check.name, check.found));
    }
  }
  if (const std::size_t count = tables.amended.size(); count > 0) {
    warnings.push_back(fmt::format(
        "{} an amended protocol: amended_sessions.csv says which and what was changed.",
        count == 1 ? "One session followed" : fmt::format("{} sessions followed", count)));
  }
  if (const std::size_t count = tables.set.exclusions.size(); count > 0) {
    warnings.push_back(fmt::format(
        "{} left out: exclusions.csv says which and why.",
        count == 1 ? "One session or value is" : fmt::format("{} sessions or values are", count)));
  }
  return warnings;
}

void append(std::vector<TextFile>& files, std::vector<TextFile> more) {
  std::move(more.begin(), more.end(), std::back_inserter(files));
}

/// The report comes last, so that it never stands beside tables older than itself.
std::vector<TextFile> files_of(const AnalysisOutput& output,
                               const study::DataQualityRecords& quality,
                               const std::string& methods) {
  const StudyTables& tables = output.tables;
  const Comparisons& comparisons = output.comparisons;
  const std::vector<Figure> figures = draw_figures(tables);
  const std::vector<PublishedMean> published =
      read_published_means(resource_folder() / "data" / "koskela2018" / "mean_percent_of_od.csv");
  std::vector<TextFile> files = table_files(tables);
  files.push_back({"comparisons.csv", comparisons_csv(comparisons, tables.set.kind)});
  files.push_back({"omnibus.csv", omnibus_csv(comparisons, tables.set.kind)});
  files.push_back({"order_effects.csv", order_csv(comparisons, tables.set.kind)});
  append(files, latex_tables(tables, comparisons));
  files.push_back({"data_quality.csv", data_quality_csv(output.checks, tables.set.kind)});
  files.push_back({"figure7_latency.csv", latency_csv(output.checks, tables.set.kind)});
  files.push_back({"reaction_times.csv", reactions_csv(output.checks, tables.set.kind)});
  files.push_back({"codebook.csv", codebook_csv(tables.set.rating_scale)});
  append(files, r_scripts());
  for (const Figure& figure : figures) {
    files.push_back({figure.name + ".svg", figure.svg});
    files.push_back({figure.name + ".pdf", pdf_of(figure)});
    files.push_back({figure.name + ".png", png_of(figure)});
  }
  files.push_back({"report.html", report_html({tables, comparisons, quality, output.checks, figures,
                                               published, methods, output.record})});
  return files;
}

void write_output(const fs::path& folder, const std::string& name, const std::string& content,
                  AnalysisOutput& output) {
  fs::create_directories((folder / name).parent_path());
  write_file(folder / name, content);
  output.files.push_back(folder / name);
}

/// Writes the data, which may be large, with one table in memory at a time.
void write_data(const std::vector<study::BackgroundRow>& answers, const fs::path& folder,
                AnalysisOutput& output) {
  const PsychDs shared = psych_ds(output.tables, answers);
  write_output(folder, shared.description.name, shared.description.content, output);
  {
    const std::string trials = trials_long_csv(output.tables.set);
    write_output(folder, "trials_long.csv", trials, output);
    write_output(folder, shared.trials_name, trials, output);
  }
  const std::string participants = participants_wide_csv(output.tables.set, answers);
  write_output(folder, "participants_wide.csv", participants, output);
  write_output(folder, shared.participants_name, participants, output);
}

/// Writes the behavioural data, and the gaze of the participants in them, with one attempt in
/// memory at a time.
void write_bids(const std::vector<study::BackgroundRow>& answers,
                const std::vector<study::GazeRunRow>& validations, const GazeReader& read_gaze,
                const fs::path& folder, AnalysisOutput& output) {
  for (const TextFile& file : bids_files(output.tables, answers)) {
    write_output(folder, file.name, file.content, output);
  }
  if (!read_gaze) {
    return;
  }
  EyeTrackingExport eyes(output.tables.set, validations);
  read_gaze([&](const study::AttemptGaze& attempt) {
    for (const TextFile& file : eyes.files_of(attempt)) {
      write_output(folder, file.name, file.content, output);
    }
  });
  if (eyes.too_short() > 0) {
    output.warnings.push_back(
        fmt::format("{} of gaze too short for a sampling frequency, and not in the BIDS files.",
                    eyes.too_short() == 1 ? "One recording is"
                                          : fmt::format("{} recordings are", eyes.too_short())));
  }
}

}  // namespace

AnalysisOutput analyze_records(study::StudyRecords records,
                               const study::DataQualityRecords& quality, const fs::path& folder,
                               const AnalysisOptions& options, const GazeReader& read_gaze,
                               std::optional<study::Verification> record) {
  AnalysisOutput output;
  output.record = std::move(record);
  output.tables = tabulate_study(records);
  // Frees the trials, of which there may be millions: the tables hold their values.
  records.trials = std::vector<study::TrialRow>();
  output.comparisons = compare_methods(output.tables.set, plan_of(records.protocol_text));
  output.checks = check_data_quality(output.tables, quality);
  output.summary = terminal_summary(output.tables);
  output.warnings = warnings_about(output);
  const std::vector<TextFile> files = files_of(
      output, quality, methods_paragraph(output.tables, output.comparisons, records.protocol_text));
  StagedFolder staged(folder);
  write_data(records.background, staged.path(), output);
  if (options.bids) {
    write_bids(records.background, quality.gaze_runs, read_gaze, staged.path(), output);
  }
  for (const TextFile& file : files) {
    write_output(staged.path(), file.name, file.content, output);
  }
  output.files = staged.publish(output.files);
  output.report = output.files.back();
  return output;
}

AnalysisOutput analyze_study(const fs::path& database, const fs::path& folder,
                             const AnalysisOptions& options) {
  study::Verification record = verified(database, options.unverified);
  return analyze_records(
      study::read_study(database), study::read_data_quality(database), folder, options,
      [&](const auto& visit) { study::visit_gaze(database, visit); }, std::move(record));
}

}  // namespace foveola::analysis
