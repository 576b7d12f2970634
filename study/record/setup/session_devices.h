// What a session's record says of its devices: the view that its display showed, its tracker, and
// what traced its rays.
#pragma once

#include <optional>
#include <string>

#include "renderer/base/build_info.h"
#include "renderer/view/viewport.h"

namespace foveola::study {

/// The view that `devices`, the JSON object that schema.sql describes at session, says the display
/// showed, of a headset its left one; empty if it says none, or none that there can be.
std::optional<FieldOfView> field_of_view_in(const std::string& devices);

/// The name of the eye tracker's profile in it; empty if it says none.
std::string tracker_in(const std::string& devices);

/// Whether the session's experimenter must not know the methods before its end.
bool is_experimenter_blind(const std::string& devices);

/// `build` with what `devices` says of what traced the rays and by which instructions; empty where
/// it says nothing.
BuildInfo with_renderer_in(const std::string& devices, BuildInfo build);

/// `devices`, a JSON object, with what is known of that.
std::string with_renderer(const std::string& devices, const BuildInfo& build);

/// The note of a session that goes on with these devices.
std::string note_of_devices(const std::string& devices);

/// The devices that such a note names; empty if it is another note.
std::optional<std::string> devices_in_note(const std::string& note);

}  // namespace foveola::study
