#include "analysis/publication/analysis_set.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>
#include <unordered_map>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "study/protocol/analysed_measures.h"

namespace foveola::analysis {
namespace {

using study::SessionRow;
using study::StudyRecords;
using study::TrialRow;

using Positions = std::unordered_map<std::string, std::size_t>;

Positions positions_of(const std::vector<std::string>& names) {
  Positions positions;
  for (const std::string& name : names) {
    positions.emplace(name, positions.size());
  }
  return positions;
}

std::string study_name(const StudyRecords& records) {
  return fmt::format("study \"{}\"", records.protocol_name);
}

std::string row_name(const TrialRow& row) {
  return fmt::format("participant {}, scene {}, method {}", row.participant, row.scene, row.method);
}

void check_protocol(const StudyRecords& records) {
  if (records.scenes.empty() || records.methods.empty()) {
    throw Error(study_name(records), "its protocol names no scene or no method",
                "analyse a file that `foveola study` wrote");
  }
}

/// The kind of sessions to analyse: people's, else pilots', else simulated ones.
std::string kind_to_analyse(const StudyRecords& records) {
  for (const char* kind : {"human", "pilot", "simulated"}) {
    const bool exists = std::any_of(
        records.sessions.begin(), records.sessions.end(),
        [&](const SessionRow& row) { return row.kind == kind && row.state == "completed"; });
    if (exists) {
      return kind;
    }
  }
  throw Error(study_name(records),
              fmt::format("none of its {} sessions is completed", records.sessions.size()),
              "complete one first, for instance with `foveola study simulate`");
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

std::string why_not_analysed(const SessionRow& row) {
  return row.reason.empty() ? fmt::format("session {}", row.state)
                            : fmt::format("session {}: {}", row.state, row.reason);
}

std::vector<Exclusion> excluded_sessions(const StudyRecords& records, const std::string& kind) {
  std::vector<Exclusion> exclusions;
  for (const SessionRow& row : records.sessions) {
    if (row.state != "completed") {
      exclusions.push_back({row.participant, "", "", "", why_not_analysed(row)});
    } else if (row.kind != kind) {
      exclusions.push_back(
          {row.participant, "", "", "",
           fmt::format("{} session; only {} sessions are analysed together", row.kind, kind)});
    }
  }
  return exclusions;
}

MarkTime mark_time(const TrialRow& row, Mark mark) {
  const std::optional<double>& seconds = mark == Mark::outline ? row.outline_s : row.material_s;
  if (seconds && (!(*seconds > 0.0) || !std::isfinite(*seconds))) {
    throw Error(fmt::format("{}, {} time", row_name(row), name_of(mark)),
                fmt::format("is {} s, which has no logarithm", *seconds),
                "a time must be above zero: correct the record or exclude the session");
  }
  if (mark == Mark::outline ? row.outline_censored : row.material_censored) {
    return {MarkTime::State::censored, seconds.value_or(0.0)};
  }
  return seconds ? MarkTime{MarkTime::State::measured, *seconds} : MarkTime{};
}

std::optional<int> rating(const TrialRow& row) {
  if (row.artifact_rating && (*row.artifact_rating < 1 || *row.artifact_rating > 5)) {
    throw Error(row_name(row) + ", artifact rating",
                fmt::format("is {}, outside the scale of 1 to 5", *row.artifact_rating),
                "correct the record or exclude the session");
  }
  return row.artifact_rating;
}

/// Fills `set`'s cells from the rows; returns which cells have a row.
std::vector<bool> fill_cells(const StudyRecords& records, AnalysisSet& set) {
  const Positions participants = positions_of(set.participants);
  const Positions scenes = positions_of(set.scenes);
  const Positions methods = positions_of(set.methods);
  set.cells.resize(set.participants.size() * set.scenes.size() * set.methods.size());
  std::vector<bool> has_row(set.cells.size(), false);
  for (const TrialRow& row : records.trials) {
    const auto participant = participants.find(row.participant);
    if (participant == participants.end()) {
      continue;
    }
    const auto scene = scenes.find(row.scene);
    const auto method = methods.find(row.method);
    if (scene == scenes.end() || method == methods.end()) {
      set.exclusions.push_back({row.participant, row.scene, row.method, "", "not in the protocol"});
      continue;
    }
    const std::size_t index =
        (participant->second * set.scenes.size() + scene->second) * set.methods.size() +
        method->second;
    if (has_row[index]) {
      throw Error(row_name(row), "appears twice", "analyse each session once");
    }
    has_row[index] = true;
    const auto methods_in_scene = static_cast<int>(set.methods.size());
    set.cells[index] = {
        .times = {mark_time(row, Mark::outline), mark_time(row, Mark::material)},
        .rating = set.rating_scale.is_analysed() ? rating(row) : std::nullopt,
        .trial_position = row.scene_position * methods_in_scene + row.method_position,
        .method_position = row.method_position,
        .attempts = row.attempts};
  }
  return has_row;
}

/// Why there is no rating where there is none.
std::string_view why_not_rated(const RatingScale& scale) {
  return !scale.question || scale.is_analysed()
             ? "no rating recorded"
             : "rated on another scale than from 1 to 5: in the record only";
}

void list_gaps_of_cell(const Cell& cell, const Exclusion& place, const RatingScale& scale,
                       std::vector<Exclusion>& exclusions) {
  const auto exclude = [&](std::string_view measure, std::string_view reason) {
    exclusions.push_back(
        {place.participant, place.scene, place.method, std::string(measure), std::string(reason)});
  };
  for (const Mark mark : marks) {
    if (cell.time(mark).state == MarkTime::State::censored) {
      exclude(name_of(mark), "right-censored: the time-out is only a lower bound of the time");
    } else if (cell.time(mark).state == MarkTime::State::missing) {
      exclude(name_of(mark), "no time recorded");
    }
  }
  if (!cell.rating) {
    exclude("artifacts", why_not_rated(scale));
  }
}

void list_gaps(const std::vector<bool>& has_row, AnalysisSet& set) {
  std::size_t index = 0;
  for (const std::string& participant : set.participants) {
    for (const std::string& scene : set.scenes) {
      for (const std::string& method : set.methods) {
        if (has_row[index]) {
          list_gaps_of_cell(set.cells[index], {participant, scene, method, "", ""},
                            set.rating_scale, set.exclusions);
        } else {
          set.exclusions.push_back({participant, scene, method, "", "no trial recorded"});
        }
        ++index;
      }
    }
  }
}

}  // namespace

std::string_view name_of(Mark mark) {
  return study::analysed_marks.at(static_cast<std::size_t>(mark));
}

const Cell& AnalysisSet::cell(std::size_t participant, std::size_t scene,
                              std::size_t method) const {
  assert(participant < participants.size() && scene < scenes.size() && method < methods.size());
  return cells[(participant * scenes.size() + scene) * methods.size() + method];
}

bool AnalysisSet::is_complete(std::size_t participant, std::size_t scene, Mark mark) const {
  for (std::size_t method = 0; method < methods.size(); ++method) {
    if (cell(participant, scene, method).time(mark).state != MarkTime::State::measured) {
      return false;
    }
  }
  return true;
}

AnalysisSet select_for_analysis(const StudyRecords& records) {
  check_protocol(records);
  AnalysisSet set;
  set.kind = kind_to_analyse(records);
  set.participants = participants_of(records, set.kind);
  set.scenes = records.scenes;
  set.methods = records.methods;
  set.rating_scale = rating_scale_of(records, set.participants);
  for (const SessionRow& row : records.sessions) {
    set.kinds[row.participant] = row.kind;
  }
  const std::vector<bool> has_row = fill_cells(records, set);
  list_gaps(has_row, set);
  exclude(excluded_sessions(records, set.kind), set);
  return set;
}

void exclude(const std::vector<Exclusion>& exclusions, AnalysisSet& set) {
  set.exclusions.insert(set.exclusions.end(), exclusions.begin(), exclusions.end());
  std::stable_sort(
      set.exclusions.begin(), set.exclusions.end(),
      [](const Exclusion& a, const Exclusion& b) { return a.participant < b.participant; });
}

}  // namespace foveola::analysis
