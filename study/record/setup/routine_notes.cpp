#include "study/record/setup/routine_notes.h"

#include <string_view>

#include <fmt/format.h>

#include "study/record/setup/amendment_note.h"
#include "study/record/setup/session_devices.h"
#include "study/record/setup/session_programs.h"
#include "study/record/write/clock_steps.h"

namespace foveola::study {
namespace {

constexpr std::string_view before_window_size = "the window has ";
constexpr std::string_view after_window_size = " pixels";

}  // namespace

std::string note_of_window_size(const IVec2& pixels) {
  return fmt::format("{}{} x {}{}", before_window_size, pixels.x, pixels.y, after_window_size);
}

bool is_routine_note(const std::string& note) {
  return devices_in_note(note) || program_in_note(note) || amendment_in(note) ||
         is_note_of_clock(note) ||
         (note.starts_with(before_window_size) && note.ends_with(after_window_size));
}

}  // namespace foveola::study
