#include "study/participant/simulated_participant.h"

#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "renderer/film/viewport_image.h"
#include "renderer/image/tone_mapping.h"
#include "study/participant/population_file.h"

namespace foveola::study {
namespace {

constexpr int view_size = 96;
constexpr double first_presented_s = 1.0;
constexpr double glance_s = 0.1;
const std::vector<OfferedObject> offered = {
    {.name = "Ball", .direction = direction_from({.azimuth_rad = 0.3}), .radius_deg = 8.0},
    {.name = "Cube", .direction = direction_from({.azimuth_rad = -0.3}), .radius_deg = 8.0}};

/// A panorama with things to see in it: stripes, bands and colours of several sizes.
RgbImage made_up_panorama() {
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
Population careful_adults() {
  Population population = read_people("adults").population;
  population.decision.lapse_part = 0.0;
  population.decision.early_part = 0.0;
  return population;
}

/// What a rendering shows `time_s` after its first frame.
using Display = std::function<RgbImage(const RgbImage& converged, double time_s)>;

/// Every pixel's noise falls with the square root of the time, as that of a progressive rendering.
RgbImage noisy(const RgbImage& converged, double time_s, double noise_after_1_s) {
  Pcg32 random(17, static_cast<std::uint64_t>(1e3 * time_s));
  RgbImage image = converged;
  for (Rgb& pixel : image.pixels) {
    const auto noise = static_cast<float>(noise_after_1_s / std::sqrt(time_s) * random.normal());
    pixel = glm::clamp(pixel + noise, 0.0F, 1.0F);
  }
  return image;
}

/// Moves every pixel to another place; the same one each time.
RgbImage scrambled(RgbImage image) {
  Pcg32 random(23);
  shuffle(std::span(image.pixels), random);
  return image;
}

/// Sits down for a trial at an object of "scene".
void sit_down(SimulatedParticipant& person, std::size_t object, std::uint32_t conduct = 7) {
  person.begin_occasion({.conduct = conduct});
  person.turn_to("scene", offered[object], Nanoseconds(0));
}

struct Marks {
  std::optional<double> outline_s;  ///< after the first frame
  std::optional<double> material_s;
  friend bool operator==(const Marks&, const Marks&) = default;
};

class SimulatedParticipantTest : public ::testing::Test {
 protected:
  SimulatedParticipant participant(std::uint64_t seed) const {
    return {population_, [this](const std::string&) { return KnownScene{.panorama = &panorama_}; },
            seed};
  }

  /// What the view converges to; kept, since most looks are through the same view.
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
    const std::vector<Answer> answers =
        person.rate({{.id = "artifacts", .minimum = 1.0, .maximum = points}});
    EXPECT_EQ(answers.size(), 1U);
    return std::get<double>(answers.at(0).value);
  }

  Population population_ = careful_adults();
  RgbImage panorama_ = made_up_panorama();
  std::size_t chosen_ = 0;
  mutable std::optional<Quat> converged_head_;
  mutable RgbImage converged_;
};

RgbImage rendering(const RgbImage& image, double time_s) { return noisy(image, time_s, 0.1); }
RgbImage finished(const RgbImage& image, double) { return image; }
RgbImage black(const RgbImage& image, double) { return {image.width, image.height}; }

TEST_F(SimulatedParticipantTest, MarksAFinishedImageAfterLookingAndReacting) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Marks m = marks(participant(seed), finished);
    ASSERT_TRUE(m.outline_s && m.material_s);
    EXPECT_GT(*m.outline_s, 0.3);
    EXPECT_LT(*m.outline_s, 1.5);
    EXPECT_GT(*m.material_s - *m.outline_s, 0.3);
    EXPECT_LT(*m.material_s, 3.0);
  }
}

TEST_F(SimulatedParticipantTest, NeverMarksBlackness) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    EXPECT_EQ(marks(participant(seed), black), Marks{});
  }
}

TEST_F(SimulatedParticipantTest, MarksWhatTheRenderingShowsAndNotWhatIsScrambled) {
  const Display scrambled_rendering = [](const RgbImage& image, double time_s) {
    return scrambled(rendering(image, time_s));
  };
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const Marks seen = marks(participant(seed), rendering);
    ASSERT_TRUE(seen.outline_s && seen.material_s);
    EXPECT_FALSE(marks(participant(seed), scrambled_rendering).material_s);
  }
}

TEST_F(SimulatedParticipantTest, MarksTheOutlineBeforeTheMaterialIsRight) {
  population_.decision.criterion_spread = 0.0;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const Marks m = marks(participant(seed), rendering);
    ASSERT_TRUE(m.outline_s && m.material_s);
    EXPECT_LT(2.0 * *m.outline_s, *m.material_s);
  }
}

TEST_F(SimulatedParticipantTest, LooksAtTheChosenObjectOnly) {
  const Display finished_at_object = [this](const RgbImage& image, double) {
    RgbImage half = black(image, 0.0);
    const Vec3& object = offered[chosen_].direction;
    const Viewport facing(head_orientation(azimuth_elevation(object)), radians(100.0),
                          radians(100.0));
    for (int y = 0; y < view_size; ++y) {
      for (int x = 0; x < view_size; ++x) {
        const Vec2 plane(Vec2(x, y) / static_cast<float>(view_size) + 0.5F / view_size);
        const double away_deg = degrees(angle_between(facing.direction(plane), object));
        if (away_deg < offered[chosen_].radius_deg * 1.5 + 2.0) {
          half.at(x, y) = image.at(x, y);
        }
      }
    }
    return half;
  };
  SimulatedParticipant person = participant(3);
  chosen_ = person.choose_object("scene", offered);
  EXPECT_TRUE(marks(person, finished_at_object).material_s);
}

TEST_F(SimulatedParticipantTest, IsAlwaysTheSamePersonForASeedAndAnotherForAnother) {
  const Marks first = marks(participant(1), rendering);
  EXPECT_EQ(first, marks(participant(1), rendering));
  const Marks second = marks(participant(2), rendering);
  EXPECT_NE(first.outline_s, second.outline_s);
  EXPECT_NE(first.material_s, second.material_s);
}

TEST_F(SimulatedParticipantTest, LosesInterestAfterAMark) {
  SimulatedParticipant person = participant(4);
  sit_down(person, 0);
  Nanoseconds now = nanoseconds_from_seconds(first_presented_s);
  ASSERT_TRUE(wait(person, Task::mark_outline, now, finished, 5.0));
  for (int i = 0; i < 20; ++i) {
    now += nanoseconds_from_seconds(glance_s);
    EXPECT_FALSE(glance(person, now, finished));
  }
}

TEST_F(SimulatedParticipantTest, StaysWithOneObjectPerSceneAndDiffersInItsChoice) {
  std::vector<int> chosen(offered.size());
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SimulatedParticipant person = participant(seed);
    const std::size_t first = person.choose_object("scene", offered);
    person.choose_object("another scene", offered);
    EXPECT_EQ(person.choose_object("scene", offered), first);
    ++chosen.at(first);
  }
  EXPECT_GT(chosen[0], 0);
  EXPECT_GT(chosen[1], 0);
}

TEST_F(SimulatedParticipantTest, RatesByWhatIsWrongWithTheImage) {
  const Display slightly_noisy = [](const RgbImage& image, double) {
    return noisy(image, 1.0, 0.15);
  };
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    EXPECT_EQ(rating(participant(seed), finished), 1);
    EXPECT_EQ(rating(participant(seed), black), 5);
    EXPECT_EQ(rating(participant(seed), black, 3.0), 3) << "of a shorter scale";
    const double noisy_rating = rating(participant(seed), slightly_noisy);
    EXPECT_GT(noisy_rating, 1);
    EXPECT_LT(noisy_rating, 5);
  }
}

TEST_F(SimulatedParticipantTest, AnOccasionDependsOnNothingThatWasBefore) {
  SimulatedParticipant tired = participant(1);
  sit_down(tired, 1, 99);
  Nanoseconds now = nanoseconds_from_seconds(first_presented_s);
  wait(tired, Task::mark_outline, now, rendering, 40.0);
  wait(tired, Task::look_around, now, rendering, 5.0);
  tired.rate({{.id = "artifacts"}});
  tired.answer("background", {{.id = "age"}});
  tired.react(3);
  EXPECT_EQ(marks(tired, rendering), marks(participant(1), rendering));
  EXPECT_NE(marks(participant(1), rendering, 7), marks(participant(1), rendering, 8))
      << "but on its own chance";
}

TEST_F(SimulatedParticipantTest, AnswersAFormAlwaysTheSameAndAnotherDifferently) {
  const std::vector<Question> questions(
      20, {.id = "q", .kind = QuestionKind::number, .minimum = 0.0, .maximum = 1000.0});
  SimulatedParticipant person = participant(2);
  const std::vector<Answer> first = person.answer("background", questions);
  EXPECT_NE(person.answer("debrief", questions), first);
  EXPECT_EQ(person.answer("background", questions), first);
  EXPECT_NE(participant(3).answer("background", questions), first);
}

TEST_F(SimulatedParticipantTest, SwappingTwoRenderingsSwapsTheirTimes) {
  const Display slow = [](const RgbImage& image, double time_s) {
    return noisy(image, time_s, 0.2);
  };
  const Display fast = [](const RgbImage& image, double time_s) {
    return noisy(image, 4.0 * time_s, 0.2);
  };
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Marks od = marks(participant(seed), slow, 1);
    const Marks fv = marks(participant(seed), fast, 1);
    ASSERT_TRUE(od.material_s && fv.material_s);
    EXPECT_GT(*od.material_s, *fv.material_s);
    EXPECT_EQ(marks(participant(seed), fast, 1), fv) << "whichever was first";
  }
}

// A person who is shown, as another scene's knowledge has it, the same pixels through the same view
// presses at the same time: there is nothing else that could tell.
TEST_F(SimulatedParticipantTest, TheSamePixelsGiveTheSamePress) {
  std::vector<RgbImage> shown;
  const Display recorded = [&shown](const RgbImage& image, double time_s) {
    shown.push_back(rendering(image, time_s));
    return shown.back();
  };
  const Marks first = marks(participant(6), recorded);
  std::size_t frame = 0;
  const Display replayed = [&](const RgbImage&, double) { return shown.at(frame++); };
  ASSERT_TRUE(first.material_s);
  EXPECT_EQ(marks(participant(6), replayed), first);
}

// Noise in the left half of an object of 40 degrees: how much of it is put up with depends on where
// the eye points, be the pixels the same.
TEST_F(SimulatedParticipantTest, WhatIsLookedAtCountsMoreThanWhatIsNot) {
  population_.decision.criterion_spread = 0.0;
  population_.decision.glance_noise = 0.0;
  const OfferedObject wide{.name = "Wall", .direction = Vec3(0.0F, 0.0F, -1.0F), .radius_deg = 20};
  const Viewport viewport(head_orientation({}), radians(100.0), radians(100.0));
  const auto largest_noise_accepted = [&](double gaze_azimuth_deg) {
    const Vec3 gaze = direction_from({.azimuth_rad = radians(gaze_azimuth_deg)});
    double accepted = 0.0;
    for (double noise = 0.02; noise < 0.2; noise *= 1.03) {
      RgbImage image = noisy(converged(viewport), 1.0, noise);
      for (int y = 0; y < view_size; ++y) {
        for (int x = view_size / 2; x < view_size; ++x) {
          image.at(x, y) = converged(viewport).at(x, y);
        }
      }
      SimulatedParticipant person = participant(1);
      person.begin_occasion({});
      person.turn_to("scene", wide, Nanoseconds(0));
      person.begin(Task::mark_material, Nanoseconds(0));
      for (int glance = 0; glance < 4; ++glance) {
        const auto press = person.see({.image = image,
                                       .viewport = viewport,
                                       .gaze = gaze,
                                       .presented = nanoseconds_from_seconds(glance * glance_s)});
        accepted = press ? noise : accepted;
      }
    }
    return accepted;
  };
  EXPECT_GT(largest_noise_accepted(15.0), 1.2 * largest_noise_accepted(-15.0));
}

// Noise of single pixels, of a degree each, is averaged in the outline's cells of 5 degrees.
TEST_F(SimulatedParticipantTest, JudgesAMaterialInFinerDetailThanAnOutline) {
  population_.decision.criterion_spread = 0.0;
  const OfferedObject wide{.name = "Wall", .direction = Vec3(0.0F, 0.0F, -1.0F), .radius_deg = 20};
  const Viewport viewport(head_orientation({}), radians(100.0), radians(100.0));
  const RgbImage image = noisy(converged(viewport), 1.0, 0.1);
  SimulatedParticipant person = participant(1);
  person.begin_occasion({});
  person.turn_to("scene", wide, Nanoseconds(0));
  const auto marks_within_a_second = [&](Task task) {
    person.begin(task, Nanoseconds(0));
    bool marked = false;
    for (int glance = 0; glance < 10; ++glance) {
      const Nanoseconds now = nanoseconds_from_seconds(glance * glance_s);
      marked =
          marked ||
          person.see(
              {.image = image, .viewport = viewport, .gaze = wide.direction, .presented = now});
    }
    return marked;
  };
  EXPECT_TRUE(marks_within_a_second(Task::mark_outline));
  EXPECT_FALSE(marks_within_a_second(Task::mark_material));
}

TEST_F(SimulatedParticipantTest, ConsideringWhatIsSeenIsSeeing) {
  SimulatedParticipant person = participant(8);
  sit_down(person, 0);
  person.begin(Task::mark_material, Nanoseconds(0));
  std::optional<Nanoseconds> press;
  for (int glance = 0; !press && glance < 10; ++glance) {
    press = person.consider({.material_jnd = 0.1}, nanoseconds_from_seconds(glance * glance_s));
  }
  EXPECT_TRUE(press);
  EXPECT_FALSE(person.wants_retime());
}

TEST_F(SimulatedParticipantTest, RatesWorseWhatIsWorse) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    double before = 0.0;
    for (const double noise : {0.0, 0.05, 0.1, 0.2, 0.4}) {
      const double now = rating(participant(seed), [noise](const RgbImage& image, double) {
        return noisy(image, 1.0, noise);
      });
      EXPECT_GE(now, before) << noise;
      before = now;
    }
    EXPECT_GT(before, 2.0);
  }
}

TEST_F(SimulatedParticipantTest,
       RatingsDifferBetweenPeopleByTheirBiasAndBetweenTrialsByTheirNoise) {
  const auto rated = [&](std::uint64_t seed, std::uint32_t conduct) {
    SimulatedParticipant person = participant(seed);
    person.begin_occasion({.conduct = conduct});
    person.begin(Task::look_around, Nanoseconds(0));
    person.consider({.artifacts_jnd = 2.8}, Nanoseconds(0));
    return std::get<double>(
        person.rate({{.id = "artifacts", .minimum = 1.0, .maximum = 5.0}}).at(0).value);
  };
  const auto ratings = [&](double bias_spread, double noise_spread) {
    population_.rating.bias_spread = bias_spread;
    population_.rating.noise_spread = noise_spread;
    std::set<double> of_people;
    std::set<double> of_trials;
    for (std::uint32_t i = 0; i < 30; ++i) {
      of_people.insert(rated(i, 1));
      of_trials.insert(rated(1, i));
    }
    return std::pair(of_people.size(), of_trials.size());
  };
  EXPECT_EQ(ratings(0.0, 0.0), std::pair(std::size_t{1}, std::size_t{1}));
  EXPECT_GT(ratings(0.5, 0.0).first, 1U);
  EXPECT_EQ(ratings(0.5, 0.0).second, 1U);
  EXPECT_GT(ratings(0.0, 0.5).second, 1U);
}

// The mean and the variance of an ex-Gaussian, times this person's own factor.
TEST_F(SimulatedParticipantTest, ReactsLikePeople) {
  population_.decision.reaction_spread = 0.0;
  population_.decision.reaction_mean_s = 0.25;
  population_.decision.reaction_deviation_s = 0.03;
  population_.decision.reaction_tail_s = 0.07;
  SimulatedParticipant person = participant(5);
  constexpr int presses = 4000;
  double sum_s = 0.0;
  double squares = 0.0;
  for (std::uint32_t press = 0; press < presses; ++press) {
    const double reaction_s = seconds(person.react(press));
    EXPECT_GT(reaction_s, 0.1);
    sum_s += reaction_s;
    squares += reaction_s * reaction_s;
  }
  const double mean_s = sum_s / presses;
  const double deviation_s = std::sqrt(squares / presses - mean_s * mean_s);
  EXPECT_NEAR(mean_s, 0.320, 4.0 * 0.0762 / std::sqrt(presses));
  EXPECT_NEAR(deviation_s, std::hypot(0.030, 0.070), 0.006);
  EXPECT_EQ(person.react(17), person.react(17));
}

}  // namespace
}  // namespace foveola::study
