#include "study/person/session/simulated_operator.h"

#include "tests/matchers.h"
#include "tests/study/participant/fake_participant.h"
#include "tests/study/person/prompts/prompt_session.h"
#include "tests/waiting.h"

namespace foveola::study {
namespace {

using namespace std::chrono_literals;
using test::PromptSession;

class SimulatedOperatorTest : public ::testing::Test {
 protected:
  SimulatedOperatorTest() {
    session_.seen.phase = Phase::ready;
    session_.seen.object = "Lamp";
    participant_.thought = 300ms;
  }

  /// Shows a frame at this time of the clock.
  void show(Nanoseconds time, bool may_answer = true) {
    clock_.advance(time - clock_.now());
    SeenFrame frame{.prompt = session_.prompt,
                    .context = session_.context(),
                    .offered = &objects_,
                    .shown = time,
                    .session_time = time};
    if (operator_.wants_to_look()) {
      frame.pixels = ShownPixels{.image = RgbImage(2, 2),
                                 .viewport = Viewport(head_orientation({}), 1.0, 1.0)};
    }
    operator_.follow(frame, may_answer);
  }

  /// What was pressed since this was asked, and when.
  std::vector<std::pair<PersonKey, Nanoseconds>> pressed() {
    std::vector<std::pair<PersonKey, Nanoseconds>> keys;
    for (const WindowEvent& event : operator_.events().take()) {
      if (const std::optional<PersonKey> key = person_key(event)) {
        keys.emplace_back(*key, event.time);
      }
    }
    return keys;
  }

  /// Shows it until a key is pressed: looks are over when they are.
  std::pair<PersonKey, Nanoseconds> key_pressed_by(Nanoseconds time) {
    std::vector<std::pair<PersonKey, Nanoseconds>> keys;
    foveola::test::wait_until("a key", [&] {
      show(time);
      keys = pressed();
      return !keys.empty();
    });
    EXPECT_EQ(keys.size(), 1U);
    return keys.front();
  }

  /// What the keys confirm that are pressed at this question, the last of which is Enter.
  Event confirmed(Confirmed what, Nanoseconds time) {
    Confirmation& asked = session_.prompt.confirmation.emplace(what, session_.protocol.texts);
    show(time);
    std::optional<FormInput> last;
    for (const WindowEvent& event : operator_.events().take()) {
      last = form_input(event);
      asked.follow(last.value());
    }
    EXPECT_EQ(last, FormInput(FormKey::enter));
    return asked.chosen().value();
  }

  /// Is ready, and the first frame has been shown at 2 s.
  void begin_trial() {
    show(0s);
    show(1100ms);
    EXPECT_THAT(pressed(), ElementsAre(std::pair(PersonKey::mark, Nanoseconds(1100ms))));
    session_.seen.phase = Phase::marking;
    show(2s);
  }

  PromptSession session_;
  std::vector<OfferedObject> objects_ = {{.name = "Lamp"}};
  FakeParticipant participant_;
  VirtualClock clock_;
  WindowEvents window_;
  SimulatedOperator operator_{{.participant = participant_,
                               .protocol = session_.protocol,
                               .plan = session_.plan,
                               .seed = {},
                               .clock = clock_,
                               .window = window_}};
};

TEST_F(SimulatedOperatorTest, StartsATrialOnceHeadAndEyeRest) {
  show(0s);
  show(900ms);
  EXPECT_THAT(pressed(), IsEmpty());
  show(1s);
  EXPECT_THAT(pressed(), ElementsAre(std::pair(PersonKey::mark, Nanoseconds(1s))));
}

TEST_F(SimulatedOperatorTest, AKeyGoesDownWhenItIsTimeToWheneverFramesCome) {
  begin_trial();
  show(2299ms);
  EXPECT_THAT(pressed(), IsEmpty());
  EXPECT_EQ(key_pressed_by(2450ms), std::pair(PersonKey::mark, 2s + participant_.thought));
  show(3s);
  EXPECT_THAT(pressed(), IsEmpty()) << "the mark is made";
}

TEST_F(SimulatedOperatorTest, NothingIsAnsweredThatIsNotAskedAnyMore) {
  begin_trial();
  show(2450ms, false);
  EXPECT_THAT(pressed(), IsEmpty());
}

TEST_F(SimulatedOperatorTest, LooksTenTimesASecondAtMost) {
  begin_trial();
  EXPECT_FALSE(operator_.wants_to_look()) << "at one thing at a time";
  key_pressed_by(2450ms);
  session_.seen.phase = Phase::rating;
  session_.seen.mark = 2;
  session_.prompt.look_around_until = 9s;
  show(4s);
  foveola::test::wait_until("a look around", [&] { return participant_.look_count == 2; });
  for (int frame = 0; frame < 100; ++frame) {
    show(4099ms);
  }
  EXPECT_EQ(participant_.look_count, 2);
  foveola::test::wait_until("the next look", [&] {
    show(4100ms);
    return participant_.look_count == 3;
  });
}

TEST_F(SimulatedOperatorTest, AFailedTimingIsAskedAboutAndConfirmed) {
  begin_trial();
  session_.seen.mark = 1;
  participant_.regrets = true;
  show(3s);
  EXPECT_THAT(pressed(), ElementsAre(std::pair(PersonKey::back, Nanoseconds(3s))));
  EXPECT_TRUE(std::holds_alternative<RetimeRequested>(confirmed(Confirmed::timing_again, 4s)));
}

TEST_F(SimulatedOperatorTest, WhoWantsToStopPausesAndSaysSo) {
  participant_.withdraws_before = 0;
  show(0s);
  show(2s);
  session_.seen.phase = Phase::paused;
  show(3s);
  EXPECT_THAT(pressed(), ElementsAre(std::pair(PersonKey::pause, Nanoseconds(0s)),
                                     std::pair(PersonKey::back, Nanoseconds(3s))));
  EXPECT_TRUE(std::holds_alternative<Withdrawn>(confirmed(Confirmed::stopping, 4s)));
}

TEST_F(SimulatedOperatorTest, HandsAtTheMachineDoNothing) {
  window_.push(make_press(PersonKey::pause, 0s));
  window_.push({.what = CloseWanted{}});
  window_.push({.what = WindowHidden{.is_hidden = true}});
  show(0s);
  const std::vector<WindowEvent> events = operator_.events().take();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<WindowHidden>(events.front().what));
}

}  // namespace
}  // namespace foveola::study
