#include "analysis/monte_carlo/expectations.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/dataset/dataset.h"
#include "analysis/dataset/participant_values.h"
#include "analysis/statistics/models/crossed_model.h"
#include "renderer/base/error.h"
#include "renderer/base/transformed.h"
#include "study/protocol/measure.h"

namespace foveola::analysis {
namespace {

constexpr double default_first_mark_s = 10.0;
constexpr double default_later_mark = 2.0;  ///< Factor of the previous mark's time.

std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
  }
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stopped == end && std::isfinite(value) ? std::optional(value)
                                                                        : std::nullopt;
}

template <typename Names>
std::size_t index_among(const Names& names, const std::string& name, const std::string& where,
                        const char* what) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) {
    throw Error(where, fmt::format("no {} '{}'", what, name),
                fmt::format("choose one of {}", fmt::join(names, ", ")));
  }
  return static_cast<std::size_t>(found - names.begin());
}

/// Returns the logarithm of a geometric standard deviation.
double sd_of(double factor, const char* option) {
  if (!(factor >= 1.0 && factor <= 100.0)) {
    throw Error(option, fmt::format("{:g} is not a factor from 1 to 100", factor),
                "give a geometric standard deviation; 1: no variation");
  }
  return std::log(factor);
}

/// Variances of differences between two methods.
struct Variances {
  double participants = 0.0;
  double scenes = 0.0;
  double residual = 0.0;
};

std::optional<Variances> mean_of(const std::vector<Variances>& all) {
  if (all.empty()) {
    return std::nullopt;
  }
  Variances mean;
  for (const Variances& one : all) {
    const auto count = static_cast<double>(all.size());
    mean.participants += one.participants / count;
    mean.scenes += one.scenes / count;
    mean.residual += one.residual / count;
  }
  return mean;
}

std::optional<Variances> variances_of(const std::vector<std::vector<std::optional<double>>>& rows,
                                      double unit) {
  const auto model = crossed_model(complete_participants(rows));
  if (!model) {
    return std::nullopt;
  }
  const double square = unit * unit;
  return Variances{model->participant_variance / square, model->scene_variance / square,
                   model->residual_variance / square};
}

/// Returns a pilot's values with the first method, of times their logarithms.
std::vector<std::vector<std::optional<double>>> baseline_values(const Dataset& set,
                                                                std::size_t measure) {
  std::vector<std::vector<std::optional<double>>> rows(set.participants.size());
  for (std::size_t participant = 0; participant < rows.size(); ++participant) {
    for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
      const Value& value = set.value(participant, scene, baseline, measure);
      const bool is_time = set.measures[measure].is_time();
      rows[participant].push_back(
          value.is_measured() ? std::optional(is_time ? std::log(value.number) : value.number)
                              : std::nullopt);
    }
  }
  return rows;
}

/// Estimates the spread from the measures' values and differences, in `unit_of(measure)`; parts
/// without data stay.
template <typename UnitOf>
void take_spread(const Dataset& set, const std::vector<std::size_t>& measures,
                 const UnitOf& unit_of, ExpectedSpread& spread) {
  std::vector<Variances> of_values;
  std::vector<Variances> of_gains;
  for (const std::size_t measure : measures) {
    const double unit = unit_of(measure);
    if (const auto own = variances_of(baseline_values(set, measure), unit)) {
      of_values.push_back(*own);
    }
    for (std::size_t method = baseline + 1; method < set.methods.size(); ++method) {
      const PairedTrials trials = paired_trials(set, measure, method, baseline);
      if (const auto gain = variances_of(trials.differences, unit)) {
        of_gains.push_back(*gain);
      }
    }
  }
  if (const auto own = mean_of(of_values)) {
    spread.participants = std::sqrt(own->participants);
    spread.scenes = std::sqrt(own->scenes);
  }
  if (const auto gain = mean_of(of_gains)) {
    spread.participants_gain = std::sqrt(gain->participants);
    spread.scenes_gain = std::sqrt(gain->scenes);
    spread.trials = std::sqrt(gain->residual / 2.0);
  }
}

double geometric_mean_of_baseline(const Dataset& set, std::size_t mark) {
  std::vector<double> logs;
  for (const auto& row : baseline_values(set, mark)) {
    for (const std::optional<double>& value : row) {
      if (value) {
        logs.push_back(*value);
      }
    }
  }
  if (logs.empty()) {
    throw Error(set.measures[mark].id(),
                fmt::format("the pilot has no time with {}", set.methods[baseline]),
                "state the times with --seconds");
  }
  return std::exp(*mean(logs));
}

/// Returns the logarithms of a mark's times with one method over those of the previous mark.
std::vector<double> log_steps(const Dataset& set, std::size_t before, std::size_t mark,
                              std::size_t method) {
  std::vector<double> logs;
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
      const Value& first = set.value(participant, scene, method, before);
      const Value& second = set.value(participant, scene, method, mark);
      if (first.is_measured() && second.is_measured()) {
        logs.push_back(std::log(second.number / first.number));
      }
    }
  }
  return logs;
}

/// Returns their coefficient of variation, within marks and methods; empty without any.
std::optional<double> later_marks_variation(const Dataset& set) {
  const std::vector<std::size_t> marks = set.marks();
  std::vector<double> relative;
  for (std::size_t mark = 1; mark < marks.size(); ++mark) {
    for (std::size_t method = 0; method < set.methods.size(); ++method) {
      const std::vector<double> logs = log_steps(set, marks[mark - 1], marks[mark], method);
      const double center = mean(logs).value_or(0.0);
      for (std::size_t i = 0; center > 0.0 && i < logs.size(); ++i) {
        relative.push_back(logs[i] / center);
      }
    }
  }
  return standard_deviation(relative);
}

/// `with_times`: whether to take the pilot's times, too.
void take_pilot(const study::StudyRecords& pilot, bool with_times, ExpectedStudy& expected) {
  const Dataset set = select_for_analysis(pilot);
  const std::vector<std::size_t> marks = set.marks();
  for (std::size_t mark = 0; with_times && mark < marks.size(); ++mark) {
    expected.times[mark].baseline_s = geometric_mean_of_baseline(set, marks[mark]);
  }
  take_spread(set, {marks.front()}, [](std::size_t) { return 1.0; }, expected.times_spread);
  expected.later_marks_variation =
      later_marks_variation(set).value_or(expected.later_marks_variation);
  take_spread(
      set, set.ratings(),
      [&](std::size_t rating) { return study::span_of(set.measures[rating].question).width(); },
      expected.ratings_spread);
  const auto withdrawn =
      std::ranges::count_if(pilot.sessions, [&](const study::SessionRow& session) {
        return session.kind == set.kind && session.state == "withdrawn";
      });
  expected.withdrawals =
      static_cast<double>(withdrawn) /
      static_cast<double>(withdrawn + static_cast<long>(set.participants.size()));
}

void take_baseline(const std::vector<double>& baseline_s, ExpectedStudy& expected) {
  if (baseline_s.size() > expected.times.size()) {
    throw Error("--seconds",
                fmt::format("{} times for {} marks", baseline_s.size(), expected.times.size()),
                "give one for each mark of the protocol, in their order");
  }
  for (std::size_t mark = 0; mark < expected.times.size(); ++mark) {
    expected.times[mark].baseline_s =
        mark < baseline_s.size() ? baseline_s[mark]
                                 : default_later_mark * expected.times[mark - 1].baseline_s;
    if (!(expected.times[mark].baseline_s > 0.0)) {
      throw Error("--seconds",
                  fmt::format("{:g} is not a time above 0", expected.times[mark].baseline_s),
                  "give a time in seconds");
    }
  }
}

void take_scenes(int count, study::Protocol& protocol) {
  while (static_cast<int>(protocol.scenes.size()) > count) {
    protocol.scenes.pop_back();
  }
  while (static_cast<int>(protocol.scenes.size()) < count) {
    protocol.scenes.push_back({.name = fmt::format("scene {}", protocol.scenes.size() + 1)});
  }
}

/// [rating][method]: whether an effect is expected.
using Stated = std::vector<std::vector<bool>>;

void take_measure(const MeasureExpectation& given, ExpectedStudy& expected, Stated& stated) {
  const study::Protocol& protocol = expected.protocol;
  const std::string where = fmt::format("--effect {}:{}", given.measure, given.method);
  const std::vector<std::string> names =
      transformed(study::trial_measures(protocol.marks, protocol.ratings),
                  [&](const Measure& measure) { return measure.id(); });
  const std::size_t measure = index_among(names, given.measure, where, "mark or rating");
  const std::size_t method = index_among(protocol.methods, given.method, where, "method");
  if (method == baseline) {
    throw Error(where, "this is the baseline", "give the effect of another method");
  }
  if (measure >= expected.times.size()) {
    const std::size_t rating = measure - expected.times.size();
    expected.shifts[rating][method] = given.value;
    stated[rating][method] = true;
    return;
  }
  if (!(given.value > 0.0)) {
    throw Error(where, fmt::format("{:g} % is not a share of a time", given.value),
                "give per cent of the first method's time, above 0");
  }
  expected.times[measure].ratios[method] = given.value / 100.0;
}

void require_marks_in_order(const ExpectedStudy& expected) {
  const study::Protocol& protocol = expected.protocol;
  for (std::size_t mark = 1; mark < expected.times.size(); ++mark) {
    for (std::size_t method = 0; method < protocol.methods.size(); ++method) {
      const auto seconds = [&](std::size_t of) {
        return expected.times[of].baseline_s * expected.times[of].ratios[method];
      };
      if (!(seconds(mark) > seconds(mark - 1))) {
        throw Error(
            protocol.marks[mark].id,
            fmt::format("with {} it would be expected after {:.3g} s, but {}, the previous mark, "
                        "after {:.3g} s",
                        protocol.methods[method], seconds(mark), protocol.marks[mark - 1].id,
                        seconds(mark - 1)),
            "change --seconds or --effect so that marks are in order");
      }
    }
  }
}

/// Planned comparisons must have an expected difference.
void require_effects(const ExpectedStudy& expected, const Stated& stated) {
  const study::Protocol& protocol = expected.protocol;
  if (protocol.analysis.primary.empty()) {
    throw Error(protocol.name, "has an analysis plan without comparisons",
                "add [[analysis.primary]] with measure, method and baseline");
  }
  const std::vector<Measure> measures = study::trial_measures(protocol.marks, protocol.ratings);
  for (const study::PlannedComparison& planned : protocol.analysis.primary) {
    std::size_t measure = 0;
    while (measures[measure].id() != planned.measure) {
      ++measure;
    }
    const std::size_t method = index_among(protocol.methods, planned.method, "plan", "method");
    const std::size_t other = index_among(protocol.methods, planned.baseline, "plan", "method");
    const auto difference = [&] {
      if (measure < expected.times.size()) {
        const std::vector<double>& ratios = expected.times[measure].ratios;
        return ratios[method] != ratios[other];
      }
      const std::size_t rating = measure - expected.times.size();
      return stated[rating][method] || stated[rating][other];
    };
    if (!difference()) {
      throw Error(
          fmt::format("{}, {} against {}", planned.measure, planned.method, planned.baseline),
          "this planned comparison has no expected difference",
          fmt::format("state it, as --effect {}:{}:{}", planned.measure, planned.method,
                      measure < expected.times.size() ? "25" : "1"));
    }
  }
}

}  // namespace

MeasureExpectation parse_expectation(const std::string& text) {
  const std::size_t first = text.find(':');
  const std::size_t last = text.rfind(':');
  const auto value =
      last == std::string::npos ? std::nullopt : number_in(std::string_view(text).substr(last + 1));
  if (first == last || first == 0 || last == first + 1 || !value) {
    throw UsageError(
        "--effect", fmt::format("'{}' is not MEASURE:METHOD:VALUE", text),
        "give a mark, a method and per cent of the first method's time, for "
        "example material:fv:25; or a rating, a method and points, for example comfort:fv:1");
  }
  return {text.substr(0, first), text.substr(first + 1, last - first - 1), *value};
}

ExpectedStudy expect(const study::Protocol& protocol, const Expectations& expectations,
                     const study::StudyRecords* pilot) {
  ExpectedStudy expected;
  expected.protocol = protocol;
  const std::size_t methods = protocol.methods.size();
  if (!(expectations.ratio_percent > 0.0)) {
    throw Error("--ratio",
                fmt::format("{:g} % is not a share of a time", expectations.ratio_percent),
                "give per cent of the first method's time, above 0");
  }
  ExpectedTimes times{.ratios = std::vector<double>(methods, expectations.ratio_percent / 100.0)};
  times.ratios[baseline] = 1.0;
  expected.times.assign(protocol.marks.size(), times);
  expected.shifts.assign(protocol.ratings.size(), std::vector<double>(methods, 0.0));
  take_baseline({default_first_mark_s}, expected);
  if (pilot != nullptr) {
    take_pilot(*pilot, !expectations.baseline_s, expected);
  }
  if (expectations.baseline_s) {
    take_baseline(*expectations.baseline_s, expected);
  }
  ExpectedSpread& spread = expected.times_spread;
  if (const auto factor = expectations.participants_factor) {
    spread.participants_gain = sd_of(*factor, "--spread");
  }
  if (const auto factor = expectations.scenes_factor) {
    spread.scenes_gain = sd_of(*factor, "--scene-spread");
  }
  if (const auto factor = expectations.trials_factor) {
    spread.trials = sd_of(*factor, "--trial-spread");
  }
  expected.later_marks_variation =
      expectations.mark_variation.value_or(expected.later_marks_variation);
  expected.withdrawals = expectations.withdrawals.value_or(expected.withdrawals);
  if (expectations.scenes) {
    take_scenes(*expectations.scenes, expected.protocol);
  }
  Stated stated(protocol.ratings.size(), std::vector<bool>(methods, false));
  for (const MeasureExpectation& given : expectations.measures) {
    take_measure(given, expected, stated);
  }
  require_marks_in_order(expected);
  require_effects(expected, stated);
  return expected;
}

}  // namespace foveola::analysis
