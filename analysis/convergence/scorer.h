// Computes the error of a film in each region, against a reference with two halves.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "analysis/convergence/convergence_plan.h"
#include "renderer/film/equirect_film.h"
#include "renderer/measure/region_error.h"
#include "renderer/view/viewport.h"

namespace foveola::analysis {

struct Region {
  std::string name;
  /// The weight of a direction (unit length) per steradian: 0 outside, 1 inside, or in between.
  std::function<double(const Vec3&)> weight;
  bool is_in_view = false;  ///< whether the display shows all of it
};

/// Returns discs of 2, 5, 10 and 20 degrees' radius around the gaze ("2deg" ... "20deg"), the
/// viewport, the viewport weighted by Reddy's visual acuity ("acuity"), and the whole sphere.
std::vector<Region> regions_around(const Vec3& gaze, const Viewport& viewport);

/// Returns the pixels of an equirect film whose centres lie in the region, weighted by their
/// steradians.
PixelRegion region_on_film(const Region& region, const IVec2& size);

/// Returns the region's pixels on a display of size x size pixels that shows `viewport`, weighted
/// by their steradians.
PixelRegion region_on_view(const Region& region, const Viewport& viewport, int size);

/// One film's error in one region.
struct Score {
  RegionError error;
  std::optional<double> flip;  ///< mean LDR-FLIP on the display; empty for regions beyond it
};

class Scorer {
 public:
  /// regions and workers must outlive it. The reference has the plan's size.
  Scorer(const ConvergencePlan& plan, const Viewport& viewport, double exposure_stops,
         const std::vector<Region>& regions, ReferenceHalves reference, const Workers& workers);

  /// Returns one score per region. The film has the plan's size. Unsampled pixels are black on the
  /// display; the published renderer did not reconstruct them either (Koskela et al. 2018, section
  /// 3).
  std::vector<Score> score(const EquirectFilm& film) const;

  const std::vector<PixelRegion>& film_regions() const { return film_regions_; }
  /// Returns the mean of both halves.
  RgbImage reference() const;

 private:
  RgbImage shown(const RgbImage& view) const;

  Viewport viewport_;
  double exposure_stops_;
  int view_size_;
  const std::vector<Region>* regions_;
  ReferenceHalves reference_;
  const Workers* workers_;
  std::vector<PixelRegion> film_regions_;
  std::vector<PixelRegion> view_regions_;
  RgbImage reference_view_;  ///< as on the display
};

/// Renders one half of the reference, 0 or 1, or takes it from `cache`. It has more samples around
/// the gaze. Its noise is independent of the other half's and of all renders', and textures are
/// filtered as in the renders, so that only noise differs. progress is called with the fraction
/// done. Throws Error if stopped, or if the cache cannot be written.
RgbImage reference_half(const Subject& subject, const ConvergencePlan& plan, const Vec3& gaze,
                        std::uint32_t half, const Workers& workers,
                        const std::filesystem::path& cache,
                        const std::function<void(double)>& progress, const std::stop_token& stop);

/// Returns both halves. progress and errors: as for one half.
ReferenceHalves reference_halves(const Subject& subject, const ConvergencePlan& plan,
                                 const Vec3& gaze, const Workers& workers,
                                 const std::filesystem::path& cache,
                                 const std::function<void(double)>& progress,
                                 const std::stop_token& stop);

}  // namespace foveola::analysis
