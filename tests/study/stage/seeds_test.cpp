#include "study/stage/seeds.h"

#include <set>

#include <gtest/gtest.h>

namespace foveola::study {
namespace {

Protocol three_by_two() {
  Protocol protocol;
  protocol.scenes = {{.name = "a"}, {.name = "b"}, {.name = "c"}};
  protocol.methods = {"od", "fv"};
  return protocol;
}

TEST(Seeds, AreOthersForEveryTrialTimingPurposeAndSession) {
  const Protocol protocol = three_by_two();
  std::set<std::uint32_t> seeds;
  std::size_t count = 0;
  for (const std::uint64_t seed : {1ULL, 2ULL, 1ULL << 32U}) {
    for (const int row : {0, 1}) {
      for (const SeedPurpose purpose : {SeedPurpose::tracker, SeedPurpose::conduct}) {
        for (const SceneEntry& scene : protocol.scenes) {
          for (const std::string& method : protocol.methods) {
            for (const TrialKind kind : {TrialKind::test, TrialKind::practice}) {
              for (const int timing : {1, 2}) {
                const PlannedTrial trial{.scene = scene.name, .method = method, .kind = kind};
                seeds.insert(trial_seed({seed, row}, purpose, protocol, trial, timing));
                ++count;
              }
            }
          }
        }
      }
    }
  }
  EXPECT_EQ(seeds.size(), count);
}

TEST(Seeds, NoPictureIsRare) {
  const Protocol protocol = three_by_two();
  const PlannedTrial trial{.scene = "b", .method = "fv"};
  int first = 0;
  constexpr int trials = 200;
  for (int row = 0; row < trials; ++row) {
    first += picture_seed({5, row}, protocol, trial) % 2 == 0 ? 1 : 0;
  }
  EXPECT_GT(first, 60);
  EXPECT_LT(first, trials - 60);
}

TEST(Seeds, DoNotDependOnWhenATrialIsShown) {
  const Protocol protocol = three_by_two();
  const PlannedTrial first{.scene = "b", .method = "fv"};
  const PlannedTrial later{.scene = "b", .method = "fv", .scene_position = 2, .method_position = 1};
  EXPECT_EQ(rendering_seed(5, 3, protocol, first, 1), rendering_seed(5, 3, protocol, later, 1));
}

}  // namespace
}  // namespace foveola::study
