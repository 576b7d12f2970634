// Renders pilots: the samples of a method as they really fall, traced only where they are judged,
// to measure the noise after each number of samples.
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "renderer/film/shown_color.h"
#include "renderer/trace/paths/path_tracer.h"
#include "study/prediction/judged_view.h"
#include "study/prediction/noise_table.h"
#include "study/prediction/sample_mask.h"

namespace foveola::study {

/// Inputs of a pilot and its display.
struct PilotSetting {
  const PathTracer& tracer;
  const Workers& workers;
  Vec3 viewpoint{0.0F};
  FilmSettings film;
  UnsampledPixels unsampled = UnsampledPixels::black;
  double exposure_stops = 0.0;
  double jnd_lab = 0.0;
  std::stop_token stop;
};

/// Sample counts at which a pilot is judged: about this many samples per pixel, in the geometric
/// mean over the view's judged patches, growing by half an octave per level.
struct SampleCountLevels {
  double first_per_pixel = 1.0 / 32.0;
  int count = 15;  ///< up to 4 samples per pixel, beyond which noise falls as one over the samples
};

/// Means of cells in a picture: [view][scale][cell].
using CellMeans = std::vector<std::vector<std::vector<ChannelValues>>>;
/// The tables of one view, one per scale.
using ScaleTables = std::vector<NoiseTable>;

/// Converged cell means in two images with independent noise, so that they need few samples: see
/// ExpectedMeans.
struct ConvergedMeans {
  CellMeans first;
  CellMeans second;
};

/// Returns the converged means of the views, by a sampler that was aimed and is uniform over the
/// image around `middle`, with the given samples per pixel for each of the two. Only the mask's
/// pixels are traced. A display shows noisy pixels darker or lighter than their mean, with a bias
/// of one over their samples; the image after half of them estimates the bias, which is subtracted.
/// The noise is independent of every pilot's. Throws Error if stopped.
ConvergedMeans converged_means(const PilotSetting& setting, const ViewSampler& sampler,
                               const Vec3& middle, double per_pixel, const SampleMask& mask,
                               std::span<const JudgedView> views);

/// Returns the tables of each view, for its patches with pixels, for one picture: each `picture`
/// has other random numbers. expected: of the same views. A view's tables do not depend on the
/// other views. Throws Error if stopped.
std::vector<ScaleTables> measure_noise(const PilotSetting& setting, const ViewSampler& sampler,
                                       const SampleCountLevels& levels, std::uint32_t picture,
                                       const SampleMask& mask, std::span<const JudgedView> views,
                                       const ConvergedMeans& expected);

}  // namespace foveola::study
