// Samplers by an image: an importance mask, and a map that follows the gaze (Pohl et al. 2016).
#pragma once

#include <filesystem>
#include <optional>

#include "renderer/base/numbers/piecewise_constant.h"
#include "renderer/view/gaze_frame.h"
#include "renderer/view/view_sampler.h"
#include "renderer/view/weight_image.h"

namespace foveola {

/// A mask over the whole equirect image, of any size. It may be edited while in use: aim() reloads
/// a changed file. If the file is then incomplete, missing or bad, the last good mask stays until
/// the next change.
///
/// Rows and columns are chosen by their cumulative sums. Alias tables would take constant time, but
/// would scatter parts of the unit square over the image. Here neighbours stay neighbours, and
/// well-distributed points stay so.
class MaskSampler final : public ViewSampler {
 public:
  /// floor: weight added to every pixel, as a multiple of the mean weight; >= 0. Throws Error as
  /// read_weights.
  MaskSampler(std::filesystem::path path, double floor);
  /// For a mask that does not change.
  MaskSampler(WeightImage image, double floor);

  void aim(const Aim& aim) override;
  void sample(std::span<const Vec2> points, std::span<ViewSample> samples) const override;
  double density_per_sr(const Vec3& direction) const override;

 private:
  /// A file's properties that reveal a change.
  struct Stamp {
    std::filesystem::file_time_type written;
    std::uintmax_t bytes = 0;
    bool operator==(const Stamp&) const = default;
  };
  /// A mask in memory.
  struct Painting {
    int width = 0;
    int height = 0;
    PiecewiseConstant2D pixels;
  };

  std::optional<Stamp> stamp() const;
  Painting painting_of(WeightImage image) const;

  std::filesystem::path path_;  ///< empty: never reloaded
  double floor_;
  std::optional<Stamp> read_at_;
  Painting painting_;
};

/// An image around the gaze in the azimuthal equidistant projection: the distance from its centre
/// is the eccentricity, up is the head's up. Its pixels have equal planar square degrees.
class MapSampler final : public ViewSampler {
 public:
  /// extent_deg: the eccentricity at half of the image's larger side, in (0, 179]. Pixels beyond
  /// 179 degrees have weight 0. Throws Error if all weights are 0.
  MapSampler(WeightImage image, double extent_deg);

  void aim(const Aim& aim) override;
  void sample(std::span<const Vec2> points, std::span<ViewSample> samples) const override;
  double density_per_sr(const Vec3& direction) const override;

 private:
  int width_;
  int height_;
  double degrees_per_pixel_;
  PiecewiseConstant2D pixels_;
  GazeFrame gaze_;
};

}  // namespace foveola
