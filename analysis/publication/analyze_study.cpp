#include "analysis/publication/analyze_study.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "analysis/dataset/answer_data.h"
#include "analysis/dataset/trial_data.h"
#include "analysis/dataset/wording.h"
#include "analysis/publication/exports/bids.h"
#include "analysis/publication/exports/bids_eye_tracking.h"
#include "analysis/publication/exports/data_files.h"
#include "analysis/publication/exports/output_folder.h"
#include "analysis/publication/exports/outputs_document.h"
#include "analysis/publication/figures/figures.h"
#include "analysis/publication/report/methods_paragraph.h"
#include "analysis/publication/report/printed_results.h"
#include "analysis/publication/report/report.h"
#include "analysis/publication/report/summary.h"
#include "analysis/publication/tables/result_tables.h"
#include "analysis/r_models/fit_models.h"
#include "analysis/r_models/models_plan.h"
#include "analysis/r_models/models_script.h"
#include "analysis/tables/row_file.h"
#include "analysis/tables/table_formats.h"
#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "study/record/sqlite/damage_remedy.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

/// Columns of the tables that are written row by row, as they may be large.
struct DataColumns {
  ColumnsOf<std::size_t> gaze;
  ColumnsOf<study::AnswerRow> answers;
  ColumnsOf<std::size_t> trials;
  ColumnsOf<std::size_t> participants;
};

/// Returns all tables, in the order of OUTPUTS.md. Those that are written row by row have no rows
/// here.
std::vector<Table> tables_of(const AnalysisOutput& output, const study::StudyRecords& records,
                             const DataColumns& data) {
  std::vector<Table> all =
      result_tables(records, output.tables, output.background, output.comparisons, output.checks);
  using enum CsvTexts;
  const auto add = [&](const char* id, const char* rows_are, const auto& columns, CsvTexts texts) {
    all.push_back({id, rows_are, columns_in(columns), {}, texts});
  };
  add("gaze_by_trial", "analysed test trial, its last timing", data.gaze, as_typed);
  add("answers_long", "answer of a questionnaire", data.answers, guarded);
  add("trials_long", "trial of a session, its last timing", data.trials, as_typed);
  add("trials_timed_again", "non-final timing of a trial", data.trials, as_typed);
  add("participants_wide", "analysed participant", data.participants, as_typed);
  return all;
}

std::vector<TextFile> latex_files(const AnalysisOutput& output,
                                  const std::optional<PublishedStudy>& published) {
  const StudyTables& tables = output.tables;
  std::vector<PrintedTable> printed;
  for (const std::size_t mark : tables.set.times()) {
    printed.push_back(printed_times(tables, mark, published));
  }
  printed.push_back(printed_geometric_means(tables, published));
  printed.push_back(printed_time_to_mark(table_named(output.results, "time_to_mark")));
  for (const std::size_t rating : tables.set.ratings()) {
    printed.push_back(printed_ratings(tables, rating));
  }
  printed.push_back(printed_background_answers(output.background, published));
  std::ranges::move(primary_tables(output.results, output.comparisons),
                    std::back_inserter(printed));
  std::ranges::move(sensitivity_tables(output.results, output.comparisons),
                    std::back_inserter(printed));
  std::vector<TextFile> files;
  for (const PrintedTable& table : printed) {
    if (!table.rows.empty()) {
      files.push_back({table.id + ".tex", latex_of(table, data_notice(tables))});
    }
  }
  return files;
}

/// Draws the figures for which this machine has programs and fonts; warnings name the others.
std::vector<Figure> drawable_figures(AnalysisOutput& output) {
  std::vector<Figure> figures;
  try {
    figures = draw_figures(output.tables);
  } catch (const Error& error) {
    output.warnings.push_back(fmt::format("No figure was drawn: {}.", error.what()));
  }
  if (!figures.empty() && figures.front().pdf.empty()) {
    output.warnings.emplace_back(
        "Figures are SVG only, since there is no font to draw the letters of PDF and PNG with; "
        "install one (apt-get install fonts-dejavu-core).");
  }
  return figures;
}

/// The report comes last, so that it is never beside tables older than itself.
std::vector<TextFile> files_of(const AnalysisOutput& output,
                               const study::DataQualityRecords& quality,
                               const study::StudyRecords& records,
                               const std::optional<PublishedStudy>& published,
                               const std::vector<Figure>& figures) {
  const StudyTables& tables = output.tables;
  std::vector<TextFile> files;
  for (const Table& table : output.results) {
    if (!is_written_by_rows(table)) {
      files.push_back({table.id + ".csv", csv_of(table)});
    }
  }
  files.push_back({"codebook.csv", csv_of(codebook_of(output.results))});
  files.push_back({"OUTPUTS.md", outputs_in_words(output.results)});
  std::vector<TextFile> latex = latex_files(output, published);
  std::move(latex.begin(), latex.end(), std::back_inserter(files));
  std::vector<TextFile> drawn = files_of_figures(figures);
  std::move(drawn.begin(), drawn.end(), std::back_inserter(files));
  files.push_back(
      {"report.html", report_html({tables, output.background, output.results, output.comparisons,
                                   quality, output.checks, figures, published,
                                   methods_paragraph(tables, output.comparisons, records, quality),
                                   output.record})});
  return files;
}

void write_output(const fs::path& folder, const std::string& name, const std::string& content,
                  AnalysisOutput& output) {
  fs::create_directories((folder / name).parent_path());
  write_file(folder / name, content);
  output.files.push_back(folder / name);
}

bool is_withdrawn(const study::SessionRow& session) { return session.state == "withdrawn"; }

std::string withdrawn_in_words(const study::StudyRecords& records) {
  const auto count =
      static_cast<std::size_t>(std::ranges::count_if(records.sessions, is_withdrawn));
  return fmt::format(
      "trials_long.csv, trials_timed_again.csv and answers_long.csv have the data of {} that a "
      "participant withdrew from (--withdrawn); no result uses them, and psych-ds/ and bids/ leave "
      "them out.",
      count == 1 ? "one session" : count_with_noun(count, "session"));
}

/// Writes the data, which may be large. Files for sharing, those of Psych-DS, never have the data
/// of withdrawn sessions.
void write_data(const study::StudyRecords& records, const DataColumns& data, const fs::path& folder,
                AnalysisOutput& output) {
  const PsychDs shared =
      psych_ds(output.tables, columns_in(data.trials), columns_in(data.participants));
  write_output(folder, shared.description.name, shared.description.content, output);
  const auto open = [&](const std::string& name, const auto& columns,
                        CsvTexts texts = CsvTexts::as_typed) {
    output.files.push_back(folder / name);
    return RowFile(folder / name, columns_in(columns), texts);
  };
  RowFile all = open("trials_long.csv", data.trials);
  RowFile again = open("trials_timed_again.csv", data.trials);
  RowFile shared_trials = open(shared.trials_name, data.trials);
  for (std::size_t i = 0; i < records.trials.size(); ++i) {
    const Row row = row_of(data.trials, i);
    if (records.trials[i].counts) {
      all.add(row);
      if (!is_withdrawn(records.sessions[records.trials[i].session])) {
        shared_trials.add(row);
      }
    } else {
      again.add(row);
    }
  }
  RowFile wide = open("participants_wide.csv", data.participants);
  RowFile shared_wide = open(shared.participants_name, data.participants);
  for (std::size_t i = 0; i < output.tables.set.participants.size(); ++i) {
    const Row row = row_of(data.participants, i);
    wide.add(row);
    shared_wide.add(row);
  }
  RowFile answered = open("answers_long.csv", data.answers, CsvTexts::guarded);
  for (const study::AnswerRow& answer : records.answers) {
    answered.add(row_of(data.answers, answer));
  }
  for (RowFile* file : {&all, &again, &shared_trials, &wide, &shared_wide, &answered}) {
    file->close();
  }
}

/// Writes gaze_by_trial.csv, of records without the data of withdrawn sessions.
void write_gaze(const study::StudyRecords& records, const ColumnsOf<std::size_t>& gaze,
                const fs::path& folder, AnalysisOutput& output) {
  const fs::path path = folder / "gaze_by_trial.csv";
  RowFile file(path, columns_in(gaze));
  for (const std::size_t trial : analysed_trials(records, output.tables.set)) {
    file.add(row_of(gaze, trial));
  }
  file.close();
  output.files.push_back(path);
}

FittedModels fit_models_of(const Dataset& set, const study::AnalysisPlan& plan,
                           const fs::path& folder) {
  const Table models = models_plan(set, compared_pairs(set, plan), plan.scenes);
  write_file(folder / (models.id + ".csv"), csv_of(models));
  return fit_models(folder);
}

/// Writes the behavioural data and their participants' gaze, with one attempt in memory at a time.
void write_bids(const study::StudyRecords& records, const DataColumns& data,
                const ColumnsOf<std::size_t>& answers, const study::DataQualityRecords& quality,
                const GazeReader& read_gaze, const fs::path& folder, AnalysisOutput& output) {
  for (const TextFile& file : bids_files(output.tables, records, data.trials, answers)) {
    write_output(folder, file.name, file.content, output);
  }
  if (!read_gaze) {
    return;
  }
  EyeTrackingExport eyes(output.tables.set, quality.gaze_runs, quality.gaze);
  read_gaze([&](const study::AttemptGaze& attempt) {
    for (const TextFile& file : eyes.export_attempt(attempt)) {
      write_output(folder, file.name, file.content, output);
    }
  });
  if (const std::optional<TextFile> file = eyes.bidsignore_file()) {
    write_output(folder, file->name, file->content, output);
  }
  if (eyes.too_short() > 0) {
    output.warnings.push_back(fmt::format(
        "{} too short for a sampling frequency, and not in the BIDS files.",
        eyes.too_short() == 1 ? "One recording of gaze is"
                              : fmt::format("{} recordings of gaze are", eyes.too_short())));
  }
}

}  // namespace

study::Verification verified_study(const fs::path& database, bool accept_changed) {
  study::Verification found = study::verify_study(database);
  if (!found.faults.empty() && !accept_changed) {
    const study::RecordFault& first = found.faults.front();
    throw Error(
        database.string(),
        fmt::format("failed its verification ({}, the first: {}{}{})",
                    count_with_noun(found.faults.size(), "fault"), first.participant,
                    first.participant.empty() ? "" : ": ", first.what),
        fmt::format("{} (foveola study verify lists the faults); or analyse it nevertheless "
                    "with --unverified",
                    study::damage_remedy));
  }
  return found;
}

bool is_written_by_rows(const Table& table) {
  return table.id == "trials_long" || table.id == "trials_timed_again" ||
         table.id == "gaze_by_trial" || table.id == "participants_wide" ||
         table.id == "answers_long";
}

AnalysisOutput analyze_records(const study::StudyRecords& records,
                               const study::DataQualityRecords& quality, const fs::path& folder,
                               const AnalysisOptions& options, const GazeReader& read_gaze,
                               std::optional<study::Verification> record,
                               const std::optional<study::StudyRecords>& exported) {
  AnalysisOutput output;
  output.record = std::move(record);
  output.tables = tabulate_study(records);
  if (output.record) {
    output.tables.set.record = output.record->faults.empty() ? "verified" : "changed";
  }
  const std::optional<PublishedStudy> published = published_study_for(output.tables.set);
  output.background =
      analyse_background(background_answers(records), records.protocol.analysis, output.tables.set);
  output.checks = check_data_quality(output.tables, quality, records);
  const study::StudyRecords& data = exported ? *exported : records;
  const DataColumns columns{gaze_by_trial_columns(records, output.tables.set, quality.gaze),
                            answer_columns(data, output.tables.set),
                            trial_columns(data, output.tables.set, quality.gaze),
                            participant_columns(records, output.tables.set)};
  StagedFolder staged(folder);
  write_data(data, columns, staged.path(), output);
  write_gaze(records, columns.gaze, staged.path(), output);
  write_output(staged.path(), "models.R", models_script(), output);
  const study::AnalysisPlan& plan = records.protocol.analysis;
  output.comparisons =
      compare_methods(output.tables.set, plan,
                      options.fits_models ? fit_models_of(output.tables.set, plan, staged.path())
                                          : FittedModels{.missing = "add --r to fit models"});
  output.results = tables_of(output, records, columns);
  output.summary = terminal_summary(output.tables, output.results, output.comparisons,
                                    output.background, published);
  output.warnings = warnings_about(output);
  if (const std::string& why = output.comparisons.models.missing;
      options.fits_models && !why.empty()) {
    output.warnings.push_back(fmt::format("No model was fitted: {}.", why));
  }
  if (options.withdrawn) {
    output.warnings.push_back(withdrawn_in_words(data));
  }
  if (options.writes_bids) {
    write_bids(data, columns, participant_answer_columns(records, output.tables.set), quality,
               read_gaze, staged.path(), output);
  }
  const std::vector<Figure> figures = drawable_figures(output);
  for (const TextFile& file : files_of(output, quality, records, published, figures)) {
    write_output(staged.path(), file.name, file.content, output);
  }
  PublishedFiles published_files = staged.publish(output.files);
  output.files = std::move(published_files.files);
  for (const fs::path& file : published_files.staying) {
    output.warnings.push_back(
        fmt::format("{}, of an earlier analysis, was not removed, because it was changed or is "
                    "reached by a link.",
                    file.string()));
  }
  output.report = output.files.back();
  return output;
}

AnalysisOutput analyze_study(const fs::path& database, const fs::path& folder,
                             const AnalysisOptions& options) {
  study::Verification record = verified_study(database, options.unverified);
  return analyze_records(
      study::read_study(database), study::read_data_quality(database), folder, options,
      [&](const auto& visit) { study::visit_gaze(database, visit); }, std::move(record),
      options.withdrawn
          ? std::optional(study::read_study(database, study::WithdrawnSessions::with_data))
          : std::nullopt);
}

}  // namespace foveola::analysis
