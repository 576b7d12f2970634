// A headless progressive render of a 360-degree image or a picture: one viewpoint, one head pose,
// one gaze, until the budget is spent.
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

/// The number in [1, shards] of the part that has `pixel`, the same for all renders. Small tiles
/// are dealt in turn, row by row, and the turn moves by the golden section of a round from row to
/// row: wherever there are many tiles, each part has as many of them, far from one another, so that
/// all trace about as much wherever samples go. shards: in [1, max_shards].
inline std::int64_t shard_of_pixel(const IVec2& pixel, std::int64_t shards) {
  // In pixels. A fovea, which gets a tenth of the samples, has some 50 such tiles in an image of
  // 1024 pixels; larger ones could not be dealt evenly, and smaller ones hardly more so.
  constexpr int tile_side = 4;
  constexpr std::uint32_t golden_section = 0x9E3779B9U;  // times 2^32
  const std::uint32_t column = static_cast<std::uint32_t>(pixel.x) / tile_side;
  const std::uint32_t row = static_cast<std::uint32_t>(pixel.y) / tile_side;
  const auto count = static_cast<std::uint32_t>(shards);
  const std::uint32_t part_of_round = golden_section * row;  // times 2^32, without whole rounds
  const auto first = static_cast<std::uint32_t>((std::uint64_t{part_of_round} * count) >> 32U);
  return 1 + std::int64_t{(first + column) % count};
}

/// When a render is done: after a number of samples or after a time, whichever comes first; without
/// either, when it is stopped.
struct RenderBudget {
  double samples_per_pixel = 0.0;  ///< of the image, on average; 0: as `samples` says
  std::uint64_t samples = 0;       ///< samples in all; 0: no limit
  double seconds = 0.0;            ///< seconds of tracing; 0: no limit
};

/// A part of a render, whose rest is rendered elsewhere.
struct RenderPart {
  enum class By {
    /// Small tiles all over the film (see tile_dealing.h): all directions are drawn, and those in
    /// its own tiles are traced, so that the parts are the whole render, bit for bit.
    tiles,
    /// A part of the samples, all over the film, from random numbers of its own.
    seeds
  };
  Shard shard;
  By by = By::tiles;
};

/// How far a render has come, and all that going on with it takes.
struct RenderProgress {
  std::uint64_t points_drawn = 0;  ///< of the directions' pattern
  std::uint64_t points = 0;        ///< to be drawn in all; 0: until a time is over
  std::uint64_t samples = 0;       ///< traced
  std::uint64_t rays = 0;
  double seconds = 0.0;  ///< as RenderReport's
  std::vector<DroppedSample> non_finite;
  IVec2 film_size{0};
  FilmStatistics statistics = FilmStatistics::mean;
  std::vector<PixelState> pixels;

  bool is_complete() const { return points > 0 && points_drawn >= points; }
};

struct RenderReport;

struct RenderSettings {
  /// An ordinary picture instead of a 360-degree image. Method, gaze, fields of view, film size and
  /// the display's image are then of no account, and adaptive sampling is refused.
  std::optional<PictureChoices> picture;
  std::string method = "od";  ///< as make_view_sampler reads it
  SceneChoices scene;
  /// How bright it is to be shown; none: as the scene says, or 0.
  std::optional<ExposureChoice> exposure;
  std::optional<AzimuthElevation> gaze;  ///< world; default: where the head points
  FieldOfView field_of_view;             ///< the viewport's
  ProgressiveSettings progressive;       ///< its viewpoint is the scene's
  std::optional<IVec2> view;             ///< make the display's image too, of so many pixels
  UnsampledPixels unsampled = UnsampledPixels::black;  ///< in that image
  RenderBudget budget;
  int threads = 0;  ///< 0: every core
  /// Only a part of it; not with adaptive sampling, which looks at the whole film.
  std::optional<RenderPart> part;
  /// Where the same render broke off, to go on with; null: it begins. Not with adaptive sampling.
  const RenderProgress* so_far = nullptr;
  /// Called once the scene is loaded, before anything is rendered; may throw, and may be empty.
  std::function<void(const RenderReport& report)> begin;
  /// Called now and then with how far it has come, and at its end; may be empty.
  std::function<void(const RenderReport& report, const RenderProgress& progress)> save;
  Nanoseconds save_interval = std::chrono::minutes(5);
};

struct RenderReport {
  std::uint64_t samples = 0;
  double seconds = 0.0;  ///< seconds of sampling, tracing and filming, without loading and building
  /// What of them tracing took, and what drawing directions and the film did, as far as it was
  /// rendered now.
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
  bool is_lit = true;        ///< whether anything in the scene shines
  bool is_enclosed = false;  ///< whether no light comes to the camera from outside the scene
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

/// The gaze that settings ask for in a scene: where the head points, if they ask for none.
AzimuthElevation gaze_of(const RenderSettings& settings, const LoadedScene& loaded);

/// Renders `source`, showing progress. If it is stopped, what there is. Throws Error for what is
/// wrong with the scene or settings.
Rendering render(const SceneSource& source, const RenderSettings& settings, std::stop_token stop);

/// The same of a scene that was loaded before, without showing progress. It has that scene's
/// camera: settings.scene and settings.threads are of no account.
Rendering render(const LoadedScene& loaded, const RenderSettings& settings, const Workers& workers,
                 std::stop_token stop);

/// One sample of one pixel of an image.
struct SampleAddress {
  IVec2 pixel{0};  ///< from the top left
  std::uint32_t sample_number = 0;
};

/// One path of a render, traced again.
struct ReplayedPath {
  SampleJob job;
  PathRecord record;
  std::vector<std::string> object_names;  ///< one for each vertex; empty where nothing was met
};

/// Finds sample `address` of the render with these settings, and traces it once more. Throws
/// UsageError if the image has no such pixel, and Error if that render does not take the sample, or
/// if stopped.
ReplayedPath replay(const SceneSource& source, const RenderSettings& settings,
                    const SampleAddress& address, std::stop_token stop);

}  // namespace foveola
