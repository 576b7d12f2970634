// Selects the pixels of a film that are worth tracing if only parts of it are judged.
#pragma once

#include <vector>

#include "renderer/base/work/parallel.h"
#include "renderer/view/view_sampler.h"

namespace foveola::study {

class SampleMask {
 public:
  /// An empty mask for a film of width x height pixels.
  SampleMask(int width, int height);

  /// Adds the pixels whose centres lie within radius_rad of `middle` (unit length, world), and
  /// those up to `margin` pixels beside them, which a resampled view reads too.
  void add(const Vec3& middle, double radius_rad, int margin, const Workers& workers);

  /// Removes the samples outside of the mask.
  void keep(std::vector<ViewSample>& samples) const;

  std::size_t count() const;

 private:
  bool holds(const Vec2& image) const;

  int width_;
  int height_;
  std::vector<std::uint8_t> pixels_;  ///< row by row; 1: wanted
};

}  // namespace foveola::study
