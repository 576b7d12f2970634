#include "study/record/setup/routine_notes.h"

#include <gtest/gtest.h>

#include "renderer/base/files/digest.h"
#include "study/record/setup/amendment_note.h"
#include "study/record/setup/session_devices.h"
#include "study/record/setup/session_programs.h"
#include "study/record/write/clock_steps.h"

namespace foveola::study {
namespace {

TEST(RoutineNotes, AreThoseOfASessionThatGoesOn) {
  const std::string amended = "name = \"other words\"\n";
  EXPECT_TRUE(is_routine_note(note_of_devices(R"({"tracker":{"profile":"camera"}})")));
  EXPECT_TRUE(is_routine_note(note_of_program("Foveola 0.2.0 (GNU)", "Foveola 0.1.0 (GNU)")));
  EXPECT_TRUE(is_routine_note(note_of(
      Amendment{.sha256 = sha256(std::string_view(amended)), .changed = {}, .text = amended})));
  EXPECT_TRUE(is_routine_note(*note_of_clock(
      {{Nanoseconds(1), Interrupted{}, "2026-11-21T09:40:00.000Z"}}, "2026-11-21T09:35:00.000Z")));
  EXPECT_TRUE(is_routine_note(note_of_sleep(std::chrono::minutes(2))));
}

TEST(RoutineNotes, AreThoseOfTheWindowsSize) {
  EXPECT_EQ(note_of_window_size({1280, 720}), "the window has 1280 x 720 pixels");
  EXPECT_TRUE(is_routine_note(note_of_window_size({1280, 720})));
}

TEST(RoutineNotes, AreNoneThatSomebodyShouldRead) {
  for (const char* const note :
       {"the eye tracker sends no gaze", "the trial waits for a gaze", "the window is hidden",
        "lost the monitor DP-1", "the window has a crack", "goes on with a headache",
        "goes by an amended protocol, SHA-256 of nothing", ""}) {
    EXPECT_FALSE(is_routine_note(note)) << note;
  }
}

}  // namespace
}  // namespace foveola::study
