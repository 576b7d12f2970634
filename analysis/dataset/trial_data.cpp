#include "analysis/dataset/trial_data.h"

#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "analysis/dataset/answer_data.h"
#include "analysis/dataset/session_columns.h"
#include "analysis/dataset/wording.h"

namespace foveola::analysis {
namespace {

using study::StudyRecords;
using study::TrialRow;

std::string trial_status(const TrialRow& row, const study::SessionRow& session, bool is_analysed) {
  if (row.kind != study::TrialKind::test) {
    return name_of(row.kind);
  }
  return is_analysed && !row.counts ? "timed again" : status_of(session, is_analysed);
}

/// Finds a text of the records by its index; 0: none.
auto word_of(const StudyRecords& records) {
  return [&records](std::uint32_t index) {
    return index == 0 ? std::nullopt : std::optional(records.words[index]);
  };
}

/// Returns the columns of one measure's values, whose texts are the records'.
ColumnsOf<Value> value_columns(const StudyRecords& records, const Dataset& set, std::size_t index) {
  const Measure& measure = set.measures[index];
  const std::string& id = measure.id();
  if (measure.is_time()) {
    const auto if_known = [](auto value) {
      return [=](const Value& found) {
        return found.state == Value::State::missing ? std::nullopt : std::optional(value(found));
      };
    };
    return {
        {id + "_s", "s",
         measure.kind == MeasureKind::time
             ? fmt::format("Time from the first presented frame to the mark {0}; a lower bound "
                           "where {0}_censored",
                           id)
             : measure.question.text,
         if_known([](const Value& found) { return found.number; })},
        {id + "_censored", "", fmt::format("True: right-censored, {}_s is a lower bound", id),
         if_known([](const Value& found) { return found.state == Value::State::right_censored; })}};
  }
  const ColumnType type = !measure.is_numeric() ? ColumnType::text
                          : measure.question.kind == study::QuestionKind::likert
                              ? ColumnType::whole
                              : ColumnType::number;
  return {
      {{id + "_rating", type, measure.unit(),
        fmt::format("{} Answers: {}", measure.question.text, scale_with_amendments(set, index))},
       [&records](const Value& found) {
         return found.state == Value::State::in_words ? field(records.words[found.words])
                : found.is_measured()                 ? field(found.number)
                                                      : Field();
       }}};
}

/// Adds columns whose item is found from another one by item_of; null: all are empty.
template <typename Item, typename ItemOf>
void add_columns(const ColumnsOf<Item>& added, const ItemOf& item_of,
                 ColumnsOf<std::size_t>& columns) {
  for (const ColumnOf<Item>& column : added) {
    columns.push_back({column.column, [value = column.value, item_of](std::size_t index) {
                         const Item* item = item_of(index);
                         return item == nullptr ? Field() : value(*item);
                       }});
  }
}

/// Finds the figures of a trial's gaze; null if there are none.
auto figures_of(GazeOfTrials gaze) {
  return [gaze = std::move(gaze)](std::size_t trial) {
    return gaze[trial] == nullptr ? nullptr : &gaze[trial]->figures;
  };
}

}  // namespace

ColumnsOf<std::size_t> trial_columns(const StudyRecords& records, const Dataset& set,
                                     std::span<const study::AttemptGazeRow> gaze) {
  using study::SessionRow;
  const auto trial = [&records](std::size_t i) -> const TrialRow& { return records.trials[i]; };
  const auto session = [&records](std::size_t i) -> const SessionRow& {
    return records.sessions[records.trials[i].session];
  };
  const auto if_test = [](const TrialRow& row) {
    return row.kind == study::TrialKind::test ? std::optional(row) : std::nullopt;
  };
  const auto place = [methods = records.methods.size()](const TrialRow& row) {
    return row.scene_position * methods + row.method_position;
  };
  ColumnsOf<std::size_t> columns = {
      {"participant", "", code_meaning, path(session, &SessionRow::participant)},
      {kind_column(), path(session, &SessionRow::kind)},
      {"session_state", "", state_meaning, path(session, &SessionRow::state)},
      {"status", "",
       "One of: analysed, practice, catch, timed again; or, for the whole session: excluded, "
       "withdrawn (with --withdrawn only), interrupted, refused, other kind. Only analysed rows "
       "enter results",
       path(trial,
            [&records, analysed = analysed_sessions(records, set)](const TrialRow& row) {
              return trial_status(row, records.sessions[row.session],
                                  analysed[row.session].has_value());
            })},
      {"status_reason", "", reason_meaning, path(session, reason_in(set))},
      {"scene", "", "Name of the scene",
       path(trial, [&records](const TrialRow& row) { return records.scenes[row.scene]; })},
      {"method", "", "Method of placing samples: od, vp, fv or another sampler",
       path(trial, [&records](const TrialRow& row) { return records.methods[row.method]; })},
      {"trial", "", "Index among all planned trials of the session, from 0",
       path(trial, &TrialRow::trial)},
      {"trial_kind", "", "Kind of trial: test, practice, or catch (nothing was rendered)",
       path(trial, &TrialRow::kind)},
      {"trial_position", "", "Index among the planned test trials of the session, from 0",
       path(trial, if_test, place)},
      {"method_position", "", "Index among the methods in the scene, from 0",
       path(trial, if_test, &TrialRow::method_position)},
      {"attempt", "", "Number of the timing, from 1; 0: never begun",
       path(trial, &TrialRow::attempt)},
      {"object", "", "Name of the chosen object", path(trial, &TrialRow::object, word_of(records))},
      {"outcome", "", "Outcome of the attempt, as rated or retimed",
       path(trial, &TrialRow::outcome, word_of(records))}};
  for (std::size_t measure = 0; measure < set.measures.size(); ++measure) {
    add_columns(
        value_columns(records, set, measure),
        [&records, measure](std::size_t i) { return &records.value(i, measure); }, columns);
  }
  add_columns(gaze_columns(set.measures), figures_of(gaze_of_trials(records, gaze)), columns);
  columns.push_back({record_column(), [&set](std::size_t /*i*/) { return set.record; }});
  return columns;
}

ColumnsOf<std::size_t> gaze_by_trial_columns(const StudyRecords& records, const Dataset& set,
                                             std::span<const study::AttemptGazeRow> gaze) {
  const GazeOfTrials of_trials = gaze_of_trials(records, gaze);
  ColumnsOf<std::size_t> columns;
  for (ColumnOf<std::size_t>& column : trial_columns(records, set)) {
    const auto is_of = [&](const char* name) { return column.column.name == name; };
    if (is_of("participant") || is_of("scene") || is_of("method") || is_of("trial") ||
        is_of("attempt") || is_of("object")) {
      columns.push_back(std::move(column));
    }
  }
  columns[2].column.description = "Id of the method";
  columns[4].column.description = "Number of the timing, from 1; the last one counts";
  columns.push_back({"tracker", "",
                     "Profile of the eye tracker: pointer, if the pointer replaced the eye; "
                     "simulated, for a simulated eye; empty if it was not recorded",
                     [of_trials](std::size_t i) {
                       return of_trials[i] == nullptr || of_trials[i]->tracker.empty()
                                  ? std::nullopt
                                  : std::optional(of_trials[i]->tracker);
                     }});
  add_columns(gaze_columns(set.measures), figures_of(of_trials), columns);
  columns.push_back({kind_column(), [&set](std::size_t /*i*/) { return set.kind; }});
  columns.push_back({record_column(), [&set](std::size_t /*i*/) { return set.record; }});
  return columns;
}

ColumnsOf<std::size_t> participant_columns(const StudyRecords& records, const Dataset& set) {
  using Index = std::size_t;
  ColumnsOf<Index> columns = {
      {"participant", "", code_meaning, [&set](Index i) { return set.participants[i]; }},
      {kind_column(), [&set](Index /*i*/) { return set.kind; }},
      {record_column(), [&set](Index /*i*/) { return set.record; }}};
  for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
    for (std::size_t method = 0; method < set.methods.size(); ++method) {
      for (std::size_t measure = 0; measure < set.measures.size(); ++measure) {
        ColumnsOf<Value> of_values = value_columns(records, set, measure);
        for (ColumnOf<Value>& value : of_values) {
          value.column.name += fmt::format(".{}.{}", set.scenes[scene], set.methods[method]);
          value.column.description +=
              fmt::format("; scene {}, method {}", set.scenes[scene], set.methods[method]);
        }
        add_columns(
            of_values,
            [&set, scene, method, measure](Index participant) {
              return &set.value(participant, scene, method, measure);
            },
            columns);
      }
    }
  }
  const ColumnsOf<Index> answers = participant_answer_columns(records, set);
  columns.insert(columns.end(), answers.begin(), answers.end());
  return columns;
}

}  // namespace foveola::analysis
