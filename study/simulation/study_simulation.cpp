#include "study/simulation/study_simulation.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "renderer/base/ordered_jobs.h"
#include "study/design/participant_code.h"
#include "study/record/store_recorder.h"

namespace foveola::study {

bool has_ended(const KnownSession& session) {
  return SessionState{.phase = session.phase}.is_over();
}

StudySimulation::StudySimulation(const SimulatedStudy& study)
    : study_(study),
      trials_in_session_(
          static_cast<double>(make_plan(study.protocol, study.settings.seed, 0).size())),
      store_(study.settings.database, study.protocol) {}

SimulateReport StudySimulation::run(const std::stop_token& stop) {
  const SteadyClock clock;
  const Nanoseconds start = clock.now();
  const int before = study_.settings.resume ? finish_begun_sessions(stop) : 0;
  const std::vector<int> design_rows =
      new_design_rows(std::max(0, study_.settings.participants - before));
  if (is_buffered()) {
    run_side_by_side(design_rows, stop);
  } else {
    run_durably(design_rows, stop);
  }
  report_.sessions_wall_s = seconds(clock.now() - start);
  return report_;
}

int StudySimulation::finish_begun_sessions(const std::stop_token& stop) {
  int done = 0;
  for (const KnownSession& session : store_.sessions()) {
    if (session.kind != SessionKind::simulated || session.seed != study_.settings.seed) {
      continue;  // a person's, or of another run, and over
    }
    if (has_ended(session)) {
      ++report_.sessions_before;
    } else if (!stop.stop_requested()) {
      run_session(session.id, session.design_row, store_.plan_of(session.id), stop);
    }
    ++done;
  }
  return done;
}

std::vector<int> StudySimulation::new_design_rows(int count) const {
  std::vector<int> rows;
  for (int row = 0; std::ssize(rows) < count; ++row) {
    if (!store_.has_participant(participant_code(row))) {
      rows.push_back(row);
    }
  }
  return rows;
}

void StudySimulation::run_durably(const std::vector<int>& design_rows,
                                  const std::stop_token& stop) {
  for (const int row : design_rows) {
    if (stop.stop_requested()) {
      return;
    }
    const Plan plan = make_plan(study_.protocol, study_.settings.seed, row);
    run_session(store_.begin_session(facts_of(row), plan), row, plan, stop);
  }
}

void StudySimulation::run_side_by_side(const std::vector<int>& design_rows,
                                       const std::stop_token& stop) {
  constexpr std::size_t ahead_per_job = 2;
  const auto jobs = static_cast<std::size_t>(study_.settings.jobs);
  OrderedJobs<Simulated> sessions(design_rows.size(), ahead_per_job * jobs, [&](std::size_t index) {
    return simulate(design_rows[index], stop);
  });
  sessions.run(study_.settings.jobs, [&](std::size_t /*index*/, const Simulated& session) {
    if (session.outcome.phase == Phase::interrupted) {
      return false;  // only whole sessions, and none before one that is missing
    }
    session.record.write(store_, session.facts, session.plan);
    add(session.outcome);
    return true;
  });
}

void StudySimulation::run_session(std::int64_t session, int design_row, const Plan& plan,
                                  const std::stop_token& stop) {
  if (study_.run_in_window) {
    show(plan.front().scene);
    const std::unique_ptr<SimulatedObserver> observer = make_observer(design_row, plan);
    add(study_.run_in_window({.store = store_, .id = session, .plan = plan, .observer = *observer},
                             stop));
    return;
  }
  const SessionPosition position =
      position_after(procedure_of(study_.protocol, plan), store_.events_of(session),
                     "participant " + participant_code(design_row));
  StoreRecorder recorder(store_, session);
  add(take_part(recorder, position, design_row, plan, study_.workers, stop));
}

StudySimulation::Simulated StudySimulation::simulate(int design_row, const std::stop_token& stop) {
  Simulated session{.facts = facts_of(design_row),
                    .plan = make_plan(study_.protocol, study_.settings.seed, design_row),
                    .record = {},
                    .outcome = {}};
  const Workers workers(std::max(1, study_.workers.threads() / study_.settings.jobs));
  session.outcome = take_part(session.record, {}, design_row, session.plan, workers, stop);
  return session;
}

SessionOutcome StudySimulation::take_part(SessionRecorder& recorder,
                                          const SessionPosition& position, int design_row,
                                          const Plan& plan, const Workers& workers,
                                          const std::stop_token& stop) {
  const SessionSeed seed{.seed = study_.settings.seed, .design_row = design_row};
  const std::unique_ptr<SimulatedObserver> observer = make_observer(design_row, plan);
  const SessionSetting setting{.protocol = study_.protocol,
                               .stages = study_.stages,
                               .recorder = recorder,
                               .make_attempt = study_.make_attempts(*observer, workers),
                               .seed = seed,
                               .on_trial = [&](std::size_t trial) { show(plan[trial].scene); },
                               .stop = stop};
  return VirtualSession(setting, plan, *observer, position).run();
}

std::unique_ptr<SimulatedObserver> StudySimulation::make_observer(int design_row,
                                                                  const Plan& plan) const {
  const SessionSeed seed{.seed = study_.settings.seed, .design_row = design_row};
  return study_.make_observer(derive_seed(seed, SeedPurpose::participant, {}), design_row, plan);
}

SessionFacts StudySimulation::facts_of(int design_row) const {
  return {.participant = participant_code(design_row),
          .kind = SessionKind::simulated,
          .seed = study_.settings.seed,
          .design_row = design_row,
          .build = build_info(),
          .machine = machine_,
          .devices = study_.devices,
          .scenes = study_.shown};
}

void StudySimulation::show(const std::string& scene) {
  const std::lock_guard hold(progress_mutex_);
  const double sessions = report_.sessions_before + trials_begun_ / trials_in_session_;
  const double all = study_.settings.participants;
  trials_begun_ += 1.0;
  progress_.update(std::min(1.0, sessions / all),
                   fmt::format("participant {:.0f} of {:.0f}, {}",
                               std::min(std::floor(sessions) + 1.0, all), all, scene));
}

void StudySimulation::add(const SessionOutcome& outcome) {
  report_.sessions_completed += outcome.phase == Phase::completed ? 1 : 0;
  report_.sessions_refused += outcome.phase == Phase::refused ? 1 : 0;
  report_.sessions_withdrawn += outcome.phase == Phase::withdrawn ? 1 : 0;
  report_.trials += static_cast<int>(outcome.trials);
  report_.simulated_s += seconds(outcome.duration);
  report_.samples += outcome.samples;
  report_.non_finite += outcome.non_finite;
}

}  // namespace foveola::study
