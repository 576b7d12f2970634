// Runs the participants of a simulated study, one after the other or concurrently.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <vector>

#include "renderer/base/build_info.h"
#include "renderer/base/work/work_scope.h"
#include "study/participant/participant.h"
#include "study/record/write/recorders.h"
#include "study/record/write/study_store.h"
#include "study/simulation/simulate_study.h"
#include "study/simulation/virtual_session.h"

namespace foveola::study {

/// Returns whether the session is over.
bool has_ended(const KnownSession& session);

/// The remaining work of a simulation.
struct SessionsAhead {
  int over = 0;                     ///< finished sessions of its seed, if it is resumed
  std::vector<KnownSession> begun;  ///< sessions to be finished, if it is resumed
  /// Design rows of participants who are not in the file yet: a study can be extended.
  std::vector<int> new_rows;
};

/// Returns the work ahead by the settings' database, which need not exist. Throws Error for a file
/// that is not a study of the protocol.
SessionsAhead sessions_ahead(const SimulateSettings& settings, const Protocol& protocol);

/// A session to be run, from its start or from its interruption.
struct BegunSession {
  StudyStore& store;
  std::int64_t id;  ///< row in the store
  const Plan& plan;
  Participant& observer;
};

/// Inputs of the sessions; must outlive the simulation.
struct SimulatedStudy {
  const SimulateSettings& settings;
  const Protocol& protocol;  ///< scaled as the settings say
  const SceneStages& stages;
  const Workers& workers;
  /// Makes the person of the session with `plan`, another one per seed. Called by several threads.
  std::function<std::unique_ptr<Participant>(std::uint32_t seed, int design_row, const Plan& plan)>
      make_observer;
  /// Makes the attempts of one session. Called by several threads.
  std::function<MakeAttempt(const Workers& workers)> make_attempts;
  /// In real time, in place of attempts: runs the session in the window.
  std::function<SessionOutcome(const BegunSession& session, const std::stop_token& stop)>
      run_in_window;
  std::vector<ShownScene> shown;
  std::string devices;  ///< see SimulationKind
};

/// Runs sessions. Full rendering runs one at a time, and each event is durable before its effects.
/// With several jobs, predicted sessions and those of a shard run concurrently, and each is written
/// as a whole when it is over, in the participants' order: a killed and resumed shard has the same
/// record as an uninterrupted one.
class StudySimulation {
 public:
  explicit StudySimulation(const SimulatedStudy& study);

  SimulateReport run(const std::stop_token& stop);

 private:
  /// A finished session, to be written.
  struct Simulated {
    SessionFacts facts;
    Plan plan;
    BufferedRecorder record;
    SessionOutcome outcome;
  };

  void run_durably(const std::vector<int>& design_rows, const std::stop_token& stop);
  void run_side_by_side(const std::vector<int>& design_rows, const std::stop_token& stop);

  /// Runs a session from its start, or from its interruption.
  void run_session(std::int64_t session, int design_row, const Plan& plan,
                   const std::stop_token& stop);
  Simulated simulate(int design_row, const std::stop_token& stop);
  SessionOutcome take_part(SessionRecorder& recorder, const SessionPosition& position,
                           int design_row, const Plan& plan, const Workers& workers,
                           const std::stop_token& stop);

  std::unique_ptr<Participant> make_observer(int design_row, const Plan& plan) const;
  SessionFacts facts_of(int design_row) const;
  /// Whether sessions are written as wholes.
  bool is_buffered() const {
    return study_.settings.predicted || study_.settings.jobs > 1 || study_.settings.shard;
  }
  void show(const std::string& scene);
  void add(const SessionOutcome& outcome);

  const SimulatedStudy& study_;
  MachineInfo machine_ = machine_info();
  double trials_in_session_;
  StudyStore store_;
  std::mutex progress_mutex_;  ///< guards the following members
  Progress progress_{"Simulating"};
  double trials_begun_ = 0.0;
  SimulateReport report_;
};

}  // namespace foveola::study
