#include "renderer/measure/reference.h"

#include <algorithm>
#include <fstream>
#include <numeric>

#include "renderer/base/angles.h"
#include "renderer/base/build_info.h"
#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/image/image_file.h"
#include "renderer/view/equirect.h"
#include "tests/matchers.h"
#include "tests/renderer/preview/box_room.h"
#include "tests/temporary_folder.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

class ReferenceImage : public testing::Test {
 protected:
  void SetUp() override {
    settings_.width = 64;
    settings_.height = 32;
    settings_.max_depth = 3;
    settings_.samples_per_pixel = 4;
  }

  FilmImage render(const std::string& key = "scene", std::stop_token stop = {}) {
    return reference_image(
        tracer_, key, settings_, workers_, cache_,
        [this](double fraction) { progress_.push_back(fraction); }, std::move(stop));
  }

  std::vector<fs::path> cached_files() const {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(cache_)) {
      if (entry.path().extension() != ".sha256") {
        files.push_back(entry.path());
      }
    }
    return files;
  }

  Scene scene_ = box_room(0.5F);
  Workers workers_{2};
  PathTracer tracer_{scene_, workers_};
  test::TemporaryFolder folder_;
  const fs::path cache_ = folder_ / "cache";
  ReferenceSettings settings_;
  std::vector<double> progress_;
};

TEST_F(ReferenceImage, GivesEveryPixelItsSamples) {
  const FilmImage image = render();
  EXPECT_EQ(image.color.width, 64);
  EXPECT_EQ(image.color.height, 32);
  EXPECT_THAT(image.samples, Each(4U));
  ASSERT_FALSE(progress_.empty());
  EXPECT_EQ(progress_.back(), 1.0);
  EXPECT_TRUE(std::is_sorted(progress_.begin(), progress_.end()));
}

TEST_F(ReferenceImage, AddsSamplesAroundEachInterest) {
  settings_.interests = {direction_from({.azimuth_rad = -2.0, .elevation_rad = 0.3}),
                         direction_from({.azimuth_rad = 1.0})};
  settings_.samples_per_interest = 5000;
  const FilmImage image = render();
  EXPECT_EQ(std::accumulate(image.samples.begin(), image.samples.end(), 0U), 64U * 32 * 4 + 10000);
  EXPECT_GE(*std::min_element(image.samples.begin(), image.samples.end()), 4U);
  for (const Vec3& interest : settings_.interests) {
    const Vec2 at = equirect_from_direction(interest) * Vec2(64.0F, 32.0F);
    // 3 samples a steradian of the fovea, over a pixel of 2 pi^2 / 2048 sr: 145 of 5000.
    EXPECT_GT(image.samples[static_cast<std::size_t>(at.y) * 64 + static_cast<std::size_t>(at.x)],
              100U);
  }
}

// The cached image of a brighter room would be the right answer to the same key.
TEST_F(ReferenceImage, TakesTheCachedImage) {
  const FilmImage first = render();
  const Scene brighter = box_room(5.0F);
  const PathTracer other(brighter, workers_);
  progress_.clear();
  const FilmImage second =
      reference_image(other, "scene", settings_, workers_, cache_,
                      [this](double fraction) { progress_.push_back(fraction); }, {});
  EXPECT_EQ(first.color.pixels, second.color.pixels);
  EXPECT_EQ(first.samples, second.samples);
  EXPECT_THAT(progress_, ElementsAre(1.0));
}

TEST_F(ReferenceImage, TheKeyHoldsEverythingTheImageDependsOn) {
  render();
  std::size_t files = 1;
  const auto expect_a_new_file = [&](const std::string& key, const std::string& changed) {
    render(key);
    EXPECT_EQ(cached_files().size(), ++files) << changed;
  };
  expect_a_new_file("another scene", "scene");
  settings_.viewpoint.y = 0.25F;
  expect_a_new_file("scene", "viewpoint");
  settings_.width = 32;
  expect_a_new_file("scene", "width");
  settings_.height = 16;
  expect_a_new_file("scene", "height");
  settings_.max_depth = 2;
  expect_a_new_file("scene", "depth");
  settings_.seed = 1;
  expect_a_new_file("scene", "seed");
  settings_.samples_per_pixel = 2;
  expect_a_new_file("scene", "samples per pixel");
  settings_.interests = {Vec3(1.0F, 0.0F, 0.0F)};
  expect_a_new_file("scene", "interests");
  settings_.samples_per_interest = 10;
  expect_a_new_file("scene", "samples per interest");
}

TEST_F(ReferenceImage, OtherProgramsHaveOtherFiles) {
  render();
  const BuildInfo build = build_info();
  EXPECT_THAT(cached_files(), ElementsAre(reference_file(cache_, "scene", settings_, build)));
  const auto expect_another_file = [&](std::string BuildInfo::* part) {
    BuildInfo other = build;
    other.*part += " of another kind";
    EXPECT_NE(reference_file(cache_, "scene", settings_, other),
              reference_file(cache_, "scene", settings_, build));
  };
  expect_another_file(&BuildInfo::compiler);
  expect_another_file(&BuildInfo::build_type);
  expect_another_file(&BuildInfo::ray_tracer);
  expect_another_file(&BuildInfo::instruction_set);
  expect_another_file(&BuildInfo::ray_instructions);
}

TEST_F(ReferenceImage, RendersADamagedFileAgain) {
  const FilmImage first = render();
  const std::vector<fs::path> files = cached_files();
  ASSERT_EQ(files.size(), 1U);
  EXPECT_EQ(files[0].extension(), ".exr");
  const std::string whole = read_file(files[0]);
  const auto expect_the_same_image = [&](const std::string& damage) {
    const FilmImage again = render();
    EXPECT_EQ(first.color.pixels, again.color.pixels) << damage;
    EXPECT_EQ(first.samples, again.samples) << damage;
    EXPECT_EQ(read_film_image(files[0]).color.pixels, first.color.pixels) << damage;
  };
  write_file(files[0], "");
  expect_the_same_image("empty");
  write_file(files[0], "no image at all");
  expect_the_same_image("garbage");
  write_file(files[0], whole.substr(0, whole.size() / 2));
  expect_the_same_image("cut off");
  write_image(files[0], RgbImage(8, 4), 0.0);
  expect_the_same_image("of another size");
  std::string flipped = whole;
  flipped[flipped.size() - 100] ^= 1;  // among the last pixels
  write_file(files[0], flipped);
  expect_the_same_image("with a bit that flipped");
}

TEST_F(ReferenceImage, DoesNotDependOnTheNumberOfThreads) {
  const FilmImage two = render();
  fs::remove_all(cache_);
  const Workers one(1);
  const FilmImage alone =
      reference_image(tracer_, "scene", settings_, one, cache_, [](double) {}, {});
  EXPECT_EQ(two.color.pixels, alone.color.pixels);
}

TEST_F(ReferenceImage, ConvergesToOneImageWhateverTheSeed) {
  settings_.samples_per_pixel = 64;
  const FilmImage a = render();
  settings_.seed = 1;
  const FilmImage b = render();
  EXPECT_NE(a.color.pixels, b.color.pixels);
  double sum_a = 0.0;
  double sum_b = 0.0;
  for (std::size_t i = 0; i < a.color.pixels.size(); ++i) {
    sum_a += a.color.pixels[i].g;
    sum_b += b.color.pixels[i].g;
  }
  EXPECT_NEAR(sum_a / sum_b, 1.0, 0.002);
}

TEST_F(ReferenceImage, LeavesNothingWhenStopped) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(render("scene", stop.get_token()), Error);
  EXPECT_TRUE(cached_files().empty());
}

TEST_F(ReferenceImage, RefusesABadCacheBeforeTheWork) {
  std::ofstream(cache_) << "a file where the folder should be";
  EXPECT_THROW(render(), Error);
  EXPECT_TRUE(progress_.empty());
}

}  // namespace
}  // namespace foveola
