-- The file of a study, schema version 3.
--
-- Times ending in _ns are nanoseconds of the session's own monotonic clock; utc is ISO 8601 in UTC
-- with milliseconds. Hashes are SHA-256 in lower-case hexadecimal. What was measured is only ever
-- added: triggers refuse to change or remove it.
--
-- Programs compare each CREATE statement with the one they know, to the letter. So comments stand
-- outside the statements, and whoever changes a statement raises user_version. A program reads and
-- writes only the version that it knows.
--
-- Version 2: study_method_file; session_scene.shown_as; frames-2, which tell a held gaze.
-- Version 3: study_profile; gaze_run, gaze_target and the state refused; gaze_chunk.

PRAGMA application_id = 1181709932; -- "Fovl"
PRAGMA user_version = 3;

-- What is studied: exactly one row. protocol_text is the researcher's file, to the letter.
CREATE TABLE study (
  id INTEGER PRIMARY KEY CHECK (id = 1),
  protocol_name TEXT NOT NULL,
  protocol_title TEXT NOT NULL,
  protocol_text TEXT NOT NULL,
  protocol_sha256 TEXT NOT NULL
    CHECK (length(protocol_sha256) = 64 AND protocol_sha256 NOT GLOB '*[^0-9a-f]*'),
  created_utc TEXT NOT NULL
) STRICT;

-- The protocol's scenes in its order; position 0 is the first.
CREATE TABLE study_scene (
  position INTEGER PRIMARY KEY CHECK (position >= 0),
  name TEXT NOT NULL UNIQUE
) STRICT;

-- The protocol's methods in its order; position 0 is the baseline.
CREATE TABLE study_method (
  position INTEGER PRIMARY KEY CHECK (position >= 0),
  name TEXT NOT NULL UNIQUE
) STRICT;

-- The files that a method reads, by the names that the method has for them, relative to the
-- protocol's folder.
CREATE TABLE study_method_file (
  method TEXT NOT NULL REFERENCES study_method (name),
  file_name TEXT NOT NULL,
  file_sha256 TEXT NOT NULL
    CHECK (length(file_sha256) = 64 AND file_sha256 NOT GLOB '*[^0-9a-f]*'),
  PRIMARY KEY (method, file_name)
) STRICT;

-- The profiles that the protocol names, to the letter; the session's display and tracker.
CREATE TABLE study_profile (
  device TEXT PRIMARY KEY CHECK (device IN ('display', 'tracker')),
  name TEXT NOT NULL,
  toml TEXT NOT NULL,
  toml_sha256 TEXT NOT NULL
    CHECK (length(toml_sha256) = 64 AND toml_sha256 NOT GLOB '*[^0-9a-f]*')
) STRICT;

-- One participant's visit, with all that is needed to repeat it. participant is a code, never a
-- name. seed is an unsigned 64-bit number in decimal digits, more than SQLite's integers hold.
-- state is the phase that the session is in, or ended in; nothing else of the row ever changes.
CREATE TABLE session (
  id INTEGER PRIMARY KEY,
  uuid TEXT NOT NULL UNIQUE CHECK (length(uuid) = 36),
  participant TEXT NOT NULL UNIQUE CHECK (participant <> ''),
  kind TEXT NOT NULL CHECK (kind IN ('human', 'pilot', 'simulated')),
  seed TEXT NOT NULL CHECK (seed <> '' AND seed NOT GLOB '*[^0-9]*'),
  started_utc TEXT NOT NULL,
  program_version TEXT NOT NULL,
  compiler TEXT NOT NULL,
  build_type TEXT NOT NULL,
  processor TEXT NOT NULL,
  cores INTEGER NOT NULL,
  operating_system TEXT NOT NULL,
  state TEXT NOT NULL CHECK (
    state IN ('created', 'validation', 'background', 'choosing_object', 'armed', 'outline',
              'material', 'rating', 'completed', 'interrupted', 'withdrawn', 'refused'))
) STRICT;

-- The file of each scene that this session really showed, and how: with file_sha256, the protocol
-- and the seed, shown_as is enough to make its pictures again. It is a JSON object:
--   camera          position (m, in the file's axes), azimuth_rad and elevation_rad of the heading
--   exposure_stops  of the display
--   objects         on offer: name, position (m), radius_deg seen from the camera
--   added           to the file: metres_per_unit, environment (null: the file's own; radiance;
--                   file_name and file_sha256; or sun, turbidity and ground_albedo of a sky),
--                   environment_rotation_rad, environment_strength, light_radius_m and
--                   sun_angular_radius_rad (null: the file's own), lights (rectangles: center, size,
--                   normal, radiance) and suns (azimuth_rad, elevation_rad, irradiance,
--                   angular_radius_rad)
CREATE TABLE session_scene (
  session INTEGER NOT NULL REFERENCES session (id),
  scene TEXT NOT NULL REFERENCES study_scene (name),
  file_name TEXT NOT NULL,
  file_sha256 TEXT NOT NULL
    CHECK (length(file_sha256) = 64 AND file_sha256 NOT GLOB '*[^0-9a-f]*'),
  shown_as TEXT NOT NULL CHECK (json_type(shown_as) = 'object'),
  PRIMARY KEY (session, scene)
) STRICT;

-- What the session set out to do, written before anything happened in it; trial 0 is the first.
CREATE TABLE planned_trial (
  session INTEGER NOT NULL REFERENCES session (id),
  trial INTEGER NOT NULL CHECK (trial >= 0),
  scene TEXT NOT NULL REFERENCES study_scene (name),
  method TEXT NOT NULL REFERENCES study_method (name),
  scene_position INTEGER NOT NULL CHECK (scene_position >= 0),
  method_position INTEGER NOT NULL CHECK (method_position >= 0),
  PRIMARY KEY (session, trial),
  UNIQUE (session, scene, method)
) STRICT;

-- Everything that happened, in order; sequence 1 is a session's first event. payload is a JSON
-- object with the event's values. The tables below follow from this log and the plan, but for what
-- was measured meanwhile: runs, frames and gaze samples.
CREATE TABLE event (
  session INTEGER NOT NULL REFERENCES session (id),
  sequence INTEGER NOT NULL CHECK (sequence >= 1),
  time_ns INTEGER NOT NULL,
  utc TEXT NOT NULL,
  type TEXT NOT NULL CHECK (
    type IN ('session_started', 'gaze_validated', 'background_answered', 'object_chosen',
             'first_frame_presented', 'outline_marked', 'material_marked', 'timed_out',
             'artifacts_rated', 'retime_requested', 'interrupted', 'withdrawn')),
  payload TEXT NOT NULL CHECK (json_type(payload) = 'object'),
  PRIMARY KEY (session, sequence)
) STRICT;

-- One look at all of a validation's targets, in the order of time; sequence is of the event that
-- tells of it. Runs of one event belong together: if the protocol asks for a correction, the first
-- calibrates and the second validates. Angles are true ones, in degrees:
--   accuracy       the mean of the samples' angles to their target, and of the targets
--   precision_rms  the root mean square of the angles between successive samples
--   precision_sd   the root mean square of the samples' angles to their mean direction
-- and null where nothing was seen. data_loss is the part of the samples that came invalid or not at
-- all. correction, what the gaze went through, is null if it was as the tracker gave it, else
-- {"azimuth": [a, b, c], "elevation": [d, e, f]}: the azimuth became a + b azimuth + c elevation,
-- and the elevation d + e azimuth + f elevation, in degrees. passed: the protocol's gate.
CREATE TABLE gaze_run (
  session INTEGER NOT NULL,
  run INTEGER NOT NULL CHECK (run >= 1),
  sequence INTEGER NOT NULL,
  accuracy_deg REAL,
  precision_rms_deg REAL,
  precision_sd_deg REAL,
  data_loss REAL NOT NULL CHECK (data_loss BETWEEN 0 AND 1),
  correction TEXT CHECK (json_type(correction) = 'object'),
  passed INTEGER NOT NULL CHECK (passed IN (0, 1)),
  PRIMARY KEY (session, run),
  FOREIGN KEY (session, sequence) REFERENCES event (session, sequence)
) STRICT;

-- Each target of a run, in the order in which they were shown; target 0 is the first. Directions
-- are in the head's axes, azimuths rightwards and elevations upwards from straight ahead. samples is
-- how many the figures, as above, are of; 0 if there were too few for any.
CREATE TABLE gaze_target (
  session INTEGER NOT NULL,
  run INTEGER NOT NULL,
  target INTEGER NOT NULL CHECK (target >= 0),
  azimuth_deg REAL NOT NULL,
  elevation_deg REAL NOT NULL,
  data_loss REAL NOT NULL CHECK (data_loss BETWEEN 0 AND 1),
  samples INTEGER NOT NULL CHECK (samples >= 0),
  mean_gaze_azimuth_deg REAL,
  mean_gaze_elevation_deg REAL,
  accuracy_deg REAL,
  precision_rms_deg REAL,
  precision_sd_deg REAL,
  PRIMARY KEY (session, run, target),
  FOREIGN KEY (session, run) REFERENCES gaze_run (session, run)
) STRICT;

-- Answers of the background questionnaire, by the question's id in the protocol.
CREATE TABLE background_answer (
  session INTEGER NOT NULL REFERENCES session (id),
  question TEXT NOT NULL,
  value INTEGER NOT NULL,
  PRIMARY KEY (session, question)
) STRICT;

-- One timing of a planned trial; attempt 1 is the first, and the last one counts. first_frame_ns is
-- when its first frame was presented. An outcome stays 'open' only if the program died in it.
CREATE TABLE attempt (
  session INTEGER NOT NULL,
  trial INTEGER NOT NULL,
  attempt INTEGER NOT NULL CHECK (attempt >= 1),
  object TEXT NOT NULL,
  first_frame_ns INTEGER,
  outcome TEXT NOT NULL DEFAULT 'open'
    CHECK (outcome IN ('open', 'rated', 'retimed', 'interrupted', 'withdrawn')),
  PRIMARY KEY (session, trial, attempt),
  FOREIGN KEY (session, trial) REFERENCES planned_trial (session, trial)
) STRICT;

-- When the participant saw the outline or the material well enough. time_ns counts from the
-- attempt's first presented frame. Censored: no mark came until then, so it is a lower bound.
CREATE TABLE mark (
  session INTEGER NOT NULL,
  trial INTEGER NOT NULL,
  attempt INTEGER NOT NULL,
  kind TEXT NOT NULL CHECK (kind IN ('outline', 'material')),
  time_ns INTEGER NOT NULL CHECK (time_ns >= 0),
  censored INTEGER NOT NULL CHECK (censored IN (0, 1)),
  PRIMARY KEY (session, trial, attempt, kind),
  FOREIGN KEY (session, trial, attempt) REFERENCES attempt (session, trial, attempt)
) STRICT;

-- How much the artifacts disturbed: 1 none ... 5 not discernible at all.
CREATE TABLE rating (
  session INTEGER NOT NULL,
  trial INTEGER NOT NULL,
  attempt INTEGER NOT NULL,
  artifacts INTEGER NOT NULL CHECK (artifacts BETWEEN 1 AND 5),
  PRIMARY KEY (session, trial, attempt),
  FOREIGN KEY (session, trial, attempt) REFERENCES attempt (session, trial, attempt)
) STRICT;

-- Consecutive rendered frames of an attempt; first_frame counts from the attempt's start.
--
-- Encoding 'frames-2' is frame_count records of 44 bytes without gaps, all little-endian:
--   offset  0  int64    time, session clock, ns
--   offset  8  float32  head azimuth, rad, from -Z towards +X
--   offset 12  float32  head elevation, rad
--   offset 16  float32  gaze direction x, world, as it was used
--   offset 20  float32  gaze direction y
--   offset 24  float32  gaze direction z
--   offset 28  int64    age of that gaze, ns
--   offset 36  uint32   samples traced for this frame
--   offset 40  uint32   flags: bit 0 is set if the tracker's newest gaze was valid, bit 1 if the
--                       gaze above was one that is held; the others are 0
CREATE TABLE frame_chunk (
  session INTEGER NOT NULL,
  trial INTEGER NOT NULL,
  attempt INTEGER NOT NULL,
  first_frame INTEGER NOT NULL CHECK (first_frame >= 0),
  frame_count INTEGER NOT NULL CHECK (frame_count >= 1),
  encoding TEXT NOT NULL CHECK (encoding = 'frames-2'),
  data BLOB NOT NULL CHECK (length(data) = 44 * frame_count),
  data_sha256 TEXT NOT NULL
    CHECK (length(data_sha256) = 64 AND data_sha256 NOT GLOB '*[^0-9a-f]*'),
  PRIMARY KEY (session, trial, attempt, first_frame),
  FOREIGN KEY (session, trial, attempt) REFERENCES attempt (session, trial, attempt)
) STRICT;

-- Consecutive gaze samples that arrived during an attempt, all of them, in the order of their
-- arrival; first_sample counts from the attempt's start. Where a session's gaze is corrected, so are
-- these.
--
-- Encoding 'gaze-1' is sample_count records of 24 bytes without gaps, all little-endian:
--   offset  0  int64    time when the eye was there, session clock, ns
--   offset  8  float32  gaze direction x, in the head's axes; straight ahead if it is not valid
--   offset 12  float32  gaze direction y
--   offset 16  float32  gaze direction z
--   offset 20  uint32   flags: bit 0 is set if the sample is valid; bits 1 and 2 are what the eye
--                       did meanwhile, by a velocity threshold: 0 unknown, 1 a fixation, 2 a
--                       saccade, 3 a blink; the others are 0
CREATE TABLE gaze_chunk (
  session INTEGER NOT NULL,
  trial INTEGER NOT NULL,
  attempt INTEGER NOT NULL,
  first_sample INTEGER NOT NULL CHECK (first_sample >= 0),
  sample_count INTEGER NOT NULL CHECK (sample_count >= 1),
  encoding TEXT NOT NULL CHECK (encoding = 'gaze-1'),
  data BLOB NOT NULL CHECK (length(data) = 24 * sample_count),
  data_sha256 TEXT NOT NULL
    CHECK (length(data_sha256) = 64 AND data_sha256 NOT GLOB '*[^0-9a-f]*'),
  PRIMARY KEY (session, trial, attempt, first_sample),
  FOREIGN KEY (session, trial, attempt) REFERENCES attempt (session, trial, attempt)
) STRICT;

-- One row per planned trial with its last attempt's values; attempts is 0 if it was never begun.
CREATE VIEW trial_result AS
SELECT
  session.participant,
  session.kind AS session_kind,
  session.state AS session_state,
  planned_trial.*,
  coalesce(last.attempt, 0) AS attempts,
  last.object,
  last.outcome,
  outline.time_ns / 1e9 AS outline_s,
  outline.censored AS outline_censored,
  material.time_ns / 1e9 AS material_s,
  material.censored AS material_censored,
  rating.artifacts
FROM planned_trial
JOIN session ON session.id = planned_trial.session
LEFT JOIN attempt AS last
  ON last.session = planned_trial.session AND last.trial = planned_trial.trial
  AND last.attempt = (
    SELECT max(attempt.attempt) FROM attempt
    WHERE attempt.session = planned_trial.session AND attempt.trial = planned_trial.trial)
LEFT JOIN mark AS outline
  ON outline.session = last.session AND outline.trial = last.trial
  AND outline.attempt = last.attempt AND outline.kind = 'outline'
LEFT JOIN mark AS material
  ON material.session = last.session AND material.trial = last.trial
  AND material.attempt = last.attempt AND material.kind = 'material'
LEFT JOIN rating
  ON rating.session = last.session AND rating.trial = last.trial
  AND rating.attempt = last.attempt;

-- Two tables change after their rows are made, in these ways only.
CREATE TRIGGER session_changes_state_only
BEFORE UPDATE OF id, uuid, participant, kind, seed, started_utc, program_version, compiler,
  build_type, processor, cores, operating_system ON session
BEGIN SELECT raise(ABORT, 'only a session''s state changes'); END;
CREATE TRIGGER session_ends_once BEFORE UPDATE ON session
WHEN OLD.state IN ('completed', 'interrupted', 'withdrawn', 'refused')
BEGIN SELECT raise(ABORT, 'the session is over'); END;
CREATE TRIGGER session_stays BEFORE DELETE ON session
BEGIN SELECT raise(ABORT, 'sessions are never removed'); END;

CREATE TRIGGER attempt_keeps_its_object
BEFORE UPDATE OF session, trial, attempt, object ON attempt
BEGIN SELECT raise(ABORT, 'only an attempt''s first frame and outcome change'); END;
CREATE TRIGGER attempt_starts_once BEFORE UPDATE OF first_frame_ns ON attempt
WHEN OLD.first_frame_ns IS NOT NULL
BEGIN SELECT raise(ABORT, 'the attempt has its first frame'); END;
CREATE TRIGGER attempt_ends_once BEFORE UPDATE ON attempt WHEN OLD.outcome <> 'open'
BEGIN SELECT raise(ABORT, 'the attempt is over'); END;
CREATE TRIGGER attempt_stays BEFORE DELETE ON attempt
BEGIN SELECT raise(ABORT, 'attempts are never removed'); END;

-- All others never do.
CREATE TRIGGER study_is_fixed BEFORE UPDATE ON study
BEGIN SELECT raise(ABORT, 'study is only added to'); END;
CREATE TRIGGER study_stays BEFORE DELETE ON study
BEGIN SELECT raise(ABORT, 'study is only added to'); END;
CREATE TRIGGER study_scene_is_fixed BEFORE UPDATE ON study_scene
BEGIN SELECT raise(ABORT, 'study_scene is only added to'); END;
CREATE TRIGGER study_scene_stays BEFORE DELETE ON study_scene
BEGIN SELECT raise(ABORT, 'study_scene is only added to'); END;
CREATE TRIGGER study_method_is_fixed BEFORE UPDATE ON study_method
BEGIN SELECT raise(ABORT, 'study_method is only added to'); END;
CREATE TRIGGER study_method_stays BEFORE DELETE ON study_method
BEGIN SELECT raise(ABORT, 'study_method is only added to'); END;
CREATE TRIGGER study_method_file_is_fixed BEFORE UPDATE ON study_method_file
BEGIN SELECT raise(ABORT, 'study_method_file is only added to'); END;
CREATE TRIGGER study_method_file_stays BEFORE DELETE ON study_method_file
BEGIN SELECT raise(ABORT, 'study_method_file is only added to'); END;
CREATE TRIGGER study_profile_is_fixed BEFORE UPDATE ON study_profile
BEGIN SELECT raise(ABORT, 'study_profile is only added to'); END;
CREATE TRIGGER study_profile_stays BEFORE DELETE ON study_profile
BEGIN SELECT raise(ABORT, 'study_profile is only added to'); END;
CREATE TRIGGER session_scene_is_fixed BEFORE UPDATE ON session_scene
BEGIN SELECT raise(ABORT, 'session_scene is only added to'); END;
CREATE TRIGGER session_scene_stays BEFORE DELETE ON session_scene
BEGIN SELECT raise(ABORT, 'session_scene is only added to'); END;
CREATE TRIGGER planned_trial_is_fixed BEFORE UPDATE ON planned_trial
BEGIN SELECT raise(ABORT, 'planned_trial is only added to'); END;
CREATE TRIGGER planned_trial_stays BEFORE DELETE ON planned_trial
BEGIN SELECT raise(ABORT, 'planned_trial is only added to'); END;
CREATE TRIGGER event_is_fixed BEFORE UPDATE ON event
BEGIN SELECT raise(ABORT, 'event is only added to'); END;
CREATE TRIGGER event_stays BEFORE DELETE ON event
BEGIN SELECT raise(ABORT, 'event is only added to'); END;
CREATE TRIGGER gaze_run_is_fixed BEFORE UPDATE ON gaze_run
BEGIN SELECT raise(ABORT, 'gaze_run is only added to'); END;
CREATE TRIGGER gaze_run_stays BEFORE DELETE ON gaze_run
BEGIN SELECT raise(ABORT, 'gaze_run is only added to'); END;
CREATE TRIGGER gaze_target_is_fixed BEFORE UPDATE ON gaze_target
BEGIN SELECT raise(ABORT, 'gaze_target is only added to'); END;
CREATE TRIGGER gaze_target_stays BEFORE DELETE ON gaze_target
BEGIN SELECT raise(ABORT, 'gaze_target is only added to'); END;
CREATE TRIGGER background_answer_is_fixed BEFORE UPDATE ON background_answer
BEGIN SELECT raise(ABORT, 'background_answer is only added to'); END;
CREATE TRIGGER background_answer_stays BEFORE DELETE ON background_answer
BEGIN SELECT raise(ABORT, 'background_answer is only added to'); END;
CREATE TRIGGER mark_is_fixed BEFORE UPDATE ON mark
BEGIN SELECT raise(ABORT, 'mark is only added to'); END;
CREATE TRIGGER mark_stays BEFORE DELETE ON mark
BEGIN SELECT raise(ABORT, 'mark is only added to'); END;
CREATE TRIGGER rating_is_fixed BEFORE UPDATE ON rating
BEGIN SELECT raise(ABORT, 'rating is only added to'); END;
CREATE TRIGGER rating_stays BEFORE DELETE ON rating
BEGIN SELECT raise(ABORT, 'rating is only added to'); END;
CREATE TRIGGER frame_chunk_is_fixed BEFORE UPDATE ON frame_chunk
BEGIN SELECT raise(ABORT, 'frame_chunk is only added to'); END;
CREATE TRIGGER frame_chunk_stays BEFORE DELETE ON frame_chunk
BEGIN SELECT raise(ABORT, 'frame_chunk is only added to'); END;
CREATE TRIGGER gaze_chunk_is_fixed BEFORE UPDATE ON gaze_chunk
BEGIN SELECT raise(ABORT, 'gaze_chunk is only added to'); END;
CREATE TRIGGER gaze_chunk_stays BEFORE DELETE ON gaze_chunk
BEGIN SELECT raise(ABORT, 'gaze_chunk is only added to'); END;
