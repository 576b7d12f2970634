#include "analysis/statistics/models/crossed_model.h"

#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "analysis/statistics/distributions.h"
#include "analysis/statistics/logarithms.h"

namespace foveola::analysis {
namespace {

struct Stratum {
  long double squares = 0.0L;
  long double degrees = 0.0L;

  long double mean_square() const { return squares / degrees; }
};

/// Strata of the two-way layout. A factor with variance 0 is pooled with the residual: its stratum
/// is empty.
struct Strata {
  std::size_t participant_count = 0;
  std::size_t scene_count = 0;
  long double mean = 0.0L;
  std::optional<Stratum> participants;
  std::optional<Stratum> scenes;
  Stratum residual;
};

std::vector<long double> column_means(const RepeatedMeasures& data) {
  std::vector<long double> means(data.conditions, 0.0L);
  for (std::size_t participant = 0; participant < data.participants; ++participant) {
    for (std::size_t scene = 0; scene < data.conditions; ++scene) {
      means[scene] += data.at(participant, scene);
    }
  }
  for (long double& mean : means) {
    mean /= static_cast<long double>(data.participants);
  }
  return means;
}

/// Returns strata with their degrees of freedom, without squares.
Strata empty_strata(std::size_t participant_count, std::size_t scene_count) {
  const long double participants = static_cast<long double>(participant_count) - 1.0L;
  const long double scenes = static_cast<long double>(scene_count) - 1.0L;
  return {participant_count,           scene_count,           0.0L,
          Stratum{0.0L, participants}, Stratum{0.0L, scenes}, Stratum{0.0L, participants * scenes}};
}

Strata analyse_variance(const RepeatedMeasures& data) {
  const auto participants = static_cast<long double>(data.participants);
  const auto scenes = static_cast<long double>(data.conditions);
  const std::vector<long double> scene_means = column_means(data);
  Strata strata = empty_strata(data.participants, data.conditions);
  strata.mean = extended_mean(data.values);
  for (const long double mean : scene_means) {
    strata.scenes->squares += participants * (mean - strata.mean) * (mean - strata.mean);
  }
  for (std::size_t participant = 0; participant < data.participants; ++participant) {
    const long double effect = extended_mean(data.of(participant)) - strata.mean;
    strata.participants->squares += scenes * effect * effect;
    for (std::size_t scene = 0; scene < data.conditions; ++scene) {
      const long double residual = data.at(participant, scene) - scene_means[scene] - effect;
      strata.residual.squares += residual * residual;
    }
  }
  return strata;
}

bool is_below_residual(const std::optional<Stratum>& factor, const Stratum& residual) {
  return factor && factor->mean_square() < residual.mean_square();
}

void pool(std::optional<Stratum>& factor, Stratum& residual) {
  residual.squares += factor->squares;
  residual.degrees += factor->degrees;
  factor.reset();
}

/// Pools factors whose mean square is below the residual's, the smaller first: the other may be
/// above it afterwards.
void pool_negative_components(Strata& strata) {
  std::optional<Stratum>* first = &strata.participants;
  std::optional<Stratum>* second = &strata.scenes;
  if (second->value().mean_square() < first->value().mean_square()) {
    std::swap(first, second);
  }
  for (std::optional<Stratum>* factor : {first, second}) {
    if (is_below_residual(*factor, strata.residual)) {
      pool(*factor, strata.residual);
    }
  }
}

/// A linear combination of independent mean squares.
struct Combination {
  long double value = 0.0L;
  long double variance = 0.0L;  ///< Half of its estimated variance.

  void add(long double coefficient, const Stratum& stratum) {
    const long double term = coefficient * stratum.mean_square();
    value += term;
    variance += term * term / stratum.degrees;
  }
  double satterthwaite() const { return static_cast<double>(value * value / variance); }
};

/// Returns participants x scenes times the variance of the mean.
Combination variance_of_mean(const Strata& strata) {
  Combination sum;
  long double factors = 0.0L;
  for (const std::optional<Stratum>& factor : {strata.participants, strata.scenes}) {
    if (factor) {
      sum.add(1.0L, *factor);
      factors += 1.0L;
    }
  }
  if (factors != 1.0L) {  // a single factor's mean square is the whole
    sum.add(1.0L - factors, strata.residual);
  }
  return sum;
}

double component(const std::optional<Stratum>& factor, const Stratum& residual,
                 std::size_t repetitions) {
  return factor ? static_cast<double>((factor->mean_square() - residual.mean_square()) /
                                      static_cast<long double>(repetitions))
                : 0.0;
}

CrossedModel model_of(Strata strata, double confidence) {
  pool_negative_components(strata);
  CrossedModel model;
  model.participants = strata.participant_count;
  model.scenes = strata.scene_count;
  model.mean = static_cast<double>(strata.mean);
  model.participant_variance = component(strata.participants, strata.residual, strata.scene_count);
  model.scene_variance = component(strata.scenes, strata.residual, strata.participant_count);
  model.residual_variance = static_cast<double>(strata.residual.mean_square());
  const Combination variance = variance_of_mean(strata);
  const auto standard_error = static_cast<double>(std::sqrt(
      variance.value / static_cast<long double>(strata.participant_count * strata.scene_count)));
  if (standard_error <= rounding_of_logarithms) {
    return model;
  }
  CrossedTest test;
  test.standard_error = standard_error;
  test.degrees_of_freedom = variance.satterthwaite();
  test.t = model.mean / standard_error;
  test.p = student_t_two_sided(test.t, test.degrees_of_freedom);
  const double half_width =
      student_t_quantile(confidence, test.degrees_of_freedom) * standard_error;
  test.interval = {model.mean - half_width, model.mean + half_width};
  model.test = test;
  return model;
}

}  // namespace

std::optional<CrossedModel> crossed_model(const RepeatedMeasures& log_ratios, double confidence) {
  assert(log_ratios.values.size() == log_ratios.participants * log_ratios.conditions);
  if (log_ratios.participants < 2 || log_ratios.conditions < 2) {
    return std::nullopt;
  }
  return model_of(analyse_variance(log_ratios), confidence);
}

std::optional<LeaveOneOut> leave_one_out(
    std::span<const double> values,
    const std::function<double(std::span<const double>)>& estimate) {
  if (values.size() < 2) {
    return std::nullopt;
  }
  // The first value is left out first; then each replaces the next.
  std::vector<double> others(values.begin() + 1, values.end());
  const double first = estimate(others);
  LeaveOneOut range{.estimates = {first, first}};
  for (std::size_t i = 1; i < values.size(); ++i) {
    others[i - 1] = values[i - 1];
    const double without = estimate(others);
    if (without < range.estimates.low) {
      range.estimates.low = without;
      range.without_low = i;
    }
    if (without > range.estimates.high) {
      range.estimates.high = without;
      range.without_high = i;
    }
  }
  return range;
}

}  // namespace foveola::analysis
