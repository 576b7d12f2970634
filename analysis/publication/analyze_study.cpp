#include "analysis/publication/analyze_study.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/bids.h"
#include "analysis/publication/bids_eye_tracking.h"
#include "analysis/publication/comparison_tables.h"
#include "analysis/publication/data_files.h"
#include "analysis/publication/figures.h"
#include "analysis/publication/methods_paragraph.h"
#include "analysis/publication/output_folder.h"
#include "analysis/publication/outputs_document.h"
#include "analysis/publication/printed_results.h"
#include "analysis/publication/report.h"
#include "analysis/publication/result_tables.h"
#include "analysis/publication/summary.h"
#include "analysis/publication/survival_output.h"
#include "analysis/r_models/fit_models.h"
#include "analysis/r_models/models_plan.h"
#include "analysis/r_models/models_script.h"
#include "analysis/tables/table_formats.h"
#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "study/protocol/cautions.h"
#include "study/record/damage_remedy.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

/// With so few scenes, what is said of others like them is less certain than its interval: see
/// data/golden/README.md. Empty if there are enough, or if nothing planned is said of others.
std::string few_scenes(const Comparisons& comparisons, std::size_t scenes) {
  const bool is_of_others = std::any_of(
      comparisons.methods.begin(), comparisons.methods.end(), [](const MethodComparison& row) {
        return row.planned && row.primary && row.primary->kind == AnalysisKind::crossed_model;
      });
  return is_of_others && scenes < study::fewest_random_scenes
             ? fmt::format(
                   "{}: 95 % intervals for scenes like these cover less (87 % with two, "
                   "92 % with three); plan five, or fixed scenes.",
                   counted(scenes, "scene"))
             : "";
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
  for (const MethodComparison& row : output.comparisons.methods) {
    if (row.planned && !row.missing.empty()) {
      warnings.push_back(fmt::format(
          "The planned comparison of {} and {} in {} has no P-value ({}); Holm's adjustment counts "
          "it as not significant.",
          row.method, row.reference, row.measure, row.missing));
    } else if (row.planned) {
      const PrimaryResult& primary = *row.primary;
      for (const auto& [verb, what] : {std::pair("is by", primary.instead),
                                       std::pair("has a warning of R for", primary.warning)}) {
        if (!what.empty()) {
          warnings.push_back(fmt::format("The planned comparison of {} and {} in {} {} the {}: {}.",
                                         row.method, row.reference, row.measure, verb,
                                         name_of(primary.kind), what));
        }
      }
    }
  }
  if (const std::string few = few_scenes(output.comparisons, tables.set.scenes.size());
      !few.empty()) {
    warnings.push_back(few);
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

/// All tables, in the order of OUTPUTS.md; those that are written by rows, which may be large, have
/// none here.
std::vector<Table> tables_of(const AnalysisOutput& output, const study::StudyRecords& records,
                             const TrialColumns& trials, const GazeByTrialColumns& gaze,
                             const ParticipantColumns& participants, const AnswerColumns& answers,
                             const Table& models) {
  const StudyTables& tables = output.tables;
  std::vector<Table> all = {times_by_scene(tables),
                            times_by_method(tables),
                            time_to_mark_table(tables),
                            ratings_by_method(tables),
                            rating_counts(tables),
                            comparisons_table(tables, output.comparisons),
                            models,
                            models_table(tables, output.comparisons),
                            model_versions_table(tables, output.comparisons),
                            omnibus_table(tables, output.comparisons),
                            order_effects_table(tables, output.comparisons),
                            answers_by_question(records, tables.set),
                            questionnaire_scores(records, tables.set),
                            background_correlation(tables, output.background),
                            data_quality_table(tables, output.checks),
                            latency_table(tables, output.checks),
                            reaction_times_table(tables, output.checks),
                            catch_trials_table(tables, output.checks),
                            outlying_times_table(tables, output.checks),
                            exclusions(tables),
                            amended_sessions(tables)};
  for (Table& table : all) {
    table = stamped(std::move(table), tables.set);
  }
  using enum CsvTexts;
  const auto add = [&](const char* id, const char* rows_are, const std::vector<Column>& columns,
                       CsvTexts texts) { all.push_back({id, rows_are, columns, {}, texts}); };
  add("gaze_by_trial", "analysed test trial, its last timing", gaze.columns(), as_typed);
  add("answers_long", "answer of a questionnaire", answers.columns(), guarded);
  add("trials_long", "trial of a session, its last timing", trials.columns(), as_typed);
  add("trials_timed_again", "timing of a trial that does not count", trials.columns(), as_typed);
  add("participants_wide", "analysed participant", participants.columns(), as_typed);
  return all;
}

const Table& table_named(const std::vector<Table>& tables, std::string_view id) {
  return *std::find_if(tables.begin(), tables.end(),
                       [&](const Table& table) { return table.id == id; });
}

std::vector<TextFile> latex_files(const AnalysisOutput& output,
                                  const std::optional<PublishedStudy>& published) {
  const StudyTables& tables = output.tables;
  std::vector<PrintedTable> printed;
  for (const std::size_t mark : tables.set.times()) {
    printed.push_back(printed_times(tables, mark, published));
  }
  printed.push_back(printed_geometric_means(tables, published));
  printed.push_back(printed_time_to_mark(tables));
  for (const std::size_t rating : tables.set.ratings()) {
    printed.push_back(printed_ratings(tables, rating));
  }
  printed.push_back(printed_background_answers(output.background, published));
  for (const bool planned : {true, false}) {
    printed.push_back(printed_primary(output.comparisons, planned));
  }
  for (PrintedTable& table : sensitivity_tables(output.comparisons)) {
    printed.push_back(std::move(table));
  }
  std::vector<TextFile> files;
  for (const PrintedTable& table : printed) {
    if (!table.rows.empty()) {
      files.push_back({table.id + ".tex", latex_of(table, data_notice(tables))});
    }
  }
  return files;
}

/// The figures that this machine has the programs and fonts for; warnings say what is left out.
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

/// The report comes last, so that it never stands beside tables older than itself.
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
      {"report.html",
       report_html({tables, output.background, table_named(output.results, "answers_by_question"),
                    table_named(output.results, "questionnaire_scores"), output.comparisons,
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
  const auto count = static_cast<std::size_t>(
      std::count_if(records.sessions.begin(), records.sessions.end(), is_withdrawn));
  return fmt::format(
      "trials_long.csv, trials_timed_again.csv and answers_long.csv have the data of {} that a "
      "participant withdrew from (--withdrawn); no result uses them, and psych-ds/ and bids/ leave "
      "them out.",
      count == 1 ? "one session" : counted(count, "session"));
}

/// Writes the data, which may be large. The files that are made to be shared, of Psych-DS, never
/// have those of withdrawn sessions.
void write_data(const study::StudyRecords& records, const TrialColumns& trials,
                const ParticipantColumns& participants, const AnswerColumns& answers,
                const fs::path& folder, AnalysisOutput& output) {
  const PsychDs shared = psych_ds(output.tables, trials, participants);
  write_output(folder, shared.description.name, shared.description.content, output);
  const auto open = [&](const std::string& name, const std::vector<Column>& columns,
                        CsvTexts texts = CsvTexts::as_typed) {
    output.files.push_back(folder / name);
    return RowFile(folder / name, columns, texts);
  };
  RowFile all = open("trials_long.csv", trials.columns());
  RowFile again = open("trials_timed_again.csv", trials.columns());
  RowFile shared_trials = open(shared.trials_name, trials.columns());
  for (std::size_t i = 0; i < records.trials.size(); ++i) {
    const Row row = trials.row(i);
    if (records.trials[i].counts) {
      all.add(row);
      if (!is_withdrawn(records.sessions[records.trials[i].session])) {
        shared_trials.add(row);
      }
    } else {
      again.add(row);
    }
  }
  RowFile wide = open("participants_wide.csv", participants.columns());
  RowFile shared_wide = open(shared.participants_name, participants.columns());
  for (std::size_t i = 0; i < output.tables.set.participants.size(); ++i) {
    const Row row = participants.row(i);
    wide.add(row);
    shared_wide.add(row);
  }
  RowFile answered = open("answers_long.csv", answers.columns(), CsvTexts::guarded);
  for (std::size_t i = 0; i < records.answers.size(); ++i) {
    answered.add(answers.row(i));
  }
  for (RowFile* file : {&all, &again, &shared_trials, &wide, &shared_wide, &answered}) {
    file->close();
  }
}

/// Writes gaze_by_trial.csv, of records without the data of withdrawn sessions.
void write_gaze(const study::StudyRecords& records, const GazeByTrialColumns& gaze,
                const fs::path& folder, AnalysisOutput& output) {
  const fs::path path = folder / "gaze_by_trial.csv";
  RowFile file(path, gaze.columns());
  for (const std::size_t trial : analysed_trials(records, output.tables.set)) {
    file.add(gaze.row(trial));
  }
  file.close();
  output.files.push_back(path);
}

/// Fits the models in the folder, where the data are.
FittedModels fit_models_of(const Table& plan, const fs::path& folder) {
  write_file(folder / (plan.id + ".csv"), csv_of(plan));
  return fit_models(folder);
}

/// Writes the behavioural data, and the gaze of the participants in them, with one attempt in
/// memory at a time.
void write_bids(const study::StudyRecords& records, const TrialColumns& trials,
                const ParticipantColumns& participants, const study::DataQualityRecords& quality,
                const GazeReader& read_gaze, const fs::path& folder, AnalysisOutput& output) {
  for (const TextFile& file : bids_files(output.tables, records, trials, participants)) {
    write_output(folder, file.name, file.content, output);
  }
  if (!read_gaze) {
    return;
  }
  EyeTrackingExport eyes(output.tables.set, quality.gaze_runs, quality.gaze);
  read_gaze([&](const study::AttemptGaze& attempt) {
    for (const TextFile& file : eyes.files_of(attempt)) {
      write_output(folder, file.name, file.content, output);
    }
  });
  if (const std::optional<TextFile> ignored = eyes.ignored()) {
    write_output(folder, ignored->name, ignored->content, output);
  }
  if (eyes.too_short() > 0) {
    output.warnings.push_back(
        fmt::format("{} of gaze too short for a sampling frequency, and not in the BIDS files.",
                    eyes.too_short() == 1 ? "One recording is"
                                          : fmt::format("{} recordings are", eyes.too_short())));
  }
}

}  // namespace

study::Verification verified_study(const fs::path& database, bool takes_changed) {
  study::Verification found = study::verify_study(database);
  if (!found.faults.empty() && !takes_changed) {
    const study::RecordFault& first = found.faults.front();
    throw Error(database.string(),
                fmt::format("is not what was written ({}, the first: {}{}{})",
                            counted(found.faults.size(), "fault"), first.participant,
                            first.participant.empty() ? "" : ": ", first.what),
                fmt::format("{} (foveola study verify lists the faults); or analyse it as it is "
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
  const std::optional<PublishedStudy> published = published_beside(output.tables.set);
  output.background =
      analyse_background(background_answers(records), records.protocol.analysis, output.tables.set);
  output.checks = check_data_quality(output.tables, quality, records);
  const study::StudyRecords& data = exported ? *exported : records;
  const TrialColumns trials(data, output.tables.set, quality.gaze);
  const GazeByTrialColumns gaze(records, output.tables.set, quality.gaze);
  const ParticipantColumns participants(records, output.tables.set);
  const AnswerColumns answers(data, output.tables.set);
  StagedFolder staged(folder);
  write_data(data, trials, participants, answers, staged.path(), output);
  write_gaze(records, gaze, staged.path(), output);
  write_output(staged.path(), "models.R", models_script(), output);
  const study::AnalysisPlan& plan = records.protocol.analysis;
  const Table models =
      models_plan(output.tables.set, compared_pairs(output.tables.set, plan), plan.scenes);
  output.comparisons =
      compare_methods(output.tables.set, plan,
                      options.r ? fit_models_of(models, staged.path())
                                : FittedModels{.missing = "it was not asked for (analyze --r)"});
  output.results = tables_of(output, records, trials, gaze, participants, answers, models);
  output.summary =
      terminal_summary(output.tables, output.comparisons, output.background, published);
  output.warnings = warnings_about(output);
  if (const std::string& why = output.comparisons.models.missing; options.r && !why.empty()) {
    output.warnings.push_back(fmt::format("No model was fitted: {}.", why));
  }
  if (options.withdrawn) {
    output.warnings.push_back(withdrawn_in_words(data));
  }
  if (options.bids) {
    write_bids(data, trials, participants, quality, read_gaze, staged.path(), output);
  }
  const std::vector<Figure> figures = drawable_figures(output);
  for (const TextFile& file : files_of(output, quality, records, published, figures)) {
    write_output(staged.path(), file.name, file.content, output);
  }
  PublishedFiles published_files = staged.publish(output.files);
  output.files = std::move(published_files.files);
  for (const fs::path& file : published_files.staying) {
    output.warnings.push_back(fmt::format(
        "{} is of an earlier analysis and stays, since it was changed or a link leads to it.",
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
