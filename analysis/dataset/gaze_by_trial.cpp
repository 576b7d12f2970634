#include "analysis/dataset/gaze_by_trial.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <tuple>

#include <fmt/format.h>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {
namespace {

/// Averages a figure over the trials in which it is known.
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

GazeOfTrials gaze_of_trials(const study::StudyRecords& records,
                            std::span<const study::AttemptGazeRow> gaze) {
  using Key = std::tuple<std::string_view, std::size_t, int>;  // participant, trial, attempt
  std::map<Key, const study::AttemptGazeRow*> known;
  for (const study::AttemptGazeRow& row : gaze) {
    known.emplace(Key(row.participant, row.trial, row.attempt), &row);
  }
  GazeOfTrials of_trials;
  for (const study::TrialRow& row : records.trials) {
    const auto found =
        known.find(Key(records.participant_of(row), row.trial, static_cast<int>(row.attempt)));
    of_trials.push_back(found == known.end() ? nullptr : found->second);
  }
  return of_trials;
}

ColumnsOf<study::AttemptGazeFigures> gaze_columns(const std::vector<Measure>& measures) {
  using Figures = study::AttemptGazeFigures;
  using Fixations = study::FixationFigures;
  const auto percent = [](auto part) {
    return [=](const Figures& figures) { return percents_of(figures.times).*part; };
  };
  const std::string on_object = fmt::format(
      "within {:g} degrees of the object's angular radius, by the gaze that frames used",
      study::gaze_margin_deg);
  ColumnsOf<Figures> columns = {
      {"gaze_time_seconds", "s",
       "Time from the first presented frame to the last mark, or to the end of the wait for it",
       path(&Figures::times, &study::GazeTimes::all_s)},
      {"gaze_on_object_seconds", "s", "Part of gaze_time_seconds with a valid gaze " + on_object,
       path(&Figures::times, &study::GazeTimes::on_object_s)},
      {"gaze_on_object_percent", "%", "gaze_on_object_seconds in per cent of gaze_time_seconds",
       percent(&GazePercents::on_object)},
      {"gaze_elsewhere_percent", "%",
       "Part of gaze_time_seconds with a valid gaze that was not on the object",
       percent(&GazePercents::elsewhere)},
      {"gaze_lost_percent", "%",
       "Part of gaze_time_seconds without a valid gaze, or with one older than a blink lasts (600 "
       "ms)",
       percent(&GazePercents::without_gaze)},
      {"fixations", "", "Number of fixations in this time, by the velocity threshold of the record",
       path(&Figures::fixations, &Fixations::count)},
      {"mean_fixation_seconds", "s", "Mean duration of the fixations",
       path(&Figures::fixations, &Fixations::mean_duration_s)},
      {"fixations_on_object", "", "Number of fixations whose mean direction is on the object",
       path(&Figures::fixations, &Fixations::on_object)}};
  for (const Measure& measure : measures) {
    if (measure.kind != MeasureKind::time) {
      continue;
    }
    const std::string& id = measure.id();
    const auto at_mark = [id](const Figures& figures) {
      const auto found = std::ranges::find(figures.marks, id, &study::GazeAtMark::mark);
      return found == figures.marks.end() ? std::nullopt : std::optional(*found);
    };
    columns.push_back(
        {id + "_gaze_from_object_deg", "deg",
         fmt::format("Angle between the gaze and the object's centre, in the frame that was on the "
                     "display at the mark {}; empty without such a frame or a valid gaze",
                     id),
         path(at_mark, &study::GazeAtMark::gaze_from_object_deg)});
    columns.push_back({id + "_object_from_middle_deg", "deg",
                       "Angle between straight ahead of the head and the object's centre, in the "
                       "same frame",
                       path(at_mark, &study::GazeAtMark::object_from_middle_deg)});
    columns.push_back({id + "_object_in_view", "",
                       "True: the object's centre was in the view of that frame, a headset's of "
                       "its left eye",
                       path(at_mark, &study::GazeAtMark::object_in_view)});
  }
  return columns;
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
    if (const study::AttemptGazeRow* const row = gaze[trial]) {
      values[records.trials[trial].method].add(row->figures);
    }
  }
  const bool is_known =
      std::ranges::any_of(values, [](const MethodValues& of) { return of.trials > 0; });
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
