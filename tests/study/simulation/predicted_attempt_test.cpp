#include "study/record/write/recorders.h"
#include "study/simulation/predicted_study.h"
#include "study/simulation/rendered_attempt.h"
#include "tests/matchers.h"
#include "tests/study/participant/fake_participant.h"
#include "tests/study/record/small_study.h"
#include "tests/study/simulation/small_wall.h"

namespace foveola::study {
namespace {

/// What an attempt presents and when, until 130 ms after the press.
struct Course {
  std::vector<Nanoseconds> looks;
  Nanoseconds end{0};
  std::uint64_t samples = 0;
  friend bool operator==(const Course&, const Course&) = default;
};

class PredictedAttemptTest : public testing::Test {
 protected:
  PredictedAttemptTest() {
    protocol_.machine = {.samples_per_second = 1003.0, .frame_rate_hz = 70.0};
    protocol_.film = {.width = 32, .height = 16, .max_depth = 1};
    protocol_.display.view_width = 8;
    protocol_.display.view_height = 8;
  }

  template <typename Make>
  Course course_of(const Make& make) {
    FakeParticipant observer;
    observer.looks_needed = 3;
    observer.thought = ms(170);
    observer.begin(Task::mark_outline, ms(1000));
    VirtualClock clock;
    clock.advance(ms(1000));
    BufferedRecorder recorder;
    std::optional<Nanoseconds> pressed;
    const std::unique_ptr<TrialAttempt> attempt =
        make(TrialAttemptSetting{.stage = stage_,
                                 .protocol = protocol_,
                                 .trial = trial_,
                                 .object = stage_.objects()[0],
                                 .seeds = {},
                                 .participant = observer,
                                 .correction = std::nullopt,
                                 .clock = clock,
                                 .recorder = recorder,
                                 .key = {},
                                 .pressed = pressed});
    attempt->begin(Task::mark_outline);
    attempt->show(clock.now());
    while (!pressed || clock.now() < *pressed + ms(130)) {
      attempt->show(pressed ? *pressed + ms(130) : ms(100'000));
    }
    return {.looks = observer.look_times, .end = clock.now(), .samples = attempt->samples()};
  }

  TemporaryFolder folder_;
  Protocol protocol_ = small_protocol();
  PlannedTrial trial_{.scene = "box", .method = "od"};
  Workers workers_{1};
  SceneStage stage_{wall_with_a_square(folder_), workers_};
};

TEST_F(PredictedAttemptTest, IsLookedAtWhenARenderedOneIs) {
  const Course rendered = course_of([&](const TrialAttemptSetting& setting) {
    return std::make_unique<RenderedAttempt>(setting, workers_);
  });
  const Course predicted = course_of([](const TrialAttemptSetting& setting) {
    return std::make_unique<PredictedAttempt>(setting, nullptr, nullptr, make_view_sampler("od"));
  });
  EXPECT_GT(rendered.looks.size(), 4U);
  EXPECT_EQ(predicted, rendered);
}

}  // namespace
}  // namespace foveola::study
