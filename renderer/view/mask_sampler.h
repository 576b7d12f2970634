// Samples by a painted mask of importance.
#pragma once

#include <filesystem>
#include <optional>

#include "renderer/base/piecewise_constant.h"
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

}  // namespace foveola
