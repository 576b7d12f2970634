// The rows of a study that are analysed, and the ones that are not, with the reason.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/publication/rating_scale.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

/// The two moments that a participant marks.
enum class Mark { outline, material };
inline constexpr std::array marks = {Mark::outline, Mark::material};
std::string_view name_of(Mark mark);

/// The index of the method that the others are compared with.
inline constexpr std::size_t baseline = 0;

/// The time from the first presented frame to a mark.
struct MarkTime {
  enum class State { missing, censored, measured };
  State state = State::missing;
  double seconds = 0.0;  ///< Above zero where measured; where censored, the time-out.
};

/// One method in one scene by one participant.
struct Cell {
  std::array<MarkTime, marks.size()> times;
  std::optional<int> rating;  ///< 1 ... 5, on the set's rating_scale.
  int trial_position = 0;     ///< Among the session's trials, as planned, from 0.
  int method_position = 0;    ///< Among the methods in the scene, as planned, from 0.
  int attempts = 0;           ///< More than 1: it was timed again, and the last time counts.

  const MarkTime& time(Mark mark) const { return times[static_cast<std::size_t>(mark)]; }
};

/// Something that the study's file holds, or should hold, but that no result uses. Empty fields
/// mean all: a session has no scene, a whole trial has no measure.
struct Exclusion {
  std::string participant;
  std::string scene;
  std::string method;
  std::string measure;  ///< "outline", "material", "artifacts" or "background".
  std::string reason;
};

struct AnalysisSet {
  std::string kind;  ///< All analysed sessions are "human", "pilot" or "simulated".
  std::vector<std::string> participants;  ///< In the order of their codes.
  std::vector<std::string> scenes;        ///< In the protocol's order.
  std::vector<std::string> methods;       ///< In the protocol's order; the first is the baseline.
  RatingScale rating_scale;
  std::vector<Cell> cells;            ///< [participant][scene][method]
  std::vector<Exclusion> exclusions;  ///< In the order of participants.
  /// The kind of every session in the file, analysed or not, by the participant's code.
  std::map<std::string, std::string> kinds;

  const Cell& cell(std::size_t participant, std::size_t scene, std::size_t method) const;
  /// Whether every method's time was measured, so that the methods can be compared in this scene.
  bool is_complete(std::size_t participant, std::size_t scene, Mark mark) const;
};

/// Takes the completed sessions of one kind: of people if there are any, else pilots, else
/// simulated ones; they are never mixed. Ratings on another scale than from 1 to 5 are left out.
/// Throws Error if nothing can be analysed, or if a value is impossible (a time that is not above
/// zero, a rating outside 1 to 5, a row twice), naming it.
AnalysisSet select_for_analysis(const study::StudyRecords& records);

/// Adds to the set's exclusions and keeps their order.
void exclude(const std::vector<Exclusion>& exclusions, AnalysisSet& set);

}  // namespace foveola::analysis
