// How bright a scene is shown: as it says itself, by what is seen of it in a small picture, or as
// somebody says.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/work/parallel.h"
#include "renderer/progressive/loaded_scene.h"
#include "renderer/trace/paths/path_tracer.h"
#include "renderer/view/viewport.h"

namespace foveola {

struct SmallPictureSettings {
  IVec2 size{1};  ///< pixels
  std::uint32_t samples_per_pixel = 16;
  /// Its seed is also that of the samples' places in their pixels, and the angle of a pixel is the
  /// picture's own.
  TraceSettings trace;
};

/// The mean radiance of each pixel, row after row from the top left; samples that are not finite
/// count as black. Equal on any number of threads.
std::vector<DVec3> small_picture(const PathTracer& tracer, const Vec3& viewpoint,
                                 const Viewport& viewport, SmallPictureSettings settings,
                                 const Workers& workers);

struct ExposureChoice {
  enum class Base : std::uint8_t {
    scene,      ///< the scene's exposure, or the automatic one where it has none
    automatic,  ///< the automatic one
    none        ///< 0
  };
  Base base = Base::scene;
  double more_stops = 0.0;  ///< added to it
};

struct Exposure {
  double stops = 0.0;
  bool is_automatic = false;
};

/// The stops that bring the logarithmic mean of the luminances to 0.18, as Reinhard et al. (2002,
/// "Photographic Tone Reproduction for Digital Images", equations 1 and 2) do it for a picture in
/// the middle key, rounded to hundredths. What is black does not count, such as the surroundings of
/// an object where there is no environment; nor does what is over 8 stops darker than all but 5 %
/// of what counts, and would be shown as black beside it. A small lamp counts as little as its part
/// of the picture. Up to two stops darker if more than 5 % were white otherwise, such as a pale
/// object on dark ground. None if nothing shines.
std::optional<double> automatic_exposure_stops(std::vector<float> luminances);

/// The same of what is seen through `viewport` from `viewpoint`: of a small picture, which is equal
/// on any number of threads and whatever the seed of `trace`. What surrounds the scene counts only
/// if less than a twentieth of the picture shows the scene alone.
std::optional<double> automatic_exposure_stops(const PathTracer& tracer, const Vec3& viewpoint,
                                               const Viewport& viewport, TraceSettings trace,
                                               const Workers& workers);

/// Looks at the scene only if nobody says how bright it is shown; 0 stops, and not automatic, if it
/// is black.
Exposure chosen_exposure(const ExposureChoice& choice, const LoadedScene& loaded,
                         const Viewport& viewport, const TraceSettings& trace,
                         const Workers& workers);

/// A line that says an automatic exposure, and how to have it again.
std::string exposure_note(const Exposure& exposure);

}  // namespace foveola
