// Selects a study's results as [participant][scene][method][measure], with the design's factors and
// the exclusions with their reasons.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/record/read/study_records.h"

namespace foveola::analysis {

using study::Measure;
using study::MeasureKind;
using study::Value;

/// Index of the method that the others are compared with.
inline constexpr std::size_t baseline = 0;

/// One method in one scene by one participant: the factors of the design.
struct Trial {
  int trial_position = 0;   ///< Among the session's test trials, as planned, from 0.
  int method_position = 0;  ///< Among the methods in the scene, as planned, from 0.
  int attempts = 0;         ///< More than 1: it was retimed, and the final timing counts.
};

/// A part of the study's file that no result uses. Empty fields mean all: a session has no scene, a
/// whole trial has no measure.
struct Exclusion {
  std::string participant;
  std::string scene;
  std::string method;
  std::string measure;  ///< The id of a mark or rating, or "background".
  std::string reason;
};

/// Other labels of a rating's points, in sessions by an amended protocol.
struct AmendedLabels {
  std::size_t measure = 0;
  std::vector<std::string> labels;
  std::size_t sessions = 0;  ///< Analysed sessions, or parts of sessions, with these labels.
};

struct Dataset {
  std::string study;  ///< The protocol's name.
  std::string kind;   ///< All analysed sessions are "human", "pilot" or "simulated".
  /// Result of verifying the study's file: "verified" or "changed"; "none" without verification.
  std::string record = "none";
  std::vector<std::string> participants;  ///< In the order of their codes.
  std::vector<std::string> scenes;        ///< In the protocol's order.
  std::vector<std::string> methods;       ///< In the protocol's order; the first is the baseline.
  std::vector<Measure> measures;          ///< Marks, response times, then ratings.
  std::vector<AmendedLabels> amended_labels;
  std::vector<Trial> trials;          ///< [participant][scene][method]
  std::vector<Value> values;          ///< [participant][scene][method][measure]
  std::vector<Exclusion> exclusions;  ///< In the order of participants.
  /// The kind of every session in the file, analysed or not, by the participant's code.
  std::map<std::string, std::string> kinds;

  const Trial& trial(std::size_t participant, std::size_t scene, std::size_t method) const {
    return trials[index_of(participant, scene, method)];
  }
  /// Returns a value, in seconds for times.
  const Value& value(std::size_t participant, std::size_t scene, std::size_t method,
                     std::size_t measure) const {
    return values[index_of(participant, scene, method) * measures.size() + measure];
  }
  /// Returns whether every method's value was measured, so that the methods can be compared in this
  /// scene.
  bool is_complete(std::size_t participant, std::size_t scene, std::size_t measure) const;

  /// Return the indices of the times, which come first; of the marks' times; and of numeric
  /// ratings.
  std::vector<std::size_t> times() const;
  std::vector<std::size_t> marks() const;
  std::vector<std::size_t> ratings() const;
  /// Counts right-censored values of a measure, with one method or with all.
  std::size_t censored(std::size_t measure, std::optional<std::size_t> method = {}) const;
  /// Returns the index of the measure of this id; empty if there is none.
  std::optional<std::size_t> measure_named(const std::string& id) const;

 private:
  std::size_t index_of(std::size_t participant, std::size_t scene, std::size_t method) const {
    return (participant * scenes.size() + scene) * methods.size() + method;
  }
};

/// Selects the completed sessions of one kind, never mixed: people's if there are any, else
/// pilots', else simulated ones. Verifies nothing: see `record`. A time that is not above zero is
/// missing and among the exclusions. Throws Error if nothing can be analysed, or for a rating
/// outside of its scale or a trial that appears twice, naming it.
Dataset select_for_analysis(const study::StudyRecords& records);

/// Returns the rows whose participants are in the set.
template <typename OfParticipant>
std::vector<OfParticipant> of_analysed(const Dataset& set, std::vector<OfParticipant> rows) {
  std::erase_if(rows, [&](const OfParticipant& row) {
    return !std::ranges::binary_search(set.participants, row.participant);
  });
  return rows;
}

/// Returns, for each session of the records, the index of its participant in the set; empty if it
/// is not analysed.
std::vector<std::optional<std::size_t>> analysed_sessions(const study::StudyRecords& records,
                                                          const Dataset& set);

/// Returns the end of a session: "completed", "withdrawn", "excluded", "refused", or "interrupted"
/// for any that has not ended.
std::string end_of(const study::SessionRow& session);

/// Returns why a session is not among those of the analysed kind, as "session excluded: fell
/// asleep"; empty if it is.
std::string reason_not_analysed(const study::SessionRow& session, const std::string& kind);

/// Adds to the set's exclusions and keeps their order.
void exclude(const std::vector<Exclusion>& exclusions, Dataset& set);

/// Returns the index of a scene's or a method's name; empty if it is not among them.
std::optional<std::size_t> position_of(const std::vector<std::string>& names,
                                       const std::string& name);

}  // namespace foveola::analysis
