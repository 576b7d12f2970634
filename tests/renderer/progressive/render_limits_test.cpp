#include "renderer/progressive/render_limits.h"

#include <cmath>
#include <cstdint>
#include <functional>

#include "renderer/base/error.h"
#include "tests/matchers.h"

namespace foveola {
namespace {

constexpr double infinity = HUGE_VAL;

TEST(RenderLimits, RefuseWhatNoRayCanBeginWith) {
  for (const double number : {std::nan(""), infinity, -1e20}) {
    const auto refused = [&](const char* name, const std::function<void(RenderSettings&)>& change) {
      RenderSettings settings;
      change(settings);
      EXPECT_THAT([&] { require_possible(settings); }, ThrowsMessage<UsageError>(HasSubstr(name)))
          << number;
    };
    refused("--camera", [&](RenderSettings& settings) { settings.scene.camera = {0, number, 0}; });
    refused("--head", [&](RenderSettings& settings) {
      settings.scene.head = {.azimuth_rad = 0.0, .elevation_rad = number};
    });
    refused("--gaze", [&](RenderSettings& settings) {
      settings.gaze = {.azimuth_rad = number == -1e20 ? -1e300 : number, .elevation_rad = 0.0};
    });
  }
  EXPECT_NO_THROW(require_possible({}));
}

/// The two farthest places are within Embree's 1.8e18 of each other.
TEST(RenderLimits, RefuseACameraWhereNoGeometryIsTraced) {
  RenderSettings settings;
  settings.scene.camera = {0, 8.9e17, 0};
  EXPECT_NO_THROW(require_possible(settings));
  settings.scene.camera = {0, 9.1e17, 0};
  EXPECT_THAT([&] { require_possible(settings); },
              ThrowsMessage<UsageError>(HasSubstr("three numbers of at most 9e+17")));
}

TEST(RenderLimits, RefuseBudgetsThatNeverEnd) {
  for (const double number : {infinity, std::nan(""), 0.0, 1e8}) {
    EXPECT_THAT([&] { (void)budget_of({.samples_per_pixel = number}); },
                ThrowsMessage<UsageError>(HasSubstr("--spp: must be above 0 and at most 1e+07")));
  }
  for (const double number : {infinity, std::nan(""), 0.0, 1e30}) {
    EXPECT_THAT([&] { (void)budget_of({.seconds = number}); },
                ThrowsMessage<UsageError>(HasSubstr("--seconds")));
  }
  for (const std::int64_t number : {std::int64_t{0}, std::int64_t{9'000'000'000'000'000'000}}) {
    EXPECT_THAT([&] { (void)budget_of({.samples = number}); },
                ThrowsMessage<UsageError>(HasSubstr("--samples")));
  }
  EXPECT_THAT([] { (void)budget_of({.samples = 1, .seconds = 1.0}); },
              ThrowsMessage<UsageError>(HasSubstr("cannot be combined")));
  EXPECT_EQ(budget_of({.default_samples_per_pixel = 3.0}).samples_per_pixel, 3.0);
}

}  // namespace
}  // namespace foveola
