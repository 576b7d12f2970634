// The error of a film in each region, against a reference with two halves.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "analysis/convergence/plan.h"
#include "analysis/convergence/regions.h"
#include "renderer/film/equirect_film.h"
#include "renderer/measure/region_error.h"
#include "renderer/view/viewport.h"

namespace foveola::analysis {

/// One film's error in one region.
struct Score {
  RegionError error;
  std::optional<double> flip;  ///< mean LDR-FLIP on the display; none for regions beyond it
};

class Scorer {
 public:
  /// regions and workers must outlive it.
  Scorer(const ConvergencePlan& plan, const Viewport& viewport, double exposure_stops,
         const std::vector<Region>& regions, ReferenceHalves reference, const Workers& workers);

  /// One score a region. Unsampled pixels are black on the display; the published renderer did not
  /// reconstruct them either (Koskela et al. 2018, section 3).
  std::vector<Score> score(const EquirectFilm& film) const;

  const std::vector<PixelRegion>& film_regions() const { return film_regions_; }
  /// The mean of both halves.
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
  RgbImage reference_view_;  ///< as the display shows it
};

/// One half of the reference, 0 or 1, rendered or taken from `cache`: more samples around the gaze,
/// noise independent of the other's and of all renders', textures filtered as in those, so that
/// noise is all that is left between them. progress is called with the fraction done. Throws Error
/// as reference_image.
RgbImage reference_half(const Subject& subject, const ConvergencePlan& plan, const Vec3& gaze,
                        std::uint32_t half, const Workers& workers,
                        const std::filesystem::path& cache,
                        const std::function<void(double)>& progress, const std::stop_token& stop);

/// Both halves.
ReferenceHalves reference_halves(const Subject& subject, const ConvergencePlan& plan,
                                 const Vec3& gaze, const Workers& workers,
                                 const std::filesystem::path& cache,
                                 const std::function<void(double)>& progress,
                                 const std::stop_token& stop);

}  // namespace foveola::analysis
