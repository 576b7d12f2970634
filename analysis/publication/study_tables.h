// The published study's tables and figures as plain values, from any study's records.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/publication/analysis_set.h"
#include "analysis/publication/background.h"
#include "analysis/statistics/descriptive.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

/// The other reading of Table 2's percentages, which the paper does not define: the mean time over
/// the baseline's mean time, and the standard deviation of the times over it, from all measured
/// times of each method, whether or not the participant has both.
struct OfBaselineMean {
  std::optional<double> mean_percent;
  std::optional<double> sd_percent_points;
};

/// One cell of Table 2: a method in a scene, over participants.
struct SceneTimes {
  std::string scene;
  std::string method;
  Mark mark = Mark::outline;
  Description seconds;  ///< Describes the measured times.
  /// Describes each participant's own ratio to the baseline in this scene, in per cent; n counts
  /// the participants with both times. Empty for the baseline.
  Description percent_of_baseline;
  OfBaselineMean of_baseline_mean;  ///< Empty for the baseline.
  int censored = 0;                 ///< Number of right-censored times, which are in no mean.
  int missing = 0;
};

/// One bar of Fig. 5: a method over all scenes, with the participant as the unit. A participant's
/// value is the geometric mean over the scenes where every method's time was measured, so that all
/// methods are compared over the same scenes; an interval is a t interval on those values' logs.
struct MethodTimes {
  std::string method;
  Mark mark = Mark::outline;
  std::vector<double>
      participant_seconds;  ///< In the order of participants, of whom some may lack.
  std::vector<double> participant_percent;  ///< In per cent of the baseline; empty for it.
  std::optional<Estimate> seconds;
  std::optional<Estimate> percent_of_baseline;
};

/// One bar of Fig. 6: a method's artifact ratings over all scenes and participants.
struct MethodRatings {
  std::string method;
  Description rating;
  std::array<int, 5> counts{};  ///< Counts of the answers 1 ... 5.
  int missing = 0;
};

/// A session of the file that followed an amended protocol, with other words or time-outs.
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

  AnalysisSet set;
  std::vector<SceneTimes> scene_times;              ///< [mark][scene][method]
  std::vector<MethodTimes> method_times;            ///< [mark][method]
  std::vector<MethodRatings> ratings;               ///< [method]
  std::vector<QuestionAnswers> background_answers;  ///< Table 1.
  BackgroundScale background;
  std::vector<BackgroundCorrelation> background_correlations;  ///< [mark][method but the baseline]
  std::vector<AmendedSession> amended;
  std::size_t incomplete_scenes = 0;  ///< (participant, scene, mark) triples left out of Fig. 5.

  const SceneTimes& scene_times_of(Mark mark, std::size_t scene, std::size_t method) const;
  const MethodTimes& method_times_of(Mark mark, std::size_t method) const;
};

/// Throws Error as select_for_analysis does.
StudyTables tabulate_study(const study::StudyRecords& records);

}  // namespace foveola::analysis
