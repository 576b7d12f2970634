// A recorded session run again from what the record keeps: its events by the session's driver, and
// each attempt's film frame by frame.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer/base/scene_source.h"
#include "study/design/plan.h"

namespace foveola::study {

struct ReplaySettings {
  std::filesystem::path database;
  std::string participant;
  std::optional<std::size_t> trial;  ///< index into the plan; all if empty
  std::optional<int> attempt;        ///< counted from 1; all if empty
  std::filesystem::path folder;      ///< where the files lie that the protocol names by a path
  std::filesystem::path pictures;    ///< folder for the last view of each attempt; empty: none
  int threads = 0;                   ///< 0: every core
};

struct ReplayedAttempt {
  std::size_t trial = 0;
  int attempt = 1;
  PlannedTrial planned;
  std::uint64_t frames = 0;   ///< 0: the program died before any reached the disk
  std::uint64_t samples = 0;  ///< how many samples were traced again
  std::size_t hashes = 0;     ///< how many films were compared
  std::optional<std::uint64_t> first_difference;  ///< the frame after which the film was another
};

struct ReplayReport {
  std::vector<ReplayedAttempt> attempts;
  /// Why the films may differ in their last bits: another program or processor. Empty if nothing is
  /// known to be another.
  std::string approximate;
  /// How the first event that the session, driven again, makes differs from the recorded one, with
  /// its number in the session; empty if none does.
  std::string difference;
};

/// Drives a session again by its recorded answers, and renders its attempts: the protocol, head,
/// gaze, samples and seeds are those of the record, the scenes are found by name. Throws Error if
/// one of the scenes, or of what the protocol names, is another now. A requested stop ends it after
/// an attempt.
ReplayReport replay_session(const ReplaySettings& settings, const SceneFinderBeside& find_scene,
                            const std::stop_token& stop);

}  // namespace foveola::study
