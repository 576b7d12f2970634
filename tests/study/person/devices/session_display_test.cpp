#include "study/person/devices/session_display.h"

#include <optional>
#include <utility>

#include "renderer/base/error.h"
#include "renderer/image/image_file.h"
#include "renderer/window/drawing/presenter.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"
#include "tests/x_server.h"

namespace foveola::study {
namespace {

class SessionDisplayTest : public ::testing::Test {
 protected:
  static DisplayProfile monitor() {
    return {.kind = DisplayKind::monitor,
            .width_px = 1280,
            .height_px = 1024,
            .refresh_rate_hz = 60.0,
            .width_m = 0.34,
            .height_m = 0.272,
            .viewing_distance_m = 0.6};
  }

  /// A page that is bright all over, as a picture.
  void take_picture(const std::filesystem::path& file) {
    display_->take_picture(file);
    display_->show({.screen = ScreenPage{.is_signal = true}});
  }

  foveola::test::XServer server_;
  foveola::test::TemporaryFolder folder_;
  SteadyClock clock_;
  WindowEvents events_;
  Window window_{{.size = {64, 48}}, events_, clock_};
  WindowPresenter presenter_{window_, window_.framebuffer_size(), clock_};
  std::optional<SessionDisplay> display_{std::in_place, presenter_, monitor(), IVec2(64, 48),
                                         clock_};
};

TEST_F(SessionDisplayTest, APageBecomesAFileOnce) {
  take_picture(folder_ / "page.png");
  display_->finish_pictures();
  const RgbImage picture = read_film_image(folder_ / "page.png").color;
  EXPECT_EQ(IVec2(picture.width, picture.height), IVec2(64, 48));
  EXPECT_GT(picture.at(1, 1).g, 0.5F);
  std::filesystem::remove(folder_ / "page.png");
  display_->show({});
  display_->finish_pictures();
  EXPECT_FALSE(std::filesystem::exists(folder_ / "page.png"));
}

TEST_F(SessionDisplayTest, ItsTimingPatchIsWhiteInTrialsAloneOverAnyPage) {
  DisplayProfile profile = monitor();
  profile.timing_patch = {.corner = WindowCorner::bottom_right, .size_px = 8};
  SessionDisplay& display = display_.emplace(presenter_, profile, IVec2(64, 48), clock_);
  const auto picture_of = [&](const SessionPicture& shown) {
    display.keep_pixels();
    display.show(shown);
    return display.take_pixels().value();
  };
  const RgbImage trial = picture_of({.lights_patch = true});
  EXPECT_EQ(trial.at(63, 47), Rgb(1.0F));
  EXPECT_EQ(trial.at(56, 40), Rgb(1.0F));
  EXPECT_EQ(trial.at(55, 47), Rgb(0.0F));
  EXPECT_EQ(trial.at(63, 39), Rgb(0.0F));
  const RgbImage page = picture_of({.screen = ScreenPage{.is_signal = true}});
  EXPECT_EQ(page.at(60, 44), Rgb(0.0F));
  EXPECT_GT(page.at(50, 44).g, 0.5F);
}

TEST_F(SessionDisplayTest, PixelsAreThoseOfTheFrameThatIsShown) {
  EXPECT_FALSE(display_->take_pixels());
  display_->show({});
  EXPECT_FALSE(display_->take_pixels()) << "nobody asked for them";
  display_->keep_pixels();
  display_->show({.screen = ScreenPage{.is_signal = true}});
  const std::optional<RgbImage> bright = display_->take_pixels();
  ASSERT_TRUE(bright);
  EXPECT_EQ(IVec2(bright->width, bright->height), IVec2(64, 48));
  EXPECT_GT(bright->at(1, 1).g, 0.5F);
  EXPECT_FALSE(display_->take_pixels()) << "they are of one frame";
  display_->keep_pixels();
  display_->hide(true);
  display_->show({});
  EXPECT_FALSE(display_->take_pixels()) << "nothing was drawn";
}

TEST_F(SessionDisplayTest, ReportsAPageThatCouldNotBecomeAFile) {
  take_picture(folder_ / "no-such-folder" / "page.png");
  EXPECT_THROW(display_->finish_pictures(), Error);
}

TEST_F(SessionDisplayTest, WhatNobodySeesWaitsToBecomeAPicture) {
  display_->hide(true);
  take_picture(folder_ / "page.png");
  display_->finish_pictures();
  EXPECT_FALSE(std::filesystem::exists(folder_ / "page.png"));
  display_->hide(false);
  display_->show({});
  display_->finish_pictures();
  EXPECT_TRUE(std::filesystem::exists(folder_ / "page.png"));
}

}  // namespace
}  // namespace foveola::study
