#include "renderer/measure/reference.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "renderer/base/digest.h"
#include "renderer/base/error.h"
#include "renderer/base/random.h"
#include "renderer/film/equirect_film.h"
#include "renderer/film/image_file.h"
#include "renderer/view/view_sampler.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

constexpr std::uint64_t batch_samples = 1 << 18;

/// Everything the image depends on, and this program's way of rendering it.
std::string cache_key(const std::string& scene_key, const ReferenceSettings& settings) {
  std::string text =
      fmt::format("reference 1\n{}\n{} {} {}\n{}x{}\ndepth {} seed {} spp {} interest {}\n",
                  scene_key, settings.viewpoint.x, settings.viewpoint.y, settings.viewpoint.z,
                  settings.width, settings.height, settings.max_depth, settings.seed,
                  settings.samples_per_pixel, settings.samples_per_interest);
  for (const Vec3& interest : settings.interests) {
    text += fmt::format("{} {} {}\n", interest.x, interest.y, interest.z);
  }
  return sha256(std::string_view(text));
}

/// The cached image, unless it is missing or damaged: then it is simply made again.
std::optional<FilmImage> read_cached(const fs::path& file, const ReferenceSettings& settings) {
  if (!fs::exists(file)) {
    return std::nullopt;
  }
  try {
    FilmImage image = read_film_image(file);
    if (image.color.width == settings.width && image.color.height == settings.height) {
      return image;
    }
  } catch (const Error&) {
  }
  return std::nullopt;
}

/// Adds samples of one sampler after the other to one film.
class ReferenceRender {
 public:
  ReferenceRender(const PathTracer& tracer, const ReferenceSettings& settings,
                  const Workers& workers, const std::function<void(double)>& progress,
                  std::stop_token stop)
      : tracer_(tracer),
        settings_(settings),
        workers_(workers),
        progress_(progress),
        stop_(std::move(stop)),
        film_(settings.width, settings.height),
        planned_(uniform_samples() + settings.interests.size() * settings.samples_per_interest) {}

  FilmImage render() {
    add("od", Vec3(0.0F, 0.0F, -1.0F), uniform_samples());
    for (const Vec3& interest : settings_.interests) {
      add("fv", interest, settings_.samples_per_interest);
    }
    return film_.resolve();
  }

 private:
  std::uint64_t uniform_samples() const {
    return static_cast<std::uint64_t>(settings_.samples_per_pixel) * settings_.width *
           settings_.height;
  }

  void add(const std::string& method, const Vec3& gaze, std::uint64_t count) {
    const std::unique_ptr<ViewSampler> sampler = make_view_sampler(method);
    constexpr double unused_fov_rad = 1.0;
    sampler->aim(
        {.viewport = Viewport(head_orientation({}), unused_fov_rad, unused_fov_rad), .gaze = gaze});
    for (std::uint64_t begin = 0; begin < count; begin += batch_samples) {
      if (stop_.stop_requested()) {
        throw Error("reference image", "stopped before it was finished");
      }
      add_batch(*sampler, begin, std::min(batch_samples, count - begin));
      progress_(static_cast<double>(done_) / static_cast<double>(planned_));
    }
  }

  void add_batch(const ViewSampler& sampler, std::uint64_t begin, std::uint64_t count) {
    points_.resize(count);
    samples_.resize(count);
    for (std::uint64_t i = 0; i < count; ++i) {
      points_[i] = sobol_2d(begin + i, settings_.seed);
    }
    sampler.sample(points_, samples_);
    film_.number(samples_, batch_);
    radiance_.resize(count);
    tracer_.trace(settings_.viewpoint, batch_.jobs, radiance_,
                  {.max_depth = settings_.max_depth, .seed = settings_.seed}, workers_);
    film_.add(batch_, radiance_, workers_);
    done_ += count;
  }

  const PathTracer& tracer_;
  const ReferenceSettings& settings_;
  const Workers& workers_;
  const std::function<void(double)>& progress_;
  std::stop_token stop_;
  EquirectFilm film_;
  std::uint64_t planned_;
  std::uint64_t done_ = 0;
  std::vector<Vec2> points_;
  std::vector<ViewSample> samples_;
  NumberedBatch batch_;
  std::vector<Rgb> radiance_;
};

}  // namespace

FilmImage reference_image(const PathTracer& tracer, const std::string& scene_key,
                          const ReferenceSettings& settings, const Workers& workers,
                          const fs::path& cache, const std::function<void(double)>& progress,
                          std::stop_token stop) {
  const fs::path file = cache / (cache_key(scene_key, settings) + ".exr");
  if (std::optional<FilmImage> cached = read_cached(file, settings)) {
    return std::move(*cached);
  }
  FilmImage image = ReferenceRender(tracer, settings, workers, progress, std::move(stop)).render();
  fs::create_directories(cache);
  write_film_image(file, image, 0.0);
  return image;
}

}  // namespace foveola
