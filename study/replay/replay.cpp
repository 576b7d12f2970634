#include "study/replay/replay.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/work/work_scope.h"
#include "study/record/read/recorded_session.h"
#include "study/record/setup/same_scenes.h"
#include "study/record/setup/session_programs.h"
#include "study/replay/attempt_replay.h"
#include "study/replay/driven_replay.h"
#include "study/stage/scene_stage.h"
#include "study/stage/seeds.h"
#include "study/stage/trial_preview.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

std::vector<RecordedAttempt> chosen_attempts(const RecordedSession& session,
                                             const ReplaySettings& settings) {
  std::vector<RecordedAttempt> chosen = session.attempts;
  std::erase_if(chosen, [&](const RecordedAttempt& attempt) {
    return (settings.trial && attempt.trial != *settings.trial) ||
           (settings.attempt && attempt.attempt != *settings.attempt);
  });
  if (chosen.empty()) {
    throw Error(settings.database.string(),
                fmt::format("participant {} has no such attempt", settings.participant),
                "remove --trial and --attempt to see all attempts; the first trial is 0");
  }
  return chosen;
}

/// Returns the protocol as it was shown: a simulated session may have been scaled, or of another
/// machine.
Protocol shown_protocol(const ReplaySettings& settings, const RecordedSession& session) {
  if (session.simulation && session.simulation->predicted) {
    throw Error(settings.database.string(),
                fmt::format("the session of participant {} was predicted, not rendered",
                            settings.participant),
                "replay a session that was simulated without --predicted");
  }
  Protocol protocol = read_recorded_protocol(settings.database, settings.folder);
  return session.simulation ? simulated_protocol(std::move(protocol), *session.simulation)
                            : protocol;
}

bool has_same_pictures(const RecordedSession& session) {
  return std::ranges::all_of(session.programs, is_of_this_version);
}

std::string why_approximate(const RecordedSession& session, const Protocol& protocol) {
  const std::string now = program_name(build_info());
  if (!has_same_pictures(session)) {
    return fmt::format("its pictures are of {}, but this is {}: no film is compared",
                       programs_in_words(session.programs), now);
  }
  if (session.programs != std::vector{now}) {
    return fmt::format("it was shown by {}, but this is {}", programs_in_words(session.programs),
                       now);
  }
  if (const std::string processor = machine_info().processor; session.processor != processor) {
    return fmt::format("it was shown on {}, but this is {}", session.processor, processor);
  }
  const bool is_adaptive = std::ranges::any_of(session.plan, [&](const PlannedTrial& trial) {
    return settings_of(protocol, trial.scene, trial.method).film.adaptive_contrast > 0.0;
  });
  if (is_adaptive && session.known.kind != SessionKind::simulated) {
    return "adaptive sampling depended on samples within a frame, which the record does not "
           "keep";
  }
  return {};
}

class Replay {
 public:
  Replay(const ReplaySettings& settings, const SceneFinderBeside& find_scene)
      : settings_(settings),
        find_scene_(find_scene),
        session_(read_session(settings.database, settings.participant)),
        protocol_(shown_protocol(settings, session_)),
        workers_(settings.threads) {}

  ReplayReport run(const std::stop_token& stop) {
    ReplayReport report{.approximate = why_approximate(session_, protocol_)};
    chosen_ = chosen_attempts(session_, settings_);
    Progress progress("Replaying");
    const auto add = [&](const ReplayedAttempt& attempt) {
      report.attempts.push_back(attempt);
      progress.update(static_cast<double>(report.attempts.size()) /
                      static_cast<double>(chosen_.size()));
    };
    report.difference = replay_events(
        {.session = session_,
         .protocol = protocol_,
         .amended = [&](const Amendment& amendment) { return amended_protocol(amendment); },
         .begin_attempt = [&](const RecordedAttempt& attempt) -> std::unique_ptr<AttemptPort> {
           return is_chosen(attempt) ? begin(attempt, add) : nullptr;
         }},
        stop);
    return report;
  }

 private:
  bool is_chosen(const RecordedAttempt& attempt) const {
    return std::ranges::find(chosen_, attempt) != chosen_.end();
  }

  std::unique_ptr<AttemptPort> begin(const RecordedAttempt& attempt,
                                     std::function<void(const ReplayedAttempt&)> report) {
    const PlannedTrial& trial = session_.plan.at(attempt.trial);
    RecordedFrames recorded = read_frames(settings_.database, session_.known, attempt);
    if (!has_same_pictures(session_)) {
      recorded.hashes.clear();
    }
    const SceneStage& stage = stage_of(trial.scene);
    return std::make_unique<AttemptReplay>(AttemptReplaySetting{
        .stage = stage,
        .workers = workers_,
        .preview = preview_settings(trial, stage),
        .sampler = make_sampler(protocol_, trial.method),
        .seed = rendering_seed(session_.known.seed, session_.known.design_row, protocol_, trial,
                               attempt.timing),
        .recorded = std::move(recorded),
        .attempt = {.trial = attempt.trial, .attempt = attempt.attempt, .planned = trial},
        .picture = picture_of(attempt),
        .report = std::move(report)});
  }

  /// Returns the amended protocol, of the same design: only durations and texts may differ.
  Protocol amended_protocol(const Amendment& amendment) const {
    return read_protocol(amendment.text, settings_.folder / (protocol_.name + ".toml"));
  }

  PreviewSettings preview_settings(const PlannedTrial& trial, const SceneStage& stage) const {
    PreviewSettings preview =
        trial_preview_settings(protocol_, settings_of(protocol_, trial.scene, trial.method), stage);
    if (session_.view) {
      preview.field_of_view = *session_.view;
    }
    return preview;
  }

  fs::path picture_of(const RecordedAttempt& attempt) const {
    return settings_.pictures.empty()
               ? fs::path()
               : settings_.pictures / fmt::format("{}-trial-{:02}-attempt-{}.png",
                                                  settings_.participant, attempt.trial,
                                                  attempt.attempt);
  }

  const SceneStage& stage_of(const std::string& scene) {
    if (!stages_.contains(scene)) {
      SceneStages loaded;
      loaded[scene] = std::make_unique<SceneStage>(find_scene_(scene, settings_.folder), workers_);
      require_same_scenes(settings_.database, shown_scenes(loaded));
      stages_.merge(loaded);
    }
    return *stages_.at(scene);
  }

  const ReplaySettings& settings_;
  const SceneFinderBeside& find_scene_;
  RecordedSession session_;
  Protocol protocol_;
  Workers workers_;
  SceneStages stages_;
  std::vector<RecordedAttempt> chosen_;
};

}  // namespace

ReplayReport replay_session(const ReplaySettings& settings, const SceneFinderBeside& find_scene,
                            const std::stop_token& stop) {
  return Replay(settings, find_scene).run(stop);
}

}  // namespace foveola::study
