// What verifying a study's file found, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "study/record/maintain/maintenance.h"

namespace foveola::study {

/// {"sessions", "events", "chunks", "faults": [{"participant", "what"}], "gaps": [the same]}
nlohmann::ordered_json verification_json(const Verification& found);

}  // namespace foveola::study
