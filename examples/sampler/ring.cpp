// A method of one's own: samples in a ring around the gaze, from 5 to 15 degrees of eccentricity,
// of which each steradian is as likely as any other. It writes the 360-degree image.
//   ring SCENE IMAGE.png
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>

#include "renderer/base/angles.h"
#include "renderer/image/image_file.h"
#include "renderer/progressive/loaded_scene.h"
#include "renderer/progressive/progressive_render.h"
#include "renderer/view/equirect.h"
#include "renderer/view/view_sampler.h"
#include "scenes/find_scene.h"

using namespace foveola;

namespace {

class RingSampler final : public ViewSampler {
 public:
  void aim(const Aim& aim) override { around_ = Frame(aim.gaze); }

  void sample(std::span<const Vec2> points, std::span<ViewSample> samples) const override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      // Uniform in the cosine is uniform in the solid angle (Archimedes).
      const double cosine = std::lerp(cosine_inside_, cosine_outside_, points[i].x);
      const double sine = std::sqrt(1.0 - cosine * cosine);
      const double turn = 2.0 * std::numbers::pi * points[i].y;
      const Vec3 direction =
          around_.to_world(Vec3(sine * std::cos(turn), sine * std::sin(turn), cosine));
      samples[i] = {direction, equirect_from_direction(direction)};
    }
  }

  double density_per_sr(const Vec3& direction) const override {
    const double cosine = dot(direction, around_.normal);
    const bool is_in_ring = cosine <= cosine_inside_ && cosine >= cosine_outside_;
    const double steradians = 2.0 * std::numbers::pi * (cosine_inside_ - cosine_outside_);
    return is_in_ring ? 1.0 / steradians : 0.0;
  }

 private:
  Frame around_{{0.0F, 0.0F, -1.0F}};
  double cosine_inside_ = std::cos(radians(5.0));
  double cosine_outside_ = std::cos(radians(15.0));
};

void render_ring(const char* scene, const char* image) {
  const Workers workers;
  const LoadedScene loaded(scenes::find_scene(scene), workers);
  ProgressiveRender render(loaded.tracer, loaded.rendered_with({.film_size = {1024, 512}}),
                           workers);
  RingSampler sampler;
  sampler.aim({.viewport = Viewport(loaded.camera.heading, {}),
               .gaze = direction_from(loaded.camera.heading)});
  const TracedSamples traced = render.advance(sampler, 1'000'000);
  write_film_image(image, render.film().resolve(), loaded.source.exposure_stops.value_or(0.0));
  std::printf("%s: %zu samples in the ring\n", image, static_cast<std::size_t>(traced.samples));
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 3) {
    throw std::invalid_argument("give a scene and the name of an image");
  }
  render_ring(argv[1], argv[2]);
} catch (const std::exception& error) {
  std::fprintf(stderr, "ring: error: %s\n", error.what());
  return 1;
}
