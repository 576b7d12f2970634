#include "study/replay/replay.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/progress.h"
#include "renderer/film/film_hash.h"
#include "renderer/film/viewport_image.h"
#include "renderer/image/image_file.h"
#include "study/protocol/scaled_protocol.h"
#include "study/record/recorded_session.h"
#include "study/record/same_scenes.h"
#include "study/stage/scene_stage.h"
#include "study/stage/seeds.h"
#include "study/stage/trial_preview.h"

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
                fmt::format("participant {} made no such attempt", settings.participant),
                "leave --trial and --attempt out to see them all; the first trial is 0");
  }
  return chosen;
}

/// As it was shown: a simulated session may have been scaled.
Protocol shown_protocol(const ReplaySettings& settings, const RecordedSession& session) {
  if (session.simulation && session.simulation->predicted) {
    throw Error(settings.database.string(),
                fmt::format("the session of participant {} was predicted, not rendered",
                            settings.participant),
                "replay one that was simulated without --predicted");
  }
  const double scale = session.simulation ? session.simulation->scale : 1.0;
  return scaled_protocol(read_recorded_protocol(settings.database, settings.folder), scale);
}

std::string why_approximate(const RecordedSession& session, const Protocol& protocol) {
  const BuildInfo now = build_info();
  const BuildInfo& then = session.build;
  if (then.version != now.version || then.compiler != now.compiler ||
      then.build_type != now.build_type) {
    return fmt::format("it was shown by Foveola {} ({}, {}), and this is {} ({}, {})", then.version,
                       then.compiler, then.build_type, now.version, now.compiler, now.build_type);
  }
  if (const std::string processor = machine_info().processor; session.processor != processor) {
    return fmt::format("it was shown on {}, and this is {}", session.processor, processor);
  }
  const bool is_adaptive =
      std::any_of(session.plan.begin(), session.plan.end(), [&](const PlannedTrial& trial) {
        return settings_of(protocol, trial.scene, trial.method).film.adaptive_contrast > 0.0;
      });
  if (is_adaptive && session.known.kind != SessionKind::simulated) {
    return "adaptive sampling followed what had come within a frame, which the record does not "
           "keep";
  }
  return {};
}

/// Replays the attempts of one session.
class Replay {
 public:
  Replay(const ReplaySettings& settings, const SceneFinder& find_scene)
      : settings_(settings),
        find_scene_(find_scene),
        session_(read_session(settings.database, settings.participant)),
        protocol_(shown_protocol(settings, session_)),
        workers_(settings.threads) {}

  ReplayReport run(const std::stop_token& stop) {
    ReplayReport report{.approximate = why_approximate(session_, protocol_)};
    const std::vector<RecordedAttempt> attempts = chosen_attempts(session_, settings_);
    Progress progress("Replaying");
    for (const RecordedAttempt& attempt : attempts) {
      if (stop.stop_requested()) {
        break;
      }
      report.attempts.push_back(show(attempt));
      progress.update(static_cast<double>(report.attempts.size()) /
                      static_cast<double>(attempts.size()));
    }
    return report;
  }

 private:
  ReplayedAttempt show(const RecordedAttempt& attempt) {
    const PlannedTrial& trial = session_.plan.at(attempt.trial);
    const RecordedFrames recorded = read_frames(settings_.database, session_.known, attempt);
    ReplayedAttempt replayed{.trial = attempt.trial,
                             .attempt = attempt.attempt,
                             .planned = trial,
                             .frames = recorded.frames.size()};
    const SceneStage& stage = stage_of(trial.scene);
    // Nobody watches: where head and eye were is in the frames.
    FixedEyeTracker eye(Vec3(0.0F, 0.0F, -1.0F));
    SimulatedHeadTracker head([](Nanoseconds) { return AzimuthElevation{}; });
    Preview preview(stage.tracer(), preview_settings(trial, stage), eye, head, workers_);
    preview.restart(make_sampler(protocol_, trial.method),
                    rendering_seed(session_.known.seed, session_.known.design_row, protocol_, trial,
                                   attempt.timing));
    auto hash = recorded.hashes.begin();
    for (std::uint64_t frame = 0; frame < recorded.frames.size(); ++frame) {
      render(recorded.frames[frame], preview);
      if (hash != recorded.hashes.end() && hash->frame == frame) {
        ++replayed.hashes;
        if (!replayed.first_difference && film_sha256(preview.film()) != hash->sha256) {
          replayed.first_difference = frame;
        }
        ++hash;
      }
    }
    replayed.samples = preview.film().total_samples();
    write_picture(attempt, preview);
    return replayed;
  }

  static void render(const FrameRow& frame, Preview& preview) {
    FrameReport report = preview.begin_frame(
        frame.time,
        {.azimuth_rad = frame.head_azimuth_rad, .elevation_rad = frame.head_elevation_rad},
        frame.gaze);
    preview.trace(frame.samples, report);
  }

  PreviewSettings preview_settings(const PlannedTrial& trial, const SceneStage& stage) const {
    PreviewSettings preview =
        trial_preview_settings(protocol_, settings_of(protocol_, trial.scene, trial.method), stage);
    if (session_.display) {
      preview.field_of_view = {.horizontal_deg = session_.display->horizontal_fov_deg,
                               .vertical_deg = session_.display->vertical_fov_deg,
                               .lens = session_.display->lens};
    }
    return preview;
  }

  void write_picture(const RecordedAttempt& attempt, const Preview& preview) const {
    if (settings_.pictures.empty()) {
      return;
    }
    const PreviewSettings& shown = preview.settings();
    write_image(
        settings_.pictures / fmt::format("{}-trial-{:02}-attempt-{}.png", settings_.participant,
                                         attempt.trial, attempt.attempt),
        viewport_image(preview.film(), preview.viewport(), shown.view_size.x, shown.view_size.y,
                       shown.unsampled, workers_),
        shown.exposure_stops);
  }

  /// Loaded when it is first needed.
  const SceneStage& stage_of(const std::string& scene) {
    if (!stages_.contains(scene)) {
      SceneStages loaded;
      loaded[scene] = std::make_unique<SceneStage>(find_scene_(scene), workers_);
      require_same_scenes(settings_.database, shown_scenes(loaded));
      stages_.merge(loaded);
    }
    return *stages_.at(scene);
  }

  const ReplaySettings& settings_;
  const SceneFinder& find_scene_;
  RecordedSession session_;
  Protocol protocol_;
  Workers workers_;
  SceneStages stages_;
};

}  // namespace

ReplayReport replay_session(const ReplaySettings& settings, const SceneFinder& find_scene,
                            const std::stop_token& stop) {
  return Replay(settings, find_scene).run(stop);
}

}  // namespace foveola::study
