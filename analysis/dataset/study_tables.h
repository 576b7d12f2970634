// Tabulates means and counts of a study's measures, by scene and method and over all scenes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/dataset/mark_survival.h"
#include "analysis/statistics/descriptive.h"
#include "study/record/read/study_records.h"

namespace foveola::analysis {

/// Another reading of a method's time in per cent of the baseline's: the ratio of the mean times,
/// and the standard deviation of the times over the baseline's mean. It uses all measured times of
/// each method, also of participants without both.
struct OfBaselineMean {
  std::optional<double> mean_percent;
  std::optional<double> sd_percent_points;
};

/// The times of one mark with a method in a scene, over participants.
struct SceneTimes {
  std::string mark;  ///< Its id.
  std::string scene;
  std::string method;
  Description seconds;  ///< Describes the measured times.
  /// Describes each participant's own ratio to the baseline in this scene, in per cent; n counts
  /// the participants with both times. Empty for the baseline.
  Description percent_of_baseline;
  /// Geometric mean of the same ratios, with its t interval over participants.
  std::optional<Estimate> geometric_percent;
  OfBaselineMean of_baseline_mean;  ///< Empty for the baseline.
  int censored = 0;                 ///< Number of right-censored times, which are in no mean.
  int missing = 0;
};

/// The times of one mark with a method over all scenes, with the participant as the unit. A
/// participant's value is the geometric mean over the scenes where every method's time was
/// measured, so that all methods are compared over the same scenes. Intervals are t intervals of
/// those values' logarithms.
struct MethodTimes {
  std::string mark;  ///< Its id.
  std::string method;
  std::vector<double> participant_seconds;  ///< In the order of participants; some may be missing.
  std::vector<double> participant_percent;  ///< In per cent of the baseline; empty for it.
  std::optional<Estimate> seconds;
  std::optional<Estimate> percent_of_baseline;
};

/// One answer to a rating, and its frequency.
struct RatingCount {
  double value = 0.0;
  std::size_t count = 0;
};

/// The ratings of one measure with a method over all scenes and participants.
struct MethodRatings {
  std::string rating;  ///< The measure's id.
  std::string method;
  Description description;
  std::vector<RatingCount> counts;  ///< Of each point of the scale; empty if it has none.
  std::size_t missing = 0;
};

/// A session that followed an amended protocol, with other texts or time-outs.
struct AmendedSession {
  std::string participant;
  std::string kind;                       ///< "human", "pilot" or "simulated".
  bool is_analysed = false;               ///< Whether the session is in the analysis set.
  std::string protocol_sha256;            ///< SHA-256 of the amended text.
  std::vector<std::string> changed_keys;  ///< Empty if only comments or spaces changed.
};

struct StudyTables {
  std::string protocol_name;
  std::string protocol_title;
  std::string protocol_sha256;
  bool has_simulated = false;  ///< Whether any session of the file is simulated, analysed or not.
  std::optional<study::SimulationFacts> simulation;  ///< Facts on simulated sessions, if known.

  Dataset set;
  std::vector<SceneTimes> scene_times;    ///< [mark][scene][method]
  std::vector<MethodTimes> method_times;  ///< [mark][method]
  std::vector<MethodRatings> ratings;     ///< [rating in numbers][method]
  std::vector<MarkSurvival> survival;     ///< [mark][method]
  std::vector<AmendedSession> amended;
  /// Number of (participant, scene, mark) triples that the means over all scenes leave out.
  std::size_t incomplete_scenes = 0;

  /// `mark`: index of a time in the set's measures.
  const SceneTimes& scene_times_of(std::size_t mark, std::size_t scene, std::size_t method) const;
  const MethodTimes& method_times_of(std::size_t mark, std::size_t method) const;
  /// Returns the rows of one rating, one per method; `rating`: index in the set's measures.
  std::vector<MethodRatings> ratings_of(std::size_t rating) const;
};

/// Throws Error as select_for_analysis does.
StudyTables tabulate_study(const study::StudyRecords& records);

}  // namespace foveola::analysis
