// What the application submits to be shown.
#pragma once

#include <nlohmann/json.hpp>

#include "tests/openxr/runtime/state.h"

namespace foveola::test::openxr {

/// Refuses layers that a runtime could not show, or not where they belong.
void check_layer(const Session& session, const Frame& frame,
                 const XrCompositionLayerBaseHeader* layer);

/// For the log.
nlohmann::json description_of(const XrCompositionLayerBaseHeader& layer);

/// As files of a portable pixmap each, FRAME-VIEW.ppm, in the folder that the environment names.
void save_pictures(const Session& session, const Frame& frame,
                   const XrCompositionLayerBaseHeader& layer);

}  // namespace foveola::test::openxr
