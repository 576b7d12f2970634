// Prepares the window of a session: measures refreshes, describes the equipment.
#pragma once

#include <stop_token>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "renderer/gaze/gaze_filter.h"
#include "renderer/headset/headset_facts.h"
#include "study/person/devices/session_display.h"
#include "study/protocol/texts.h"

namespace foveola::study {

/// Shows that the study is loading until the refresh rate is measured or `stop` is requested.
void measure_refreshes(SessionDisplay& display, const Texts& texts, const std::stop_token& stop);

/// Returns the recorded facts of the display, as "display" of SessionFacts::devices.
nlohmann::ordered_json display_json(const SessionDisplay& display, const DisplayProfile& profile);

/// Returns the recorded facts of the machine, as "machine" there. threads: number of rendering
/// threads.
nlohmann::ordered_json machine_json(int threads);

/// Returns the recorded facts of a headset, as its runtime reported them, as "headset" there.
nlohmann::ordered_json headset_json(const HeadsetFacts& facts);

/// Returns the recorded facts of the tracker, as "tracker" there: the profile's name, and "filter"
/// if there is one.
nlohmann::ordered_json tracker_json(const std::string& profile, const GazeFilterSettings& filter);

}  // namespace foveola::study
