#include "renderer/measure/reference.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/cache.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"
#include "renderer/base/numbers/random.h"
#include "renderer/image/image_file.h"
#include "renderer/progressive/progressive_render.h"
#include "renderer/view/equirect.h"
#include "renderer/view/view_sampler.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

constexpr std::uint64_t pass_samples = 1 << 18;

/// Separates the noise of a reference from that of previews with the same seed: an image that
/// shared paths with its reference would have too small an error.
constexpr std::uint32_t reference_stream = 0x72656665U;

/// All inputs of the image, and this program's version of the rendering.
std::string cache_key(const std::string& scene_key, const ReferenceSettings& settings,
                      const BuildInfo& build) {
  std::string text = fmt::format(
      "reference 6\n{}\n{}\n{} {} {}\n{}x{}\ndepth {} seed {} angle {} spp {} interest {}\n",
      arithmetic_name(build), scene_key, settings.viewpoint.x, settings.viewpoint.y,
      settings.viewpoint.z, settings.width, settings.height, settings.max_depth, settings.seed,
      pixel_angle_rad(settings.width), settings.samples_per_pixel, settings.samples_per_interest);
  for (const Vec3& interest : settings.interests) {
    text += fmt::format("{} {} {}\n", interest.x, interest.y, interest.z);
  }
  return sha256(std::string_view(text));
}

/// The cached image; nullopt if it is missing or damaged, so that it is made again.
std::optional<FilmImage> read_cached(const fs::path& file) {
  if (!is_cached(file)) {
    return std::nullopt;
  }
  try {
    return read_film_image(file);
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// Adds samples of several samplers to one film.
class ReferenceRender {
 public:
  ReferenceRender(const PathTracer& tracer, const ReferenceSettings& settings,
                  const Workers& workers, const std::function<void(double)>& progress,
                  std::stop_token stop)
      : settings_(settings),
        progress_(progress),
        stop_(std::move(stop)),
        seed_(mix(settings.seed, reference_stream)),
        render_(tracer,
                {.viewpoint = settings.viewpoint,
                 .film_size = {settings.width, settings.height},
                 .trace = {.max_depth = settings.max_depth, .seed = seed_}},
                workers),
        planned_(uniform_samples() + settings.interests.size() * settings.samples_per_interest) {}

  FilmImage render() {
    add("od", Vec3(0.0F, 0.0F, -1.0F), uniform_samples());
    for (const Vec3& interest : settings_.interests) {
      add("fv", interest, settings_.samples_per_interest);
    }
    return render_.film().resolve();
  }

 private:
  std::uint64_t uniform_samples() const {
    return static_cast<std::uint64_t>(settings_.samples_per_pixel) * settings_.width *
           settings_.height;
  }

  void add(const std::string& method, const Vec3& gaze, std::uint64_t count) {
    const std::unique_ptr<ViewSampler> sampler = make_view_sampler(method);
    sampler->aim({.viewport = Viewport({}, FieldOfView{}), .gaze = gaze});
    render_.begin_pattern(mix(seed_, ++patterns_));
    while (render_.points_drawn() < count) {
      if (stop_.stop_requested()) {
        throw Error("reference image", "stopped before it was finished");
      }
      const std::uint64_t points = std::min(pass_samples, count - render_.points_drawn());
      render_.advance(*sampler, points);
      done_ += points;
      progress_(static_cast<double>(done_) / static_cast<double>(planned_));
    }
  }

  const ReferenceSettings& settings_;
  const std::function<void(double)>& progress_;
  std::stop_token stop_;
  std::uint32_t seed_;
  ProgressiveRender render_;
  std::uint32_t patterns_ = 0;
  std::uint64_t planned_;
  std::uint64_t done_ = 0;
};

}  // namespace

fs::path reference_file(const fs::path& cache, const std::string& scene_key,
                        const ReferenceSettings& settings, const BuildInfo& build) {
  return cache / (cache_key(scene_key, settings, build) + ".exr");
}

FilmImage reference_image(const PathTracer& tracer, const std::string& scene_key,
                          const ReferenceSettings& settings, const Workers& workers,
                          const fs::path& cache, const std::function<void(double)>& progress,
                          std::stop_token stop) {
  const fs::path file = reference_file(cache, scene_key, settings, build_info());
  if (std::optional<FilmImage> cached = read_cached(file)) {
    progress(1.0);
    return std::move(*cached);
  }
  make_cache_folder(cache);
  require_writable(file);
  FilmImage image = ReferenceRender(tracer, settings, workers, progress, std::move(stop)).render();
  store_file(file, [&](const fs::path& temporary) { write_film_image(temporary, image, 0.0); });
  return image;
}

}  // namespace foveola
