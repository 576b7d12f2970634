// How a simulated participant rates what was seen.
#include <set>
#include <utility>

#include "tests/study/participant/made_up_renderings.h"

namespace foveola::study {
namespace {

TEST_F(SimulatedParticipantTest, RatesByWhatIsWrongWithTheImage) {
  const Display slightly_noisy = [](const RgbImage& image, double) {
    return noisy(image, 1.0, 0.15);
  };
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    EXPECT_EQ(rating(participant(seed), finished), 1);
    EXPECT_EQ(rating(participant(seed), black), 5);
    EXPECT_EQ(rating(participant(seed), black, 3.0), 3) << "of a shorter scale";
    const double noisy_rating = rating(participant(seed), slightly_noisy);
    EXPECT_GT(noisy_rating, 1);
    EXPECT_LT(noisy_rating, 5);
  }
}

TEST_F(SimulatedParticipantTest, RatesWorseWhatIsWorse) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    double before = 0.0;
    for (const double noise : {0.0, 0.05, 0.1, 0.2, 0.4}) {
      const double now = rating(participant(seed), [noise](const RgbImage& image, double) {
        return noisy(image, 1.0, noise);
      });
      EXPECT_GE(now, before) << noise;
      before = now;
    }
    EXPECT_GT(before, 2.0);
  }
}

TEST_F(SimulatedParticipantTest,
       RatingsDifferBetweenPeopleByTheirBiasAndBetweenTrialsByTheirNoise) {
  const auto rated = [&](std::uint64_t seed, std::uint32_t conduct) {
    SimulatedParticipant person = participant(seed);
    person.begin_attempt({.conduct = conduct});
    person.begin(Task::look_around, Nanoseconds(0));
    person.consider({.artifacts_jnd = 2.8}, Nanoseconds(0));
    return std::get<double>(
        person.rate({{.id = "artifacts", .minimum = 1.0, .maximum = 5.0, .simulated = "artifacts"}})
            .at(0)
            .value);
  };
  const auto ratings = [&](double bias_spread, double noise_spread) {
    population_.rating.bias_spread = bias_spread;
    population_.rating.noise_spread = noise_spread;
    std::set<double> of_people;
    std::set<double> of_trials;
    for (std::uint32_t i = 0; i < 30; ++i) {
      of_people.insert(rated(i, 1));
      of_trials.insert(rated(1, i));
    }
    return std::pair(of_people.size(), of_trials.size());
  };
  EXPECT_EQ(ratings(0.0, 0.0), std::pair(std::size_t{1}, std::size_t{1}));
  EXPECT_GT(ratings(0.5, 0.0).first, 1U);
  EXPECT_EQ(ratings(0.5, 0.0).second, 1U);
  EXPECT_GT(ratings(0.0, 0.5).second, 1U);
}

}  // namespace
}  // namespace foveola::study
