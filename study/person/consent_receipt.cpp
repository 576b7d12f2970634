#include "study/person/consent_receipt.h"

#include <algorithm>

#include <fmt/format.h>

#include "study/protocol/texts.h"

namespace foveola::study {

std::optional<std::string> consent_receipt(const Protocol& protocol, const std::string& participant,
                                           const std::vector<LoggedEvent>& events) {
  const auto consent = std::find_if(events.begin(), events.end(), [](const LoggedEvent& logged) {
    return std::holds_alternative<ConsentGiven>(logged.event);
  });
  if (consent == events.end()) {
    return std::nullopt;
  }
  return fmt::format(
      "{title}\n\n"
      "{words}\n\n"
      "Agreed to by participant {code} at {utc} (UTC).\n"
      "The study knows you by this code alone. You may ask the experimenter at any time to delete "
      "what was recorded under it.\n"
      "Protocol {name}, SHA-256 {sha256}\n",
      fmt::arg("title", protocol.title), fmt::arg("words", text_of(protocol.texts, "consent")),
      fmt::arg("code", participant), fmt::arg("utc", consent->utc), fmt::arg("name", protocol.name),
      fmt::arg("sha256", protocol.sha256));
}

}  // namespace foveola::study
