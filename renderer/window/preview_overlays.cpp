#include "renderer/window/preview_overlays.h"

#include <array>

#include "renderer/view/acuity.h"
#include "renderer/window/view_overlays.h"

namespace foveola {
namespace {

/// Where the published model of acuity begins to fall, and round numbers beyond.
constexpr std::array acuity_rings_deg = {reddy_knee_deg, 10.0, 20.0, 40.0};

}  // namespace

ViewOverlays preview_overlays(const PreviewChoices& choices, const Preview& preview) {
  constexpr int density_cells = 48;
  ViewOverlays overlays{.gaze = preview.gaze(), .shows_gaze = choices.shows_gaze};
  if (choices.shows_rings) {
    for (const double ring_deg : acuity_rings_deg) {
      overlays.rings_rad.push_back(static_cast<float>(radians(ring_deg)));
    }
  }
  if (choices.shows_density) {
    overlays.density =
        density_map(preview.sampler(), preview.viewport(), density_cells, density_cells);
  }
  return overlays;
}

}  // namespace foveola
