// Scenes and renders for Python: numpy arrays, and angles in degrees.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>

#include "renderer/base/work/parallel.h"
#include "renderer/progressive/headless_render.h"
#include "renderer/progressive/loaded_scene.h"
#include "renderer/progressive/render_limits.h"

namespace foveola::analysis {

/// Azimuth and elevation in the world.
using AnglesDeg = std::pair<double, double>;

/// A loaded scene, and its rendering threads.
struct SceneForPython {
  Workers workers;
  LoadedScene loaded;

  SceneForPython(const std::string& name_or_path, const RenderSettings& settings);
};

/// Returns whether this process was forked from one that had loaded a scene. Threads do not survive
/// a fork, and a render would wait for them forever.
bool is_forked();

/// Stops the renders of other threads, for ever, and waits for their end. To be called once, when
/// the interpreter ends.
void end_renders();

/// Leaks a scene in a forked process, which cannot end its threads.
struct DeleteUnlessForked {
  void operator()(const SceneForPython* scene) const;
};

/// Arguments of render() in Python, with their defaults.
struct RenderArguments {
  std::optional<std::string> method;        ///< as make_view_sampler reads it; empty: a picture
  std::optional<AnglesDeg> gaze_deg;        ///< default: the head's direction
  std::optional<std::pair<int, int>> size;  ///< width and height in pixels
  BudgetChoices budget;
  TraceSettings trace;  ///< its seed and depth
};

struct RenderForPython {
  pybind11::array_t<float> radiance;         ///< [height][width][3], linear Rec. 709
  pybind11::array_t<std::uint32_t> samples;  ///< [height][width]
  double seconds = 0.0;
  std::vector<std::array<std::uint32_t, 3>> dropped;  ///< x, y, index of the sample in its pixel
};

/// Returns settings with the camera's place in metres, its direction, and the threads. Throws
/// UsageError for invalid settings, Error in a forked process.
RenderSettings scene_settings(const std::optional<std::array<double, 3>>& camera_m,
                              const std::optional<AnglesDeg>& head_deg, int threads);

/// Renders without Python's lock, and stops when Python is interrupted. Throws Error for invalid
/// settings, and in a forked process.
RenderForPython render_for_python(const SceneForPython& scene, const RenderArguments& arguments);

}  // namespace foveola::analysis
