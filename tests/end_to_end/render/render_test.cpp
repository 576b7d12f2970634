// What the render command writes and says.
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "renderer/base/files/files.h"
#include "renderer/image/image_file.h"
#include "renderer/image/tone_mapping.h"
#include "tests/end_to_end/render/rendered_room.h"
#include "tests/matchers.h"
#include "tests/noisy_pair.h"

namespace foveola::test {
namespace {

TEST_F(Render, ReportsWhatItDidAsJson) {
  const ProgramResult result =
      succeeded(render("a.exr", {"--size", "64x32", "--spp", "4", "--seed", "3", "--json"}));
  const nlohmann::json report = nlohmann::json::parse(result.output);
  EXPECT_EQ(report.at("samples"), 64 * 32 * 4);
  EXPECT_EQ(report.at("non_finite"), 0);
  EXPECT_GT(report.at("seconds"), 0.0);
  EXPECT_GT(report.at("samples_per_second"), 0.0);
  EXPECT_GE(report.at("rays"), 64 * 32 * 4);
  EXPECT_GT(report.at("peak_memory_bytes"), 0);
  EXPECT_GT(report.at("load_seconds"), 0.0);
  EXPECT_GT(report.at("build_seconds"), 0.0);
}

TEST_F(Render, KeepsVariancesAndSaysInTheFileWhatItDid) {
  ASSERT_EQ(render("a.exr", {"--size", "64x32", "--samples", "3000", "--method", "fv:cutoff=70",
                             "--seed", "11", "--gaze", "20,-5", "--variance", "--clamp", "7.5",
                             "--environment", "0.25,0.5,0.75"})
                .exit_code,
            0);
  const FilmImage image = read_film_image(folder_ / "a.exr");
  ASSERT_EQ(image.variances.size(), 64U * 32U);
  double sum = 0.0;
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    if (image.samples[i] < 2) {
      EXPECT_EQ(image.variances[i], 0.0F);
    }
    sum += image.variances[i];
  }
  EXPECT_GT(sum, 0.0);
  const std::string bytes = read_file(folder_ / "a.exr");
  for (const char* fact : {"foveola:method", "fv:cutoff=70", "foveola:seed", "foveola:gaze_deg",
                           "20,-5", "foveola:head_deg", "room.gltf", "foveola:clamp", "7.5",
                           "foveola:environment", "0.25,0.5,0.75", "foveola:camera_m"}) {
    EXPECT_THAT(bytes, HasSubstr(fact));
  }
  succeeded(render("b.exr", {"--size", "64x32", "--samples", "3000"}));
  EXPECT_TRUE(read_film_image(folder_ / "b.exr").variances.empty());
}

TEST_F(Render, WritesWhatTheDisplayShows) {
  const auto view = [&](const std::vector<std::string>& more) {
    succeeded(render(
        "a.exr", joined({"--size", "512x256", "--samples", "3000", "--view",
                         (folder_ / "v.exr").string(), "--view-size", "80x40", "--head", "30,10"},
                        more)));
    return read_film_image(folder_ / "v.exr").color;
  };
  const RgbImage plain = view({});
  EXPECT_EQ(plain.width, 80);
  EXPECT_EQ(plain.height, 40);
  EXPECT_GT(black_share(plain), 0.3);
  EXPECT_EQ(black_share(view({"--fill-unsampled"})), 0.0);
  EXPECT_NE(view({"--lens", "0.5,0.5,0.3,0.1"}).pixels, plain.pixels);
}

TEST_F(Render, TheImageDependsOnTheSeedAndNotOnTheThreads) {
  const auto image = [&](const std::string& name, const std::vector<std::string>& more) {
    EXPECT_EQ(
        render(name, joined({"--size", "64x32", "--spp", "2", "--method", "fv"}, more)).exit_code,
        0);
    return read_film_image(folder_ / name).color.pixels;
  };
  const std::vector<Rgb> one = image("1.exr", {"--threads", "1"});
  EXPECT_TRUE(one == image("2.exr", {"--threads", "2"}));
  EXPECT_TRUE(one == image("4.exr", {"--threads", "4"}));
  EXPECT_FALSE(one == image("s.exr", {"--seed", "1"}));
}

// Seeds of renders have 32 bits: the largest is 2^32 - 1.
TEST_F(Render, AWholeNumberBeyondItsOptionIsRefusedWithTheRange) {
  EXPECT_THAT(render("a.exr", {"--seed", "4294967296"}).errors, HasSubstr(" 0 to 4294967295"));
  EXPECT_THAT(
      run_foveola({"study", "simulate", "demo", "--participants", "2", "--jobs", "99999999999"})
          .errors,
      HasSubstr("--jobs: Value 99999999999 not in range 1 to 1024"));
}

TEST_F(Render, SecondsBoundTheTime) {
  const ProgramResult result = succeeded(
      render("a.png", {"--size", "64x32", "--seconds", "0.2", "--json", "--max-depth", "1"}));
  EXPECT_GE(nlohmann::json::parse(result.output).at("seconds"), 0.2);
}

TEST_F(Render, CompareFindsNoErrorBetweenAnImageAndItself) {
  succeeded(render("a.exr", {"--size", "32x16", "--spp", "1"}));
  const std::string image = (folder_ / "a.exr").string();
  const ProgramResult result = succeeded(run_foveola({"compare", image, image, "--json"}));
  const nlohmann::json metrics = nlohmann::json::parse(result.output);
  EXPECT_EQ(metrics.at("rmse"), 0.0);
  EXPECT_EQ(metrics.at("pixels"), 32 * 16);
  EXPECT_FALSE(metrics.contains("flip"));
}

RgbImage linear_image(RgbImage encoded) {
  for (Rgb& pixel : encoded.pixels) {
    pixel = Rgb(linear_from_srgb(pixel.r));
  }
  return encoded;
}

TEST_F(Render, CompareSaysWhatIsSeenOnADisplay) {
  const NoisyPair pair = noisy_pair();
  write_image(folder_ / "image.png", linear_image(pair.image), 0.0);
  write_image(folder_ / "reference.png", linear_image(pair.reference), 0.0);
  const auto compared = [&](const std::vector<std::string>& options) {
    return nlohmann::json::parse(
        succeeded(run_foveola(joined({"compare", (folder_ / "image.png").string(),
                                      (folder_ / "reference.png").string(), "--json"},
                                     options)))
            .output);
  };
  EXPECT_NEAR(compared({"--pixels-per-degree", "67.0206"}).at("flip"), 0.047088, 1e-5);
  const double aside = compared({"--display", "desktop", "--fixation", "0,0"}).at("jod");
  EXPECT_LT(compared({"--display", "desktop", "--fixation", "256,256"}).at("jod"), aside);
  EXPECT_LT(compared({"--display", "desktop"}).at("jod"), aside);
}

}  // namespace
}  // namespace foveola::test
