// Measurements whose laws are known: squared errors of noise / samples, seconds of cost x samples.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "analysis/convergence/measurement.h"

namespace foveola::analysis {

struct MadeUpConfiguration {
  std::string name;
  double noise = 1.0;       ///< squared error of one sample
  double cost_s = 1e-6;     ///< seconds for one sample
  double decay = 1.0;       ///< exponent of the squared error in samples
  double per_pixel = 1e-3;  ///< a region's samples per pixel, of one sample
};

/// One region, "5deg", seen by FLIP too: the root of the squared error. Checkpoints at 1000, 2000,
/// ..., 64000 samples. Repetition r has the seed r and is
/// r * spread noisier than the first.
inline GazeMeasurement made_up_measurement(const std::vector<MadeUpConfiguration>& configurations,
                                           std::size_t repetitions, double spread = 0.0) {
  GazeMeasurement measurement{.scene = "aula",
                              .scene_sha256 = "aula's",
                              .gaze = "10,0",
                              .configurations = {},
                              .regions = {"5deg"},
                              .predicted = {},
                              .repetitions = {}};
  for (const MadeUpConfiguration& configuration : configurations) {
    measurement.configurations.push_back(configuration.name);
    measurement.predicted.push_back({configurations.front().noise / configuration.noise});
  }
  for (std::size_t repetition = 0; repetition < repetitions; ++repetition) {
    Repetition logs;
    for (const MadeUpConfiguration& configuration : configurations) {
      RenderLog log;
      log.seed = static_cast<std::uint32_t>(repetition);
      for (std::uint64_t samples = 1000; samples <= 64000; samples *= 2) {
        const auto count = static_cast<double>(samples);
        Score score;
        score.error.mse = configuration.noise * (1.0 + spread * static_cast<double>(repetition)) *
                          std::pow(count, -configuration.decay);
        score.error.relative_mse = 2.0 * score.error.mse;
        score.error.samples_per_pixel = configuration.per_pixel * count;
        score.error.pixels = 100;
        score.flip = std::sqrt(score.error.mse);
        log.checkpoints.push_back(
            {.samples = samples, .seconds = configuration.cost_s * count, .scores = {score}});
      }
      logs.push_back(log);
    }
    measurement.repetitions.push_back(logs);
  }
  return measurement;
}

}  // namespace foveola::analysis
