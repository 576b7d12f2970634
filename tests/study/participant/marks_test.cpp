// When a simulated participant presses the key.
#include <utility>

#include "tests/study/participant/made_up_renderings.h"

namespace foveola::study {
namespace {

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

TEST_F(SimulatedParticipantTest, NeverMarksABlackImage) {
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
// presses at the same time: the press depends on nothing else.
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

// Noise in the left half of an object of 40 degrees: its visibility depends on where the eye
// points, even with the same pixels.
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
      person.begin_attempt({});
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
  person.begin_attempt({});
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

}  // namespace
}  // namespace foveola::study
