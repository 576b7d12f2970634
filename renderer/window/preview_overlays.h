// What the live preview draws over the film: what its user has chosen to see.
#pragma once

#include "renderer/preview/preview.h"
#include "renderer/window/preview_controls.h"
#include "renderer/window/view_overlays.h"

namespace foveola {

/// As of the preview's last frame.
ViewOverlays preview_overlays(const PreviewChoices& choices, const Preview& preview);

}  // namespace foveola
