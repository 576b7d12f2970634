// Reads the settings of a protocol's trials: machine, display, film, tracker, timing.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "renderer/base/toml/toml_reader.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

// Each function reads a TOML table; keys that are absent keep their defaults, or the values of
// `film` or `timing`. Each throws Error with file:line:column for an unknown key, a wrong type or a
// value that is out of range. `folder`: against which relative paths of profiles are resolved.
// `meaning`: help text of the key.
MachineModel read_machine(TomlReader reader);
DisplaySettings read_display(TomlReader reader, const std::filesystem::path& folder);
FilmSettings read_film(TomlReader reader, FilmSettings film);
TrackerSettings read_tracker(TomlReader reader, const std::filesystem::path& folder);
Timing read_timing(TomlReader reader, Timing timing);
ReferenceQuality read_reference(TomlReader reader);
PreflightGate read_preflight(TomlReader reader);

/// Finds the profile that a protocol's [display] names.
using DisplayProfiles = std::function<DisplayProfile(const std::string& name)>;

/// Reads [display] over the defaults, with profiles that need not be on a disk.
DisplaySettings read_display(TomlReader reader, const DisplayProfiles& profiles);

/// Reads one of the protocol's scenes; empty if the key is absent.
std::string read_scene_name(TomlReader& reader, const TomlKeyName& key, const Protocol& protocol,
                            std::string_view meaning);

/// Reads one of the protocol's methods; empty if the key is absent.
std::string read_method_name(TomlReader& reader, const TomlKeyName& key, const Protocol& protocol,
                             std::string_view meaning);

}  // namespace foveola::study
