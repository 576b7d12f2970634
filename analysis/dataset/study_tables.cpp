#include "analysis/dataset/study_tables.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace foveola::analysis {
namespace {

SceneTimes tabulate_scene(const Dataset& set, std::size_t mark, std::size_t scene,
                          std::size_t method) {
  SceneTimes result{
      .mark = set.measures[mark].id(), .scene = set.scenes[scene], .method = set.methods[method]};
  std::vector<double> seconds;
  std::vector<double> percent;
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    const Value& time = set.value(participant, scene, method, mark);
    const Value& reference = set.value(participant, scene, baseline, mark);
    result.censored += time.state == Value::State::right_censored ? 1 : 0;
    result.missing += time.state == Value::State::missing ? 1 : 0;
    if (!time.is_measured()) {
      continue;
    }
    seconds.push_back(time.number);
    if (method != baseline && reference.is_measured()) {
      percent.push_back(100.0 * time.number / reference.number);
    }
  }
  result.seconds = describe(seconds);
  result.percent_of_baseline = describe(percent);
  result.geometric_percent = geometric_mean(percent);
  return result;
}

OfBaselineMean over_baseline_mean(const Description& seconds, const Description& reference) {
  const auto percent = [&](std::optional<double> value) {
    return value && reference.mean ? std::optional(100.0 * *value / *reference.mean) : std::nullopt;
  };
  return {percent(seconds.mean), percent(seconds.standard_deviation)};
}

std::optional<double> geometric_mean_over_scenes(const Dataset& set, std::size_t participant,
                                                 std::size_t mark, std::size_t method) {
  std::vector<double> seconds;
  for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
    if (set.is_complete(participant, scene, mark)) {
      seconds.push_back(set.value(participant, scene, method, mark).number);
    }
  }
  const std::optional<Estimate> estimate = geometric_mean(seconds);
  return estimate ? std::optional(estimate->value) : std::nullopt;
}

MethodTimes tabulate_method(const Dataset& set, std::size_t mark, std::size_t method) {
  MethodTimes result;
  result.mark = set.measures[mark].id();
  result.method = set.methods[method];
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

MethodRatings tabulate_ratings(const Dataset& set, std::size_t rating, std::size_t method) {
  MethodRatings result{.rating = set.measures[rating].id(), .method = set.methods[method]};
  for (const double point : set.measures[rating].points()) {
    result.counts.push_back({.value = point});
  }
  std::vector<double> values;
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
      const Value& value = set.value(participant, scene, method, rating);
      if (!value.is_measured()) {
        ++result.missing;
        continue;
      }
      values.push_back(value.number);
      for (RatingCount& count : result.counts) {
        count.count += count.value == value.number ? 1 : 0;
      }
    }
  }
  result.description = describe(values);
  return result;
}

std::size_t count_incomplete_scenes(const Dataset& set) {
  std::size_t count = 0;
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
      for (const std::size_t mark : set.times()) {
        count += set.is_complete(participant, scene, mark) ? 0 : 1;
      }
    }
  }
  return count;
}

std::vector<AmendedSession> list_amended(const study::StudyRecords& records, const Dataset& set) {
  std::vector<AmendedSession> amended;
  for (const auto& [participant, amendment] : records.amended) {
    const auto kind = set.kinds.find(participant);
    const bool is_analysed =
        std::ranges::find(set.participants, participant) != set.participants.end();
    amended.push_back({participant, kind == set.kinds.end() ? "" : kind->second, is_analysed,
                       amendment.sha256, amendment.changed});
  }
  return amended;
}

}  // namespace

const SceneTimes& StudyTables::scene_times_of(std::size_t mark, std::size_t scene,
                                              std::size_t method) const {
  // Times come first among the measures.
  return scene_times.at((mark * set.scenes.size() + scene) * set.methods.size() + method);
}

const MethodTimes& StudyTables::method_times_of(std::size_t mark, std::size_t method) const {
  return method_times.at(mark * set.methods.size() + method);
}

std::vector<MethodRatings> StudyTables::ratings_of(std::size_t rating) const {
  std::vector<MethodRatings> rows;
  std::ranges::copy_if(ratings, std::back_inserter(rows), [&](const MethodRatings& row) {
    return row.rating == set.measures[rating].id();
  });
  return rows;
}

StudyTables tabulate_study(const study::StudyRecords& records) {
  StudyTables tables;
  tables.protocol_name = records.protocol.name;
  tables.protocol_title = records.protocol.title;
  tables.protocol_sha256 = records.protocol.sha256;
  tables.has_simulated = records.has_simulated();
  tables.simulation = records.simulation;

  tables.set = select_for_analysis(records);
  const Dataset& set = tables.set;
  for (const std::size_t mark : set.times()) {
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
  for (const std::size_t rating : set.ratings()) {
    for (std::size_t method = 0; method < set.methods.size(); ++method) {
      tables.ratings.push_back(tabulate_ratings(set, rating, method));
    }
  }
  tables.survival = mark_survival(set);
  tables.amended = list_amended(records, set);
  tables.incomplete_scenes = count_incomplete_scenes(set);
  return tables;
}

}  // namespace foveola::analysis
