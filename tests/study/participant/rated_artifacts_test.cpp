// How a simulated participant rates what was seen.
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "tests/study/participant/made_up_renderings.h"

namespace foveola::study {
namespace {

/// When a person who begins to look around at time 0 judges what is seen for the first time.
Nanoseconds when_fixating(SimulatedParticipant& person) {
  return person.path().fixation(Nanoseconds(0)).landing + std::chrono::milliseconds(60);
}

/// On five points.
double rated_artifacts(SimulatedParticipant& person) {
  const std::vector<Answer> answers =
      person.rate({{.id = "artifacts", .minimum = 1.0, .maximum = 5.0, .simulated = "artifacts"}});
  return std::get<double>(answers.at(0).value);
}

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

// By hand: the root mean cube of 1 and 3 is 2.41; their mean would be 2.
TEST_F(SimulatedParticipantTest, RatesTheWorseOfWhatWasSeenMore) {
  population_.rating = {.second_point_jnd = 2.3,
                        .step_factor = 1.1,
                        .pooling_exponent = 3.0,
                        .bias_spread = 0.0,
                        .noise_spread = 0.0};
  SimulatedParticipant person = participant(1);
  person.begin_attempt({});
  person.begin(Task::look_around, Nanoseconds(0));
  const Nanoseconds now = when_fixating(person);
  person.consider({.artifacts_jnd = 1.0}, now);
  person.consider({.artifacts_jnd = 3.0}, now);
  person.consider({.artifacts_jnd = std::numeric_limits<double>::infinity()}, now);
  EXPECT_EQ(rated_artifacts(person), 2.0) << "between 2.3 and 2.53";
}

TEST_F(SimulatedParticipantTest, DoesNotRateWhatPassesInASaccade) {
  population_.rating.bias_spread = 0.0;
  population_.rating.noise_spread = 0.0;
  population_.gaze.suppression_s = 0.05;
  SimulatedParticipant person = participant(1);
  person.begin_attempt({});
  person.begin(Task::look_around, Nanoseconds(0));
  int judged = 0;
  for (Nanoseconds now(0); now < std::chrono::seconds(4); now += std::chrono::milliseconds(10)) {
    const ScanPath::Fixation fixation = person.path().fixation(now);
    const bool is_fixating = now >= fixation.landing + std::chrono::milliseconds(50);
    person.consider({.artifacts_jnd = is_fixating ? 0.0 : 1e6}, now);
    judged += is_fixating ? 1 : 0;
  }
  EXPECT_GT(judged, 50);
  EXPECT_LT(judged, 350);
  EXPECT_EQ(rated_artifacts(person), 1.0);
}

TEST_F(SimulatedParticipantTest,
       RatingsDifferBetweenPeopleByTheirBiasAndBetweenTrialsByTheirNoise) {
  const auto rated = [&](std::uint64_t seed, std::uint32_t conduct) {
    SimulatedParticipant person = participant(seed);
    person.begin_attempt({.conduct = conduct});
    person.begin(Task::look_around, Nanoseconds(0));
    person.consider({.artifacts_jnd = 2.8}, when_fixating(person));
    return rated_artifacts(person);
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
