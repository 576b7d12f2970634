#include "study/driver/session_driver.h"

#include <deque>
#include <functional>

#include "study/driver/clock_watch.h"
#include "tests/matchers.h"

namespace foveola::study {
namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds frame = 100ms;

Protocol protocol_of_one_trial() {
  Protocol protocol;
  protocol.scenes = {{.name = "box"}};
  protocol.methods = {"od"};
  protocol.timing = {.mark_timeout_s = 1.0, .rating_s = 0.5};
  protocol.marks = {{.id = "outline"}, {.id = "material"}};
  protocol.phases = {{.kind = PhaseEntry::Kind::trials}};
  return protocol;
}

/// A world in which a frame takes a tenth of a second, and a script says what is done.
class ScriptedWorld final : public ClockPort,
                            public DisplayPort,
                            public InputPort,
                            public SessionRecorder {
 public:
  // The record, which takes as long as the test wants it to.
  std::future<void> record(SessionEntry entry) override {
    const auto& event = std::get<EventEntry>(entry);
    log.push_back(std::to_string(event.time / 1ms) + " " + name_of(event.event));
    commits_.emplace_back();
    std::future<void> durable = commits_.back().get_future();
    if (is_disk_quick) {
      commit();
    }
    return durable;
  }
  void commit() {
    commits_.front().set_value();
    commits_.pop_front();
  }

  Nanoseconds now() const override { return now_; }

  void follow(const DurableEvent& event) override {
    log.push_back(std::string("seen ") + name_of(event.event));
  }
  void carry_out(const Effect& /*effect*/) override {}
  std::unique_ptr<AttemptPort> begin_attempt() override {
    if (gaze_comes_at > now_) {
      return nullptr;
    }
    return std::make_unique<Attempt>(*this);
  }
  Nanoseconds show() override { return now_ += frame; }

  void pass_input(SessionDriver& driver) override { does(driver); }

  std::function<void(SessionDriver& driver)> does;
  std::vector<std::string> log;
  bool is_disk_quick = true;
  Nanoseconds gaze_comes_at{0};
  int attempts_ended = 0;

 private:
  class Attempt final : public AttemptPort {
   public:
    explicit Attempt(ScriptedWorld& world) : world_(world) {}
    Nanoseconds show(Nanoseconds /*until*/) override { return world_.now_ += frame; }
    ~Attempt() override { ++world_.attempts_ended; }
    Attempt(const Attempt&) = delete;
    Attempt& operator=(const Attempt&) = delete;
    void complete_record() override { world_.log.emplace_back("frames"); }
    std::uint64_t samples() const override { return 7; }
    std::uint64_t non_finite() const override { return 1; }

   private:
    ScriptedWorld& world_;
  };

  Nanoseconds now_{0};
  std::deque<std::promise<void>> commits_;
};

class SessionDriverTest : public ::testing::Test {
 protected:
  SessionOutcome run(const SessionPosition& position = {}, std::vector<std::string> notes = {}) {
    SessionDriver driver(
        {.protocol = protocol_, .plan = plan_, .position = position, .notes = std::move(notes)},
        world_, world_, world_, world_);
    return driver.run(stop_.get_token());
  }

  /// Chooses and starts at once, makes the marks at these times, and rates as soon as it may.
  void take_part(std::deque<Nanoseconds> marks) {
    world_.does = [this, marks](SessionDriver& driver) mutable {
      if (driver.waits_in(Phase::choosing_object)) {
        driver.record_event(ObjectChosen{"vase"});
      } else if (driver.waits_in(Phase::ready)) {
        driver.record_event(TrialStarted{});
      } else if (driver.waits_in(Phase::marking) && !marks.empty() &&
                 world_.now() >= marks.front()) {
        driver.mark(marks.front());
        marks.pop_front();
      } else if (driver.waits_in(Phase::rating) && world_.now() >= driver.look_around_until()) {
        driver.record_event(Rated{});
      } else if (driver.state().is_over()) {
        driver.leave();
      }
    };
  }

  /// The same before clocks of which UTC is set ten seconds back once `happens`.
  void take_part_until_clock_is_set(std::deque<Nanoseconds> marks,
                                    const std::function<bool(const SessionState&)>& happens) {
    take_part(std::move(marks));
    world_.does = [this, happens, takes_part = world_.does, watch = ClockWatch(ClockReadings{}),
                   step = Nanoseconds(0)](SessionDriver& driver) mutable {
      step = happens(driver.state()) ? Nanoseconds(-10s) : step;
      const Nanoseconds now = world_.now();
      follow_clocks(watch, {.steady = now, .since_boot = now, .since_1970 = now + step}, driver);
      takes_part(driver);
    };
  }

  Protocol protocol_ = protocol_of_one_trial();
  Plan plan_ = {{.scene = "box", .method = "od"}};
  ScriptedWorld world_;
  std::stop_source stop_;
};

TEST_F(SessionDriverTest, MarksHaveTheTimesOfTheirKeys) {
  take_part({250ms, 470ms});
  const SessionOutcome outcome = run();
  EXPECT_EQ(outcome.phase, Phase::completed);
  EXPECT_EQ(outcome.trials, 1U);
  EXPECT_EQ(outcome.samples, 7U);
  EXPECT_EQ(outcome.non_finite, 1U);
  EXPECT_THAT(world_.log,
              ElementsAre("0 session_started", "seen session_started", "0 object_chosen",
                          "seen object_chosen", "0 trial_started", "seen trial_started",
                          "100 first_frame_presented", "seen first_frame_presented", "250 marked",
                          "seen marked", "470 marked", "seen marked", "frames", "1000 rated",
                          "seen rated"));
}

// The deadline is one second after the first frame; a key that comes later is a time-out, whenever
// it is heard of.
TEST_F(SessionDriverTest, AMarkTimesOutAtItsDeadline) {
  take_part({1150ms});
  run();
  EXPECT_THAT(world_.log, Contains("1100 timed_out").Times(2));
  EXPECT_THAT(world_.log, Not(Contains("1150 marked")));
}

TEST_F(SessionDriverTest, AKeyAfterTheDeadlineIsATimeOut) {
  take_part({});
  const auto takes_part = world_.does;
  world_.does = [this, takes_part](SessionDriver& driver) {
    takes_part(driver);
    if (driver.waits_in(Phase::marking) && world_.now() >= 1100ms) {
      EXPECT_FALSE(driver.mark(1150ms));
      stop_.request_stop();
    }
  };
  run();
  EXPECT_THAT(world_.log, Contains("1100 timed_out"));
  EXPECT_THAT(world_.log, Not(Contains("1150 marked")));
}

TEST_F(SessionDriverTest, NothingIsSeenBeforeItIsOnTheDisk) {
  world_.is_disk_quick = false;
  int frames = 0;
  world_.does = [&](SessionDriver& driver) {
    EXPECT_EQ(driver.seen().phase, frames <= 2 ? Phase::created : Phase::choosing_object);
    EXPECT_EQ(driver.has_effects_to_come(), frames <= 2);
    if (++frames == 3) {
      world_.commit();
    } else if (frames == 5) {
      driver.leave();
    }
  };
  EXPECT_EQ(run().phase, Phase::choosing_object);
  EXPECT_THAT(world_.log, ElementsAre("0 session_started", "seen session_started"));
}

TEST_F(SessionDriverTest, ATrialWaitsUntilItsAttemptCanBegin) {
  world_.gaze_comes_at = 300ms;
  take_part({600ms, 700ms});
  run();
  EXPECT_THAT(world_.log, Contains("400 first_frame_presented"));
}

TEST_F(SessionDriverTest, WhatDiedInATrialGoesOnBeforeIt) {
  take_part({});
  world_.does = [](SessionDriver& driver) { driver.leave(); };
  const SessionOutcome outcome =
      run({.state = {.phase = Phase::marking, .object = "vase"}}, {"goes on"});
  EXPECT_EQ(outcome.phase, Phase::ready);
  EXPECT_EQ(world_.attempts_ended, 0) << "it was another program's";
  EXPECT_THAT(world_.log, ElementsAre("0 interrupted", "0 note_written", "0 resumed",
                                      "seen interrupted", "seen note_written", "seen resumed"));
}

TEST_F(SessionDriverTest, AnAttemptInWhichTheClockIsSetIsTimedAgain) {
  take_part_until_clock_is_set({250ms, 470ms, 550ms},
                               [](const SessionState& state) { return state.mark == 1; });
  EXPECT_EQ(run().trials, 1U);
  EXPECT_EQ(world_.attempts_ended, 2);
  EXPECT_THAT(world_.log,
              ElementsAre("0 session_started", "seen session_started", "0 object_chosen",
                          "seen object_chosen", "0 trial_started", "seen trial_started",
                          "100 first_frame_presented", "seen first_frame_presented", "250 marked",
                          "seen marked", "300 note_written", "frames", "300 retime_requested",
                          "seen note_written", "seen retime_requested", "300 trial_started",
                          "seen trial_started", "400 first_frame_presented",
                          "seen first_frame_presented", "470 marked", "seen marked", "550 marked",
                          "seen marked", "frames", "1100 rated", "seen rated"));
}

TEST_F(SessionDriverTest, BetweenAttemptsAClockThatIsSetIsOnlyNoted) {
  take_part_until_clock_is_set(
      {250ms, 470ms}, [](const SessionState& state) { return state.phase == Phase::ready; });
  EXPECT_EQ(run().trials, 1U);
  EXPECT_EQ(world_.attempts_ended, 1);
  EXPECT_THAT(world_.log, Contains("0 note_written"));
}

TEST_F(SessionDriverTest, AStopInterruptsTheAttempt) {
  take_part({250ms});
  const auto takes_part = world_.does;
  world_.does = [this, takes_part](SessionDriver& driver) {
    takes_part(driver);
    if (driver.state().mark == 1) {
      stop_.request_stop();
    }
  };
  EXPECT_EQ(run().phase, Phase::interrupted);
  EXPECT_EQ(world_.attempts_ended, 1);
  EXPECT_EQ(world_.log.back(), "seen interrupted");
}

}  // namespace
}  // namespace foveola::study
