
#include "renderer/view/view_sampler.h"
#include "tests/error_of.h"
#include "tests/matchers.h"
#include "tests/renderer/view/test_images.h"
#include "tests/temporary_folder.h"

namespace foveola {
namespace {

/// What is wrong with a method's text; empty if nothing.
std::string complaint(const std::string& method) {
  return test::error_of([&] { make_view_sampler(method); });
}

TEST(MakeViewSampler, ATextThatMakesNoSenseIsExplained) {
  const std::pair<const char*, const char*> refused[] = {
      {"xyz", "od, vp, vp-rect, fv, fv-paper, fv-map"},
      {"", "no such method"},
      {"fv:acuity=cat", "reddy, guenter"},
      {"fv:colour=3", "settings are acuity, exponent"},
      {"fv:cutoff=0", "cutoff lies in"},
      {"fv:cutoff=nan", "cutoff lies in"},
      {"fv:cutoff", "KEY=VALUE"},
      {"fv:cutoff=60,cutoff=70", "set twice"},
      {"fv:slope=0.02", "'slope' is not a setting"},
      {"fv:acuity=linear,inner=20,outer=10", "below outer"},
      {"od:width=3", "od has no settings"},
      {"fv-paper:cutoff=60", "fv-paper has no settings"},
      {"fv:acuity=watson,eye=third", "left, right, both"},
      {"mask:floor=1", "image of the mask is missing"},
      {"fv-map", "image of the map is missing"},
      {"mask:file=\"/no/such", "KEY=VALUE"},
      {"pointer:radius=0", "radius lies in"},
      {"hybrid:fv", "WEIGHT*METHOD"},
      {"hybrid:0*fv", "positive weight"},
      {"hybrid:", "no parts"},
      {"hybrid:1*xyz", "no such method"},
      {"hybrid:0.5*hybrid:0.9*fv+0.1*od+0.4*vp", "in quotes"},
      {"fv-mpa", "did you mean 'fv-map'?"},
      {"fv:acuiti=watson", "did you mean 'acuity'?"},
      {"fv:acuity=watsen", "did you mean 'watson'?"}};
  for (const auto& [method, why] : refused) {
    EXPECT_THAT(complaint(method), HasSubstr(why)) << method;
  }
}

// Densities that fall by more than a double can hold beside the fovea's.
TEST(MakeViewSampler, TakesEveryExponentAndCutOff) {
  for (const std::string acuity : {"reddy", "guenter,slope=10", "watson", "linear,least=0.000001",
                                   "linear,inner=0,outer=0.1,least=0.000001", "weier1"}) {
    for (const char* measure : {"planar", "solid-angle"}) {
      for (const char* cutoff : {"0.1", "179"}) {
        for (const char* exponent : {"0.01", "10"}) {
          EXPECT_EQ(complaint("fv:acuity=" + acuity + ",exponent=" + exponent +
                              ",cutoff=" + cutoff + ",measure=" + measure),
                    "");
        }
      }
    }
  }
}

// The plus and the comma of a path are not those between methods and settings.
TEST(MakeViewSampler, APathInQuotesMayHoldAnything) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder / "a+0.5*od,floor=b.exr";
  test::write_weights(path, 2, 1, [](double x, double) { return x < 0.5 ? 1.0 : 0.0; });
  const auto mask = make_view_sampler("mask:file=\"" + path.string() + "\",floor=0");
  EXPECT_GT(mask->density_per_sr({-1.0F, 0.0F, 0.0F}), 0.0);
  EXPECT_EQ(mask->density_per_sr({1.0F, 0.0F, 0.0F}), 0.0);
  const auto both =
      make_view_sampler("hybrid:0.5*mask:file=\"" + path.string() + "\"+0.5*crop:azimuth=90");
  EXPECT_GT(both->density_per_sr({-1.0F, 0.0F, 0.0F}), 0.0);
  EXPECT_GT(both->density_per_sr({1.0F, 0.0F, 0.0F}), 0.0);
}

// By hand: 0.6 (0.75 fv + 0.25 od) + 0.4 vp.
TEST(MakeViewSampler, AHybridInQuotesIsAPartOfAnother) {
  const Aim aim{.viewport = Viewport(Quat(1, 0, 0, 0), 1.0, 1.0)};
  const auto density = [&](const std::string& method) {
    const auto sampler = make_view_sampler(method);
    sampler->aim(aim);
    return sampler->density_per_sr(glm::normalize(Vec3(0.1F, 0.2F, -1.0F)));
  };
  EXPECT_NEAR(density("hybrid:6*\"hybrid:3*fv+1*od\"+4*vp"),
              0.6 * (0.75 * density("fv") + 0.25 * density("od")) + 0.4 * density("vp"), 1e-12);
  EXPECT_THAT(with_pointer("hybrid:6*\"hybrid:3*pointer+1*od\"+4*vp", {}),
              StartsWith("hybrid:6*\"hybrid:3*pointer:azimuth=0"));
}

// From 10 to 20 degrees in a straight line to nothing.
TEST(MakeViewSampler, ALinearAcuityMayFallToNothing) {
  const auto sampler = make_view_sampler("fv:acuity=linear,least=0,exponent=1");
  sampler->aim({.viewport = Viewport(Quat(1, 0, 0, 0), 1.0, 1.0)});
  const auto density = [&](double e_deg) {
    return sampler->density_per_sr(direction_from({.elevation_rad = radians(e_deg)})) *
           std::sin(radians(e_deg)) / radians(e_deg);
  };
  EXPECT_NEAR(density(15.0) / density(5.0), 0.5, 1e-5);
  EXPECT_NEAR(density(19.0) / density(5.0), 0.1, 1e-5);
  EXPECT_EQ(density(20.1), 0.0);
  std::vector<ViewSample> samples(2);
  sampler->sample(std::vector<Vec2>{{0.5F, 0.3F}, {0x1.fffffep-1F, 0.3F}}, samples);
  // e^2 / 2 to 10 degrees, then 50 + (e^2 - 100) - (e^3 - 1000) / 30, comes to half of its value
  // at 20 degrees, 116.667, at 10.8353.
  EXPECT_NEAR(degrees(angle_between(samples[0].direction, {0, 0, -1})), 10.8353, 1e-4);
  EXPECT_LT(degrees(angle_between(samples[1].direction, {0, 0, -1})), 20.0);
}

// Left and right halves of the image, from files that do not exist.
TEST(MakeViewSampler, WeightsCanBeGivenForEveryFile) {
  std::vector<std::string> asked;
  const FindWeights halves = [&](const std::string& file) {
    asked.push_back(file);
    const bool left = file == "left";
    return WeightImage{
        .width = 2, .height = 1, .weights = {left ? 1.0F : 0.0F, left ? 0.0F : 1.0F}};
  };
  const Vec3 to_the_left(-1.0F, 0.0F, 0.0F);
  const auto mask = make_view_sampler("mask:file=left", halves);
  mask->aim({.viewport = Viewport(Quat(1, 0, 0, 0), 1.0, 1.0)});
  EXPECT_GT(mask->density_per_sr(to_the_left), 0.0);
  EXPECT_EQ(mask->density_per_sr(-to_the_left), 0.0);
  const auto mixed = make_view_sampler(
      "hybrid:0.5*\"hybrid:1*fv-map:file=right,extent=100+1*mask:file=left\"+0.5*mask:file=right",
      halves);
  mixed->aim({.viewport = Viewport(Quat(1, 0, 0, 0), 1.0, 1.0)});
  EXPECT_GT(mixed->density_per_sr(to_the_left), 0.0);
  EXPECT_GT(mixed->density_per_sr(-to_the_left), 2.0 * mixed->density_per_sr(to_the_left));
  EXPECT_THAT(asked, ElementsAre("left", "right", "left", "right"));
  make_view_sampler("hybrid:0.5*fv+0.5*pointer", halves);
  EXPECT_THAT(asked, SizeIs(4)) << "methods without files";
}

TEST(MethodNotes, SayWhatWeightsThatDoNotAddUpTo1Mean) {
  EXPECT_THAT(method_notes("fv"), IsEmpty());
  EXPECT_THAT(method_notes("hybrid:0.7*fv+0.2*vp+0.1*od"), IsEmpty());
  EXPECT_THAT(method_notes("hybrid:3*fv+1*od"),
              ElementsAre("the weights of 'hybrid:3*fv+1*od' add up to 4, not to 1: of "
                          "the samples, fv 75 %, od 25 %"));
  EXPECT_THAT(method_notes("hybrid:0.6*\"hybrid:0.5*fv+0.4*od\"+0.4*vp"),
              ElementsAre(HasSubstr("fv 55.56 %, od 44.44 %")));
}

TEST(WithPointer, HoldsEveryPointerInPlace) {
  const AzimuthElevation place{.azimuth_rad = radians(270.0), .elevation_rad = radians(30.0)};
  EXPECT_EQ(with_pointer("fv:cutoff=60", place), "fv:cutoff=60");
  const std::string alone = with_pointer("pointer", place);
  EXPECT_THAT(alone, StartsWith("pointer:azimuth="));
  const std::string mixed = with_pointer("hybrid:0.5*fv+0.5*pointer:radius=3", place);
  EXPECT_THAT(mixed, StartsWith("hybrid:0.5*fv+0.5*pointer:radius=3,azimuth="));
  const Vec3 there = direction_from(place);
  for (const std::string& method : {alone, mixed}) {
    const auto sampler = make_view_sampler(method);
    sampler->aim({.viewport = Viewport(Quat(1, 0, 0, 0), 1.0, 1.0)});
    EXPECT_GT(sampler->density_per_sr(there), 10.0 * sampler->density_per_sr(-there));
    EXPECT_GT(sampler->density_per_sr(there), 1.0);
  }
}

TEST(FollowsGaze, IsTrueForMethodsAimedByGaze) {
  for (const char* method : {"fv", "fv:acuity=watson", "fv-paper", "fv-map:file=a.png", "pointer",
                             "hybrid:0.9*od+0.1*fv", "hybrid:6*\"hybrid:3*fv+1*od\"+4*vp"}) {
    EXPECT_TRUE(follows_gaze(method)) << method;
  }
  for (const char* method : {"od", "vp", "vp-rect", "crop", "mask:file=a.png",
                             "pointer:azimuth=1,elevation=2", "hybrid:0.9*od+0.1*vp"}) {
    EXPECT_FALSE(follows_gaze(method)) << method;
  }
}

}  // namespace
}  // namespace foveola
