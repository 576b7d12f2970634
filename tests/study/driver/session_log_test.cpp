#include "study/driver/session_log.h"

#include <stdexcept>

#include "tests/matchers.h"

namespace foveola::study {
namespace {

using namespace std::chrono_literals;

/// A disk that takes as long as the test wants it to.
struct SlowDisk final : SessionRecorder {
  std::future<void> record(SessionEntry entry) override {
    const auto& event = std::get<EventEntry>(entry);
    times.push_back(event.time);
    names.emplace_back(name_of(event.event));
    return commits.emplace_back().get_future();
  }

  std::vector<Nanoseconds> times;
  std::vector<std::string> names;
  std::deque<std::promise<void>> commits;
};

Procedure one_trial() { return {.agenda = {ConsentStep{}, TrialStep{}}, .marks = 1}; }

TEST(SessionLog, EffectsComeOnceTheEventIsOnTheDisk) {
  SlowDisk disk;
  SessionLog log(one_trial(), {}, disk);
  ASSERT_TRUE(log.record_event(1s, SessionStarted{}));
  EXPECT_EQ(log.state().phase, Phase::consent);
  EXPECT_TRUE(log.has_effects_to_come());
  EXPECT_TRUE(log.take_durable().empty());

  disk.commits.front().set_value();
  const std::vector<DurableEvent> durable = log.take_durable();
  ASSERT_EQ(durable.size(), 1U);
  EXPECT_EQ(durable[0].time, 1s);
  EXPECT_EQ(durable[0].after.phase, Phase::consent);
  ASSERT_EQ(durable[0].effects.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<AskForConsent>(durable[0].effects[0]));
  EXPECT_FALSE(log.has_effects_to_come());
  EXPECT_TRUE(log.take_durable().empty());
}

TEST(SessionLog, WhatIsNotAllowedIsNotWritten) {
  SlowDisk disk;
  SessionLog log(one_trial(), {}, disk);
  EXPECT_FALSE(log.record_event(1s, Marked{1s}));
  EXPECT_TRUE(disk.commits.empty());
  EXPECT_EQ(log.state(), SessionState{});
}

TEST(SessionLog, LaterEventsWaitForEarlierOnes) {
  SlowDisk disk;
  SessionLog log(one_trial(), {}, disk);
  log.record_event(1s, SessionStarted{});
  log.record_event(2s, NoteWritten{"late"});
  disk.commits[1].set_value();
  EXPECT_TRUE(log.take_durable().empty());
  disk.commits[0].set_value();
  EXPECT_EQ(log.take_durable().size(), 2U);
  EXPECT_THAT(disk.names, ElementsAre("session_started", "note_written"));
}

TEST(SessionLog, ANoteHoldsNobodyUp) {
  SlowDisk disk;
  SessionLog log(one_trial(), {}, disk);
  log.record_event(1s, SessionStarted{});
  disk.commits[0].set_value();
  log.take_durable();
  log.record_event(2s, NoteWritten{"the light flickered"});
  EXPECT_FALSE(log.has_effects_to_come());
}

TEST(SessionLog, AMarkHasTheTimeOfItsKey) {
  SlowDisk disk;
  SessionLog log(one_trial(), {.phase = Phase::marking, .step = 1, .first_frame = 2s}, disk);
  ASSERT_TRUE(log.record_event(9s, Marked{5s}));
  EXPECT_THAT(disk.times, ElementsAre(5s));
}

TEST(SessionLog, SaysWhatKeptAnEventFromTheDisk) {
  SlowDisk disk;
  SessionLog log(one_trial(), {}, disk);
  log.record_event(1s, SessionStarted{});
  disk.commits[0].set_exception(std::make_exception_ptr(std::runtime_error("disk full")));
  EXPECT_THROW(log.take_durable(), std::runtime_error);
}

}  // namespace
}  // namespace foveola::study
