// A headless progressive render: one viewpoint, one head pose, one gaze, until the budget is spent.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer/base/scene_source.h"
#include "renderer/commands/arguments.h"
#include "renderer/film/viewport_image.h"
#include "renderer/trace/path_tracer.h"

namespace foveola {

/// When a render is done: after a number of samples, or after a time.
struct RenderBudget {
  std::uint64_t samples = 0;  ///< in all; 0: no limit
  double seconds = 0.0;       ///< of tracing; 0: no limit. At least one of the two is set.
};

struct RenderSettings {
  std::string method = "od";  ///< as make_view_sampler reads it
  IVec2 size{2048, 1024};
  std::optional<DVec3> camera;             ///< default: see Stage::camera
  std::optional<AzimuthElevation> head;    ///< world; default: with the camera
  std::optional<AzimuthElevation> gaze;    ///< world; default: where the head points
  double fov_deg = 100.0;                  ///< of the viewport, horizontally
  std::optional<double> vertical_fov_deg;  ///< default: as horizontally
  RadialLens lens;
  bool variance = false;      ///< keep the variances of luminance too
  std::optional<IVec2> view;  ///< make the display's image too, of so many pixels
  UnsampledPixels unsampled = UnsampledPixels::black;  ///< in it
  RenderBudget budget;
  int max_depth = 8;
  std::uint32_t seed = 0;
  int threads = 0;       ///< 0: every core
  bool diffuse = false;  ///< every material is Lambertian in its base colour, emission kept
  float largest_radiance = std::numeric_limits<float>::infinity();  ///< see TraceSettings
  bool uses_general_path = false;                                   ///< see TraceSettings
  /// Relative standard error below which a pixel at the gaze gets no more samples (see
  /// VisibleNoise); 0: every sample stays where the method put it.
  double adaptive_contrast = 0.0;
};

struct RenderReport {
  std::uint64_t samples = 0;
  double seconds = 0.0;  ///< of aiming, tracing and filming, without loading and building
  std::uint64_t rays = 0;
  std::vector<DroppedSample> non_finite;
  double load_seconds = 0.0;
  double build_seconds = 0.0;
  std::size_t triangles = 0;
  DVec3 camera{0.0};  ///< in the file's world
  AzimuthElevation head;
  AzimuthElevation gaze;
  int threads = 0;
  std::vector<std::string> warnings;
  bool stopped = false;  ///< ended early because `stop` was requested
};

struct Rendering {
  FilmImage image;
  RgbImage view;  ///< linear; empty if none was asked for
  RenderReport report;
};

/// Renders `source`, showing progress. Throws Error for what is wrong with the scene or settings.
Rendering render(const SceneSource& source, const RenderSettings& settings, std::stop_token stop);

/// One path of a render, again.
struct ReplayedPath {
  SampleJob job;
  PathRecord record;
  std::vector<std::string> object_names;  ///< one a vertex; empty where nothing was met
};

/// Finds sample `address` of the render with these settings, and traces it once more. Throws Error
/// if that render does not take it, or if stopped.
ReplayedPath replay(const SceneSource& source, const RenderSettings& settings,
                    const SampleAddress& address, std::stop_token stop);

}  // namespace foveola
