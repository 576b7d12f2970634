#include "study/replay/compared_record.h"

#include <fmt/format.h>

#include "study/record/log/event_json.h"

namespace foveola::study {
namespace {

std::string words_for(Nanoseconds time, const Event& event) {
  return fmt::format("{} {} at {} ns", name_of(event), payload_of(event), time.count());
}

}  // namespace

std::future<void> ComparedRecord::record(SessionEntry entry) {
  const auto* made = std::get_if<EventEntry>(&entry);
  if (made != nullptr && !is_at_end()) {
    const std::string words = words_for(made->time, made->event);
    if (words != words_for(next().time, next().event)) {
      differ("the replayed session makes " + words);
    }
    ++next_;
  }
  return already_recorded();
}

std::vector<std::string> ComparedRecord::next_notes() const {
  std::vector<std::string> notes;
  std::size_t i = next_;
  i += !is_at_end() && std::holds_alternative<SessionStarted>(next().event) ? 1 : 0;
  for (; i < events_.size(); ++i) {
    const auto* note = std::get_if<NoteWritten>(&events_[i].event);
    if (note == nullptr) {
      break;
    }
    notes.push_back(note->text);
  }
  return notes;
}

Nanoseconds ComparedRecord::time() const {
  if (!is_at_end()) {
    return next().time;
  }
  return events_.empty() ? Nanoseconds(0) : events_.back().time;
}

void ComparedRecord::differ(const std::string& how) {
  if (difference_.empty()) {
    difference_ = fmt::format("event {} is recorded as {}, but {}", next_ + 1,
                              words_for(next().time, next().event), how);
  }
}

}  // namespace foveola::study
