// A pilot render: the samples of a method as they really fall, traced only where they will be
// judged, to know how noisy that is after how many of them.
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

/// What is rendered and how it is shown.
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

/// When a pilot is looked at: after about so many samples a pixel, in the geometric mean over the
/// view's judged patches, growing by half an octave from level to level.
struct SampleCountLevels {
  double first_per_pixel = 1.0 / 32.0;
  int count = 15;  ///< up to 4 samples per pixel, beyond which noise falls as one over the samples
};

/// The means of cells in a picture, of each view on each scale.
using CellMeans = std::vector<std::vector<std::vector<ChannelValues>>>;
/// The tables of one view, on each scale.
using ScaleTables = std::vector<NoiseTable>;

/// What views converge to, in two images whose noise is independent, so that they need few samples:
/// see ExpectedMeans.
struct ConvergedMeans {
  CellMeans first;
  CellMeans second;
};

/// What the views converge to, by a sampler that was aimed and is uniform over the image where they
/// are, around `middle`, where a pixel gets so many samples for each of the two; only the mask's
/// pixels are traced. A display shows noisy pixels darker or lighter than their mean, by as much as
/// one over their samples: what it shows after half of them tells how much, and this is taken away.
/// The noise is independent of every pilot's. Throws Error if stopped.
ConvergedMeans converged_means(const PilotSetting& setting, const ViewSampler& sampler,
                               const Vec3& middle, double per_pixel, const SampleMask& mask,
                               std::span<const JudgedView> views);

/// The tables of each view, of the patches that have pixels in it, for one picture: each `picture`
/// has other random numbers. expected: of the same views. A view's tables do not depend on which
/// others are made with it. Throws Error if stopped.
std::vector<ScaleTables> measure_noise(const PilotSetting& setting, const ViewSampler& sampler,
                                       const SampleCountLevels& levels, std::uint32_t picture,
                                       const SampleMask& mask, std::span<const JudgedView> views,
                                       const ConvergedMeans& expected);

}  // namespace foveola::study
