// A headless progressive render of a 360-degree image or a picture: one viewpoint, head pose and
// gaze, until the budget is spent.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/base/scene_source.h"
#include "renderer/base/vec.h"
#include "renderer/base/work/parallel.h"
#include "renderer/base/work/shard.h"
#include "renderer/film/viewport_resampler.h"
#include "renderer/progressive/exposure.h"
#include "renderer/progressive/loaded_scene.h"
#include "renderer/progressive/picture.h"
#include "renderer/progressive/progressive_render.h"
#include "renderer/trace/paths/path_tracer.h"

namespace foveola {

/// The number in [1, shards] of the part that contains `pixel`, the same for all renders. Small
/// tiles are assigned round-robin along a row. Each row is offset by the golden ratio of a cycle.
/// Every region of many tiles is thereby split evenly, and the parts' work is nearly equal for any
/// sampling. shards: in [1, max_shards].
inline std::int64_t shard_of_pixel(const IVec2& pixel, std::int64_t shards) {
  // In pixels. A fovea, which gets a tenth of the samples, has some 50 such tiles in an image of
  // 1024 pixels. Larger tiles would split it unevenly, and smaller ones hardly more evenly.
  constexpr int tile_side = 4;
  constexpr std::uint32_t golden_section = 0x9E3779B9U;  // times 2^32
  const std::uint32_t column = static_cast<std::uint32_t>(pixel.x) / tile_side;
  const std::uint32_t row = static_cast<std::uint32_t>(pixel.y) / tile_side;
  const auto count = static_cast<std::uint32_t>(shards);
  const std::uint32_t part_of_round = golden_section * row;  // times 2^32, modulo a cycle
  const auto first = static_cast<std::uint32_t>((std::uint64_t{part_of_round} * count) >> 32U);
  return 1 + std::int64_t{(first + column) % count};
}

/// The end of a render: a number of samples or a time, whichever comes first; without either, a
/// stop.
struct RenderBudget {
  double samples_per_pixel = 0.0;  ///< of the image, on average; 0: given by `samples`
  std::uint64_t samples = 0;       ///< samples in all; 0: no limit
  double seconds = 0.0;            ///< seconds of tracing; 0: no limit
};

/// A part of a render; other processes render the rest.
struct RenderPart {
  enum class By {
    /// Small tiles all over the film (see shard_of_pixel). All directions are drawn, and those in
    /// the part's tiles are traced: the parts sum to the whole render, bit for bit.
    tiles,
    /// A part of the samples, all over the film, with its own random numbers.
    seeds
  };
  Shard shard;
  By by = By::tiles;
};

/// The state for continuing a render.
struct RenderProgress {
  std::uint64_t points_drawn = 0;  ///< of the directions' pattern
  std::uint64_t points = 0;        ///< to be drawn in all; 0: until the time limit
  std::uint64_t samples = 0;       ///< traced
  std::uint64_t rays = 0;
  double seconds = 0.0;  ///< as in RenderReport
  std::vector<DroppedSample> non_finite;
  IVec2 film_size{0};
  FilmStatistics statistics = FilmStatistics::mean;
  std::vector<PixelState> pixels;

  bool is_complete() const { return points > 0 && points_drawn >= points; }
};

struct RenderReport;

struct RenderSettings {
  /// An ordinary picture instead of a 360-degree image. Method, gaze, fields of view, film size and
  /// the display's image are then ignored, and adaptive sampling is refused.
  std::optional<PictureChoices> picture;
  std::string method = "od";  ///< parsed by make_view_sampler
  SceneChoices scene;
  /// The choice of the exposure; nullopt: the scene's, or 0.
  std::optional<ExposureChoice> exposure;
  std::optional<AzimuthElevation> gaze;                ///< world; default: the head's direction
  FieldOfView field_of_view;                           ///< of the viewport
  ProgressiveSettings progressive;                     ///< its viewpoint is the scene's
  std::optional<IVec2> view;                           ///< size of an additional display image
  UnsampledPixels unsampled = UnsampledPixels::black;  ///< in that image
  RenderBudget budget;
  int threads = 0;  ///< 0: all cores
  /// Renders only a part; not with adaptive sampling, which depends on the whole film.
  std::optional<RenderPart> part;
  /// The state to continue from; null: the beginning. Not with adaptive sampling.
  const RenderProgress* so_far = nullptr;
  /// Called once the scene is loaded, before rendering; may throw, and may be empty.
  std::function<void(const RenderReport& report)> begin;
  /// Called with the progress at intervals, and at the end; may be empty.
  std::function<void(const RenderReport& report, const RenderProgress& progress)> save;
  Nanoseconds save_interval = std::chrono::minutes(5);
};

struct RenderReport {
  std::uint64_t samples = 0;
  double seconds = 0.0;  ///< seconds of sampling, tracing and filming, without loading and building
  /// Parts of it for tracing, and for drawing directions and the film, in this run.
  double trace_seconds = 0.0;
  double draw_seconds = 0.0;
  std::uint64_t rays = 0;
  std::vector<DroppedSample> non_finite;
  double load_seconds = 0.0;
  double build_seconds = 0.0;
  std::size_t triangles = 0;
  std::string scene_sha256;   ///< of the scene's file
  IVec2 size{0};              ///< of the image, in pixels
  FieldOfView field_of_view;  ///< of the picture, or of the viewport
  Exposure exposure;
  DVec3 camera{0.0};  ///< in the file's world
  AzimuthElevation head;
  double roll_rad = 0.0;     ///< of a picture
  bool is_lit = true;        ///< whether anything in the scene emits
  bool is_enclosed = false;  ///< whether no light reaches the camera from outside the scene
  AzimuthElevation gaze;
  int threads = 0;
  std::vector<std::string> warnings;
  bool stopped = false;  ///< ended early because `stop` was requested
};

struct Rendering {
  FilmImage image;
  RgbImage view;  ///< linear; empty if not requested
  RenderReport report;
};

/// The gaze of the settings in a scene: by default the head's direction.
AzimuthElevation gaze_of(const RenderSettings& settings, const LoadedScene& loaded);

/// Renders `source`, showing progress. Returns a partial result if stopped. Throws Error for faults
/// of the scene or settings.
Rendering render(const SceneSource& source, const RenderSettings& settings, std::stop_token stop);

/// The same for a loaded scene, without showing progress. Uses that scene's camera: settings.scene
/// and settings.threads are ignored.
Rendering render(const LoadedScene& loaded, const RenderSettings& settings, const Workers& workers,
                 std::stop_token stop);

/// One sample of one pixel of an image.
struct SampleAddress {
  IVec2 pixel{0};  ///< from the top left
  std::uint32_t sample_number = 0;
};

/// One retraced path of a render.
struct ReplayedPath {
  SampleJob job;
  PathRecord record;
  std::vector<std::string> object_names;  ///< one per vertex; empty for misses
};

/// Finds sample `address` of the render with these settings, and traces it again. Throws UsageError
/// if the image has no such pixel, and Error if that render does not take the sample, or if
/// stopped.
ReplayedPath replay(const SceneSource& source, const RenderSettings& settings,
                    const SampleAddress& address, std::stop_token stop);

}  // namespace foveola
