#include "study/simulation/study_simulation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include <fmt/format.h>

#include "renderer/base/work/ordered_jobs.h"
#include "study/design/participant_code.h"
#include "study/record/write/recorders.h"

namespace foveola::study {

namespace {

int first_row(const SimulateSettings& settings) {
  return static_cast<int>(part_of(settings.shard.value_or(Shard{}), settings.participants).begin);
}

SessionsAhead ahead_of(const SimulateSettings& settings, const StudyStore& store) {
  SessionsAhead ahead;
  for (const KnownSession& session : store.sessions()) {
    if (!settings.resume || session.kind != SessionKind::simulated ||
        session.seed != settings.seed) {
      continue;  // a person's, or a finished one of another run
    }
    if (has_ended(session)) {
      ++ahead.over;
    } else {
      ahead.begun.push_back(session);
    }
  }
  const auto rows = settings.participants_in_file() - ahead.over - std::ssize(ahead.begun);
  for (int row = first_row(settings); std::ssize(ahead.new_rows) < rows; ++row) {
    if (!store.has_participant(participant_code(row))) {
      ahead.new_rows.push_back(row);
    }
  }
  return ahead;
}

}  // namespace

SessionsAhead sessions_ahead(const SimulateSettings& settings, const Protocol& protocol) {
  if (std::filesystem::exists(settings.database)) {
    return ahead_of(settings, StudyStore(settings.database, protocol));
  }
  SessionsAhead ahead;
  ahead.new_rows.resize(static_cast<std::size_t>(settings.participants_in_file()));
  std::iota(ahead.new_rows.begin(), ahead.new_rows.end(), first_row(settings));
  return ahead;
}

bool has_ended(const KnownSession& session) {
  return SessionState{.phase = session.phase}.is_over();
}

StudySimulation::StudySimulation(const SimulatedStudy& study)
    : study_(study),
      trials_in_session_(
          static_cast<double>(make_plan(study.protocol, study.settings.seed, 0).size())),
      store_(study.settings.database, study.protocol, OtherProtocol::refuse,
             study.settings.real_time ? RecordDates::wall_clock : RecordDates::virtual_time) {
  const SimulateSettings& settings = study.settings;
  store_.mark_as_part(settings.shard && settings.shard->count > 1
                          ? std::optional(ShardedStudy{.seed = std::to_string(settings.seed),
                                                       .participants = settings.participants})
                          : std::nullopt);
}

SimulateReport StudySimulation::run(const std::stop_token& stop) {
  const SteadyClock clock;
  const Nanoseconds start = clock.now();
  const SessionsAhead ahead = ahead_of(study_.settings, store_);
  report_.sessions_before = ahead.over;
  for (const KnownSession& session : ahead.begun) {
    if (!stop.stop_requested()) {
      run_session(session.id, session.design_row, store_.plan_of(session.id), stop);
    }
  }
  if (is_buffered()) {
    run_side_by_side(ahead.new_rows, stop);
  } else {
    run_durably(ahead.new_rows, stop);
  }
  report_.sessions_wall_s = seconds(clock.now() - start);
  return report_;
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
      return false;  // only complete sessions, without gaps
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
    const std::unique_ptr<Participant> observer = make_observer(design_row, plan);
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
  const std::unique_ptr<Participant> observer = make_observer(design_row, plan);
  const SessionSetting setting{.protocol = study_.protocol,
                               .stages = study_.stages,
                               .recorder = recorder,
                               .make_attempt = study_.make_attempts(workers),
                               .seed = seed,
                               .on_trial = [&](std::size_t trial) { show(plan[trial].scene); },
                               .stop = stop};
  return VirtualSession(setting, plan, *observer, position).run();
}

std::unique_ptr<Participant> StudySimulation::make_observer(int design_row,
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
  const double all = study_.settings.participants_in_file();
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
