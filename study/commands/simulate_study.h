// A whole study with simulated participants: protocol in, records out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stop_token>

#include "renderer/base/scene_source.h"

namespace foveola::study {

struct SimulateSettings {
  std::filesystem::path protocol;
  std::filesystem::path database;  ///< must not exist yet, or be a study of the same protocol
  int participants = 0;
  std::uint64_t seed = 0;
  int threads = 0;  ///< 0: every core
  /// Goes on where the same settings were stopped or killed: finishes the sessions that were begun,
  /// until there are so many participants in all. Otherwise they are added to those in the file.
  bool resume = false;
};

struct SimulateReport {
  int sessions_before = 0;  ///< over before, of those that were resumed
  int sessions_completed = 0;
  int sessions_refused = 0;  ///< by the protocol's gate
  int trials = 0;
  double wall_s = 0.0;
  double simulated_s = 0.0;  ///< virtual time that the participants spent
  std::uint64_t samples = 0;
  std::uint64_t non_finite = 0;
};

/// Runs the participants one after the other, each through a real session in virtual time, and
/// shows progress with the time left. Same settings, same results: also of a study that was stopped
/// or killed and resumed. When `stop` is requested the running session is recorded as interrupted
/// and the report says how many were completed. Throws Error, before anything is rendered, if a
/// session to be resumed is of another seed or program.
SimulateReport simulate_study(const SimulateSettings& settings, const SceneFinder& find_scene,
                              std::stop_token stop);

}  // namespace foveola::study
