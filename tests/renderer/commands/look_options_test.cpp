#include "renderer/commands/look_options.h"

#include <CLI/CLI.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/error.h"

namespace foveola::test {
namespace {

using Base = ExposureChoice::Base;

LookArguments typed(const std::string& command_line) {
  CLI::App app;
  LookArguments arguments;
  add_viewpoint_options(app, arguments);
  add_fov_option(app, arguments, "60");
  add_light_options(app, arguments);
  add_exposure_option(app, arguments);
  add_tone_option(app, arguments);
  app.parse(command_line);
  return arguments;
}

TEST(LookOptions, ACameraIsAPlaceOrAName) {
  EXPECT_EQ(scene_choices(typed("--camera -1,2.5,3")).camera, DVec3(-1.0, 2.5, 3.0));
  EXPECT_EQ(scene_choices(typed("--camera -1,2.5,3")).camera_name, "");
  const SceneChoices named = scene_choices(typed("--camera \"Camera, left\""));
  EXPECT_EQ(named.camera_name, "Camera, left");
  EXPECT_FALSE(named.camera);
  EXPECT_EQ(scene_choices(typed("--camera 2")).camera_name, "2");
  EXPECT_FALSE(scene_choices(typed("")).camera);
  EXPECT_THROW(scene_choices(typed("--camera 1,2")), UsageError);
  EXPECT_THROW(scene_choices(typed("--camera 0,nan,0")), UsageError);
}

TEST(LookOptions, AHeadIsTwoAngles) {
  const SceneChoices choices = scene_choices(typed("--head 90,-30"));
  ASSERT_TRUE(choices.head);
  EXPECT_NEAR(choices.head->azimuth_rad, radians(90.0), 1e-12);
  EXPECT_NEAR(choices.head->elevation_rad, radians(-30.0), 1e-12);
}

TEST(LookOptions, AFieldOfViewIsOneOrTwoAngles) {
  EXPECT_FALSE(fields_of_view(typed("")));
  EXPECT_EQ(fields_of_view(typed("--fov 50"))->horizontal_deg, 50.0);
  EXPECT_EQ(fields_of_view(typed("--fov 50x30"))->vertical_deg, 30.0);
  EXPECT_THROW(fields_of_view(typed("--fov 180")), UsageError);
}

TEST(LookOptions, AnExposureAddsToTheScenesOrTheAutomaticOneOrIsExact) {
  const auto choice = [](const std::string& text) {
    return exposure_choice(typed(text.empty() ? "" : "--exposure " + text));
  };
  const auto expect = [&](const std::string& text, Base base, double stops) {
    EXPECT_EQ(choice(text).base, base) << text;
    EXPECT_EQ(choice(text).more_stops, stops) << text;
  };
  expect("", Base::scene, 0.0);
  expect("1.5", Base::scene, 1.5);
  expect("+1.5", Base::scene, 1.5);
  expect("-2", Base::scene, -2.0);
  expect("auto", Base::automatic, 0.0);
  expect("auto+1", Base::automatic, 1.0);
  expect("auto-0.5", Base::automatic, -0.5);
  expect("fixed:-9.4", Base::none, -9.4);
  expect("fixed:+3", Base::none, 3.0);
  for (const char* wrong :
       {"bright", "auto1", "auto+", "fixed:", "fixed:auto", "41", "nan", "1e9"}) {
    EXPECT_THROW(choice(wrong), UsageError) << wrong;
  }
}

TEST(LookOptions, AToneIsPlainOrFilmic) {
  EXPECT_EQ(tone_curve(typed("")), ToneCurve::plain);
  EXPECT_EQ(tone_curve(typed("--tone filmic")), ToneCurve::filmic);
  EXPECT_THROW(typed("--tone sepia"), CLI::ParseError);
}

TEST(LookOptions, LightIsAddedToTheScenesOwn) {
  SceneSource source;
  source.environment_strength = 2.0;
  source.environment_rotation_rad = 1.0;
  apply_light(typed(""), source);
  EXPECT_EQ(source.environment_strength, 2.0);
  EXPECT_EQ(source.environment_rotation_rad, 1.0);
  EXPECT_FALSE(source.light_units);
  EXPECT_FALSE(source.light_radius_m);
  apply_light(typed("--environment-strength 3 --environment-rotation 90 --light-units photometric "
                    "--light-radius 0.5 --sun-radius 1"),
              source);
  EXPECT_EQ(source.environment_strength, 6.0);
  EXPECT_NEAR(source.environment_rotation_rad, 1.0 + radians(90.0), 1e-12);
  EXPECT_EQ(source.light_units, LightUnits::photometric);
  EXPECT_EQ(source.light_radius_m, 0.5F);
  EXPECT_NEAR(source.sun_angular_radius_rad.value(), radians(1.0), 1e-6);
  for (const char* radius : {"-1", "1.1e6", "1e19", "nan"}) {
    EXPECT_THROW(apply_light(typed(std::string("--light-radius ") + radius), source), UsageError)
        << radius;
  }
  apply_light(typed("--environment 1,2,3"), source);
  EXPECT_EQ(source.environment_radiance, Rgb(1.0F, 2.0F, 3.0F));
  EXPECT_EQ(source.environment_strength, 1.0) << "another environment is as it is given";
}

TEST(LookOptions, WhatWasTypedOfTheLightStandsInAnImagesHeader) {
  EXPECT_TRUE(light_facts(typed("--camera 0,0,0")).empty());
  const ImageFacts facts = light_facts(typed("--environment 1,2,3 --sun-radius 0 --time 0.5"));
  EXPECT_EQ(facts.at("foveola:environment"), "1,2,3");
  EXPECT_EQ(facts.at("foveola:sun-radius"), "0");
  EXPECT_EQ(facts.at("foveola:time"), "0.5");
  EXPECT_EQ(facts.size(), 3U);
}

}  // namespace
}  // namespace foveola::test
