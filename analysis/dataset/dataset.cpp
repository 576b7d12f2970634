#include "analysis/dataset/dataset.h"

#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "renderer/base/error.h"

namespace foveola::analysis {
namespace {

using study::SessionRow;
using study::StudyRecords;
using study::TrialRow;

std::string place_of(const StudyRecords& records) {
  return records.file.empty() ? fmt::format("study \"{}\"", records.protocol.name) : records.file;
}

std::string name_of(const StudyRecords& records, const TrialRow& row) {
  return fmt::format("participant {}, scene {}, method {}", records.participant_of(row),
                     records.scenes[row.scene], records.methods[row.method]);
}

void check_protocol(const StudyRecords& records) {
  if (records.scenes.empty() || records.methods.empty()) {
    throw Error(place_of(records), "has a protocol without scenes or methods",
                "analyse a file that `foveola study` wrote");
  }
}

/// Returns the kind of sessions to analyse: people's, else pilots', else simulated ones.
std::string kind_to_analyse(const StudyRecords& records) {
  for (const char* kind : {"human", "pilot", "simulated"}) {
    const bool exists = std::ranges::any_of(records.sessions, [&](const SessionRow& row) {
      return row.kind == kind && row.state == "completed";
    });
    if (exists) {
      return kind;
    }
  }
  throw Error(place_of(records),
              fmt::format("none of its {} sessions is completed", records.sessions.size()),
              "complete one first, for example with `foveola study simulate`");
}

std::vector<std::string> participants_of(const StudyRecords& records, const std::string& kind) {
  std::set<std::string> codes;
  for (const SessionRow& row : records.sessions) {
    if (row.kind == kind && row.state == "completed") {
      codes.insert(row.participant);
    }
  }
  return {codes.begin(), codes.end()};
}

std::vector<Exclusion> excluded_sessions(const StudyRecords& records, const std::string& kind) {
  std::vector<Exclusion> exclusions;
  for (const SessionRow& row : records.sessions) {
    if (std::string reason = reason_not_analysed(row, kind); !reason.empty()) {
      exclusions.push_back({row.participant, "", "", "", std::move(reason)});
    }
  }
  return exclusions;
}

/// Throws Error for a rating that no session can have recorded; `where` names it.
void check_rating(const Measure& measure, const Value& value, const std::string& where) {
  if (!measure.is_time() && value.is_measured() &&
      !study::fault_of(measure.question, value.number).empty()) {
    throw Error(fmt::format("{}, rating {}", where, measure.id()),
                fmt::format("is {:g}, which is not on its scale ({})", value.number,
                            study::scale_in_words(measure)),
                "restore the study's file, or exclude the session");
  }
}

/// Returns whether it is a time without a logarithm, as the 0 s of a key that was held down.
bool has_no_logarithm(const Measure& measure, const Value& value) {
  return measure.is_time() && value.state != Value::State::missing &&
         !(value.number > 0.0 && std::isfinite(value.number));
}

/// Fills the set's trials and values from the rows. Returns each trial's index in the records.
std::vector<std::optional<std::size_t>> fill_trials(const StudyRecords& records, Dataset& set) {
  const auto participants = analysed_sessions(records, set);
  const auto methods = static_cast<int>(set.methods.size());
  set.trials.resize(set.participants.size() * set.scenes.size() * set.methods.size());
  set.values.resize(set.trials.size() * set.measures.size());
  std::vector<std::optional<std::size_t>> rows(set.trials.size());
  for (std::size_t i = 0; i < records.trials.size(); ++i) {
    const TrialRow& row = records.trials[i];
    if (!participants[row.session] || !StudyRecords::is_result(row)) {
      continue;
    }
    const std::size_t index =
        (*participants[row.session] * set.scenes.size() + row.scene) * set.methods.size() +
        row.method;
    if (rows[index]) {
      throw Error(name_of(records, row), "appears twice", "analyse each session once");
    }
    rows[index] = i;
    set.trials[index] = {.trial_position = row.scene_position * methods + row.method_position,
                         .method_position = row.method_position,
                         .attempts = row.attempt};
    for (std::size_t measure = 0; measure < set.measures.size(); ++measure) {
      const Value& value = records.value(i, measure);
      check_rating(set.measures[measure], value, name_of(records, row));
      set.values[index * set.measures.size() + measure] =
          has_no_logarithm(set.measures[measure], value) ? Value() : value;
    }
  }
  return rows;
}

/// Returns why no result uses a value; empty if one does.
std::string why_left_out(const Measure& measure, const Value& value) {
  if (has_no_logarithm(measure, value)) {
    return fmt::format("a time of {:g} s has no logarithm", value.number);
  }
  switch (value.state) {
    case Value::State::right_censored:
      return "right-censored: the time-out is only a lower bound of the time";
    case Value::State::missing:
      return measure.is_time() ? "no time recorded" : "no rating recorded";
    case Value::State::measured:
    case Value::State::in_words:
      break;
  }
  return "";
}

bool is_missing_by_choice(const Measure& measure, const Value& value) {
  return !measure.question.required && value.state == Value::State::missing;
}

void list_gaps(const StudyRecords& records, const std::vector<std::optional<std::size_t>>& rows,
               Dataset& set) {
  std::size_t index = 0;
  for (const std::string& participant : set.participants) {
    for (const std::string& scene : set.scenes) {
      for (const std::string& method : set.methods) {
        const std::optional<std::size_t> row = rows[index++];
        if (!row) {
          set.exclusions.push_back({participant, scene, method, "", "no trial recorded"});
        }
        for (std::size_t measure = 0; row && measure < set.measures.size(); ++measure) {
          const Value& value = records.value(*row, measure);
          std::string reason = why_left_out(set.measures[measure], value);
          if (!reason.empty() && !is_missing_by_choice(set.measures[measure], value)) {
            set.exclusions.push_back(
                {participant, scene, method, set.measures[measure].id(), std::move(reason)});
          }
        }
      }
    }
  }
}

}  // namespace

bool Dataset::is_complete(std::size_t participant, std::size_t scene, std::size_t measure) const {
  for (std::size_t method = 0; method < methods.size(); ++method) {
    if (!value(participant, scene, method, measure).is_measured()) {
      return false;
    }
  }
  return true;
}

std::vector<std::size_t> Dataset::times() const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    if (measures[i].is_time()) {
      found.push_back(i);
    }
  }
  return found;
}

std::vector<std::size_t> Dataset::marks() const {
  std::vector<std::size_t> found = times();
  std::erase_if(found, [&](std::size_t i) { return measures[i].kind != MeasureKind::time; });
  return found;
}

std::vector<std::size_t> Dataset::ratings() const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    if (measures[i].kind == MeasureKind::rating && measures[i].is_numeric()) {
      found.push_back(i);
    }
  }
  return found;
}

std::size_t Dataset::censored(std::size_t measure, std::optional<std::size_t> method) const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (!method || i % methods.size() == *method) {
      count += values[i * measures.size() + measure].state == Value::State::right_censored ? 1 : 0;
    }
  }
  return count;
}

std::optional<std::size_t> Dataset::measure_named(const std::string& id) const {
  for (std::size_t i = 0; i < measures.size(); ++i) {
    if (measures[i].id() == id) {
      return i;
    }
  }
  return std::nullopt;
}

Dataset select_for_analysis(const StudyRecords& records) {
  check_protocol(records);
  Dataset set;
  set.study = records.protocol.name;
  set.kind = kind_to_analyse(records);
  set.participants = participants_of(records, set.kind);
  set.scenes = records.scenes;
  set.methods = records.methods;
  set.measures = records.measures;
  set.amended_labels = amended_labels(records, set.participants);
  for (const SessionRow& row : records.sessions) {
    set.kinds[row.participant] = row.kind;
  }
  list_gaps(records, fill_trials(records, set), set);
  exclude(excluded_sessions(records, set.kind), set);
  return set;
}

std::vector<std::optional<std::size_t>> analysed_sessions(const StudyRecords& records,
                                                          const Dataset& set) {
  std::vector<std::optional<std::size_t>> analysed;
  for (const SessionRow& row : records.sessions) {
    const auto found =
        std::lower_bound(set.participants.begin(), set.participants.end(), row.participant);
    const bool is_analysed = found != set.participants.end() && *found == row.participant;
    analysed.push_back(is_analysed ? std::optional<std::size_t>(found - set.participants.begin())
                                   : std::nullopt);
  }
  return analysed;
}

std::string end_of(const SessionRow& session) {
  for (const char* end : {"completed", "withdrawn", "excluded", "refused"}) {
    if (session.state == end) {
      return end;
    }
  }
  return "interrupted";
}

std::string reason_not_analysed(const SessionRow& session, const std::string& kind) {
  const std::string end = end_of(session);
  if (end != "completed") {
    const std::string reason = end == "interrupted" && session.state != end
                                   ? "in its state " + session.state
                                   : session.reason;
    return reason.empty() ? fmt::format("session {}", end)
                          : fmt::format("session {}: {}", end, reason);
  }
  return session.kind == kind ? ""
                              : fmt::format("{} session; only {} sessions are analysed together",
                                            session.kind, kind);
}

void exclude(const std::vector<Exclusion>& exclusions, Dataset& set) {
  set.exclusions.insert(set.exclusions.end(), exclusions.begin(), exclusions.end());
  std::ranges::stable_sort(set.exclusions, [](const Exclusion& a, const Exclusion& b) {
    return a.participant < b.participant;
  });
}

std::optional<std::size_t> position_of(const std::vector<std::string>& names,
                                       const std::string& name) {
  const auto found = std::ranges::find(names, name);
  return found != names.end() ? std::optional<std::size_t>(found - names.begin()) : std::nullopt;
}

}  // namespace foveola::analysis
