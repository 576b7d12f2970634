// A render in parts, which are merged, and one that is stopped and goes on.
#include <algorithm>
#include <csignal>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "renderer/base/files/files.h"
#include "renderer/image/image_file.h"
#include "tests/end_to_end/render/rendered_room.h"
#include "tests/end_to_end/running_program.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

using Options = std::vector<std::string>;

/// Options of a 360-degree image of 4 x 3 tiles, the last ones of which reach beyond it.
const Options panorama = {"--size", "120x70", "--spp",      "6",      "--method", "fv",
                          "--gaze", "20,-5",  "--variance", "--seed", "5"};

class RenderParts : public Render {
 protected:
  /// Renders all parts of a split. Returns their files.
  Options parts(int count, const Options& options, const std::string& name) {
    Options files;
    for (int number = 1; number <= count; ++number) {
      files.push_back(fmt::format("{}-{}.film", name, number));
      const ProgramResult result =
          render(files.back(), joined(options, {"--shard", fmt::format("{}/{}", number, count),
                                                "--threads", fmt::format("{}", 1 + number % 2)}));
      EXPECT_EQ(result.exit_code, 0) << result.errors;
    }
    return files;
  }

  ProgramResult merge(const Options& files, const std::string& output) {
    Options arguments = {"merge-images"};
    for (const std::string& file : files) {
      arguments.push_back((folder_ / file).string());
    }
    arguments.push_back("-o");
    arguments.push_back((folder_ / output).string());
    return run_foveola(arguments);
  }

  std::string bytes(const std::string& file) const { return read_file(folder_ / file); }
};

TEST_F(RenderParts, ByTilesAreTheWholeImageByteForByte) {
  for (const Options& options :
       {panorama, Options{"--size", "100x60", "--spp", "5", "--fov", "60"}}) {
    succeeded(render("whole.exr", options));
    for (const int count : {1, 2, 5}) {
      Options files = parts(count, options, "part");
      std::ranges::reverse(files);
      const ProgramResult merged = succeeded(merge(files, "merged.exr"));
      EXPECT_THAT(merged.output, HasSubstr(fmt::format("of {} parts", count)));
      EXPECT_TRUE(bytes("merged.exr") == bytes("whole.exr")) << count << " parts";
    }
    succeeded(render("whole.png", options));
    succeeded(merge(parts(2, options, "part"), "merged.png"));
    EXPECT_TRUE(bytes("merged.png") == bytes("whole.png"));
  }
}

TEST_F(RenderParts, BySeedsAreTheSameImageInAnyOrder) {
  const Options files = parts(4, joined(panorama, {"--split", "seeds"}), "part");
  succeeded(merge(files, "a.exr"));
  succeeded(merge({files[2], files[0], files[3], files[1]}, "b.exr"));
  EXPECT_TRUE(bytes("a.exr") == bytes("b.exr"));
  succeeded(render("whole.exr", panorama));
  const FilmImage whole = read_film_image(folder_ / "whole.exr");
  const FilmImage merged = read_film_image(folder_ / "a.exr");
  const auto samples = [](const FilmImage& image) {
    return std::accumulate(image.samples.begin(), image.samples.end(), std::uint64_t{0});
  };
  EXPECT_EQ(samples(merged), samples(whole));
  const auto brightness = [](const FilmImage& image) {
    double sum = 0.0;
    for (std::size_t i = 0; i < image.samples.size(); ++i) {
      sum += image.samples[i] * luminance(DVec3(image.color.pixels[i]));
    }
    return sum;
  };
  EXPECT_NE(merged.color.pixels, whole.color.pixels) << "other random numbers";
  EXPECT_NEAR(brightness(merged) / brightness(whole), 1.0, 0.05);
}

TEST_F(RenderParts, OneThatWasStoppedGoesOnAsIfNothingHadBeen) {
  const Options options = {"--size", "240x120", "--spp", "40", "--panorama", "--shard", "1/2"};
  succeeded(render("once.film", options));
  const Options arguments = joined({"render", (folder_ / "room.gltf").string(), "-o",
                                    (folder_ / "stopped.film").string(), "--resume"},
                                   options);
  constexpr int max_tries = 20;
  int exit_code = 0;
  for (int i = 0; exit_code == 0 && i < max_tries; ++i) {  // a busy machine may stop it too late
    std::filesystem::remove(folder_ / "stopped.film");
    RunningProgram stopped(arguments);
    stopped.wait_for("samples per pixel");
    stopped.kill(SIGTERM);
    exit_code = stopped.wait_for_end();
  }
  ASSERT_EQ(exit_code, 130);
  Options rest = options;
  rest.back() = "2/2";
  succeeded(render("rest.film", rest));
  expect_one_line(merge({"stopped.film", "rest.film"}, "merged.exr"), 1,
                  "stopped.film: is not finished");
  for (int time = 0; time < 2; ++time) {  // the second one has nothing left to do
    succeeded(run_foveola(arguments));
  }
  succeeded(merge({"stopped.film", "rest.film"}, "merged.exr"));
  succeeded(merge({"once.film", "rest.film"}, "expected.exr"));
  EXPECT_TRUE(bytes("merged.exr") == bytes("expected.exr"));
}

TEST_F(RenderParts, AreRefusedIfTheyAreNotThoseOfOneRender) {
  const Options files = parts(3, panorama, "part");
  expect_one_line(merge({files[0], files[2]}, "m.exr"), 1, "part 2/3 is missing");
  expect_one_line(merge({files[0], files[1], files[1], files[2]}, "m.exr"), 1,
                  "part 2/3 is given more than once");
  const Options halves = parts(2, panorama, "half");
  expect_one_line(merge({files[0], halves[1], files[2]}, "m.exr"), 1,
                  "half-2.film: is part 2/2, but");
  Options other = panorama;
  other.back() = "6";
  parts(3, other, "other");
  expect_one_line(merge({files[0], "other-2.film", files[2]}, "m.exr"), 1,
                  "other-2.film: is of another render than");
  write_file(folder_ / "damaged.film", bytes(files[1]).replace(5000, 1, "x"));
  expect_one_line(merge({files[0], "damaged.film", files[2]}, "m.exr"), 1,
                  "damaged.film: is damaged");
  expect_one_line(merge({"room.gltf"}, "m.exr"), 1, "room.gltf: is not a film");
  const std::string before = bytes(files[1]);
  EXPECT_THAT(render(files[1], joined(other, {"--shard", "2/3", "--resume"})).errors,
              HasSubstr("part-2.film: is of another render"));
  EXPECT_TRUE(bytes(files[1]) == before);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "m.exr"));
}

TEST_F(RenderParts, RefuseWhatCannotBeSplit) {
  for (const auto& [options, says] :
       std::vector<std::pair<Options, std::string>>{{{"--seconds", "1"}, "seconds"},
                                                    {{"--adaptive", "0.01"}, "--adaptive"},
                                                    {{"--view", "v.png"}, "--view"}}) {
    expect_one_line(render("a.film", joined({"--panorama", "--shard", "1/2"}, options)), 2, says);
  }
  expect_one_line(render("a.exr", {"--shard", "1/2"}), 2, "--shard: needs a .film");
  expect_one_line(render("a.exr", {"--resume"}), 2, "--resume: needs a .film");
  expect_one_line(
      render("a.film", {"--panorama", "--samples", "3", "--shard", "1/4", "--split", "seeds"}), 1,
      "more parts than samples");
}

}  // namespace
}  // namespace foveola::test
