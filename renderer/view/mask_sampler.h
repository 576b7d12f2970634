// Samplers by a picture: a mask of importance, and a map that follows the gaze (Pohl et al. 2016).
#pragma once

#include <filesystem>
#include <optional>

#include "renderer/base/piecewise_constant.h"
#include "renderer/view/gaze_frame.h"
#include "renderer/view/view_sampler.h"
#include "renderer/view/weight_image.h"

namespace foveola {

/// A painting over the whole equirect image, of any size. It may be painted on while it is in use:
/// aim() reads the file anew where it changed. What cannot be read at that moment, because the file
/// is half-written, gone or bad, leaves the last good painting in place until it changes again.
///
/// Rows and columns are chosen by their running sums. Alias tables would choose them in constant
/// time, but they cut the unit square into pieces that lie elsewhere in the image, so that
/// well-distributed points would no longer be so; here neighbours stay neighbours.
class MaskSampler final : public ViewSampler {
 public:
  /// floor: what every pixel weighs more, as a multiple of the mean weight; >= 0. Throws Error as
  /// read_weights.
  MaskSampler(std::filesystem::path path, double floor);
  /// For a painting that stays as it is.
  MaskSampler(WeightImage image, double floor);

  void aim(const Aim& aim) override;
  void sample(std::span<const Vec2> points, std::span<ViewSample> samples) const override;
  double density_per_sr(const Vec3& direction) const override;

 private:
  /// What a change of the file is noticed by.
  struct Stamp {
    std::filesystem::file_time_type written;
    std::uintmax_t bytes = 0;
    bool operator==(const Stamp&) const = default;
  };
  /// A painting that was read.
  struct Painting {
    int width = 0;
    int height = 0;
    PiecewiseConstant2D pixels;
  };

  std::optional<Stamp> stamp() const;
  Painting painting_of(WeightImage image) const;

  std::filesystem::path path_;  ///< empty: none is read anew
  double floor_;
  std::optional<Stamp> read_at_;
  Painting painting_;
};

/// An image around the gaze in the azimuthal equidistant projection: the distance from its middle
/// is the eccentricity, up is the head's up. Its pixels are alike in planar square degrees.
class MapSampler final : public ViewSampler {
 public:
  /// extent_deg: the eccentricity at half of the image's larger side, in (0, 179]. Pixels that
  /// reach beyond 179 degrees weigh nothing. Throws Error if no other has any weight.
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
