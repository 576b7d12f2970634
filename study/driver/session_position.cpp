#include "study/driver/session_position.h"

#include <algorithm>

#include "study/record/event_log.h"

namespace foveola::study {

SessionPosition position_after(const Procedure& procedure, const std::vector<LoggedEvent>& events,
                               const std::string& whose) {
  SessionPosition position;
  for_each_step(
      procedure, events, whose,
      [&](const LoggedEvent& logged, const SessionState& /*before*/, const SessionState& after) {
        position.state = after;
        position.time = std::max(position.time, logged.time);
        if (const auto* validated = std::get_if<GazeValidated>(&logged.event)) {
          position.correction = correction_after(*validated);
        } else if (const auto* consent = std::get_if<ConsentGiven>(&logged.event)) {
          position.consent_sha256 = consent->text_sha256;
        }
      });
  return position;
}

}  // namespace foveola::study
