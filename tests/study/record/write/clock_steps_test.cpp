#include "study/record/write/clock_steps.h"

#include "study/record/maintain/maintenance.h"
#include "tests/matchers.h"
#include "tests/study/record/small_study.h"

namespace foveola::study {
namespace {

TEST(ClockSteps, AreReportedFromAMinuteOn) {
  const std::string before = "2026-11-21T09:30:00.500Z";
  EXPECT_EQ(clock_set_back(before, "2026-11-21T09:30:00.600Z"), std::nullopt);
  EXPECT_EQ(clock_set_back(before, "2036-11-21T09:30:00.000Z"), std::nullopt) << "a long break";
  EXPECT_EQ(clock_set_back(before, "2026-11-21T09:29:00.500Z"), std::nullopt);
  EXPECT_THAT(clock_set_back(before, "2026-11-21T09:28:55.500Z"),
              Optional(std::string("1 m 05 s")));
  EXPECT_THAT(clock_set_back(before, "2026-11-21T08:30:00.500Z"),
              Optional(std::string("1 h 00 m")));
  EXPECT_THAT(clock_set_back(before, "2016-11-21T09:30:00.500Z"),
              Optional(std::string("3652 days")));
}

TEST(ClockSteps, OfARunningSessionAreNoted) {
  using namespace std::chrono_literals;
  const std::vector<std::string> notes = {note_of_clock_step(5h), note_of_clock_step(-65s),
                                          note_of_sleep(72h)};
  EXPECT_THAT(notes,
              ElementsAre("the computer's clock was set forward by 5 h 00 m while the session ran",
                          "the computer's clock was set back by 1 m 05 s while the session ran",
                          "the computer slept for 3 days while the session ran"));
  for (const std::string& note : notes) {
    EXPECT_TRUE(is_note_of_running_session(note)) << note;
    EXPECT_TRUE(is_note_of_clock(note)) << note;
  }
  EXPECT_FALSE(is_note_of_running_session("the participant slept while the session ran"));
}

TEST(ClockSteps, OfARunningSessionAreNamedByVerify) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "study.sqlite";
  {
    StudyStore store(path, small_protocol());
    PlayedSession session = begun_session(store);
    session.happen(ms(20), NoteWritten{note_of_clock_step(std::chrono::hours(5))});
    session.happen(ms(30), NoteWritten{"the clock on the wall rang"});
  }
  EXPECT_THAT(verify_study(path).warnings,
              ElementsAre(FieldsAre(
                  "P01",
                  "event 3: the computer's clock was set forward by 5 h 00 m while the session "
                  "ran")));
}

TEST(ClockSteps, AreNoneOfWhatIsNoTime) {
  EXPECT_EQ(clock_set_back("", "2026-11-21T09:30:00.500Z"), std::nullopt);
  EXPECT_EQ(clock_set_back("2026-11-21T09:30:00.500Z", "yesterday"), std::nullopt);
}

TEST(ClockSteps, ASessionThatGoesOnNotesThem) {
  EXPECT_EQ(note_of_clock({}, "2016-01-01T00:00:00.000Z"), std::nullopt);
  const std::vector<LoggedEvent> events = {
      {Nanoseconds(0), SessionStarted{}, "2026-11-21T09:30:00.000Z"},
      {Nanoseconds(1), Interrupted{}, "2026-11-21T09:40:00.000Z"}};
  EXPECT_EQ(note_of_clock(events, "2026-11-21T09:41:00.000Z"), std::nullopt);
  EXPECT_THAT(note_of_clock(events, "2026-11-21T09:35:00.000Z"),
              Optional(std::string(
                  "the computer's clock was set back by 5 m 00 s since "
                  "2026-11-21T09:40:00.000Z, when the session's last event was recorded")));
  EXPECT_TRUE(is_note_of_clock(*note_of_clock(events, "2026-11-21T09:35:00.000Z")));
  EXPECT_FALSE(is_note_of_running_session(*note_of_clock(events, "2026-11-21T09:35:00.000Z")));
  EXPECT_FALSE(is_note_of_clock("the clock on the wall was set back"));
}

}  // namespace
}  // namespace foveola::study
