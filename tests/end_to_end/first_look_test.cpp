// A person's own file, without a camera or without light, rendered with no options at all.
#include <algorithm>

#include "renderer/image/image_file.h"
#include "tests/end_to_end/first_look_files.h"
#include "tests/end_to_end/program.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

class FirstLook : public testing::TestWithParam<FirstLookFile> {
 protected:
  ProgramResult render(const std::string& output, std::vector<std::string> options = {}) const {
    const std::vector<std::string> quick = {
        "render", scene().string(), "-o",    (folder_ / output).string(),
        "--size", "96x54",          "--spp", "16"};
    options.insert(options.begin(), quick.begin(), quick.end());
    return run_foveola(options);
  }

  FilmImage film_image(const std::string& output) const {
    return read_film_image(folder_ / output);
  }
  RgbImage picture(const std::string& output) const { return film_image(output).color; }

 private:
  std::filesystem::path scene() const {
    return folder_.write(GetParam().file_name, GetParam().content());
  }

  TemporaryFolder folder_;
};

/// The share of the picture's pixels whose luminance is between these.
double share_between(const RgbImage& image, float least, float most) {
  const auto is_between = [&](const Rgb& pixel) {
    return luminance(pixel) >= least && luminance(pixel) <= most;
  };
  const auto count = std::count_if(image.pixels.begin(), image.pixels.end(), is_between);
  return static_cast<double>(count) / static_cast<double>(image.pixels.size());
}

/// Neither black nor white, as a screen shows it.
void expect_something_to_see(const RgbImage& shown) {
  EXPECT_LT(share_between(shown, 0.0F, 0.002F), 0.95);
  EXPECT_LT(share_between(shown, 0.98F, 1.0F), 0.95);
}

TEST_P(FirstLook, ShowsSomethingOrSaysWhatToDo) {
  const ProgramResult result = render("shown.png");
  if (GetParam().has_light) {
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    expect_something_to_see(picture("shown.png"));
  } else {
    EXPECT_THAT(result.errors, HasSubstr(GetParam().is_empty ? "no triangles" : "--environment"));
  }
}

/// The part of a picture that shows something else than a sky of radiance 1, which is without
/// noise: a white thing before it cannot be told from it by its mean radiance.
double share_before_sky(const FilmImage& image) {
  std::size_t covered = 0;
  for (std::size_t i = 0; i < image.color.pixels.size(); ++i) {
    covered += image.variances[i] > 0.0F || luminance(image.color.pixels[i]) < 0.5F ? 1 : 0;
  }
  return static_cast<double>(covered) / static_cast<double>(image.color.pixels.size());
}

TEST_P(FirstLook, FillsAFairPartOfThePicture) {
  if (GetParam().is_empty) {
    GTEST_SKIP() << "there is nothing to see";
  }
  succeeded(render("seen.exr", {"--environment", "1,1,1", "--variance"}));
  const double covered = share_before_sky(film_image("seen.exr"));
  EXPECT_GE(covered, GetParam().least_covered);
  EXPECT_LE(covered, GetParam().most_covered);
  if (!GetParam().is_enclosed) {
    succeeded(render("seen.png", {"--environment", "1,1,1"}));
    expect_something_to_see(picture("seen.png"));
  }
}

INSTANTIATE_TEST_SUITE_P(Of, FirstLook, testing::ValuesIn(first_look_files()),
                         [](const testing::TestParamInfo<FirstLookFile>& info) {
                           std::string name = info.param.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace foveola::test
