// Replays a recorded session: its events by the session's driver, and each attempt's film frame by
// frame.
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
  std::optional<std::size_t> trial;  ///< index into the plan; empty: all
  std::optional<int> attempt;        ///< counted from 1; empty: all
  std::filesystem::path folder;      ///< folder of the files that the protocol names by a path
  std::filesystem::path pictures;    ///< folder for the last view of each attempt; empty: none
  int threads = 0;                   ///< 0: one per core
};

struct ReplayedAttempt {
  std::size_t trial = 0;
  int attempt = 1;
  PlannedTrial planned;
  std::uint64_t frames = 0;                       ///< 0: the program died before any was recorded
  std::uint64_t samples = 0;                      ///< number of samples traced again
  std::size_t hashes = 0;                         ///< number of compared films
  std::optional<std::uint64_t> first_difference;  ///< the frame after which the film differs
};

struct ReplayReport {
  std::vector<ReplayedAttempt> attempts;
  /// The reason why films may differ in their last bits: another program or processor. Empty if
  /// none is known.
  std::string approximate;
  /// Describes the first event that differs from the recorded one, with its number in the session;
  /// empty if none does.
  std::string difference;
};

/// Drives a session again by its recorded answers, and renders its attempts. Protocol, head, gaze,
/// samples and seeds are the recorded ones; scenes are found by name. Throws Error if a scene, or a
/// file that the protocol names, has changed. A requested stop ends it after an attempt.
ReplayReport replay_session(const ReplaySettings& settings, const SceneFinderBeside& find_scene,
                            const std::stop_token& stop);

}  // namespace foveola::study
