// The participants of a simulated study, one after the other or side by side.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <vector>

#include "renderer/base/build_info.h"
#include "renderer/base/work/work_scope.h"
#include "study/participant/participant.h"
#include "study/record/buffered_recorder.h"
#include "study/record/study_store.h"
#include "study/simulation/simulate_study.h"
#include "study/simulation/virtual_session.h"

namespace foveola::study {

/// Whether the session is over: nothing more can happen in it.
bool has_ended(const KnownSession& session);

/// What a simulation has before it.
struct SessionsAhead {
  int over = 0;                     ///< sessions of its seed that are over, if it is resumed
  std::vector<KnownSession> begun;  ///< to be finished, if it is resumed
  /// The design rows of participants who are not in the file yet: a study can be added to.
  std::vector<int> new_rows;
};

/// By what is in the settings' database, which need not exist. Throws Error for a file that is no
/// study of the protocol.
SessionsAhead sessions_ahead(const SimulateSettings& settings, const Protocol& protocol);

/// A session that is to be taken part in, from its start or from where it broke off.
struct BegunSession {
  StudyStore& store;
  std::int64_t id;  ///< its row in the store
  const Plan& plan;
  Participant& observer;
};

/// What sessions are simulated with; it must outlive the simulation.
struct SimulatedStudy {
  const SimulateSettings& settings;
  const Protocol& protocol;  ///< scaled as the settings say
  const SceneStages& stages;
  const Workers& workers;
  /// Makes the person whose session `plan` is, another one for each seed. Called from several
  /// threads.
  std::function<std::unique_ptr<Participant>(std::uint32_t seed, int design_row, const Plan& plan)>
      make_observer;
  /// What makes the attempts of one session. Called from several threads.
  std::function<MakeAttempt(const Workers& workers)> make_attempts;
  /// In real time, instead of attempts: how a session goes on in the window.
  std::function<SessionOutcome(const BegunSession& session, const std::stop_token& stop)>
      run_in_window;
  std::vector<ShownScene> shown;
  std::string devices;  ///< see SimulationKind
};

/// Runs sessions of full rendering one after the other, each event on the disk before it has its
/// effects; with several jobs, predicted ones, and those of a shard, side by side, each session on
/// the disk whole when it is over, in the participants' order: so a shard that was killed and goes
/// on has the same record as one that was not.
class StudySimulation {
 public:
  explicit StudySimulation(const SimulatedStudy& study);

  SimulateReport run(const std::stop_token& stop);

 private:
  /// A session that is over, with what is to be written of it.
  struct Simulated {
    SessionFacts facts;
    Plan plan;
    BufferedRecorder record;
    SessionOutcome outcome;
  };

  void run_durably(const std::vector<int>& design_rows, const std::stop_token& stop);
  void run_side_by_side(const std::vector<int>& design_rows, const std::stop_token& stop);

  /// Runs a session from its start, or from where it broke off.
  void run_session(std::int64_t session, int design_row, const Plan& plan,
                   const std::stop_token& stop);
  Simulated simulate(int design_row, const std::stop_token& stop);
  SessionOutcome take_part(SessionRecorder& recorder, const SessionPosition& position,
                           int design_row, const Plan& plan, const Workers& workers,
                           const std::stop_token& stop);

  std::unique_ptr<Participant> make_observer(int design_row, const Plan& plan) const;
  SessionFacts facts_of(int design_row) const;
  /// Whether sessions reach the disk as whole ones.
  bool is_buffered() const {
    return study_.settings.predicted || study_.settings.jobs > 1 || study_.settings.shard;
  }
  void show(const std::string& scene);
  void add(const SessionOutcome& outcome);

  const SimulatedStudy& study_;
  MachineInfo machine_ = machine_info();
  double trials_in_session_;
  StudyStore store_;
  std::mutex progress_mutex_;  ///< guards what follows
  Progress progress_{"Simulating"};
  double trials_begun_ = 0.0;
  SimulateReport report_;
};

}  // namespace foveola::study
