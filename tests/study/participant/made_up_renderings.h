// Made-up renderings, and simulated participants who look at them.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/film/viewport_resampler.h"
#include "renderer/image/tone_mapping.h"
#include "study/participant/population_file.h"
#include "study/participant/simulated_participant.h"

namespace foveola::study {

constexpr int view_size = 96;
constexpr double first_presented_s = 1.0;
constexpr double glance_s = 0.1;
inline const std::vector<OfferedObject> offered = {
    {.name = "Ball", .direction = direction_from({.azimuth_rad = 0.3}), .radius_deg = 8.0},
    {.name = "Cube", .direction = direction_from({.azimuth_rad = -0.3}), .radius_deg = 8.0}};

/// A panorama with stripes, bands and colours of several sizes.
inline RgbImage made_up_panorama() {
  RgbImage panorama(256, 128);
  for (int y = 0; y < panorama.height; ++y) {
    for (int x = 0; x < panorama.width; ++x) {
      const float stripes = x / 8 % 2 == 0 ? 0.15F : 0.7F;
      const float bands = y / 8 % 2 == 0 ? 0.6F : 1.0F;
      panorama.at(x, y) = stripes * bands * Rgb(1.0F, 0.8F, 0.5F);
    }
  }
  return panorama;
}

/// Without lapses and early presses, which are for the tests of decisions.
inline Population careful_adults() {
  Population population = read_people("adults").population;
  population.decision.lapse_part = 0.0;
  population.decision.early_part = 0.0;
  return population;
}

/// What a rendering shows `time_s` after its first frame.
using Display = std::function<RgbImage(const RgbImage& converged, double time_s)>;

/// Every pixel's noise falls with the square root of the time, as that of a progressive rendering.
inline RgbImage noisy(const RgbImage& converged, double time_s, double noise_after_1_s) {
  Pcg32 random(17, static_cast<std::uint64_t>(1e3 * time_s));
  RgbImage image = converged;
  for (Rgb& pixel : image.pixels) {
    const auto noise = static_cast<float>(noise_after_1_s / std::sqrt(time_s) * random.normal());
    pixel = glm::clamp(pixel + noise, 0.0F, 1.0F);
  }
  return image;
}

/// Moves every pixel to another place; the same one each time.
inline RgbImage scrambled(RgbImage image) {
  Pcg32 random(23);
  shuffle(std::span(image.pixels), random);
  return image;
}

/// Sits down for a trial at an object of "scene".
inline void sit_down(SimulatedParticipant& person, std::size_t object, std::uint32_t conduct = 7) {
  person.begin_attempt({.conduct = conduct});
  person.turn_to("scene", offered[object], Nanoseconds(0));
}

struct Marks {
  std::optional<double> outline_s;  ///< Time after the first frame.
  std::optional<double> material_s;
  friend bool operator==(const Marks&, const Marks&) = default;
};

class SimulatedParticipantTest : public ::testing::Test {
 protected:
  SimulatedParticipant participant(std::uint64_t seed) const {
    return {population_, [this](const std::string&) { return KnownScene{.panorama = &panorama_}; },
            seed};
  }

  /// The image that the view converges to, kept because most glances are through the same view.
  const RgbImage& converged(const Viewport& viewport) const {
    if (!converged_head_ || *converged_head_ != viewport.head()) {
      converged_head_ = viewport.head();
      converged_ = display_image(viewport_image(panorama_, viewport, view_size, view_size), 0.0);
    }
    return converged_;
  }

  std::optional<Nanoseconds> glance(SimulatedParticipant& person, Nanoseconds now,
                                    const Display& display) const {
    const Viewport viewport(head_orientation(person.head(now)), radians(100.0), radians(100.0));
    const RgbImage image =
        display(converged(viewport), seconds(now) - first_presented_s + glance_s);
    return person.see(
        {.image = image, .viewport = viewport, .gaze = person.gaze(now), .presented = now});
  }

  /// Looks every glance_s until a mark, but not beyond limit_s after the first frame.
  std::optional<Nanoseconds> wait(SimulatedParticipant& person, Task task, Nanoseconds& now,
                                  const Display& display, double limit_s) const {
    person.begin(task, now);
    while (seconds(now) - first_presented_s < limit_s) {
      const std::optional<Nanoseconds> mark = glance(person, now, display);
      if (mark) {
        EXPECT_GE(*mark, now) << "nobody reacts before they see";
        now = std::max(now, *mark);
        return mark;
      }
      now += nanoseconds_from_seconds(glance_s);
    }
    return std::nullopt;
  }

  Marks marks(SimulatedParticipant person, const Display& display,
              std::uint32_t conduct = 7) const {
    constexpr double limit_s = 40.0;
    sit_down(person, person.choose_object("scene", offered), conduct);
    Nanoseconds now = nanoseconds_from_seconds(first_presented_s);
    const auto after_first_frame = [](std::optional<Nanoseconds> mark) {
      return mark ? std::optional(seconds(*mark) - first_presented_s) : std::nullopt;
    };
    Marks result;
    result.outline_s = after_first_frame(wait(person, Task::mark_outline, now, display, limit_s));
    if (result.outline_s) {
      result.material_s =
          after_first_frame(wait(person, Task::mark_material, now, display, limit_s));
    }
    return result;
  }

  double rating(SimulatedParticipant person, const Display& display, double points = 5.0) const {
    sit_down(person, 0);
    Nanoseconds now = nanoseconds_from_seconds(first_presented_s);
    wait(person, Task::look_around, now, display, 3.0);
    const std::vector<Answer> answers = person.rate(
        {{.id = "artifacts", .minimum = 1.0, .maximum = points, .simulated = "artifacts"}});
    EXPECT_EQ(answers.size(), 1U);
    return std::get<double>(answers.at(0).value);
  }

  Population population_ = careful_adults();
  RgbImage panorama_ = made_up_panorama();
  std::size_t chosen_ = 0;
  mutable std::optional<Quat> converged_head_;
  mutable RgbImage converged_;
};

inline RgbImage rendering(const RgbImage& image, double time_s) {
  return noisy(image, time_s, 0.1);
}
inline RgbImage finished(const RgbImage& image, double) { return image; }
inline RgbImage black(const RgbImage& image, double) { return {image.width, image.height}; }

}  // namespace foveola::study
