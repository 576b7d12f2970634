// The live preview, as its user runs it: on a display without a screen.
#include <chrono>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <utility>

#include <nlohmann/json.hpp>

#include "renderer/base/files/files.h"
#include "renderer/image/image_file.h"
#include "tests/end_to_end/preview/preview_command.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

/// Of the targets around the middle of a window of 200 x 160: four fifths of the way to its sides.
constexpr int reach_px = 80;
constexpr int rise_px = 64;

/// The mean of the green of a file's pixels.
double mean_green(const std::string& file) {
  double sum = 0.0;
  const RgbImage picture = read_film_image(file).color;
  for (const Rgb& color : picture.pixels) {
    sum += color.g;
  }
  return sum / static_cast<double>(picture.pixels.size());
}

TEST_F(PreviewCommand, WritesItsLastPicture) {
  const std::string file = folder_ / "last.png";
  const ProgramResult result =
      succeeded(preview({"--frames", "25", "--screenshot", file, "--fill-unsampled"}));
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json.at("frame_count"), 25);
  EXPECT_THAT(json.at("methods"), ElementsAre("fv"));
  EXPECT_EQ(image_size(file), IVec2(200, 160));
  EXPECT_GT(mean_green(file), 0.02);
}

TEST_F(PreviewCommand, RefusesAWindowThatOpenGlCannotDraw) {
  expect_one_line(run_foveola({"preview", scene_, "--window", "20000x20000"}), 1,
                  "20000 x 20000 pixels are more than OpenGL draws here");
}

/// From 9 m above the room's ceiling, nothing but the environment is overhead.
TEST_F(PreviewCommand, StandsAndIsLitAsRenderIs) {
  const std::string file = folder_ / "last.png";
  const auto seen = [&](const std::string& stops) {
    const ProgramResult result = succeeded(preview(
        {"--frames", "10", "--screenshot", file, "--fill-unsampled", "--camera", "0,11,0", "--head",
         "0,89", "--environment", "0.125,0.125,0.125", "--exposure", "fixed:" + stops}));
    EXPECT_THAT(result.errors, Not(HasSubstr("camera")));
    return mean_green(file);
  };
  EXPECT_NEAR(seen("0"), 0.125, 0.01);
  EXPECT_NEAR(seen("2"), 0.5, 0.02);
}

TEST_F(PreviewCommand, SaysWhereItStandsAndThatNothingShines) {
  write_file(scene_, R"({"asset":{"version":"2.0"}})");
  const std::string file = folder_ / "last.png";
  const ProgramResult empty = succeeded(preview(
      {"--frames", "5", "--screenshot", file, "--fill-unsampled", "--exposure", "fixed:0"}));
  EXPECT_THAT(empty.errors, HasSubstr("the scene has no triangles"));
  EXPECT_THAT(empty.errors, HasSubstr("it is shown in a studio light"));
  EXPECT_GT(mean_green(file), 0.3);
  write_file(scene_, room_gltf());
  EXPECT_THAT(preview({"--frames", "5"}).errors,
              HasSubstr("1.6 m above the floor of a room where it is widest"));
  EXPECT_EQ(preview({"--frames", "5", "--camera", "0,0"}).exit_code, 2);
  expect_one_line(preview({"--frames", "5", "--gaze-filter", "kalman"}), 2,
                  "'kalman' is not a gaze filter");
}

TEST_F(PreviewCommand, ChecksTheTracker) {
  // The pointer rests in the middle of a window of 55 x 44 mm, 0.6 m away, and so on the first
  // target; the other four lie at four fifths of the way to its corners, 2.1 and 1.7 degrees across
  // and up.
  const auto json = preview_while([this](XUser& user) {
    user.type("c");
    wait_for_target(user, 100 + reach_px, 80 + rise_px);
    wait_for_target(user, 100 + reach_px, 80 + rise_px, false);
    user.type("q");
  });
  ASSERT_EQ(json.at("gaze_checks").size(), 1U);
  const auto& check = json.at("gaze_checks").at(0);
  EXPECT_NEAR(check.at("accuracy_deg").get<double>(), 0.8 * 2.70, 0.1);
  EXPECT_LT(check.at("precision_rms_deg").get<double>(), 0.01);
  EXPECT_LT(check.at("data_loss").get<double>(), 0.2);
  EXPECT_FALSE(check.contains("correction"));
}

TEST_F(PreviewCommand, CorrectsTheGazeIfAsked) {
  const auto json = preview_while(
      [this](XUser& user) {
        user.type("c");
        for (const auto& [x, y] : {std::pair(0, 0), {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}) {
          wait_for_target(user, 100 + x * reach_px, 80 + y * rise_px);
          user.point_at(title_, 100 + x * reach_px, 80 + y * rise_px);
        }
        wait_for_target(user, 100 + reach_px, 80 + rise_px, false);
        user.type("q");
      },
      {"--correct-gaze"});
  ASSERT_EQ(json.at("gaze_checks").size(), 1U);
  const auto& correction = json.at("gaze_checks").at(0).at("correction");
  EXPECT_EQ(correction.at("azimuth").size(), 3U);
  EXPECT_GT(correction.at("azimuth").at(1).get<double>(), 0.0) << "right stays right";
  EXPECT_GT(correction.at("elevation").at(2).get<double>(), 0.0) << "up stays up";
}

/// The numbers of "--camera X,Y,Z --head AZIMUTH,ELEVATION --fov WIDTH".
struct LastView {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double azimuth_deg = 0.0;
  double elevation_deg = 0.0;
  double fov_deg = 0.0;
};

LastView view_of(const std::string& text) {
  LastView view;
  EXPECT_EQ(std::sscanf(text.c_str(), "--camera %lf,%lf,%lf --head %lf,%lf --fov %lf", &view.x,
                        &view.y, &view.z, &view.azimuth_deg, &view.elevation_deg, &view.fov_deg),
            6)
      << text;
  return view;
}

LastView last_view(const nlohmann::json& json) {
  return view_of(json.at("last_view").get<std::string>());
}

TEST_F(PreviewCommand, BeginsAsWideAsAPictureUnlessTrueAnglesAreAskedFor) {
  const auto view = [&](std::vector<std::string> options) {
    options.insert(options.end(),
                   {"--frames", "2", "--camera", "0.5,0.25,-0.5", "--head", "30,-5"});
    return last_view(nlohmann::json::parse(preview(options).output));
  };
  const LastView usual = view({});
  EXPECT_EQ(std::tuple(usual.x, usual.y, usual.z), std::tuple(0.5, 0.25, -0.5));
  EXPECT_EQ(std::tuple(usual.azimuth_deg, usual.elevation_deg), std::tuple(30.0, -5.0));
  EXPECT_EQ(usual.fov_deg, 60.0);
  // 200 pixels of this display are 55 mm, 0.6 m away.
  EXPECT_NEAR(view({"--true-angles"}).fov_deg, 5.28, 0.05);
}

TEST_F(PreviewCommand, IsMovedThroughAndZoomed) {
  constexpr unsigned wheel_away = 4;
  const auto json = preview_while(
      [](XUser& user, RunningProgram& program) {
        user.hold("Prior");
        wait_until("a higher view", [&] {
          user.type("o");  // prints the view
          return view_of(program.wait_for("--camera ")).y > 0.0;
        });
        user.let_go("Prior");
        user.press_button(wheel_away);
        user.release_button(wheel_away);
        user.type("q");
      },
      {"--camera", "0,0,0", "--head", "0,0"});
  const LastView view = last_view(json);
  EXPECT_GT(view.y, 0.0);
  EXPECT_EQ(std::tuple(view.x, view.z), std::tuple(0.0, 0.0));
  EXPECT_LT(view.fov_deg, 60.0);
  EXPECT_GT(view.fov_deg, 50.0);
  EXPECT_THAT(json.at("methods"), ElementsAre("fv")) << "moving restarts no method";
}

TEST_F(PreviewCommand, SurvivesFullScreenWhileOrbitingAndTinyWindows) {
  constexpr unsigned middle_button = 2;
  const auto json = preview_while(
      [this](XUser& user) {
        user.press_button(middle_button);
        user.type("F11");
        wait_until("full screen", [&] { return user.place_of(title_).width == 1280; });
        user.point_at(title_, 700, 500);
        user.type("F11");
        wait_until("the window", [&] { return user.place_of(title_).width == 200; });
        user.release_button(middle_button);
        user.resize(title_, 100, 60);
        user.type("z");
        user.ask_to_close(title_);
      },
      {"--show", "gaze,rings,density,times,latency,view,help"});
  EXPECT_GT(json.at("frame_count"), 1);
}

TEST_F(PreviewCommand, ACheckEndsWithEscape) {
  const auto json = preview_while([this](XUser& user) {
    user.type("c");
    wait_for_target(user, 100, 80);
    user.type("Escape");
    wait_for_target(user, 100, 80, false);
    user.type("Escape");
  });
  EXPECT_THAT(json.at("gaze_checks"), IsEmpty());
}

// If it did not go on, the frames would never be done.
TEST_F(PreviewCommand, GoesOnWhileMinimised) {
  const auto json = preview_while(
      [this](XUser& user) {
        user.say_minimised(title_, true);
        std::this_thread::sleep_for(std::chrono::milliseconds(500));  // frames go by
        user.say_minimised(title_, false);
      },
      {"--frames", "300"});
  EXPECT_EQ(json.at("frame_count"), 300);
}

TEST_F(PreviewCommand, GoesOnWithoutItsMonitor) {
  std::optional<XMonitors> monitors;
  try {
    monitors.emplace();
  } catch (const std::runtime_error& reason) {
    GTEST_SKIP() << reason.what();
  }
  const auto json = preview_while(
      [&](XUser& user) {
        wait_until("the window that fills DUMMY1", [&] {
          const XUser::Place place = user.place_of(title_);
          return place.x == 1024 && place.width == 800 && place.height == 600;
        });
        monitors->take_away("DUMMY1");
        user.ask_to_close(title_);
      },
      {"--full-screen", "--monitor", "1"}, monitors->display());
  EXPECT_THAT(json.at("lost_monitors"), ElementsAre("DUMMY1"));
}

/// Without a display: had it been looked for first, its absence would be the error.
TEST_F(PreviewCommand, RefusesWhatIsMalformedBeforeAnythingIsLoaded) {
  write_file(folder_ / "bad.csv", "time");
  const std::string bad_file = folder_ / "bad.csv";
  for (const auto& [option, value, exit_code] :
       {std::tuple("--exposure", std::string("nonsense"), 2),
        {"--window", "big", 2},
        {"--gaze-file", bad_file, 1},
        {"--tracker", "crystal-ball", 1}}) {
    expect_one_line(run_foveola({"preview", scene_, option, value}, {{"DISPLAY", ":9999"}}),
                    exit_code, exit_code == 2 ? option : value);
  }
}

TEST_F(PreviewCommand, ARecordingTurnsTheHead) {
  const std::string recording = folder_
                                    .write("head.csv",
                                           "time_ns,azimuth_rad,elevation_rad\n"
                                           "0,0.5235987755982988,0\n")
                                    .string();
  const auto json = preview_while(
      [](XUser& user) {
        user.hold("Left");
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        user.let_go("Left");
        user.press_button(1);
        user.release_button(1);
        user.type("q");
      },
      {"--camera", "0,1,0", "--head-file", recording});
  const LastView view = last_view(json);
  EXPECT_NEAR(view.azimuth_deg, 30.0, 1e-3);
  EXPECT_EQ(view.elevation_deg, 0.0);
}

}  // namespace
}  // namespace foveola::test
