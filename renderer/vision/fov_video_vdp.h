// FovVideoVDP: the difference that a person sees between two pictures or sequences, by where they
// look.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "renderer/base/work/parallel.h"
#include "renderer/image/image.h"
#include "renderer/vision/vdp_sensitivity.h"

namespace foveola {

/// A flat display before the eye. A picture of any size covers all of it.
struct VdpDisplay {
  double pixels_per_degree = 0.0;  ///< in its middle; above 0
  Vec2 half_size{0.0F};            ///< over its distance: tangents of half its fields of view
  double white_cd_m2 = 0.0;        ///< above black_cd_m2
  double black_cd_m2 = 0.0;        ///< reflections included; 0 or more
};

/// Rates picture against reference in just-objectionable differences (Mantiuk et al. 2021,
/// "FovVideoVDP: A visible difference predictor for wide field-of-view video", ACM TOG 40(4), with
/// the constants of version 1.2): 10 where no difference is seen, 1 less where three of four people
/// prefer the reference over it as they prefer it over one that is again 1 less.
class FovVideoVdp {
 public:
  /// fixation_px: where the eye looks, from the picture's upper left corner; none: everywhere, so
  /// that nothing is foveated. rate_hz: of a sequence, in (0, 1000]; none: still pictures. Throws
  /// Error for a display, size or rate that makes no sense, or a fixation outside.
  FovVideoVdp(const VdpDisplay& display, const IVec2& size, const std::optional<Vec2>& fixation_px,
              const std::optional<double>& rate_hz, const Workers& workers);
  ~FovVideoVdp();

  /// Adds a frame. Both are sRGB-encoded in [0, 1], as the display is given them. A sequence is
  /// taken to have shown its first frame before. Throws Error for another size, or values that are
  /// not finite.
  void add(const RgbImage& image, const RgbImage& reference);

  /// The quality over the frames so far, at least one, in JOD: at most 10.
  double jod() const;

 private:
  using Luminance = std::vector<float>;  ///< cd/m2 of each pixel, row by row
  struct Band;
  struct Level;
  using Pyramid = std::vector<Level>;  ///< one for each band, the finest first

  Luminance luminance_of(const RgbImage& image) const;
  Pyramid pyramid_of(Luminance luminance) const;
  /// Of the last frames, the newest first, as a channel sees them.
  Pyramid seen_by(VdpChannel channel, const std::deque<Luminance>& frames) const;
  float sensitivity(const VdpSensitivityTable& table, const Band& band, int x, int y,
                    float background_cd_m2) const;
  /// background: what the eye is adapted to.
  double channel_difference(VdpChannel channel, const Pyramid& image, const Pyramid& reference,
                            const Pyramid& background) const;

  VdpDisplay display_;
  IVec2 size_;
  const Workers& workers_;
  std::optional<Vec2> fixation_deg_;  ///< from the display's middle
  float half_pixel_;                  ///< tangent of half a pixel, in the display's middle
  std::vector<Band> bands_;
  /// By VdpChannel, as filters_ is; still pictures have the sustained one alone.
  std::vector<VdpSensitivityTable> sensitivity_;
  std::vector<std::vector<float>> filters_;
  std::deque<Luminance> images_;  ///< newest first, as many as filters have weights
  std::deque<Luminance> references_;
  double sum_ = 0.0;  ///< of the frames' differences
  int frames_ = 0;
};

}  // namespace foveola
