#include "study/driver/session_log.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

namespace foveola::study {

SessionLog::SessionLog(Procedure procedure, SessionState state, SessionRecorder& recorder)
    : procedure_(std::move(procedure)), state_(std::move(state)), recorder_(recorder) {}

bool SessionLog::record_event(Nanoseconds now, const Event& event) {
  std::optional<Transition> next = step(procedure_, state_, event);
  if (!next) {
    return false;
  }
  const Nanoseconds time = time_of(event, now);
  std::future<void> written = recorder_.record(
      EventEntry{.time = time, .event = event, .before = state_, .after = next->state});
  pending_.push_back({.event = {.time = time,
                                .event = event,
                                .after = next->state,
                                .effects = std::move(next->effects)},
                      .written = std::move(written)});
  state_ = std::move(next->state);
  return true;
}

bool SessionLog::has_effects_to_come() const {
  return std::ranges::any_of(pending_,
                             [](const Pending& pending) { return !pending.event.effects.empty(); });
}

std::vector<DurableEvent> SessionLog::take_durable() {
  std::vector<DurableEvent> durable;
  while (!pending_.empty() &&
         pending_.front().written.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    pending_.front().written.get();
    durable.push_back(std::move(pending_.front().event));
    pending_.pop_front();
  }
  return durable;
}

std::vector<DurableEvent> SessionLog::wait_for_all() {
  if (!pending_.empty()) {
    pending_.back().written.wait();
  }
  return take_durable();
}

}  // namespace foveola::study
