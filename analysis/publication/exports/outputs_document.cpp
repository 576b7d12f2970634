#include "analysis/publication/exports/outputs_document.h"

#include "analysis/tables/table_formats.h"

namespace foveola::analysis {
namespace {

constexpr const char* before_columns =
    R"md(# What `foveola analyze` writes

This text is generated from the tables' columns, and is written beside each study's results with that
study's marks, ratings and questions. Foveola's own copy describes a synthetic study.

Every CSV file follows RFC 4180 (CRLF line ends, quotes where needed) with a heading; a column's name
ends in its unit. A value that does not exist is an empty field (CSV), `null` (JSON), `n/a` (BIDS).
Typed texts may look like one: NA, None, null, n/a. Only an empty field is missing in CSV:
read it so by `pandas.read_csv(file, keep_default_na=False, na_values=[""])`, in R by
`read.csv(file, na.strings = "")`. In BIDS a typed `n/a` has an apostrophe before it, `'n/a`: read by
`keep_default_na=False, na_values=["n/a"]` or `na.strings = "n/a"`, and take it away.
In Foveola's sources, `data/koskela2018/README.md` names the file and the function of each item of
Koskela et al. 2018.
Truth values are `TRUE` and `FALSE` in CSV, as R and pandas read them, and `true` and `false` elsewhere.
Files for people are guarded, so that no spreadsheet takes a typed text for a formula: a
text has an apostrophe before it if it begins with `=`, `+`, `-` or `@`, in full width too, with a tab,
a line break or an apostrophe. Remove the first apostrophe to get the typed text.
Files for programs have texts as typed: `trials_long.csv`, `trials_timed_again.csv`,
`participants_wide.csv`, `gaze_by_trial.csv`, `models_plan.csv`, `psych-ds/` and `bids/`; open them in a
spreadsheet with all columns imported as text. `codebook.csv` names the guarded files;
numbers are the same in all.
`participant_kind` is the kind of participants: `human`, `pilot` or `simulated`. Numbers are written so that
they read back as the same double. Confidence limits are at 95 % unless another level is named.
The report defines how each number is computed. A study's file is verified before it is read,
as `foveola study verify` does; the report's section “The record” has the findings. A file that was
changed or damaged since it was written is refused, unless `--unverified` is given: the report then
says so above everything else, every caption too, and `record` in every table is `changed`.

All recorded data are exported: every mark, rating, catch and practice trial in
`trials_long.csv` (the last timing of each trial) and `trials_timed_again.csv` (the others), every
answer in `answers_long.csv`. Their column `status` marks the rows that the results use (`analysed`),
and which are not: practice and catch trials, and those of sessions that were excluded, interrupted or
refused, with the recorded reason in `status_reason`. So your own analysis can include
rows that the results leave out. The data of sessions that a participant withdrew from are in no file,
unless `--withdrawn` is given: then they are in these three, with the status `withdrawn`, and still in
no result and not in `psych-ds/` or `bids/`. `study forget` erases a participant from the study's file.

An analysis into the folder of an earlier one replaces that one's files and removes those that it does
not write itself, such as the gaze of an erased participant, or `bids/` without `--bids`.
`manifest.sha256` lists these files. Changed files, files of others, and files reached by a link
stay; a warning names those of the earlier analysis. A folder without a manifest
loses nothing.

Where frames were recorded, the rows of trials also say where gaze and object were, as
`gaze_by_trial.csv` does of the analysed trials alone, with the tracker's name. The directions of
objects and the display's fields of view are the recorded ones; missing facts are empty, as
are all in withdrawn sessions.

| file | content |
|---|---|
| `report.html` | the whole report, one file that needs no network |
| `OUTPUTS.md`, `codebook.csv` | the files' columns |
| `manifest.sha256` | the SHA-256 of every other file, as `sha256sum -c manifest.sha256` checks it |
| `times-MARK.tex`, `geometric-means.tex`, `ratings-RATING.tex`, `planned-comparisons.tex` and others | the report's tables for LaTeX, each in a file to `\input`, with the packages array, booktabs and graphicx; tables wider than the text are set smaller |
| `relative_times`, `relative_times_by_scene`, `times_in_seconds`, `time_to_MARK`, `ratings_RATING`: `.svg`, `.pdf`, `.png` | figures |
| `psych-ds/` | trials and participants as Psych-DS 1 lays them out |
| `models.R`, `models_plan.csv` | a script for R, and the comparisons that it fits: crossed mixed models of log times (lme4, lmerTest), Tobit models where times are right-censored (survival), cumulative link mixed models of ratings (ordinal). It reads `trials_long.csv`; `--r` runs it, and `models.csv` has its results. Run by hand, it writes `r_models.csv` and `r_versions.csv` |
| `bids/` (`--bids`) | BIDS 1.11.1: behaviour, and gaze as eye-tracking, below |

## Tables

)md";

constexpr const char* after_columns = R"md(## `--json`

The same tables on standard output: under `tables` each by its name, a list of objects with the
columns as their keys; those of trials, their gaze, answers and participants are in their files only.
Beside them
`report`, `files`, `warnings`, `protocol`, `protocol_sha256`, `participant_kind`, `data_notice`,
`participants`, `scenes`, `methods`, `baseline`, `measures`, `record` (what verifying the study's file
found, as `study verify --json` prints it) and `excluded` (how many rows `exclusions.csv` has).

## `bids/`

`sub-LABEL/beh/sub-LABEL_task-preview_beh.tsv` has a participant's trials. Where gaze was recorded,
`…_run-NN_recording-eye1_physio.tsv.gz` (no heading; `timestamp` in ns, `x_coordinate` and
`y_coordinate` in degrees rightwards and upwards from straight ahead of the head) is one timing of a
trial, which its `.json` names; `StartTime` counts from the trial's first frame, and
`SamplingFrequency` is measured. `…_physioevents.tsv.gz` has `onset`, `duration`, `trial_type`
(`first_frame`, `mark`, `timed_out`, `fixation`, `saccade`, `blink`) and `message` (the mark's name).
Trackers here give one direction for both eyes (`RecordedEye`: `cyclopean`) and no pupil size.
A recording of fewer than two samples has no frequency and is left out with a warning.
Where there are `_physioevents`, `.bidsignore` hides them from validators that are older than BIDS 1.11,
such as npm's bids-validator; delete it for newer ones.
)md";

}  // namespace

std::string outputs_in_words(const std::vector<Table>& tables) {
  return before_columns + columns_in_markdown(tables) + after_columns;
}

}  // namespace foveola::analysis
