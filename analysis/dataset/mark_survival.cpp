#include "analysis/dataset/mark_survival.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analysis/dataset/participant_values.h"
#include "analysis/dataset/wording.h"
#include "analysis/statistics/models/additive_fit.h"
#include "renderer/base/transformed.h"

namespace foveola::analysis {
namespace {

std::vector<TimeToMark> times_to(const Dataset& set, std::size_t mark, std::size_t method) {
  std::vector<TimeToMark> times;
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
      const Value& value = set.value(participant, scene, method, mark);
      if (value.is_measured() || value.state == Value::State::right_censored) {
        times.push_back({value.number, !value.is_measured()});
      }
    }
  }
  return times;
}

std::optional<Interval> limits_of(const std::vector<TimeToMark>& times) {
  std::optional<Interval> limits;
  for (const TimeToMark& time : times) {
    if (time.censored) {
      limits = limits
                   ? Interval{std::min(limits->low, time.time), std::max(limits->high, time.time)}
                   : Interval{time.time, time.time};
    }
  }
  return limits;
}

/// Returns the common horizon; empty without times.
std::optional<double> horizon_of(const std::vector<std::vector<TimeToMark>>& by_method) {
  std::optional<double> longest;
  std::optional<double> earliest_limit;
  for (const std::vector<TimeToMark>& times : by_method) {
    for (const TimeToMark& time : times) {
      longest = std::max(longest.value_or(0.0), time.time);
    }
    if (const std::optional<Interval> limits = limits_of(times)) {
      earliest_limit = std::min(earliest_limit.value_or(limits->low), limits->low);
    }
  }
  return earliest_limit ? earliest_limit : longest;
}

}  // namespace

std::vector<MarkSurvival> mark_survival(const Dataset& set) {
  std::vector<MarkSurvival> survival;
  for (const std::size_t mark : set.marks()) {
    std::vector<std::vector<TimeToMark>> by_method;
    for (std::size_t method = 0; method < set.methods.size(); ++method) {
      by_method.push_back(times_to(set, mark, method));
    }
    const std::optional<double> horizon = horizon_of(by_method);
    for (std::size_t method = 0; method < set.methods.size(); ++method) {
      MarkSurvival& row = survival.emplace_back();
      row.mark = set.measures[mark].id();
      row.method = set.methods[method];
      row.curve = kaplan_meier(by_method[method]);
      if (horizon && *horizon > 0.0) {
        row.restricted = restricted_mean(row.curve, *horizon);
      }
      row.censored_range_s = limits_of(by_method[method]);
    }
  }
  return survival;
}

std::vector<std::string> unreached_in_words(const std::vector<MarkSurvival>& survival) {
  std::vector<std::string> sentences;
  for (const MarkSurvival& row : survival) {
    if (row.censored_range_s) {
      const std::string limit = row.censored_range_s->low == row.censored_range_s->high
                                    ? fmt::format("{:.3g} s", row.censored_range_s->low)
                                    : fmt::format("{:.3g} to {:.3g} s", row.censored_range_s->low,
                                                  row.censored_range_s->high);
      sentences.push_back(fmt::format("{} did not reach the mark {} within {} in {} of {} trials.",
                                      method_label(row.method), row.mark, limit, row.curve.censored,
                                      row.curve.n));
    }
  }
  return sentences;
}

std::vector<OutlyingTime> outlying_times(const Dataset& set) {
  std::vector<OutlyingTime> outlying;
  for (const std::size_t mark : set.times()) {
    const std::vector<TrialValue> logs =
        transformed(ordered_values(set, mark, OrderOf::trials), [&](const OrderedValue& value) {
          return TrialValue{value.participant, value.condition, value.value};
        });
    for (const ResidualOutlier& outlier : residual_outliers(logs)) {
      const TrialValue& trial = logs[outlier.index];
      outlying.push_back({.mark = set.measures[mark].id(),
                          .participant = set.participants[trial.participant],
                          .scene = set.scenes[trial.condition / set.methods.size()],
                          .method = set.methods[trial.condition % set.methods.size()],
                          .seconds = std::exp(trial.value),
                          .ratio_to_expected = std::exp(outlier.deviation),
                          .studentized = outlier.studentized});
    }
  }
  return outlying;
}

}  // namespace foveola::analysis
