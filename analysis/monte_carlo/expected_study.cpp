#include "analysis/monte_carlo/expected_study.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "renderer/base/numbers/random.h"
#include "study/design/plan.h"
#include "study/protocol/measure.h"
#include "study/protocol/reading/read_procedure.h"

namespace foveola::analysis {
namespace {

using study::Value;

/// Effects on one kind of measure, in the units of ExpectedSpread.
struct DrawnEffects {
  double own = 0.0;
  std::vector<double> gains;  ///< [method]
};

/// Each of two methods contributes half of the variance of their difference.
DrawnEffects draw_effects(double own_sd, double gain_sd, std::size_t methods, Pcg32& generator) {
  DrawnEffects effects{.own = own_sd * generator.normal(), .gains = std::vector<double>(methods)};
  for (double& gain : effects.gains) {
    gain = gain_sd / std::sqrt(2.0) * generator.normal();
  }
  return effects;
}

std::vector<DrawnEffects> draw_scenes(const ExpectedSpread& spread, std::size_t scenes,
                                      std::size_t methods, Pcg32& generator) {
  std::vector<DrawnEffects> effects;
  for (std::size_t scene = 0; scene < scenes; ++scene) {
    effects.push_back(draw_effects(spread.scenes, spread.scenes_gain, methods, generator));
  }
  return effects;
}

template <typename Entries, typename Name>
std::size_t index_in(const Entries& entries, const Name& is_it) {
  return static_cast<std::size_t>(std::ranges::find_if(entries, is_it) - entries.begin());
}

struct Place {
  std::size_t scene = 0;
  std::size_t method = 0;
};

Value measured(double number) { return {.state = Value::State::measured, .number = number}; }

double nearest_answer(const study::Measure& rating, double value) {
  const std::vector<double> points = rating.points();
  if (points.empty()) {
    return std::clamp(std::round(value), rating.question.minimum, rating.question.maximum);
  }
  return *std::ranges::min_element(
      points, [&](double a, double b) { return std::abs(a - value) < std::abs(b - value); });
}

/// Effects shared by all participants of a study.
struct DrawnScenes {
  std::vector<DrawnEffects> times;                 ///< [scene]
  std::vector<std::vector<DrawnEffects>> ratings;  ///< [rating][scene]
};

class DrawnParticipant {
 public:
  DrawnParticipant(const ExpectedStudy& expected, const std::vector<study::Measure>& measures,
                   const DrawnScenes& scenes, Pcg32& generator)
      : expected_(expected), measures_(measures), scenes_(scenes), generator_(generator) {
    const std::size_t methods = expected.protocol.methods.size();
    const auto draw = [&](const ExpectedSpread& spread) {
      return draw_effects(spread.participants, spread.participants_gain, methods, generator);
    };
    times_ = draw(expected.times_spread);
    for (std::size_t rating = 0; rating < expected.shifts.size(); ++rating) {
      ratings_.push_back(draw(expected.ratings_spread));
    }
  }

  /// Returns values in the order of the measures; `timeout_s` censors marks.
  std::vector<Value> draw_trial(const Place& place, int trial, double timeout_s) {
    std::vector<Value> values;
    draw_times(place, trial, timeout_s, values);
    for (std::size_t rating = 0; rating < expected_.shifts.size(); ++rating) {
      values.push_back(draw_rating(place, rating));
    }
    return values;
  }

 private:
  double expected_log_s(std::size_t mark, std::size_t method) const {
    const ExpectedTimes& times = expected_.times[mark];
    return std::log(times.baseline_s) + std::log(times.ratios[method]);
  }

  /// Draws a log-normal factor with mean 1.
  double draw_factor(double variation) {
    const double variance = std::log1p(variation * variation);
    return std::exp(std::sqrt(variance) * generator_.normal() - 0.5 * variance);
  }

  void draw_times(const Place& place, int trial, double timeout_s, std::vector<Value>& values) {
    const ExpectedSpread& spread = expected_.times_spread;
    const DrawnEffects& scene = scenes_.times[place.scene];
    double log_s = expected_log_s(0, place.method) + times_.own + times_.gains[place.method] +
                   scene.own + scene.gains[place.method] + expected_.change_per_trial * trial +
                   spread.trials * generator_.normal();
    for (std::size_t mark = 0; mark < expected_.times.size(); ++mark) {
      if (mark > 0) {
        const double longer =
            expected_log_s(mark, place.method) - expected_log_s(mark - 1, place.method);
        log_s += longer * draw_factor(expected_.later_marks_variation);
      }
      const double seconds = std::exp(log_s);
      values.push_back(seconds <= timeout_s
                           ? measured(seconds)
                           : Value{.state = Value::State::right_censored, .number = timeout_s});
    }
  }

  Value draw_rating(const Place& place, std::size_t rating) {
    const study::Measure& measure = measures_[expected_.times.size() + rating];
    if (!measure.is_numeric()) {
      return {};
    }
    const ExpectedSpread& spread = expected_.ratings_spread;
    const std::vector<double>& shifts = expected_.shifts[rating];
    const auto [least, most] = std::ranges::minmax_element(shifts);
    const DrawnEffects& person = ratings_[rating];
    const DrawnEffects& scene = scenes_.ratings[rating][place.scene];
    const study::Span answers = study::span_of(measure.question);
    const double effects = person.own + person.gains[place.method] + scene.own +
                           scene.gains[place.method] + spread.trials * generator_.normal();
    const double value = 0.5 * (answers.low + answers.high) - 0.5 * (*least + *most) +
                         shifts[place.method] + answers.width() * effects;
    return measured(nearest_answer(measure, value));
  }

  const ExpectedStudy& expected_;
  const std::vector<study::Measure>& measures_;
  const DrawnScenes& scenes_;
  Pcg32& generator_;
  DrawnEffects times_;
  std::vector<DrawnEffects> ratings_;  ///< [rating]
};

void add_trials(const ExpectedStudy& expected, const study::Plan& plan, std::uint32_t session,
                DrawnParticipant participant, study::StudyRecords& records) {
  int trial = 0;
  for (const study::PlannedTrial& planned : plan) {
    if (planned.kind != study::TrialKind::test) {
      continue;
    }
    const Place place{
        index_in(records.scenes, [&](const std::string& name) { return name == planned.scene; }),
        index_in(records.methods, [&](const std::string& name) { return name == planned.method; })};
    const study::Timing timing =
        settings_of(expected.protocol, planned.scene, planned.method).timing;
    records.add_trial({.session = session,
                       .trial = static_cast<std::uint32_t>(trial),
                       .scene = static_cast<std::uint16_t>(place.scene),
                       .method = static_cast<std::uint16_t>(place.method),
                       .scene_position = static_cast<std::uint16_t>(planned.scene_position),
                       .method_position = static_cast<std::uint16_t>(planned.method_position),
                       .attempt = 1},
                      participant.draw_trial(place, trial, timing.mark_timeout_s));
    ++trial;
  }
}

study::StudyRecords records_of(const study::Protocol& protocol) {
  study::StudyRecords records;
  records.protocol.name = protocol.name;
  records.protocol.title = protocol.title;
  records.protocol.analysis = protocol.analysis;
  records.words = {""};
  records.measures = study::trial_measures(protocol.marks, protocol.ratings);
  for (const study::SceneEntry& scene : protocol.scenes) {
    records.scenes.push_back(scene.name);
  }
  records.methods = protocol.methods;
  return records;
}

}  // namespace

double correlation_with_mark_before(const ExpectedStudy& expected, std::size_t mark,
                                    std::size_t method) {
  const auto log_s = [&](std::size_t of) {
    return std::log(expected.times[of].baseline_s * expected.times[of].ratios[method]);
  };
  const auto square = [](double x) { return x * x; };
  double variance = square(expected.times_spread.trials);
  double before = variance;
  for (std::size_t later = 1; later <= mark; ++later) {
    before = variance;
    variance += square(expected.later_marks_variation * (log_s(later) - log_s(later - 1)));
  }
  return variance > 0.0 ? std::sqrt(before / variance) : 1.0;
}

study::StudyRecords draw_study(const ExpectedStudy& expected, std::size_t participants,
                               std::uint64_t seed) {
  const study::Protocol& protocol = expected.protocol;
  study::StudyRecords records = records_of(protocol);
  const std::size_t scenes = protocol.scenes.size();
  const std::size_t methods = protocol.methods.size();
  Pcg32 of_scenes(seed);
  DrawnScenes drawn{.times = draw_scenes(expected.times_spread, scenes, methods, of_scenes)};
  for (std::size_t rating = 0; rating < expected.shifts.size(); ++rating) {
    drawn.ratings.push_back(draw_scenes(expected.ratings_spread, scenes, methods, of_scenes));
  }
  const std::uint64_t design_seed = (std::uint64_t{of_scenes.next()} << 32U) + of_scenes.next();
  for (std::size_t i = 0; i < participants; ++i) {
    Pcg32 generator(seed, i + 1);
    const bool withdraws = generator.uniform() < expected.withdrawals;
    records.sessions.push_back({.participant = fmt::format("S{:05}", i + 1),
                                .kind = "simulated",
                                .state = withdraws ? "withdrawn" : "completed"});
    if (!withdraws) {
      add_trials(expected, make_plan(protocol, design_seed, static_cast<int>(i)),
                 static_cast<std::uint32_t>(i),
                 DrawnParticipant(expected, records.measures, drawn, generator), records);
    }
  }
  return records;
}

ExpectedStudy example_study() {
  ExpectedStudy expected;
  expected.times_spread.scenes_gain = 0.0;
  study::Protocol& protocol = expected.protocol;
  protocol.name = "example";
  protocol.title = "A study drawn from a model";
  for (int scene = 1; scene <= 5; ++scene) {
    protocol.scenes.push_back({.name = fmt::format("scene-{}", scene)});
  }
  protocol.methods = {"od", "vp", "fv"};
  protocol.timing.mark_timeout_s = std::numeric_limits<double>::infinity();
  protocol.marks = study::published_marks();
  protocol.marks.push_back({.id = "recognition", .instruction = "Press when you know what it is."});
  protocol.ratings = study::published_ratings();
  protocol.ratings.push_back(
      {.id = "comfort", .text = "How comfortable?", .minimum = 0.0, .maximum = 100.0});
  for (const double baseline_s : {15.0, 30.0, 90.0}) {
    expected.times.push_back({.baseline_s = baseline_s, .ratios = {1.0, 0.32, 0.1}});
  }
  expected.shifts = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
  // So small that answers are hardly ever clipped at the ends of the scale.
  expected.ratings_spread = {.participants = 0.1,
                             .scenes = 0.0,
                             .participants_gain = 0.05,
                             .scenes_gain = 0.0,
                             .trials = 0.08};
  return expected;
}

}  // namespace foveola::analysis
