#include "renderer/progressive/progressive_render.h"

#include <algorithm>

#include "renderer/base/numbers/random.h"
#include "tests/matchers.h"
#include "tests/renderer/preview/box_room.h"

namespace foveola {
namespace {

class ProgressiveRenderTest : public testing::Test {
 protected:
  ProgressiveRenderTest() {
    settings_.film_size = {256, 128};
    settings_.trace.max_depth = 3;
    settings_.trace.seed = 1;
    gaze_sampler_->aim({.viewport = Viewport({}, FieldOfView{})});
    even_sampler_->aim({.viewport = Viewport({}, FieldOfView{})});
  }

  ProgressiveRender render() const { return {tracer_, settings_, workers_}; }

  Scene scene_ = box_room(0.2F);
  Workers workers_{2};
  PathTracer tracer_{scene_, workers_};
  ProgressiveSettings settings_;
  std::unique_ptr<ViewSampler> gaze_sampler_ = make_view_sampler("fv");
  std::unique_ptr<ViewSampler> even_sampler_ = make_view_sampler("od");
};

// Where a sample goes then depends on those before it, which the search has to trace again.
TEST_F(ProgressiveRenderTest, ASampleIsFoundAgainWithAdaptiveSampling) {
  settings_.adaptive = VisibleNoise{.contrast = 0.9, .least_samples = 2};
  constexpr int passes = 6;
  constexpr std::uint64_t samples = 4000;
  const Vec3 ahead(0.0F, 0.0F, -1.0F);
  ProgressiveRender rendered = render();
  std::uint64_t traced = 0;
  for (int pass = 0; pass < passes; ++pass) {
    rendered.look_at(ahead);
    traced += rendered.advance(*gaze_sampler_, samples).samples;
  }
  EXPECT_LT(traced, passes * samples);
  EXPECT_EQ(rendered.points_drawn(), passes * samples);
  const auto width = static_cast<std::uint32_t>(rendered.film().width());
  const std::uint32_t middle =
      width * static_cast<std::uint32_t>(rendered.film().height()) / 2 + width / 2;
  const std::uint32_t count = rendered.film().sample_count(static_cast<int>(middle % width),
                                                           static_cast<int>(middle / width));
  ASSERT_GT(count, 1U);
  const auto is_found = [&](std::uint32_t sample_number) {
    ProgressiveRender searched = render();
    bool found = false;
    for (int pass = 0; pass < passes; ++pass) {
      searched.look_at(ahead);
      found = found || searched.find_job(*gaze_sampler_, samples, middle, sample_number);
    }
    return found;
  };
  EXPECT_TRUE(is_found(count - 1));
  EXPECT_FALSE(is_found(count));
}

TEST_F(ProgressiveRenderTest, PassesOverWhatItWouldTrace) {
  constexpr std::uint64_t samples = 3000;
  ProgressiveRender traced = render();
  traced.advance(*even_sampler_, samples);
  ProgressiveRender passed = render();
  std::vector<SampleJob> jobs = passed.pass_over(*even_sampler_, 1000);
  const std::vector<SampleJob> more = passed.pass_over(*even_sampler_, 2000);
  jobs.insert(jobs.end(), more.begin(), more.end());
  ASSERT_EQ(jobs.size(), samples);
  EXPECT_EQ(passed.film().resolve().samples, traced.film().resolve().samples);
  EXPECT_THAT(passed.film().resolve().color.pixels, Each(Rgb(0.0F)));
  EXPECT_THAT(traced.film().resolve().color.pixels, Contains(testing::Ne(Rgb(0.0F))));
}

TEST_F(ProgressiveRenderTest, ARestartWithAnotherSeedIsAnotherRender) {
  ProgressiveRender render_of_one = render();
  render_of_one.advance(*even_sampler_, 5000);
  const FilmImage one = render_of_one.film().resolve();
  render_of_one.restart(2);
  EXPECT_EQ(render_of_one.film().total_samples(), 0U);
  render_of_one.advance(*even_sampler_, 5000);
  settings_.trace.seed = 2;
  ProgressiveRender render_of_two = render();
  render_of_two.advance(*even_sampler_, 5000);
  EXPECT_NE(render_of_one.film().resolve().color.pixels, one.color.pixels);
  EXPECT_EQ(render_of_one.film().resolve().color.pixels,
            render_of_two.film().resolve().color.pixels);
}

// A viewport's samples, and a gaze's, fall where the sampler says, pixels or not.
TEST_F(ProgressiveRenderTest, OnlyASamplerThatIsUniformVisitsPixelsInRounds) {
  const auto samples = [&](const ViewSampler& sampler, bool in_rounds) {
    settings_.film_size = {150, 75};
    settings_.visits_pixels_in_rounds = in_rounds;
    ProgressiveRender rendered = render();
    rendered.advance(sampler, 5000);
    rendered.advance(sampler, std::uint64_t{150} * 75 - 5000);
    return rendered.film().resolve().samples;
  };
  EXPECT_THAT(samples(*even_sampler_, true), Each(1U));
  EXPECT_THAT(samples(*even_sampler_, false), Contains(0U));
  for (const char* method : {"fv", "vp", "vp-rect", "crop:width=40"}) {
    const std::unique_ptr<ViewSampler> sampler = make_view_sampler(method);
    sampler->aim({.viewport = Viewport({}, FieldOfView{})});
    EXPECT_EQ(samples(*sampler, true), samples(*sampler, false)) << method;
  }
}

// Each of two patterns of as many points as there are pixels gives every pixel one of them.
TEST_F(ProgressiveRenderTest, AnotherPatternAddsToTheFilm) {
  constexpr std::uint64_t pixels = 256 * 128;
  ProgressiveRender rendered = render();
  rendered.begin_pattern(3);
  rendered.advance(*even_sampler_, pixels);
  rendered.begin_pattern(4);
  EXPECT_EQ(rendered.points_drawn(), 0U);
  rendered.advance(*even_sampler_, pixels);
  EXPECT_THAT(rendered.film().resolve().samples, Each(2U));
}

TEST_F(ProgressiveRenderTest, ShowsWhatItTraced) {
  ProgressiveRender rendered = render();
  std::vector<SampleJob> jobs;
  DVec3 sum(0.0);
  rendered.observe_samples([&](std::span<const SampleJob> traced, std::span<const Rgb> radiance) {
    ASSERT_EQ(traced.size(), radiance.size());
    jobs.insert(jobs.end(), traced.begin(), traced.end());
    for (const Rgb& one : radiance) {
      sum += DVec3(one);
    }
  });
  rendered.advance(*even_sampler_, 1000);
  rendered.advance(*even_sampler_, 2000);
  EXPECT_EQ(jobs.size(), 3000U);
  DVec3 in_film(0.0);
  rendered.film().for_each_sampled_pixel(
      [&](const IVec2&, const FilmTile::Pixel& pixel) { in_film += pixel.sum; });
  EXPECT_NEAR(luminance(in_film), luminance(sum), 1e-5 * luminance(sum));
}

TEST_F(ProgressiveRenderTest, GoesOnWithAnotherTracer) {
  ProgressiveRender one = render();
  one.advance(*even_sampler_, 5000);
  ProgressiveRender two = render();
  two.advance(*even_sampler_, 2000);
  const PathTracer another(scene_, workers_);
  two.use(another);
  two.advance(*even_sampler_, 3000);
  EXPECT_EQ(one.film().resolve().color.pixels, two.film().resolve().color.pixels);
}

TEST_F(ProgressiveRenderTest, AFilterTakesSamplesAway) {
  ProgressiveRender rendered = render();
  rendered.filter_samples([](std::vector<ViewSample>& samples) {
    std::erase_if(samples, [](const ViewSample& sample) { return sample.image.x < 0.5F; });
  });
  const TracedSamples traced = rendered.advance(*even_sampler_, 256 * 128);
  EXPECT_EQ(traced.samples, 256U * 128 / 2);
  EXPECT_EQ(traced.rays.primary, traced.samples);
  EXPECT_EQ(rendered.film().sample_count(127, 64), 0U);
  EXPECT_EQ(rendered.film().sample_count(128, 64), 1U);
}

}  // namespace
}  // namespace foveola
