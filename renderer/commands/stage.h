// A scene ready to be seen: loaded, built, with a camera and a gaze chosen for it.
#pragma once

#include <string>
#include <vector>

#include "renderer/base/parallel.h"
#include "renderer/commands/render.h"
#include "renderer/preview/preview.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/path_tracer.h"

namespace foveola {

struct Stage {
  double load_seconds = 0.0;
  double build_seconds = 0.0;
  Workers workers;
  Scene scene;
  PathTracer tracer;
  /// One line each: the scene's, where one stands if neither it nor the settings say so (see
  /// choose_standpoint), and that nothing shines.
  std::vector<std::string> warnings;
  /// Where the settings say, else the source, else the file's first, else by choose_standpoint.
  CameraView camera;
  AzimuthElevation gaze;

  /// Throws Error for what is wrong with the scene.
  Stage(const SceneSource& source, const RenderSettings& settings);
};

/// One line each, on standard error.
void print_warnings(const std::vector<std::string>& warnings);

/// What a render with these settings asks of the tracer.
TraceSettings trace_settings(const RenderSettings& settings);

/// What it asks of a preview.
PreviewSettings preview_settings(const RenderSettings& settings, const Vec3& viewpoint,
                                 double exposure_stops);

}  // namespace foveola
