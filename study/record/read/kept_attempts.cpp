#include "study/record/read/kept_attempts.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>

#include "renderer/base/error.h"
#include "study/protocol/protocol.h"
#include "study/record/setup/session_devices.h"
#include "study/record/sqlite/stored_number.h"

namespace foveola::study {
namespace {

/// The view of the protocol's [display], which simulated participants see; empty if the protocol is
/// one that this program cannot read.
std::optional<FieldOfView> protocols_view(SQLite::Database& database) {
  SQLite::Statement row(database,
                        "SELECT protocol_text, coalesce((SELECT toml FROM study_profile"
                        "  WHERE device = 'display'), '') FROM study");
  if (!row.executeStep()) {
    return std::nullopt;
  }
  try {
    const DisplaySettings display = read_recorded_display(
        row.getColumn(0).getString(), "the study's protocol", row.getColumn(1).getString());
    return FieldOfView{.horizontal_deg = display.horizontal_fov_deg,
                       .vertical_deg = display.vertical_fov_deg,
                       .lens = display.lens};
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace

std::vector<FrameRow> KeptAttempt::decoded_frames() const {
  try {
    return frames_in(frames);
  } catch (const std::invalid_argument&) {
    throw changed_frames(session, trial, attempt);
  }
}

std::vector<GazeSample> KeptAttempt::decoded_gaze() const {
  try {
    return gaze_in(gaze);
  } catch (const std::invalid_argument&) {
    throw changed_record(session, trial, attempt, "gaze samples");
  }
}

KeptAttempts::KeptAttempts(SQLite::Database& database)
    : attempts_(database,
                "SELECT attempt.session, session.participant, attempt.trial, attempt.attempt,"
                "  planned_trial.kind = 'test' AND attempt.attempt = max(attempt.attempt)"
                "   OVER (PARTITION BY attempt.session, attempt.trial) AS counts,"
                "  attempt.first_frame_ns, attempt.object, planned_trial.scene"
                " FROM attempt JOIN session ON session.id = attempt.session"
                " JOIN planned_trial USING (session, trial)"
                " WHERE state <> 'withdrawn' AND EXISTS (SELECT 1 FROM frame_chunk AS chunk"
                "   WHERE chunk.session = attempt.session AND chunk.trial = attempt.trial"
                "   AND chunk.attempt = attempt.attempt)"
                " ORDER BY attempt.session, attempt.trial, attempt.attempt"),
      sessions_(database, "SELECT devices, kind = 'simulated' FROM session WHERE id = ?"),
      notes_(database, "SELECT time_ns, text FROM note WHERE session = ? ORDER BY sequence"),
      scenes_(database, "SELECT shown_as FROM session_scene WHERE session = ? AND scene = ?"),
      frames_(database, "frame_chunk"),
      gaze_(database, "gaze_chunk"),
      marks_(query_of_marks(database)),
      simulated_view_(protocols_view(database)) {}

std::optional<KeptAttempt> KeptAttempts::next() {
  if (attempts_.isDone() || !attempts_.executeStep()) {
    return std::nullopt;
  }
  KeptAttempt kept{.session = attempts_.getColumn("session").getInt64(),
                   .participant = attempts_.getColumn("participant").getString(),
                   .trial = whole_number<std::size_t>(attempts_.getColumn("trial")),
                   .attempt = whole_number<int>(attempts_.getColumn("attempt")),
                   .counts = attempts_.getColumn("counts").getInt() == 1,
                   .object = attempts_.getColumn("object").getString()};
  const Nanoseconds first_frame = time_from(attempts_.getColumn("first_frame_ns"));
  follow_session(kept.session);
  const auto first_later_devices =
      std::find_if(devices_.begin() + 1, devices_.end(),
                   [&](const Devices& devices) { return devices.since > first_frame; });
  kept.view = std::prev(first_later_devices)->view;
  kept.tracker = std::prev(first_later_devices)->tracker;
  scenes_.reset();
  SQLite::bind(scenes_, kept.session, attempts_.getColumn("scene").getString());
  if (scenes_.executeStep()) {
    kept.shown_as = scenes_.getColumn(0).getString();
  }
  kept.frames = frames_.read(kept.session, kept.trial, kept.attempt);
  kept.gaze = gaze_.read(kept.session, kept.trial, kept.attempt);
  kept.marks = read_marks(marks_, kept.session, kept.trial, kept.attempt, first_frame);
  return kept;
}

KeptAttempts::Devices KeptAttempts::devices_of(const std::string& devices, Nanoseconds since,
                                               bool is_simulated) const {
  Devices known{.since = since, .view = field_of_view_in(devices), .tracker = tracker_in(devices)};
  if (is_simulated && !known.view) {
    known.view = simulated_view_;
  }
  if (is_simulated && known.tracker.empty()) {
    known.tracker = "simulated";
  }
  return known;
}

void KeptAttempts::follow_session(std::int64_t session) {
  if (session_ == session) {
    return;
  }
  session_ = session;
  sessions_.reset();
  sessions_.bind(1, session);
  sessions_.executeStep();
  const bool is_simulated = sessions_.getColumn(1).getInt() == 1;
  devices_ = {devices_of(sessions_.getColumn(0).getString(), Nanoseconds(0), is_simulated)};
  notes_.reset();
  notes_.bind(1, session);
  while (notes_.executeStep()) {
    if (const std::optional<std::string> devices =
            devices_in_note(notes_.getColumn(1).getString())) {
      devices_.push_back(devices_of(*devices, time_from(notes_.getColumn(0)), is_simulated));
    }
  }
}

}  // namespace foveola::study
