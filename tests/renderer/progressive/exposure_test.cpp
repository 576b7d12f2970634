#include "renderer/progressive/exposure.h"

#include <cmath>
#include <limits>

#include "renderer/stability/shapes.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

using Base = ExposureChoice::Base;

std::vector<float> many(std::size_t count, float value) { return std::vector(count, value); }

std::vector<float> together(std::vector<float> a, const std::vector<float>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(AutomaticExposure, BringsTheLogarithmicMeanToMiddleGrey) {
  EXPECT_NEAR(*automatic_exposure_stops(many(10, 0.18F)), 0.0, 0.005);
  EXPECT_NEAR(*automatic_exposure_stops(many(10, 0.72F)), -2.0, 0.005);
  // Half of 0.09 and half of 0.36: their geometric mean is 0.18.
  EXPECT_NEAR(*automatic_exposure_stops(together(many(50, 0.09F), many(50, 0.36F))), 0.0, 0.005);
  EXPECT_NEAR(*automatic_exposure_stops(many(10, 0.18F * 683.0F)), -std::log2(683.0), 0.005);
}

TEST(AutomaticExposure, BlackSurroundingsDoNotCount) {
  EXPECT_NEAR(*automatic_exposure_stops(together(many(10, 0.18F), many(990, 0.0F))), 0.0, 0.005);
  // Nor those that are as good as black beside the rest: more than 8 stops darker.
  EXPECT_NEAR(*automatic_exposure_stops(together(many(100, 0.18F), many(900, 1e-5F))), 0.0, 0.005);
  EXPECT_LT(*automatic_exposure_stops(together(many(100, 0.18F), many(900, 0.18F / 64.0F))), 6.0);
}

/// Two of a hundred cells are a million times as bright: 0.02 log2(10^6) is 0.4 stops.
TEST(AutomaticExposure, ASmallLampCountsLittle) {
  EXPECT_NEAR(*automatic_exposure_stops(together(many(98, 0.18F), many(2, 0.18e6F))), -0.4, 0.01);
}

/// A pale object, a tenth of the picture, on ground 22 times darker: white, and not cut.
TEST(AutomaticExposure, PaleThingsOnDarkGroundStayBelowWhite) {
  EXPECT_NEAR(*automatic_exposure_stops(together(many(90, 0.09F), many(10, 2.0F))), -1.0, 0.005);
  // But a window does not make the room before it black: two stops at most.
  EXPECT_NEAR(*automatic_exposure_stops(together(many(90, 0.18F), many(10, 18.0F))),
              -0.1 * std::log2(100.0) - 2.0, 0.005);
}

TEST(AutomaticExposure, WithoutLightThereIsNone) {
  EXPECT_EQ(automatic_exposure_stops({}), std::nullopt);
  EXPECT_EQ(automatic_exposure_stops(many(10, 0.0F)), std::nullopt);
  EXPECT_EQ(automatic_exposure_stops({std::nanf(""), -1.0F, 0.0F}), std::nullopt);
}

SceneSource named(std::optional<double> exposure_stops) {
  SceneSource source;
  source.exposure_stops = exposure_stops;
  source.camera_position = Vec3(0.0F);
  return source;
}

/// Nothing but surroundings of 0.72, which are two stops brighter than middle grey.
Scene surroundings() {
  Scene scene;
  scene.environment = constant_environment(0.72F);
  return scene;
}

Exposure chosen(const ExposureChoice& choice, std::optional<double> own, int threads = 1) {
  const Workers workers(threads);
  const LoadedScene loaded(named(own), surroundings(), workers);
  const Viewport ahead({}, {.horizontal_deg = 60.0, .vertical_deg = 36.0, .lens = {}});
  return chosen_exposure(choice, loaded, ahead, {}, workers);
}

TEST(ChosenExposure, IsTheScenesOrElseAutomatic) {
  EXPECT_EQ(chosen({}, 1.5).stops, 1.5);
  EXPECT_FALSE(chosen({}, 1.5).is_automatic);
  EXPECT_NEAR(chosen({}, std::nullopt).stops, -2.0, 0.005);
  EXPECT_TRUE(chosen({}, std::nullopt).is_automatic);
}

TEST(ChosenExposure, AddsWhatTheUserSays) {
  EXPECT_EQ(chosen({.base = Base::scene, .more_stops = 2.0}, 1.5).stops, 3.5);
  EXPECT_NEAR(chosen({.base = Base::scene, .more_stops = 2.0}, std::nullopt).stops, 0.0, 0.005);
  EXPECT_NEAR(chosen({.base = Base::automatic, .more_stops = 1.0}, 1.5).stops, -1.0, 0.005);
  EXPECT_EQ(chosen({.base = Base::none, .more_stops = -3.0}, 1.5).stops, -3.0);
  EXPECT_FALSE(chosen({.base = Base::none, .more_stops = -3.0}, std::nullopt).is_automatic);
}

TEST(ChosenExposure, OfABlackSceneIsNone) {
  const Workers workers(1);
  const LoadedScene loaded(named(std::nullopt), Scene{}, workers);
  const Exposure exposure =
      chosen_exposure({.more_stops = 1.0}, loaded, Viewport({}, {}), {}, workers);
  EXPECT_EQ(exposure.stops, 1.0);
  EXPECT_FALSE(exposure.is_automatic);
}

/// A wall of 0.18 before surroundings that are a hundred times as bright or as dark.
TEST(ChosenExposure, IsThatOfTheSceneAndNotOfWhatSurroundsIt) {
  const Viewport ahead({}, {.horizontal_deg = 60.0, .vertical_deg = 36.0, .lens = {}});
  const auto stops = [&](float half_width, float around) {
    Scene scene;
    scene.environment = constant_environment(around);
    scene.meshes = {
        quad({-half_width, -half_width, -1}, {2 * half_width, 0, 0}, {0, 2 * half_width, 0}, 0)};
    scene.materials = {lamp(Rgb(0.18F), true)};
    const Workers workers(1);
    return *automatic_exposure_stops(PathTracer(scene, workers), Vec3(0.0F), ahead, {}, workers);
  };
  EXPECT_NEAR(stops(0.25F, 18.0F), 0.0, 0.05);
  EXPECT_NEAR(stops(0.25F, 0.0018F), 0.0, 0.05);
  EXPECT_LT(stops(0.05F, 18.0F), -5.0) << "too small to be what the picture is of";
}

TEST(ChosenExposure, IsEqualOnAnyNumberOfThreadsAndForAnySeed) {
  Scene room;
  room.meshes = {inward_box(Vec3(0.0F), 2.0F, 0), quad({-1, 1.9F, -1}, {2, 0, 0}, {0, 0, 2}, 1)};
  room.materials = {matte(Rgb(0.5F)), lamp(Rgb(5.0F), true)};
  const Viewport ahead({}, {.horizontal_deg = 60.0, .vertical_deg = 36.0, .lens = {}});
  const auto stops = [&](int threads, std::uint32_t seed) {
    const Workers workers(threads);
    const PathTracer tracer(room, workers);
    return *automatic_exposure_stops(tracer, {0.1F, 0.2F, 1.5F}, ahead, {.seed = seed}, workers);
  };
  EXPECT_NE(stops(1, 0), 0.0);
  EXPECT_EQ(stops(1, 0), stops(3, 7));
}

TEST(ExposureNote, SaysHowToHaveItAgain) {
  EXPECT_THAT(exposure_note({.stops = -3.21, .is_automatic = true}),
              HasSubstr("--exposure fixed:-3.21"));
}

/// 90 degrees wide and high, ahead.
Viewport ahead() { return {{}, {.horizontal_deg = 90.0, .vertical_deg = 90.0}}; }

std::vector<DVec3> picture_of(const Scene& scene, const SmallPictureSettings& settings,
                              int threads = 1) {
  const Workers workers(threads);
  return small_picture(PathTracer(scene, workers), Vec3(0.0F), ahead(), settings, workers);
}

/// A lamp over the upper left quarter of the view, before surroundings of `radiance`.
Scene quarter_of_light(const Rgb& light, float radiance) {
  Scene scene;
  scene.meshes = {quad({-1.0F, 0.0F, -1.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, 0)};
  scene.materials = {lamp(light)};
  scene.environment = constant_environment(radiance);
  return scene;
}

TEST(SmallPicture, HasItsRowsFromTheTopLeft) {
  EXPECT_THAT(picture_of(quarter_of_light(Rgb(3.0F, 2.0F, 1.0F), 0.25F), {.size = {4, 2}}),
              ElementsAre(DVec3(3.0, 2.0, 1.0), DVec3(3.0, 2.0, 1.0), DVec3(0.25), DVec3(0.25),
                          DVec3(0.25), DVec3(0.25), DVec3(0.25), DVec3(0.25)));
}

/// The first 16 Sobol points are one to each quarter of a quarter.
TEST(SmallPicture, APixelIsTheMeanOfItsSamples) {
  EXPECT_THAT(picture_of(quarter_of_light(Rgb(4.0F), 0.0F), {.size = {1, 1}}),
              ElementsAre(DVec3(1.0)));
}

TEST(SmallPicture, WhatIsNotFiniteCountsAsBlack) {
  const Rgb infinite(std::numeric_limits<float>::infinity());
  EXPECT_THAT(picture_of(quarter_of_light(infinite, 1.0F), {.size = {1, 1}}),
              ElementsAre(DVec3(0.75)));
}

TEST(SmallPicture, DependsOnTheSeedAndNotOnTheThreads) {
  Scene room;
  room.meshes = {inward_box(Vec3(0.0F), 2.0F, 0), quad({-1, 1.9F, -1}, {2, 0, 0}, {0, 0, 2}, 1)};
  room.materials = {matte(Rgb(0.5F)), lamp(Rgb(5.0F), true)};
  const SmallPictureSettings settings{.size = {8, 6}, .samples_per_pixel = 4};
  const std::vector<DVec3> picture = picture_of(room, settings);
  EXPECT_EQ(picture, picture_of(room, settings, 3));
  SmallPictureSettings other = settings;
  other.trace.seed = 1;
  EXPECT_NE(picture, picture_of(room, other));
}

}  // namespace

}  // namespace foveola::test
