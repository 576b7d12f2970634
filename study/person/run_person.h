// Runs a person's session, from its settings to its backup.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>

#include "renderer/base/scene_source.h"
#include "renderer/base/vec.h"
#include "renderer/gaze/gaze_filter.h"
#include "study/record/write/study_store.h"

namespace foveola::study {

struct RunSettings {
  std::filesystem::path protocol;
  std::filesystem::path database;  ///< a new file, or a study of the same protocol
  std::string participant;         ///< a code: letters, digits, - and _
  SessionKind kind = SessionKind::human;
  std::optional<std::uint64_t> seed;  ///< seed of orders and noise; default: drawn at random
  /// Row of the counterbalancing design from which the least used one is taken; empty: that of the
  /// study's first person, or 0.
  std::optional<int> first_row;
  std::string display;  ///< a profile; empty: the protocol's, or desktop
  std::string tracker;  ///< pointer or a profile; empty: the protocol's, or pointer
  /// A pilot's gaze filter; empty: the protocol's.
  std::optional<GazeFilterSettings> gaze_filter;
  IVec2 window{1280, 720};     ///< size of the window; not used in full screen
  std::optional<int> monitor;  ///< the monitor to fill; empty: a window
  int threads = 0;             ///< 0: one per core
  bool resumes = false;        ///< resumes the participant's unfinished session
  bool undo_end = false;       ///< undoes the session's withdrawal or exclusion
  bool is_blind = false;       ///< the console hides the methods until the session's end
  /// Resumes or begins even if the program, the scenes or the equipment have changed.
  bool accept_changes = false;
  OtherProtocol other_protocol = OtherProtocol::refuse;  ///< if the protocol differs from the one
                                                         ///< that the database was begun with
  /// Folder for a screenshot of each page shown.
  std::optional<std::filesystem::path> screens;
  /// The experimenter's console reads and writes a JSON object per line.
  bool json = false;
  /// File for a receipt of the participant's consent, once given.
  std::optional<std::filesystem::path> receipt;
  /// Folder for a copy of the study after the session, in addition to its backup.
  std::optional<std::filesystem::path> backup_folder;
};

struct RunReport {
  Phase phase = Phase::created;  ///< completed, refused, withdrawn, excluded or interrupted
  bool is_blind = false;         ///< by the settings, or since the session began
  std::filesystem::path backup;
  std::filesystem::path copy;  ///< file in backup_folder; empty if there is none
};

/// Call in the program's first thread, which owns the window. The experimenter's console is
/// standard input and output: a screen if both are a terminal, lines otherwise. find_scene returns
/// the file of a scene that the protocol names. On `stop` the session is recorded as interrupted;
/// `resumes` continues it. Throws Error,
/// before anything is begun, if the settings, the files, the window or the participant's earlier
/// sessions do not allow the session.
RunReport run_person(const RunSettings& settings, const SceneFinderBeside& find_scene,
                     const std::stop_token& stop);

}  // namespace foveola::study
