// Simulates a whole study: protocol in, records out.
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
  std::filesystem::path database;  ///< a new file, or a study of the same protocol
  int participants = 0;            ///< number in all shards together
  /// Only this part of the participants, in a file of their own; empty: all.
  std::optional<Shard> shard{};
  std::uint64_t seed = 0;
  std::string people = "adults";               ///< see read_people
  std::string injected = "none";               ///< see parse_injected_effect
  int threads = 0;                             ///< 0: one per core
  int jobs = 1;                                ///< concurrent sessions, which share the threads
  double scale = 1.0;                          ///< see scaled_protocol
  std::optional<double> samples_per_second{};  ///< see SimulationKind
  bool predicted = false;  ///< renders pilots only, and predicts looks from them
  bool real_time = false;  ///< shows the trials in a window, at this machine's speed
  /// Resumes a simulation with the same settings that was stopped or killed: finishes its sessions,
  /// until there are `participants` in all. Otherwise they are added to the file's.
  bool resume = false;
  bool warns = false;  ///< warns of the protocol's outdated keys on standard error

  /// Returns the final number of participants in the file.
  int participants_in_file() const {
    return static_cast<int>(part_of(shard.value_or(Shard{}), participants).size());
  }
};

struct SimulateReport {
  int sessions_before = 0;  ///< earlier finished sessions, if the study was resumed
  int sessions_completed = 0;
  int sessions_refused = 0;  ///< sessions refused by the protocol's gate
  int sessions_withdrawn = 0;
  int trials = 0;
  double wall_s = 0.0;
  double sessions_wall_s = 0.0;  ///< part of wall_s after references or pilots were ready
  double simulated_s = 0.0;      ///< the participants' time: virtual, or real
  std::uint64_t samples = 0;
  std::uint64_t non_finite = 0;
};

/// Runs the participants, each through a real session, and shows progress with the remaining time.
/// In virtual time, equal settings give equal results, with any number of threads and jobs, also
/// after a stop, kill and resume, and in merged shards. In real time it must be called by the
/// program's first thread, which owns the window; random draws are equal, but times of marks depend
/// on the machine. When `stop` is requested, a session that runs alone is recorded as interrupted;
/// concurrent or predicted ones are left out, and the report has the number of completed ones.
/// Throws UsageError for settings that exclude one another. Throws Error, before anything is
/// rendered, if the protocol asks for what its analysis or simulated participants cannot do, if a
/// session to be resumed is of another seed or program, or if the file's sessions were simulated in
/// another way.
SimulateReport simulate_study(const SimulateSettings& settings, const SceneFinderBeside& find_scene,
                              std::stop_token stop);

}  // namespace foveola::study
