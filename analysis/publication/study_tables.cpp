#include "analysis/publication/study_tables.h"

#include <algorithm>
#include <utility>

namespace foveola::analysis {
namespace {

SceneTimes tabulate_scene(const AnalysisSet& set, Mark mark, std::size_t scene,
                          std::size_t method) {
  SceneTimes result{set.scenes[scene], set.methods[method], mark, {}, {}, {}, 0, 0};
  std::vector<double> seconds;
  std::vector<double> percent;
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    const MarkTime& time = set.cell(participant, scene, method).time(mark);
    const MarkTime& reference = set.cell(participant, scene, baseline).time(mark);
    result.censored += time.state == MarkTime::State::censored ? 1 : 0;
    result.missing += time.state == MarkTime::State::missing ? 1 : 0;
    if (time.state != MarkTime::State::measured) {
      continue;
    }
    seconds.push_back(time.seconds);
    if (method != baseline && reference.state == MarkTime::State::measured) {
      percent.push_back(100.0 * time.seconds / reference.seconds);
    }
  }
  result.seconds = describe(seconds);
  result.percent_of_baseline = describe(percent);
  return result;
}

OfBaselineMean over_baseline_mean(const Description& seconds, const Description& reference) {
  const auto percent = [&](std::optional<double> value) {
    return value && reference.mean ? std::optional(100.0 * *value / *reference.mean) : std::nullopt;
  };
  return {percent(seconds.mean), percent(seconds.standard_deviation)};
}

/// A participant's geometric mean over complete scenes, in seconds; empty without any.
std::optional<double> geometric_mean_over_scenes(const AnalysisSet& set, std::size_t participant,
                                                 Mark mark, std::size_t method) {
  std::vector<double> seconds;
  for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
    if (set.is_complete(participant, scene, mark)) {
      seconds.push_back(set.cell(participant, scene, method).time(mark).seconds);
    }
  }
  const std::optional<Estimate> estimate = geometric_mean(seconds);
  return estimate ? std::optional(estimate->value) : std::nullopt;
}

MethodTimes tabulate_method(const AnalysisSet& set, Mark mark, std::size_t method) {
  MethodTimes result;
  result.method = set.methods[method];
  result.mark = mark;
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    const auto seconds = geometric_mean_over_scenes(set, participant, mark, method);
    if (!seconds) {
      continue;
    }
    result.participant_seconds.push_back(*seconds);
    if (method != baseline) {
      const auto reference = geometric_mean_over_scenes(set, participant, mark, baseline);
      result.participant_percent.push_back(100.0 * *seconds / reference.value());
    }
  }
  result.seconds = geometric_mean(result.participant_seconds);
  result.percent_of_baseline = geometric_mean(result.participant_percent);
  return result;
}

MethodRatings tabulate_ratings(const AnalysisSet& set, std::size_t method) {
  MethodRatings result;
  result.method = set.methods[method];
  std::vector<double> ratings;
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
      if (const std::optional<int>& rating = set.cell(participant, scene, method).rating) {
        ratings.push_back(*rating);
        ++result.counts[static_cast<std::size_t>(*rating - 1)];
      } else {
        ++result.missing;
      }
    }
  }
  result.rating = describe(ratings);
  return result;
}

std::size_t count_incomplete_scenes(const AnalysisSet& set) {
  std::size_t count = 0;
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
      for (const Mark mark : marks) {
        count += set.is_complete(participant, scene, mark) ? 0 : 1;
      }
    }
  }
  return count;
}

std::vector<AmendedSession> list_amended(const study::StudyRecords& records,
                                         const AnalysisSet& set) {
  std::vector<AmendedSession> amended;
  for (const auto& [participant, amendment] : records.amended) {
    const auto kind = set.kinds.find(participant);
    const bool is_analysed = std::find(set.participants.begin(), set.participants.end(),
                                       participant) != set.participants.end();
    amended.push_back({participant, kind == set.kinds.end() ? "" : kind->second, is_analysed,
                       amendment.sha256, amendment.changed});
  }
  return amended;
}

}  // namespace

const SceneTimes& StudyTables::scene_times_of(Mark mark, std::size_t scene,
                                              std::size_t method) const {
  const std::size_t scenes = set.scenes.size();
  const std::size_t methods = set.methods.size();
  return scene_times.at((static_cast<std::size_t>(mark) * scenes + scene) * methods + method);
}

const MethodTimes& StudyTables::method_times_of(Mark mark, std::size_t method) const {
  return method_times.at(static_cast<std::size_t>(mark) * set.methods.size() + method);
}

StudyTables tabulate_study(const study::StudyRecords& records) {
  StudyTables tables;
  tables.protocol_name = records.protocol_name;
  tables.protocol_title = records.protocol_title;
  tables.protocol_sha256 = records.protocol_sha256;
  tables.has_simulated = records.has_simulated();
  tables.simulation = records.simulation;

  tables.set = select_for_analysis(records);
  const AnalysisSet& set = tables.set;
  for (const Mark mark : marks) {
    for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
      for (std::size_t method = 0; method < set.methods.size(); ++method) {
        SceneTimes times = tabulate_scene(set, mark, scene, method);
        if (method != baseline) {
          times.of_baseline_mean = over_baseline_mean(
              times.seconds, tables.scene_times_of(mark, scene, baseline).seconds);
        }
        tables.scene_times.push_back(std::move(times));
      }
    }
    for (std::size_t method = 0; method < set.methods.size(); ++method) {
      tables.method_times.push_back(tabulate_method(set, mark, method));
    }
  }
  for (std::size_t method = 0; method < set.methods.size(); ++method) {
    tables.ratings.push_back(tabulate_ratings(set, method));
  }
  tables.background_answers = describe_background(set, records.background);
  tables.background = choose_background_scale(records.background);
  tables.background_correlations = correlate_background(set, records.background, tables.background);
  exclude(list_missing_answers(set, records.background, tables.background), tables.set);
  tables.amended = list_amended(records, set);
  tables.incomplete_scenes = count_incomplete_scenes(set);
  return tables;
}

}  // namespace foveola::analysis
