// Chooses a scene's exposure: the scene's own, an automatic one from a small picture, or the
// user's.
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
  /// Its seed also places the samples in their pixels; its pixel angle is replaced by the
  /// picture's.
  TraceSettings trace;
};

/// The mean radiance of each pixel, row by row from the top left; non-finite samples count as
/// black. Does not depend on the number of threads.
std::vector<DVec3> small_picture(const PathTracer& tracer, const Vec3& viewpoint,
                                 const Viewport& viewport, SmallPictureSettings settings,
                                 const Workers& workers);

struct ExposureChoice {
  enum class Base : std::uint8_t {
    scene,      ///< the scene's exposure, or automatic without one
    automatic,  ///< automatic
    none        ///< 0
  };
  Base base = Base::scene;
  double more_stops = 0.0;  ///< added to it
};

struct Exposure {
  double stops = 0.0;
  bool is_automatic = false;
};

/// The stops that bring the logarithmic mean of the luminances to 0.18, as in Reinhard et al.
/// (2002, "Photographic Tone Reproduction for Digital Images", equations 1 and 2) for a picture in
/// the middle key, rounded to hundredths. Black pixels are excluded, such as an object's
/// surroundings without an environment. So are pixels over 8 stops below the 95th percentile, which
/// would be shown as black. A small lamp has little weight. Up to two stops darker if more than 5 %
/// were white otherwise, such as a pale object on dark ground. nullopt if all is black.
std::optional<double> automatic_exposure_stops(std::vector<float> luminances);

/// The same for the view through `viewport` from `viewpoint`, by a small picture that does not
/// depend on the number of threads or the seed of `trace`. The environment counts only if less than
/// a twentieth of the picture shows the scene alone.
std::optional<double> automatic_exposure_stops(const PathTracer& tracer, const Vec3& viewpoint,
                                               const Viewport& viewport, TraceSettings trace,
                                               const Workers& workers);

/// The chosen exposure. Renders the small picture only if needed; 0 stops, and not automatic, if it
/// is black.
Exposure chosen_exposure(const ExposureChoice& choice, const LoadedScene& loaded,
                         const Viewport& viewport, const TraceSettings& trace,
                         const Workers& workers);

/// A line that states an automatic exposure, and the option to repeat it.
std::string exposure_note(const Exposure& exposure);

}  // namespace foveola
