#include "renderer/gaze/simulated_eye.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "renderer/base/angles.h"

namespace foveola {
namespace {

using std::chrono::hours;
using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::minutes;

TEST(Saccade, LastsAsLongAsTheMainSequenceSays) {
  EXPECT_NEAR(saccade_duration_s(0.0), 0.021, 1e-15);
  EXPECT_NEAR(saccade_duration_s(10.0), 0.043, 1e-15);
}

// The formula as published, worked out elsewhere.
TEST(Saccade, ProgressesByThePublishedFormula) {
  struct Point {
    double amplitude_deg;
    double since_middle_s;
    double progress_deg;
  };
  for (const Point& p : {Point{10.0, -0.008333333333333333, 1.4464890099791214},
                         {10.0, -0.003333333333333333, 3.4063612099605556},
                         {10.0, 0.011666666666666667, 9.257347779784212},
                         {1.0, -0.004833333333333334, 0.19105603886931866},
                         {0.2, 0.0028333333333333335, 0.1432481248759916},
                         {25.0, 0.009166666666666667, 17.85826017646839}}) {
    EXPECT_NEAR(saccade_progress_deg(p.amplitude_deg, p.since_middle_s), p.progress_deg, 1e-12);
  }
}

// eta (1 - exp(-A / c)), as its authors state.
TEST(Saccade, IsFastestInTheMiddleAndAsFastAsStated) {
  constexpr double step_s = 1e-6;
  const auto velocity = [](double amplitude_deg, double t_s) {
    return (saccade_progress_deg(amplitude_deg, t_s + step_s) -
            saccade_progress_deg(amplitude_deg, t_s - step_s)) /
           (2.0 * step_s);
  };
  for (const double amplitude_deg : {0.1, 1.0, 5.0, 10.0, 20.0, 40.0}) {
    const double stated = 600.0 * (1.0 - std::exp(-amplitude_deg / 6.0));
    EXPECT_NEAR(velocity(amplitude_deg, 0.0), stated, 1e-4 * stated);
    for (double t_s = -0.1; t_s < 0.1; t_s += 0.0007) {
      EXPECT_LE(velocity(amplitude_deg, t_s), stated * (1.0 + 1e-6));
    }
  }
}

TEST(Saccade, IsSymmetricAndGoesAllTheWay) {
  for (const double amplitude_deg : {0.1, 2.0, 30.0}) {
    EXPECT_NEAR(saccade_progress_deg(amplitude_deg, -0.3), 0.0, 1e-9);
    EXPECT_NEAR(saccade_progress_deg(amplitude_deg, 0.3), amplitude_deg, 1e-9);
    EXPECT_NEAR(
        saccade_progress_deg(amplitude_deg, 0.004) + saccade_progress_deg(amplitude_deg, -0.004),
        amplitude_deg, 1e-12);
  }
}

/// Fixations and saccades only.
SimulatedEyeSettings plain(std::uint64_t seed) {
  return {.seed = seed, .microsaccade_interval_s = 0.0, .blinks_per_minute = 0.0};
}

double degrees_between(const Vec3& a, const DVec3& b) { return degrees(angle_between(a, Vec3(b))); }

TEST(SimulatedEye, FixatesBetweenSaccades) {
  SimulatedEye eye(plain(3));
  const std::vector<SimulatedSaccade> saccades = eye.saccades(hours(1));
  double sum_s = 0.0;
  for (std::size_t i = 1; i < saccades.size(); ++i) {
    const double fixation_s = foveola::seconds(saccades[i].start - saccades[i - 1].end);
    ASSERT_GE(fixation_s, 0.2 - 1e-8);
    ASSERT_LE(fixation_s, 0.35 + 1e-8);
    sum_s += fixation_s;
    ASSERT_EQ(saccades[i].from, saccades[i - 1].to);
  }
  const auto count = static_cast<double>(saccades.size() - 1);
  const double deviation_s = 0.15 / std::sqrt(12.0);  // of a uniform distribution
  EXPECT_NEAR(sum_s / count, 0.275, 5.0 * deviation_s / std::sqrt(count));
}

TEST(SimulatedEye, SaccadesAreWithinTheirLimits) {
  SimulatedEye eye(plain(4));
  const DVec3 ahead(0.0, 0.0, -1.0);
  double square_sum = 0.0;
  const std::vector<SimulatedSaccade> saccades = eye.saccades(hours(1));
  for (const SimulatedSaccade& saccade : saccades) {
    ASSERT_NEAR(saccade.amplitude_deg, degrees_between(Vec3(saccade.from), saccade.to), 1e-4);
    ASSERT_GE(saccade.amplitude_deg, 1.0);
    ASSERT_LT(saccade.amplitude_deg, 30.0);
    ASSERT_LE(degrees_between(Vec3(saccade.to), ahead), 30.0 + 1e-4);
    ASSERT_NEAR(foveola::seconds(saccade.end - saccade.start),
                0.021 + 0.0022 * saccade.amplitude_deg, 2e-9);
    ASSERT_FALSE(saccade.is_micro);
    const double right_deg = degrees(azimuth_elevation(Vec3(saccade.to)).azimuth_rad);
    square_sum += right_deg * right_deg;
  }
  // Of 10 degrees, the limits leave this much, by 60 000 draws written down in another language.
  const double deviation_deg = std::sqrt(square_sum / static_cast<double>(saccades.size()));
  EXPECT_NEAR(deviation_deg, 9.28, 0.3);
}

TEST(SimulatedEye, LooksAheadAtFirst) {
  SimulatedEye eye(plain(5));
  EXPECT_LT(degrees_between(*eye.gaze(Nanoseconds(0)), {0.0, 0.0, -1.0}), 1e-5);
  EXPECT_EQ(eye.gaze(-milliseconds(100)), eye.gaze(Nanoseconds(0)));
}

TEST(SimulatedEye, RestsWhereItsSaccadesLead) {
  SimulatedEye eye(plain(5));
  for (const SimulatedSaccade& saccade : eye.saccades(minutes(1))) {
    EXPECT_LT(degrees_between(*eye.gaze(saccade.end + milliseconds(100)), saccade.to), 1e-5);
    const Nanoseconds middle = saccade.start + (saccade.end - saccade.start) / 2;
    const Vec3 half_way = *eye.gaze(middle);
    EXPECT_NEAR(degrees_between(half_way, saccade.from), 0.5 * saccade.amplitude_deg, 1e-4);
    EXPECT_NEAR(degrees_between(half_way, saccade.to), 0.5 * saccade.amplitude_deg, 1e-4);
  }
}

TEST(SimulatedEye, MovesAsFastAsItsSaccades) {
  SimulatedEye eye(plain(6));
  const Nanoseconds step = microseconds(500);
  for (const SimulatedSaccade& saccade : eye.saccades(minutes(1))) {
    const Nanoseconds middle = saccade.start + (saccade.end - saccade.start) / 2;
    const double measured =
        degrees(angle_between(*eye.gaze(middle - step), *eye.gaze(middle + step))) /
        foveola::seconds(2 * step);
    const double stated = 600.0 * (1.0 - std::exp(-saccade.amplitude_deg / 6.0));
    // The mean over a millisecond around the middle is a little less.
    EXPECT_LT(measured, stated * 1.001);
    EXPECT_GT(measured, stated * 0.95);
  }
}

TEST(SimulatedEye, NeverJumps) {
  SimulatedEye eye({.seed = 8, .blinks_per_minute = 0.0});
  Vec3 last = *eye.gaze(Nanoseconds(0));
  for (Nanoseconds time = microseconds(100); time < minutes(1); time += microseconds(100)) {
    const Vec3 gaze = *eye.gaze(time);
    ASSERT_LT(degrees(angle_between(last, gaze)), 600.0 * 1e-4 + 1e-4);
    last = gaze;
  }
}

/// One fixation without end, in which there are only microsaccades.
SimulatedEyeSettings staring(std::uint64_t seed) {
  return {.seed = seed,
          .shortest_fixation_s = 20000.0,
          .longest_fixation_s = 20000.0,
          .blinks_per_minute = 0.0};
}

struct Moments {
  double mean = 0.0;
  double deviation = 0.0;
};
Moments moments_of(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  Moments moments;
  for (const double value : values) {
    moments.mean += value / count;
  }
  for (const double value : values) {
    moments.deviation += (value - moments.mean) * (value - moments.mean) / count;
  }
  moments.deviation = std::sqrt(moments.deviation);
  return moments;
}

// A Gamma distribution of shape k has a standard deviation of its mean over sqrt(k).
TEST(SimulatedEye, MicrosaccadesAreGammaDistributed) {
  SimulatedEye eye(staring(9));
  const std::vector<SimulatedSaccade> saccades = eye.saccades(hours(5));
  std::vector<double> intervals_s;
  std::vector<double> amplitudes_arcmin;
  for (std::size_t i = 1; i < saccades.size(); ++i) {
    ASSERT_TRUE(saccades[i].is_micro);
    intervals_s.push_back(foveola::seconds(saccades[i].start - saccades[i - 1].start));
    amplitudes_arcmin.push_back(60.0 * saccades[i].amplitude_deg);
  }
  ASSERT_GT(intervals_s.size(), 30000U);
  const Moments interval = moments_of(intervals_s);
  EXPECT_NEAR(interval.mean, 0.45, 0.006);  // five standard errors
  EXPECT_NEAR(interval.deviation, 0.45 / std::sqrt(5.0), 0.006);
  const Moments amplitude = moments_of(amplitudes_arcmin);
  EXPECT_NEAR(amplitude.mean, 8.0, 0.1);
  EXPECT_NEAR(amplitude.deviation, 4.0, 0.15);
}

TEST(SimulatedEye, MicrosaccadesDoNotLeadAway) {
  SimulatedEye eye(staring(10));
  for (Nanoseconds time{0}; time < hours(5); time += std::chrono::seconds(1)) {
    ASSERT_LT(degrees_between(*eye.gaze(time), {0.0, 0.0, -1.0}), 1.5);
  }
}

TEST(SimulatedEye, MicrosaccadesKeepOutOfTheWayOfSaccades) {
  SimulatedEye eye({.seed = 11, .blinks_per_minute = 0.0});
  const std::vector<SimulatedSaccade> saccades = eye.saccades(minutes(10));
  for (std::size_t i = 1; i < saccades.size(); ++i) {
    ASSERT_GE(saccades[i].start, saccades[i - 1].end);
  }
  const auto micro = std::count_if(saccades.begin(), saccades.end(),
                                   [](const SimulatedSaccade& s) { return s.is_micro; });
  // At most one for every 0.45 s; what a saccade is in the way of does not take place.
  EXPECT_LT(micro, 600.0 / 0.45 * 1.1);
  EXPECT_GT(micro, 600.0 / 0.45 * 0.5);
}

TEST(SimulatedEye, BlinksAsOftenAndAsLongAsItShould) {
  SimulatedEye eye({.seed = 12});
  const std::vector<SimulatedBlink> blinks = eye.blinks(hours(10));
  std::vector<double> lengths_s;
  for (std::size_t i = 0; i < blinks.size(); ++i) {
    lengths_s.push_back(foveola::seconds(blinks[i].end - blinks[i].start));
    ASSERT_GE(lengths_s.back(), 0.1 - 1e-8);
    ASSERT_LE(lengths_s.back(), 0.4 + 1e-8);
    if (i > 0) {
      ASSERT_GE(blinks[i].start - blinks[i - 1].end, milliseconds(500));
    }
  }
  const double expected = 17.5 * 600.0;
  EXPECT_NEAR(static_cast<double>(blinks.size()), expected, 5.0 * std::sqrt(expected));
  EXPECT_NEAR(moments_of(lengths_s).mean, 0.25, 0.01);
}

TEST(SimulatedEye, HasNoGazeWhileItBlinks) {
  SimulatedEye eye({.seed = 13});
  for (const SimulatedBlink& blink : eye.blinks(minutes(5))) {
    EXPECT_TRUE(eye.gaze(blink.start - Nanoseconds(1)));
    EXPECT_FALSE(eye.gaze(blink.start));
    EXPECT_FALSE(eye.gaze(blink.end - Nanoseconds(1)));
    EXPECT_TRUE(eye.gaze(blink.end));
  }
}

TEST(SimulatedEye, IsTheSameInWhateverOrderItIsAsked) {
  SimulatedEye forwards({.seed = 14});
  SimulatedEye backwards({.seed = 14});
  std::vector<std::optional<Vec3>> seen;
  for (int i = 0; i < 10000; ++i) {
    seen.push_back(forwards.gaze(i * milliseconds(7)));
  }
  for (int i = 9999; i >= 0; --i) {
    ASSERT_EQ(backwards.gaze(i * milliseconds(7)), seen[static_cast<std::size_t>(i)]);
  }
}

// By the generator as its author describes it, written down in another language.
TEST(SimulatedEye, IsTheSameEverywhere) {
  const auto first_saccade_s = [](std::uint64_t seed) {
    return foveola::seconds(SimulatedEye(plain(seed)).saccades(minutes(1)).front().start);
  };
  EXPECT_NEAR(first_saccade_s(1), 0.3325527690397595, 1.5e-9);
  EXPECT_NEAR(first_saccade_s(7), 0.34192777853342815, 1.5e-9);
  const SimulatedBlink blink = SimulatedEye({.seed = 7}).blinks(minutes(1)).front();
  EXPECT_NEAR(foveola::seconds(blink.start), 2.9046802686733812, 2.5e-9);
  EXPECT_NEAR(foveola::seconds(blink.end), 3.1851013124106466, 3.5e-9);
}

}  // namespace
}  // namespace foveola
