// A person's session from the command line to the backup.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>

#include "renderer/base/scene_source.h"
#include "renderer/base/vec.h"
#include "renderer/gaze/gaze_filter.h"
#include "study/record/study_store.h"

namespace foveola::study {

struct RunSettings {
  std::filesystem::path protocol;
  std::filesystem::path database;  ///< a new file, or a study of the same protocol
  std::string participant;         ///< a code: letters, digits, - and _
  SessionKind kind = SessionKind::human;
  std::optional<std::uint64_t> seed;  ///< seed of orders and noise; default: drawn at random
  std::optional<int> first_row;  ///< of the design; empty: that of the file's first person, or 0
  std::string display;           ///< a profile; empty: the protocol's, or desktop
  std::string tracker;           ///< pointer or a profile; empty: the protocol's, or pointer
  /// Of a pilot's gaze, in place of the protocol's; empty: the protocol's.
  std::optional<GazeFilterSettings> gaze_filter;
  IVec2 window{1280, 720};     ///< size of the window; not used in full screen
  std::optional<int> monitor;  ///< fills this monitor
  int threads = 0;             ///< 0: one for every core
  bool resumes = false;        ///< goes on with the participant's unfinished session
  bool undoes_end = false;     ///< which a withdrawal or an exclusion was
  bool is_blind = false;       ///< the experimenter does not read the methods before its end
  /// Even if the program, the scenes or the equipment have changed since.
  bool despite_changes = false;
  OtherProtocol other_protocol =
      OtherProtocol::refuse;  ///< if the protocol is not the one that the database was begun with
  /// Every page that the participant comes to is written there as a picture.
  std::optional<std::filesystem::path> screens;
  /// The experimenter's console is for machines: a JSON object a line.
  bool json = false;
  /// Gets a receipt of the participant's consent, once that was given.
  std::optional<std::filesystem::path> receipt;
  /// Gets a copy of the study after the session, besides its backup.
  std::optional<std::filesystem::path> backup_folder;
};

struct RunReport {
  Phase phase = Phase::created;  ///< completed, refused, withdrawn, excluded or interrupted
  bool is_blind = false;         ///< by the settings, or since the session began
  std::filesystem::path backup;
  std::filesystem::path copy;  ///< in the backup_folder; empty if there is none
};

/// Runs in the program's first thread, whose is the window. The experimenter's console is standard
/// input and output: a screen if both are a terminal, lines otherwise. Throws Error for what is
/// wrong with the settings, the files, the window or the participant's session so far; then nothing
/// was begun.
RunReport run_person(const RunSettings& settings, const SceneFinderBeside& find_scene,
                     const std::stop_token& stop);

}  // namespace foveola::study
