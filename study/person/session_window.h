// What a session in the window begins with, whoever takes part.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "study/person/session_display.h"
#include "study/protocol/texts.h"

namespace foveola::study {

/// Shows that the study is being loaded, until the rate of refreshes is measured.
void measure_refreshes(SessionDisplay& display, const Texts& texts);

/// What the record keeps of the display, as "display" of SessionFacts::devices.
nlohmann::ordered_json display_json(const SessionDisplay& display, const DisplayProfile& profile);

}  // namespace foveola::study
