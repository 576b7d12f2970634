#include "analysis/publication/gaze_by_trial.h"

#include <algorithm>

#include <fmt/format.h>

#include "analysis/publication/result_tables.h"
#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {
namespace {

using enum ColumnType;

Field whole_field(const std::optional<std::size_t>& count) {
  return count ? field(*count) : Field();
}

Field truth_field(const std::optional<bool>& truth) { return truth ? field(*truth) : Field(); }

void append_times(const std::optional<study::GazeTimes>& times, Row& row) {
  const GazePercents percents = percents_of(times);
  row.push_back(times ? field(times->all_s) : Field());
  row.push_back(times ? field(times->on_object_s) : Field());
  row.push_back(field(percents.on_object));
  row.push_back(field(percents.elsewhere));
  row.push_back(field(percents.without_gaze));
}

void append_fixations(const std::optional<study::FixationFigures>& fixations, Row& row) {
  row.push_back(fixations ? field(fixations->count) : Field());
  row.push_back(fixations ? field(fixations->mean_duration_s) : Field());
  row.push_back(fixations ? whole_field(fixations->on_object) : Field());
}

void append_mark(const study::AttemptGazeFigures& figures, const std::string& mark, Row& row) {
  const auto found =
      std::find_if(figures.marks.begin(), figures.marks.end(),
                   [&](const study::GazeAtMark& known) { return known.mark == mark; });
  const study::GazeAtMark known = found == figures.marks.end() ? study::GazeAtMark{} : *found;
  row.push_back(field(known.gaze_from_object_deg));
  row.push_back(field(known.object_from_middle_deg));
  row.push_back(truth_field(known.object_in_view));
}

/// Gathers a figure over trials.
class KnownValues {
 public:
  void add(const std::optional<double>& value) {
    if (value) {
      values_.push_back(*value);
    }
  }
  std::optional<double> mean() const { return describe(values_).mean; }

 private:
  std::vector<double> values_;
};

/// Gathers the figures of one method's trials.
struct MethodValues {
  std::size_t trials = 0;
  KnownValues on_object;
  KnownValues elsewhere;
  KnownValues without_gaze;
  KnownValues fixations;
  KnownValues gaze_from_object;

  void add(const study::AttemptGazeFigures& figures) {
    trials += figures.times ? 1 : 0;
    const GazePercents percents = percents_of(figures.times);
    on_object.add(percents.on_object);
    elsewhere.add(percents.elsewhere);
    without_gaze.add(percents.without_gaze);
    if (figures.fixations) {
      fixations.add(static_cast<double>(figures.fixations->count));
    }
    for (const study::GazeAtMark& mark : figures.marks) {
      gaze_from_object.add(mark.gaze_from_object_deg);
    }
  }
};

}  // namespace

GazeOfTrials::GazeOfTrials(const study::StudyRecords& records,
                           std::span<const study::AttemptGazeRow> gaze)
    : records_(records) {
  for (const study::AttemptGazeRow& row : gaze) {
    rows_.emplace(Key(row.participant, row.trial, row.attempt), &row);
  }
}

const study::AttemptGazeRow* GazeOfTrials::of(std::size_t trial) const {
  const study::TrialRow& row = records_.trials[trial];
  const auto found =
      rows_.find(Key(records_.participant_of(row), row.trial, static_cast<int>(row.attempt)));
  return found == rows_.end() ? nullptr : found->second;
}

std::vector<Column> gaze_columns(const std::vector<Measure>& measures) {
  const std::string on_object = fmt::format(
      "within {:g} degrees of the object's angular radius, by the gaze that frames used",
      study::gaze_margin_deg);
  std::vector<Column> columns = {
      {"gaze_time_seconds", number, "s",
       "From the first presented frame to the last mark, or to the end of the wait for it"},
      {"gaze_on_object_seconds", number, "s", "Of this time, with a valid gaze " + on_object},
      {"gaze_on_object_percent", number, "%", "The same in per cent of gaze_time_seconds"},
      {"gaze_elsewhere_percent", number, "%", "With a valid gaze that was not on the object"},
      {"gaze_lost_percent", number, "%",
       "Without a valid gaze, or with one older than a blink lasts (600 ms)"},
      {"fixations", whole, "",
       "Fixations in this time, by the velocity threshold with which gaze is recorded"},
      {"mean_fixation_seconds", number, "s", "Their mean duration"},
      {"fixations_on_object", whole, "", "Those whose mean direction is on the object"}};
  for (const Measure& measure : measures) {
    if (measure.kind != MeasureKind::time) {
      continue;
    }
    const std::string& id = measure.id();
    columns.push_back(
        {id + "_gaze_from_object_deg", number, "deg",
         fmt::format("Angle between the gaze and the object's middle, in the frame that was on the "
                     "display at the mark {}",
                     id)});
    columns.push_back({id + "_object_from_middle_deg", number, "deg",
                       "Angle between straight ahead of the head and the object's middle, in the "
                       "same frame"});
    columns.push_back({id + "_object_in_view", truth, "",
                       "True: the object's middle was in the view of that frame, a headset's of "
                       "its left eye"});
  }
  return columns;
}

void append_gaze(const study::AttemptGazeRow* gaze, const std::vector<Measure>& measures,
                 Row& row) {
  const study::AttemptGazeFigures none;
  const study::AttemptGazeFigures& figures = gaze == nullptr ? none : gaze->figures;
  append_times(figures.times, row);
  append_fixations(figures.fixations, row);
  for (const Measure& measure : measures) {
    if (measure.kind == MeasureKind::time) {
      append_mark(figures, measure.id(), row);
    }
  }
}

std::vector<std::size_t> analysed_trials(const study::StudyRecords& records, const Dataset& set) {
  const std::vector<std::optional<std::size_t>> analysed = analysed_sessions(records, set);
  std::vector<std::size_t> trials;
  for (std::size_t i = 0; i < records.trials.size(); ++i) {
    const study::TrialRow& row = records.trials[i];
    if (study::StudyRecords::is_result(row) && analysed[row.session]) {
      trials.push_back(i);
    }
  }
  return trials;
}

GazeByTrialColumns::GazeByTrialColumns(const study::StudyRecords& records, const Dataset& set,
                                       std::span<const study::AttemptGazeRow> gaze)
    : records_(records), set_(set), gaze_(records, gaze) {
  columns_ = {{"participant", text, "", "Code of the participant"},
              {"scene", text, "", "Name of the scene"},
              {"method", text, "", "Id of the method"},
              {"trial", whole, "", "Place among all of the session's trials as planned, from 0"},
              {"attempt", whole, "", "Which timing it is, from 1; the last one counts"},
              {"object", text, "", "The chosen object"},
              {"tracker", text, "",
               "Profile of the eye tracker: pointer, if the gaze was where the pointer was; "
               "simulated of a simulated eye; empty if it was not recorded"}};
  const std::vector<Column> of_gaze = gaze_columns(set.measures);
  columns_.insert(columns_.end(), of_gaze.begin(), of_gaze.end());
  columns_.push_back(kind_column());
  columns_.push_back(record_column());
}

Row GazeByTrialColumns::row(std::size_t trial) const {
  const study::TrialRow& row = records_.trials[trial];
  const study::AttemptGazeRow* const gaze = gaze_.of(trial);
  Row fields = {records_.participant_of(row),
                records_.scenes[row.scene],
                records_.methods[row.method],
                field(static_cast<int>(row.trial)),
                field(static_cast<int>(row.attempt)),
                row.object == 0 ? Field() : field(records_.words[row.object]),
                gaze == nullptr || gaze->tracker.empty() ? Field() : field(gaze->tracker)};
  append_gaze(gaze, set_.measures, fields);
  fields.push_back(field(set_.kind));
  fields.push_back(field(set_.record));
  return fields;
}

GazePercents percents_of(const std::optional<study::GazeTimes>& times) {
  if (!times) {
    return {};
  }
  const auto percent = [&](const std::optional<double>& part_s) {
    return part_s ? std::optional(100.0 * *part_s / times->all_s) : std::nullopt;
  };
  return {.on_object = percent(times->on_object_s),
          .elsewhere = percent(times->elsewhere_s),
          .without_gaze = percent(times->without_gaze_s)};
}

std::vector<MethodGaze> gaze_by_method(const study::StudyRecords& records, const Dataset& set,
                                       const GazeOfTrials& gaze) {
  std::vector<MethodValues> values(set.methods.size());
  for (const std::size_t trial : analysed_trials(records, set)) {
    if (const study::AttemptGazeRow* const row = gaze.of(trial)) {
      values[records.trials[trial].method].add(row->figures);
    }
  }
  const bool is_known = std::any_of(values.begin(), values.end(),
                                    [](const MethodValues& of) { return of.trials > 0; });
  std::vector<MethodGaze> methods;
  for (std::size_t i = 0; is_known && i < values.size(); ++i) {
    methods.push_back({.method = set.methods[i],
                       .trials = values[i].trials,
                       .on_object_percent = values[i].on_object.mean(),
                       .elsewhere_percent = values[i].elsewhere.mean(),
                       .without_gaze_percent = values[i].without_gaze.mean(),
                       .fixations = values[i].fixations.mean(),
                       .gaze_from_object_deg = values[i].gaze_from_object.mean()});
  }
  return methods;
}

}  // namespace foveola::analysis
