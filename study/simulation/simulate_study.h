// A whole study with simulated participants: protocol in, records out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>

#include "renderer/base/scene_source.h"
#include "renderer/base/work/shard.h"

namespace foveola::study {

struct SimulateSettings {
  std::filesystem::path protocol;
  std::filesystem::path database;  ///< must not exist yet, or be a study of the same protocol
  int participants = 0;            ///< of all shards together
  /// Only this part of the participants, in a file of their own; empty: all.
  std::optional<Shard> shard{};
  std::uint64_t seed = 0;
  std::string people = "adults";               ///< see read_people
  std::string injected = "none";               ///< see parse_injected_effect
  int threads = 0;                             ///< 0: every core
  int jobs = 1;                                ///< sessions side by side, which share the threads
  double scale = 1.0;                          ///< see scaled_protocol
  std::optional<double> samples_per_second{};  ///< see SimulationKind
  bool predicted = false;  ///< renders pilots only, from which looks are predicted
  bool real_time = false;  ///< shows the trials in a window, at this machine's speed
  /// Goes on where the same settings were stopped or killed: finishes the sessions that were begun,
  /// until there are so many participants in all. Otherwise they are added to those in the file.
  bool resume = false;
  bool warns = false;  ///< says on standard error what the protocol should call otherwise

  /// How many participants are to be in the file.
  int participants_in_file() const {
    return static_cast<int>(part_of(shard.value_or(Shard{}), participants).size());
  }
};

struct SimulateReport {
  int sessions_before = 0;  ///< how many were over before, if the study was resumed
  int sessions_completed = 0;
  int sessions_refused = 0;  ///< how many the protocol's gate refused
  int sessions_withdrawn = 0;
  int trials = 0;
  double wall_s = 0.0;
  double sessions_wall_s = 0.0;  ///< the part of wall_s after references or pilots were there
  double simulated_s = 0.0;      ///< time that the participants spent: virtual, or real
  std::uint64_t samples = 0;
  std::uint64_t non_finite = 0;
};

/// Runs the participants, each through a real session, and shows progress with the time left. In
/// virtual time: same settings, same results, on any number of threads and jobs, also of a study
/// that was stopped or killed and resumed, and of shards that are merged. In real time it has to be
/// called by the program's first thread, whose is the window; what is drawn for a participant is
/// the same, when marks come is up to the machine. When `stop` is requested, a session that runs
/// alone is recorded as interrupted, those that run side by side or are predicted are left out, and
/// the report says how many were completed. Throws UsageError for settings that exclude one
/// another, and Error, before anything is rendered, if the protocol asks for what its analysis or
/// simulated participants cannot do, if a session to be resumed is of another seed or program, or
/// if the file has sessions that were simulated in another way.
SimulateReport simulate_study(const SimulateSettings& settings, const SceneFinderBeside& find_scene,
                              std::stop_token stop);

}  // namespace foveola::study
