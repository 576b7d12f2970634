// FovVideoVDP: the visible difference between two pictures or sequences, given the fixation.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "renderer/base/work/parallel.h"
#include "renderer/image/image.h"
#include "renderer/vision/vdp_sensitivity.h"

namespace foveola {

/// A flat display before the eye. A picture of any size fills it.
struct VdpDisplay {
  double pixels_per_degree = 0.0;  ///< in its centre; above 0
  Vec2 half_size{0.0F};            ///< divided by its distance: tangents of half its fields of view
  double white_cd_m2 = 0.0;        ///< above black_cd_m2
  double black_cd_m2 = 0.0;        ///< reflections included; 0 or more
};

/// Rates picture against reference in just-objectionable differences (Mantiuk et al. 2021,
/// "FovVideoVDP: A visible difference predictor for wide field-of-view video", ACM TOG 40(4), with
/// the constants of version 1.2): 10 for no visible difference. Of two pictures 1 apart, three of
/// four people prefer the better.
class FovVideoVdp {
 public:
  /// fixation_px: the fixation from the picture's upper left corner; nullopt: everywhere, without
  /// foveation. rate_hz: of a sequence, in (0, 1000]; nullopt: still pictures. Throws Error for an
  /// invalid display, size or rate, or a fixation outside.
  FovVideoVdp(const VdpDisplay& display, const IVec2& size, const std::optional<Vec2>& fixation_px,
              const std::optional<double>& rate_hz, const Workers& workers);
  ~FovVideoVdp();

  /// Adds a frame. Both are sRGB-encoded in [0, 1], as sent to the display. The first frame of a
  /// sequence counts as shown before. Throws Error for another size, or values that are not finite.
  void add(const RgbImage& image, const RgbImage& reference);

  /// The quality over the frames so far, at least one, in JOD: at most 10.
  double jod() const;

 private:
  using Luminance = std::vector<float>;  ///< cd/m2 of each pixel, row by row
  struct Band;
  struct Level;
  using Pyramid = std::vector<Level>;  ///< one per band, the finest first

  Luminance luminance_of(const RgbImage& image) const;
  Pyramid pyramid_of(Luminance luminance) const;
  /// A channel's response to the last frames, the newest first.
  Pyramid seen_by(VdpChannel channel, const std::deque<Luminance>& frames) const;
  float sensitivity(const VdpSensitivityTable& table, const Band& band, int x, int y,
                    float background_cd_m2) const;
  /// background: the adaptation.
  double channel_difference(VdpChannel channel, const Pyramid& image, const Pyramid& reference,
                            const Pyramid& background) const;

  VdpDisplay display_;
  IVec2 size_;
  const Workers& workers_;
  std::optional<Vec2> fixation_deg_;  ///< from the display's centre
  float half_pixel_;                  ///< tangent of half a pixel, in the display's centre
  std::vector<Band> bands_;
  /// By VdpChannel, like filters_; still pictures have only the sustained channel.
  std::vector<VdpSensitivityTable> sensitivity_;
  std::vector<std::vector<float>> filters_;
  std::deque<Luminance> images_;  ///< newest first, as many as a filter's weights
  std::deque<Luminance> references_;
  double sum_ = 0.0;  ///< over the frames' differences
  int frames_ = 0;
};

}  // namespace foveola
