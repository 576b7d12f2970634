#include "study/record/trial_rows.h"

#include <array>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "study/record/damage_remedy.h"
#include "study/record/schema.h"
#include "study/record/stored_number.h"

namespace foveola::study {
namespace {

using Positions = std::unordered_map<std::string, std::size_t>;

Positions positions_of(const std::vector<std::string>& names) {
  Positions positions;
  for (const std::string& name : names) {
    positions.emplace(name, positions.size());
  }
  return positions;
}

/// Throws Error for a name that is not among them, which the file's foreign keys exclude.
std::uint16_t position_of(const Positions& positions, const std::string& name, const char* what) {
  const auto found = positions.find(name);
  if (found == positions.end() || !std::in_range<std::uint16_t>(found->second)) {
    throw Error(fmt::format("the {} '{}' of a planned trial", what, name),
                "is not one of the study's", damage_remedy);
  }
  return static_cast<std::uint16_t>(found->second);
}

TrialKind kind_named(const std::string& name) {
  constexpr std::array kinds = {TrialKind::practice, TrialKind::catch_trial};
  for (const TrialKind kind : kinds) {
    if (name == name_of(kind)) {
      return kind;
    }
  }
  return TrialKind::test;
}

class TrialReader {
 public:
  TrialReader(SQLite::Database& database, const SessionIndices& sessions, WordIndices& words,
              StudyRecords& records)
      : database_(database), sessions_(sessions), words_(words), records_(records) {
    for (const Measure& measure : records.measures) {
      measures_.emplace(measure.id(), measures_.size());
    }
  }

  void read() {
    read_rows();
    records_.values.assign(records_.trials.size() * records_.measures.size(), Value{});
    read_values(
        "SELECT session, trial, attempt, kind, time_ns / 1e9, censored FROM mark"
        " ORDER BY session, trial, attempt");
    read_values(
        "SELECT session, trial, attempt, question, value, 0 FROM rating"
        " ORDER BY session, trial, attempt");
    if (schema_version_of(database_) >= 5) {
      read_values(
          fmt::format("SELECT session, trial, attempt, question || '{}', response_ns / 1e9, 0"
                      " FROM rating WHERE response_ns IS NOT NULL"
                      " ORDER BY session, trial, attempt",
                      response_suffix));
      read_values(
          fmt::format("SELECT session, trial, attempt, '{}', looked_around_ns / 1e9, 0"
                      " FROM attempt WHERE looked_around_ns IS NOT NULL"
                      " ORDER BY session, trial, attempt",
                      looking_around_id));
    }
  }

 private:
  using Key = std::tuple<std::uint32_t, std::uint32_t, int>;  ///< Session, trial, attempt.

  static Key key_of(const TrialRow& row) { return {row.session, row.trial, row.attempt}; }

  void read_rows() {
    const Positions scenes = positions_of(records_.scenes);
    const Positions methods = positions_of(records_.methods);
    SQLite::Statement row(
        database_,
        "SELECT planned_trial.session, planned_trial.trial, planned_trial.kind, scene, method,"
        " scene_position, method_position, coalesce(attempt, 0), coalesce(object, ''),"
        " coalesce(outcome, '')"
        " FROM planned_trial LEFT JOIN attempt ON attempt.session = planned_trial.session"
        "  AND attempt.trial = planned_trial.trial"
        " ORDER BY planned_trial.session, planned_trial.trial, attempt");
    while (row.executeStep()) {
      const auto session = sessions_.find(row.getColumn(0).getInt64());
      if (session == sessions_.end()) {
        continue;
      }
      const TrialKind kind = kind_named(row.getColumn(2).getString());
      const auto position = [&](int column, const std::vector<std::string>& list) {
        return kind == TrialKind::test ? place_in<std::uint16_t>(row.getColumn(column), list.size())
                                       : std::uint16_t{0};
      };
      const TrialRow trial{.session = session->second,
                           .trial = whole_number<std::uint32_t>(row.getColumn(1)),
                           .kind = kind,
                           .scene = position_of(scenes, row.getColumn(3).getString(), "scene"),
                           .method = position_of(methods, row.getColumn(4).getString(), "method"),
                           .scene_position = position(5, records_.scenes),
                           .method_position = position(6, records_.methods),
                           .attempt = whole_number<std::uint16_t>(row.getColumn(7)),
                           .object = words_.index_of(row.getColumn(8).getString()),
                           .outcome = words_.index_of(row.getColumn(9).getString())};
      if (!records_.trials.empty()) {
        TrialRow& before = records_.trials.back();
        before.counts = before.session != trial.session || before.trial != trial.trial;
      }
      records_.trials.push_back(trial);
    }
  }

  /// The query's columns: session, trial, attempt, measure, value, censored; in the order of the
  /// trials' rows, so that both are read once.
  void read_values(const std::string& sql) {
    SQLite::Statement row(database_, sql);
    std::size_t at = 0;
    while (row.executeStep()) {
      const auto session = sessions_.find(row.getColumn(0).getInt64());
      const auto measure = measures_.find(row.getColumn(3).getString());
      if (session == sessions_.end() || measure == measures_.end()) {
        continue;
      }
      const Key key{session->second, whole_number<std::uint32_t>(row.getColumn(1)),
                    whole_number<int>(row.getColumn(2))};
      while (at < records_.trials.size() && key_of(records_.trials[at]) < key) {
        ++at;
      }
      if (at < records_.trials.size() && key_of(records_.trials[at]) == key) {
        records_.values[at * records_.measures.size() + measure->second] =
            value_of(row.getColumn(4), row.getColumn(5).getInt() == 1);
      }
    }
  }

  Value value_of(const SQLite::Column& column, bool is_censored) {
    if (column.isText()) {
      return {.state = Value::State::in_words, .words = words_.index_of(column.getString())};
    }
    return {.state = is_censored ? Value::State::right_censored : Value::State::measured,
            .number = finite_number(column)};
  }

  SQLite::Database& database_;
  const SessionIndices& sessions_;
  WordIndices& words_;
  StudyRecords& records_;
  Positions measures_;
};

}  // namespace

WordIndices::WordIndices(std::vector<std::string>& words) : words_(words) {
  words_.assign(1, {});
  indices_.emplace("", 0);
}

std::uint32_t WordIndices::index_of(const std::string& text) {
  const auto [known, is_new] = indices_.emplace(text, static_cast<std::uint32_t>(words_.size()));
  if (is_new) {
    words_.push_back(text);
  }
  return known->second;
}

void read_trial_rows(SQLite::Database& database, const SessionIndices& sessions, WordIndices& words,
                     StudyRecords& records) {
  TrialReader(database, sessions, words, records).read();
}

}  // namespace foveola::study
