#include "analysis/statistics/repeated_measures.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include <boost/math/distributions/fisher_f.hpp>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {
namespace {

/// Returns the data less the participants' means: within-participant tests depend on nothing else,
/// and large common offsets vanish.
std::vector<long double> centered_by_participant(const RepeatedMeasures& data) {
  std::vector<long double> centered;
  centered.reserve(data.values.size());
  for (std::size_t participant = 0; participant < data.participants; ++participant) {
    const std::span<const double> row = data.of(participant);
    const long double mean = extended_mean(row);
    for (const double value : row) {
      centered.push_back(value - mean);
    }
  }
  return centered;
}

struct SumsOfSquares {
  long double conditions = 0.0L;
  long double residual = 0.0L;
  std::vector<long double> residuals;  ///< [participant][condition], free of both means
};

SumsOfSquares sums_of_squares(const RepeatedMeasures& data) {
  SumsOfSquares sums;
  sums.residuals = centered_by_participant(data);
  const auto n = static_cast<long double>(data.participants);
  for (std::size_t condition = 0; condition < data.conditions; ++condition) {
    long double mean = 0.0L;
    for (std::size_t participant = 0; participant < data.participants; ++participant) {
      mean += sums.residuals[participant * data.conditions + condition] / n;
    }
    sums.conditions += n * mean * mean;
    for (std::size_t participant = 0; participant < data.participants; ++participant) {
      long double& residual = sums.residuals[participant * data.conditions + condition];
      residual -= mean;
      sums.residual += residual * residual;
    }
  }
  return sums;
}

/// Returns tr(S)^2 / ((k - 1) tr(S S)) of the double-centred covariance matrix S, that of
/// residuals. Only ratios count, so S is not divided.
double greenhouse_geisser_epsilon(const RepeatedMeasures& data, const SumsOfSquares& sums) {
  const std::size_t k = data.conditions;
  long double squares = 0.0L;
  for (std::size_t a = 0; a < k; ++a) {
    for (std::size_t b = 0; b < k; ++b) {
      long double covariance = 0.0L;
      for (std::size_t participant = 0; participant < data.participants; ++participant) {
        covariance += sums.residuals[participant * k + a] * sums.residuals[participant * k + b];
      }
      squares += covariance * covariance;
    }
  }
  const auto degrees = static_cast<double>(k - 1);
  const auto epsilon = static_cast<double>(sums.residual / squares * sums.residual) / degrees;
  return std::clamp(epsilon, 1.0 / degrees, 1.0);
}

/// Returns Huynh and Feldt's epsilon of one group of n participants, from Greenhouse and Geisser's
/// e: (n (k - 1) e - 2) / ((k - 1) (n - 1 - (k - 1) e)).
double huynh_feldt_epsilon(const RepeatedMeasures& data, double greenhouse_geisser) {
  if (data.participants == 2) {  // one direction of residuals, whose epsilon needs no correction
    return greenhouse_geisser;
  }
  const auto n = static_cast<double>(data.participants);
  const auto degrees = static_cast<double>(data.conditions - 1);
  const double denominator = degrees * (n - 1.0 - degrees * greenhouse_geisser);
  // With no more participants than conditions it may vanish: the limit is above 1.
  return denominator > 0.0 ? std::clamp((n * degrees * greenhouse_geisser - 2.0) / denominator,
                                        greenhouse_geisser, 1.0)
                           : 1.0;
}

double f_tail(double f, double numerator_degrees, double denominator_degrees) {
  const boost::math::fisher_f distribution(numerator_degrees, denominator_degrees);
  return boost::math::cdf(boost::math::complement(distribution, f));
}

bool is_rounding(const RepeatedMeasures& data, long double residual) {
  long double largest = 0.0L;
  for (const double value : data.values) {
    largest = std::max(largest, value < 0.0 ? -static_cast<long double>(value) : value);
  }
  const long double step = largest * std::numeric_limits<double>::epsilon();
  return residual <= step * step * static_cast<long double>(data.values.size());
}

}  // namespace

RepeatedMeasures complete_participants(
    const std::vector<std::vector<std::optional<double>>>& rows) {
  RepeatedMeasures data;
  data.conditions = rows.empty() ? 0 : rows.front().size();
  for (const auto& row : rows) {
    assert(row.size() == data.conditions);
    if (std::ranges::all_of(row, [](const auto& value) { return value.has_value(); })) {
      ++data.participants;
      for (const std::optional<double>& value : row) {
        data.values.push_back(*value);
      }
    }
  }
  return data;
}

std::optional<VarianceAnalysis> repeated_measures_anova(const RepeatedMeasures& data) {
  assert(data.values.size() == data.participants * data.conditions);
  if (data.participants < 2 || data.conditions < 2) {
    return std::nullopt;
  }
  const SumsOfSquares sums = sums_of_squares(data);
  if (is_rounding(data, sums.residual)) {
    return std::nullopt;
  }
  VarianceAnalysis result;
  result.participants = data.participants;
  result.conditions = data.conditions;
  result.degrees_of_freedom = static_cast<double>(data.conditions - 1);
  result.residual_degrees_of_freedom =
      result.degrees_of_freedom * static_cast<double>(data.participants - 1);
  result.f = static_cast<double>(sums.conditions / sums.residual) *
             static_cast<double>(data.participants - 1);
  result.p = f_tail(result.f, result.degrees_of_freedom, result.residual_degrees_of_freedom);
  result.greenhouse_geisser = greenhouse_geisser_epsilon(data, sums);
  result.p_greenhouse_geisser =
      f_tail(result.f, result.greenhouse_geisser * result.degrees_of_freedom,
             result.greenhouse_geisser * result.residual_degrees_of_freedom);
  result.huynh_feldt = huynh_feldt_epsilon(data, result.greenhouse_geisser);
  result.p_huynh_feldt = f_tail(result.f, result.huynh_feldt * result.degrees_of_freedom,
                                result.huynh_feldt * result.residual_degrees_of_freedom);
  result.partial_eta_squared =
      static_cast<double>(sums.conditions / (sums.conditions + sums.residual));
  return result;
}

}  // namespace foveola::analysis
