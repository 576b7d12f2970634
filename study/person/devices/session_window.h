// What a session in the window begins with, whoever takes part.
#pragma once

#include <stop_token>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "renderer/gaze/gaze_filter.h"
#include "renderer/headset/headset_facts.h"
#include "study/person/devices/session_display.h"
#include "study/protocol/texts.h"

namespace foveola::study {

/// Shows that the study is being loaded, until the rate of refreshes is measured or `stop` is
/// requested.
void measure_refreshes(SessionDisplay& display, const Texts& texts, const std::stop_token& stop);

/// What the record keeps of the display, as "display" of SessionFacts::devices.
nlohmann::ordered_json display_json(const SessionDisplay& display, const DisplayProfile& profile);

/// What it keeps of the machine, as "machine" there; threads: that render.
nlohmann::ordered_json machine_json(int threads);

/// What it keeps of a headset beside that, as its runtime told it, as "headset" there.
nlohmann::ordered_json headset_json(const HeadsetFacts& facts);

/// What it keeps of the tracker, as "tracker" there: the profile's name, and "filter" if there is
/// one.
nlohmann::ordered_json tracker_json(const std::string& profile, const GazeFilterSettings& filter);

}  // namespace foveola::study
