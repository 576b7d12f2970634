-- The file of a study, schema versions 5 and 4. A line that ends with --5 or --4 is of that version
-- only, and stands in the file without this mark.
--
-- Times ending in _ns are nanoseconds of the session's own monotonic clock; utc is ISO 8601 in UTC
-- with milliseconds, in virtual time, which simulated sessions have, by a clock with which the study
-- and each of its sessions begin in 1970. Hashes are SHA-256 in lower-case hexadecimal. Positions are places in an order
-- of the protocol's. What was measured is only ever added: triggers refuse to change or remove it.
--
-- Programs compare each CREATE statement with the one they know, to the letter. So comments stand
-- outside the statements, and whoever changes a statement raises user_version. Files of version 4 are
-- read, verified, analysed and merged with one another; sessions are recorded in version 5 only. No
-- released program wrote an older one than 4.
--
-- Version 2: study_method_file; session_scene.shown_as; frames-2, which report a held gaze.
-- Version 3: study_profile; gaze_run, gaze_target and the state refused; gaze_chunk.
-- Version 4: marks, ratings and questionnaires as the protocol names them; practice and catch
--            trials; planned_step, design_row, devices, migrated_from; reactions, notes, pauses,
--            exclusions; the hash chain; film_hash; compressed chunks, and frames-3.
-- Version 5: what follows from the log is in views; each event's trial and attempt, and what was
--            measured in an attempt that it ended, in the hash chain; the session in the hashes of
--            chunks and films; study_created_utc; forgotten; ends that are undone, the text of a
--            consent, and consent that is asked for anew; response times of answers, and how long
--            was looked around; the sites of merged sessions.

PRAGMA application_id = 1181709932; -- "Fovl"
PRAGMA user_version = 4; --4
PRAGMA user_version = 5; --5

-- protocol_text is the researcher's file, to the letter.
CREATE TABLE study (
  id INTEGER PRIMARY KEY CHECK (id = 1),
  protocol_name TEXT NOT NULL,
  protocol_title TEXT NOT NULL,
  protocol_text TEXT NOT NULL,
  protocol_sha256 TEXT NOT NULL
    CHECK (length(protocol_sha256) = 64 AND protocol_sha256 NOT GLOB '*[^0-9a-f]*'),
  created_utc TEXT NOT NULL
) STRICT;

CREATE TABLE study_scene (
  position INTEGER PRIMARY KEY CHECK (position >= 0),
  name TEXT NOT NULL UNIQUE
) STRICT;

-- Position 0 is the baseline.
CREATE TABLE study_method (
  position INTEGER PRIMARY KEY CHECK (position >= 0),
  name TEXT NOT NULL UNIQUE
) STRICT;

-- The files that a method reads, by its names for them, relative to the protocol's folder.
CREATE TABLE study_method_file (
  method TEXT NOT NULL REFERENCES study_method (name),
  file_name TEXT NOT NULL,
  file_sha256 TEXT NOT NULL
    CHECK (length(file_sha256) = 64 AND file_sha256 NOT GLOB '*[^0-9a-f]*'),
  PRIMARY KEY (method, file_name)
) STRICT;

-- The files that the protocol names, to the letter: the profiles of the session's display and
-- tracker, and ready questionnaires.
CREATE TABLE study_profile (
  device TEXT NOT NULL CHECK (device IN ('display', 'tracker', 'questionnaire')),
  name TEXT NOT NULL,
  toml TEXT NOT NULL,
  toml_sha256 TEXT NOT NULL
    CHECK (length(toml_sha256) = 64 AND toml_sha256 NOT GLOB '*[^0-9a-f]*'),
  PRIMARY KEY (device, name)
) STRICT;

-- What participants mark in each trial, in this order.
CREATE TABLE study_mark (
  position INTEGER PRIMARY KEY CHECK (position >= 0),
  mark TEXT NOT NULL UNIQUE
) STRICT;

-- What they are asked after the marks. question is a JSON object: text, kind (likert, number,
-- choice, text), minimum, maximum, labels, options (label, value), required.
CREATE TABLE study_rating (
  position INTEGER PRIMARY KEY CHECK (position >= 0),
  rating TEXT NOT NULL UNIQUE,
  question TEXT NOT NULL CHECK (json_type(question) = 'object')
) STRICT;

-- One participant's visit, with all that is needed to repeat it. participant is a code, never a
-- name. seed is an unsigned 64-bit number, more than SQLite's integers hold. design_row is that of
-- the protocol's design which the plan was made of. program_version, compiler and build_type are of
-- the program that began the session: another that goes on with it says so in a note. devices is
-- what the display, the eye tracker and the machine turned out to be, of a simulated session how it was
-- simulated, and what traced the rays by which instructions. migrated_from is the schema that the session was recorded in,
-- if it was another; such a session has no design_row. study_created_utc is created_utc of the study
-- that the session was begun in; the study's own is the earliest of its sessions'. state is the phase
-- that the session is in, or ended in. site is that which study merge was told; participant then begins
-- with it and a hyphen, which the code that the hash chain covers does not.
CREATE TABLE session (
  id INTEGER PRIMARY KEY,
  uuid TEXT NOT NULL UNIQUE CHECK (length(uuid) = 36),
  participant TEXT NOT NULL UNIQUE CHECK (participant <> ''),
  kind TEXT NOT NULL CHECK (kind IN ('human', 'pilot', 'simulated')),
  seed TEXT NOT NULL CHECK (seed <> '' AND seed NOT GLOB '*[^0-9]*'),
  design_row INTEGER CHECK (design_row >= 0),
  started_utc TEXT NOT NULL,
  program_version TEXT NOT NULL,
  compiler TEXT NOT NULL,
  build_type TEXT NOT NULL,
  processor TEXT NOT NULL,
  cores INTEGER NOT NULL,
  operating_system TEXT NOT NULL,
  devices TEXT NOT NULL CHECK (json_type(devices) = 'object'),
  migrated_from INTEGER CHECK (migrated_from < 4),
  study_created_utc TEXT NOT NULL, --5
  state TEXT NOT NULL CHECK (
    state IN ('created', 'consent', 'questionnaire', 'validation', 'reaction', 'choosing_object',
              'ready', 'armed', 'marking', 'rating', 'paused', 'interrupted', 'completed',
              'withdrawn', 'excluded', 'refused')) --4
              'withdrawn', 'excluded', 'refused')), --5
  site TEXT NOT NULL DEFAULT '' CHECK ( --5
    site NOT GLOB '*[^0-9A-Za-z]*' --5
    AND (site = '' OR substr(participant, 1, length(site) + 1) = site || '-')) --5
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
--                   angular_radius_rad), and light_units where the file's lights were said to be
--                   photometric or radiometric
CREATE TABLE session_scene (
  session INTEGER NOT NULL REFERENCES session (id),
  scene TEXT NOT NULL REFERENCES study_scene (name),
  file_name TEXT NOT NULL,
  file_sha256 TEXT NOT NULL
    CHECK (length(file_sha256) = 64 AND file_sha256 NOT GLOB '*[^0-9a-f]*'),
  shown_as TEXT NOT NULL CHECK (json_type(shown_as) = 'object'),
  PRIMARY KEY (session, scene)
) STRICT;

-- What the session set out to do, written before anything happened in it. Practice and catch
-- trials, in which nothing is rendered, are never analysed, and their positions say nothing.
CREATE TABLE planned_trial (
  session INTEGER NOT NULL REFERENCES session (id),
  trial INTEGER NOT NULL CHECK (trial >= 0),
  kind TEXT NOT NULL CHECK (kind IN ('test', 'practice', 'catch')),
  scene TEXT NOT NULL REFERENCES study_scene (name),
  method TEXT NOT NULL REFERENCES study_method (name),
  scene_position INTEGER NOT NULL CHECK (scene_position >= 0),
  method_position INTEGER NOT NULL CHECK (method_position >= 0),
  PRIMARY KEY (session, trial)
) STRICT;
CREATE UNIQUE INDEX planned_test_trial ON planned_trial (session, scene, method)
WHERE kind = 'test';

-- All steps of the session, the trials among them. times: as often may the gaze be validated, or is
-- a key to be pressed. chooses_object: otherwise the trial keeps the object that was chosen last.
CREATE TABLE planned_step (
  session INTEGER NOT NULL REFERENCES session (id),
  step INTEGER NOT NULL CHECK (step >= 0),
  kind TEXT NOT NULL
    CHECK (kind IN ('consent', 'questionnaire', 'validation', 'reaction', 'trial')),
  questionnaire TEXT CHECK ((questionnaire IS NOT NULL) = (kind = 'questionnaire')),
  times INTEGER CHECK ((times IS NOT NULL) = (kind IN ('validation', 'reaction'))),
  trial INTEGER CHECK ((trial IS NOT NULL) = (kind = 'trial')),
  chooses_object INTEGER CHECK ((chooses_object IS NOT NULL) = (kind = 'trial')),
  PRIMARY KEY (session, step),
  FOREIGN KEY (session, trial) REFERENCES planned_trial (session, trial)
) STRICT;

-- Everything that happened. payload has the event's values, on one line. The views below, note to
-- rating, follow from this log and the plan. In version 4 all but note are tables of the same names
-- and columns, without response_ns and looked_around_ns. What was measured meanwhile, frames, gaze
-- samples and films, is in tables of both versions.
--
-- trial and attempt say in which attempt it happened; of trial_started, which one it began. The event
-- that ends an attempt states in measured what the tables of frames, gaze and films then held of it,
-- as {"frames":{"count":N,"sha256":"..."},"gaze":{...},"films":{...}}: how many frames, samples and
-- film hashes, and the SHA-256 of their rows' hashes in their order (data_sha256; of films row_sha256),
-- joined by line feeds. An attempt in which the program died is ended by the event that interrupts it
-- when the session is resumed.
--
-- hash chains a session's events. It is the SHA-256 of nine lines in UTF-8, joined by line feeds,
-- without one at the end: the hash of the event before, then sequence, time_ns, utc, type, payload,
-- trial, attempt and measured as they are here, of which NULL is an empty line; in version 4 the first
-- six of them. What stands for the hash before the first event is the SHA-256, in the
-- same form, of the lines below: each is a row as a JSON array of the named columns, without spaces
-- and with every character beyond ASCII as it is (Python: json.dumps(row, separators=(',', ':'),
-- ensure_ascii=False)).
--   study              protocol_name, protocol_title, protocol_text, protocol_sha256
--   study_scene        position, name; by position
--   study_method       position, name; by position
--   study_method_file  method, file_name, file_sha256; by the first two
--   study_profile      device, name, toml, toml_sha256; by the first two
--   study_mark         position, mark; by position
--   study_rating       position, rating, question; by position
--   session            all but id, state and site, of this session, as are the tables below;
--                      participant without its site
--   session_scene      all but session; by scene
--   planned_trial      all but session; by trial
--   planned_step       all but session; by step
CREATE TABLE event (
  session INTEGER NOT NULL REFERENCES session (id),
  sequence INTEGER NOT NULL CHECK (sequence >= 1),
  time_ns INTEGER NOT NULL,
  utc TEXT NOT NULL,
  type TEXT NOT NULL CHECK (
    type IN ('session_started', 'consent_given', 'questionnaire_answered', 'gaze_validated',
             'reaction_pressed', 'object_chosen', 'trial_started', 'first_frame_presented',
             'marked', 'timed_out', 'rated', 'retime_requested', 'pause_requested', 'interrupted',
             'resumed', 'note_written', 'withdrawn', 'excluded')), --4
             'resumed', 'note_written', 'withdrawn', 'excluded', 'end_undone', --5
             'consent_asked')), --5
  payload TEXT NOT NULL CHECK (json_type(payload) = 'object'),
  trial INTEGER, --5
  attempt INTEGER CHECK ((attempt IS NULL) = (trial IS NULL)), --5
  measured TEXT CHECK (json_type(measured) = 'object'), --5
  hash TEXT NOT NULL CHECK (length(hash) = 64 AND hash NOT GLOB '*[^0-9a-f]*'),
  PRIMARY KEY (session, sequence)
) STRICT;

CREATE INDEX event_of_attempt ON event (session, trial, attempt) WHERE trial IS NOT NULL; --5

CREATE VIEW note AS
SELECT session, sequence, time_ns, utc, payload ->> 'text' AS text
FROM event
WHERE type = 'note_written';

-- One look at all of a validation's targets, in the order of time; sequence is of the event that
-- reports it. Runs of one event belong together: if the protocol asks for a correction, the first
-- calibrates and the second validates. Angles are true ones, in degrees:
--   accuracy       the mean of the samples' angles to their target, and of the targets
--   precision_rms  the root mean square of the angles between successive samples
--   precision_sd   the root mean square of the samples' angles to their mean direction
-- and null where nothing was seen. data_loss is the part of the samples that came invalid or not at
-- all. correction, what the gaze went through, is null if it was as the tracker gave it, else
-- {"azimuth": [a, b, c], "elevation": [d, e, f]}: the azimuth became a + b azimuth + c elevation,
-- and the elevation d + e azimuth + f elevation, in degrees. passed: the protocol's gate.
CREATE TABLE gaze_run ( --4
  session INTEGER NOT NULL, --4
  run INTEGER NOT NULL CHECK (run >= 1), --4
  sequence INTEGER NOT NULL, --4
  accuracy_deg REAL, --4
  precision_rms_deg REAL, --4
  precision_sd_deg REAL, --4
  data_loss REAL NOT NULL CHECK (data_loss BETWEEN 0 AND 1), --4
  correction TEXT CHECK (json_type(correction) = 'object'), --4
  passed INTEGER NOT NULL CHECK (passed IN (0, 1)), --4
  PRIMARY KEY (session, run), --4
  FOREIGN KEY (session, sequence) REFERENCES event (session, sequence) --4
) STRICT; --4
CREATE VIEW gaze_run AS --5
SELECT --5
  session, --5
  row_number() OVER (PARTITION BY session ORDER BY sequence, run.key) AS run, --5
  sequence, --5
  run.value ->> '$.figures.accuracy_deg' AS accuracy_deg, --5
  run.value ->> '$.figures.precision_rms_deg' AS precision_rms_deg, --5
  run.value ->> '$.figures.precision_sd_deg' AS precision_sd_deg, --5
  run.value ->> 'data_loss' AS data_loss, --5
  nullif(run.value -> 'correction', 'null') AS correction, --5
  run.value ->> 'passed' AS passed --5
FROM event, json_each(payload, '$.runs') AS run --5
WHERE event.type = 'gaze_validated'; --5

-- Each target of a run, in the order in which they were shown. Directions are in the head's axes,
-- azimuths rightwards and elevations upwards from straight ahead. samples is how many the figures,
-- as above, are of; 0 if there were too few for any. In version 5, reading it takes an SQLite with
-- mathematical functions (SQLITE_ENABLE_MATH_FUNCTIONS), as Debian's are.
CREATE TABLE gaze_target ( --4
  session INTEGER NOT NULL, --4
  run INTEGER NOT NULL, --4
  target INTEGER NOT NULL CHECK (target >= 0), --4
  azimuth_deg REAL NOT NULL, --4
  elevation_deg REAL NOT NULL, --4
  data_loss REAL NOT NULL CHECK (data_loss BETWEEN 0 AND 1), --4
  samples INTEGER NOT NULL CHECK (samples >= 0), --4
  mean_gaze_azimuth_deg REAL, --4
  mean_gaze_elevation_deg REAL, --4
  accuracy_deg REAL, --4
  precision_rms_deg REAL, --4
  precision_sd_deg REAL, --4
  PRIMARY KEY (session, run, target), --4
  FOREIGN KEY (session, run) REFERENCES gaze_run (session, run) --4
) STRICT; --4
CREATE VIEW gaze_target AS --5
WITH found AS ( --5
  SELECT --5
    session, --5
    dense_rank() OVER (PARTITION BY session ORDER BY sequence, run.key) AS run, --5
    target.key AS target, --5
    target.value ->> '$.direction[0]' AS x, --5
    target.value ->> '$.direction[1]' AS y, --5
    target.value ->> '$.direction[2]' AS z, --5
    target.value ->> '$.seen.mean_gaze[0]' AS gaze_x, --5
    target.value ->> '$.seen.mean_gaze[1]' AS gaze_y, --5
    target.value ->> '$.seen.mean_gaze[2]' AS gaze_z, --5
    target.value --5
  FROM event, json_each(payload, '$.runs') AS run, json_each(run.value, '$.targets') AS target --5
  WHERE event.type = 'gaze_validated') --5
SELECT --5
  session, --5
  run, --5
  target, --5
  degrees(iif(x = 0 AND z = 0, 0.0, atan2(x, -z))) AS azimuth_deg, --5
  degrees(atan2(y, sqrt(x * x + z * z))) AS elevation_deg, --5
  value ->> 'data_loss' AS data_loss, --5
  coalesce(value ->> '$.seen.samples', 0) AS samples, --5
  degrees(iif(gaze_x = 0 AND gaze_z = 0, 0.0, atan2(gaze_x, -gaze_z))) AS mean_gaze_azimuth_deg, --5
  degrees(atan2(gaze_y, sqrt(gaze_x * gaze_x + gaze_z * gaze_z))) AS mean_gaze_elevation_deg, --5
  value ->> '$.seen.figures.accuracy_deg' AS accuracy_deg, --5
  value ->> '$.seen.figures.precision_rms_deg' AS precision_rms_deg, --5
  value ->> '$.seen.figures.precision_sd_deg' AS precision_sd_deg --5
FROM found; --5

-- By the ids in the protocol, and the plan's step, since a questionnaire may be asked twice: its
-- questionnaires are answered in their order. Rows are in the order in which answers were given.
-- response_ns, also of rating: how long the question was shown until it was answered, all of its
-- showings together; NULL where that was not measured.
CREATE TABLE questionnaire_answer ( --4
  session INTEGER NOT NULL, --4
  step INTEGER NOT NULL, --4
  questionnaire TEXT NOT NULL, --4
  question TEXT NOT NULL, --4
  number REAL, --4
  text TEXT CHECK ((text IS NULL) <> (number IS NULL)), --4
  PRIMARY KEY (session, step, question), --4
  FOREIGN KEY (session, step) REFERENCES planned_step (session, step) --4
) STRICT; --4
CREATE VIEW questionnaire_answer AS --5
SELECT --5
  session, --5
  step, --5
  questionnaire, --5
  answer.value ->> 'question' AS question, --5
  iif(json_type(answer.value, '$.value') = 'text', NULL, answer.value ->> 'value') AS number, --5
  iif(json_type(answer.value, '$.value') = 'text', answer.value ->> 'value', NULL) AS text, --5
  answer.value ->> 'response_ns' AS response_ns --5
FROM ( --5
  SELECT *, row_number() OVER (PARTITION BY session ORDER BY sequence) AS form --5
  FROM event WHERE type = 'questionnaire_answered') --5
JOIN ( --5
  SELECT session, step, questionnaire, --5
    row_number() OVER (PARTITION BY session ORDER BY step) AS form --5
  FROM planned_step WHERE kind = 'questionnaire') USING (session, form), --5
  json_each(payload, '$.answers') AS answer --5
ORDER BY session, step, answer.key; --5

-- Key presses at something that appeared at shown_ns. early: a false start.
CREATE TABLE reaction ( --4
  session INTEGER NOT NULL REFERENCES session (id), --4
  number INTEGER NOT NULL CHECK (number >= 1), --4
  shown_ns INTEGER NOT NULL, --4
  pressed_ns INTEGER NOT NULL, --4
  early INTEGER NOT NULL CHECK (early = (pressed_ns < shown_ns)), --4
  PRIMARY KEY (session, number) --4
) STRICT; --4
CREATE VIEW reaction AS --5
SELECT --5
  session, --5
  row_number() OVER (PARTITION BY session ORDER BY sequence) AS number, --5
  payload ->> 'shown_ns' AS shown_ns, --5
  payload ->> 'time_ns' AS pressed_ns, --5
  payload ->> 'time_ns' < payload ->> 'shown_ns' AS early --5
FROM event --5
WHERE type = 'reaction_pressed'; --5

-- One timing of a planned trial, of which the last one counts. first_frame_ns is when its first
-- frame was presented. An outcome stays 'open' only if the program died in it. looked_around_ns is
-- from the last mark, or its time-out, until the first question came.
CREATE TABLE attempt ( --4
  session INTEGER NOT NULL, --4
  trial INTEGER NOT NULL, --4
  attempt INTEGER NOT NULL CHECK (attempt >= 1), --4
  object TEXT NOT NULL, --4
  first_frame_ns INTEGER, --4
  outcome TEXT NOT NULL DEFAULT 'open' CHECK ( --4
    outcome IN ('open', 'rated', 'retimed', 'paused', 'interrupted', 'withdrawn', 'excluded')), --4
  PRIMARY KEY (session, trial, attempt), --4
  FOREIGN KEY (session, trial) REFERENCES planned_trial (session, trial) --4
) STRICT; --4
CREATE VIEW attempt AS --5
SELECT --5
  session, --5
  trial, --5
  attempt, --5
  coalesce(( --5
    SELECT payload ->> 'object' FROM event AS chosen --5
    WHERE chosen.session = begun.session AND chosen.sequence < begun.sequence --5
      AND chosen.type = 'object_chosen' --5
    ORDER BY chosen.sequence DESC LIMIT 1), '') AS object, --5
  ( --5
    SELECT payload ->> 'time_ns' FROM event AS first --5
    WHERE first.session = begun.session AND first.trial = begun.trial --5
      AND first.attempt = begun.attempt AND first.type = 'first_frame_presented') AS first_frame_ns, --5
  coalesce(( --5
    SELECT CASE type WHEN 'retime_requested' THEN 'retimed' WHEN 'pause_requested' THEN 'paused' --5
      ELSE type END --5
    FROM event AS ending --5
    WHERE ending.session = begun.session AND ending.trial = begun.trial --5
      AND ending.attempt = begun.attempt AND ending.measured IS NOT NULL), 'open') AS outcome, --5
  ( --5
    SELECT payload ->> 'looked_around_ns' FROM event AS rated --5
    WHERE rated.session = begun.session AND rated.trial = begun.trial --5
      AND rated.attempt = begun.attempt AND rated.type = 'rated') AS looked_around_ns --5
FROM event AS begun --5
WHERE type = 'trial_started'; --5

-- time_ns counts from the attempt's first presented frame. Censored: no mark came until then, so it
-- is a lower bound. The attempt's first mark or time-out is of the first kind, and so on.
CREATE TABLE mark ( --4
  session INTEGER NOT NULL, --4
  trial INTEGER NOT NULL, --4
  attempt INTEGER NOT NULL, --4
  kind TEXT NOT NULL REFERENCES study_mark (mark), --4
  time_ns INTEGER NOT NULL CHECK (time_ns >= 0), --4
  censored INTEGER NOT NULL CHECK (censored IN (0, 1)), --4
  PRIMARY KEY (session, trial, attempt, kind), --4
  FOREIGN KEY (session, trial, attempt) REFERENCES attempt (session, trial, attempt) --4
) STRICT; --4
CREATE VIEW mark AS --5
SELECT --5
  session, --5
  trial, --5
  attempt, --5
  ( --5
    SELECT mark FROM study_mark WHERE position = ( --5
      SELECT count(*) FROM event AS before --5
      WHERE before.session = marked.session AND before.trial = marked.trial --5
        AND before.attempt = marked.attempt AND before.type IN ('marked', 'timed_out') --5
        AND +before.sequence < marked.sequence)) AS kind, --5
  payload ->> 'time_ns' - ( --5
    SELECT payload ->> 'time_ns' FROM event AS first --5
    WHERE first.session = marked.session AND first.trial = marked.trial --5
      AND first.attempt = marked.attempt AND first.type = 'first_frame_presented') AS time_ns, --5
  type = 'timed_out' AS censored --5
FROM event AS marked --5
WHERE type IN ('marked', 'timed_out'); --5

CREATE TABLE rating ( --4
  session INTEGER NOT NULL, --4
  trial INTEGER NOT NULL, --4
  attempt INTEGER NOT NULL, --4
  question TEXT NOT NULL REFERENCES study_rating (rating), --4
  value ANY NOT NULL CHECK (typeof(value) IN ('real', 'text')), --4
  PRIMARY KEY (session, trial, attempt, question), --4
  FOREIGN KEY (session, trial, attempt) REFERENCES attempt (session, trial, attempt) --4
) STRICT; --4
CREATE VIEW rating AS --5
SELECT --5
  session, --5
  trial, --5
  attempt, --5
  answer.value ->> 'question' AS question, --5
  answer.value ->> 'value' AS value, --5
  answer.value ->> 'response_ns' AS response_ns --5
FROM event, json_each(payload, '$.answers') AS answer --5
WHERE event.type = 'rated'; --5

-- Consecutive rendered frames of an attempt; first_frame counts from the attempt's start. data is a
-- zlib stream (RFC 1950); data_sha256 is of six lines, each with a line feed behind it, of the session's
-- uuid, trial, attempt, first_frame, frame_count and encoding, and then of what data holds; in version 4
-- of that alone.
--
-- Encoding 'frames-3' is frame_count records of 52 bytes without gaps, all little-endian:
--   offset  0  int64    time when head and gaze were polled, session clock, ns
--   offset  8  int64    time when it was on the display, session clock, ns
--   offset 16  float32  head azimuth, rad, from -Z towards +X
--   offset 20  float32  head elevation, rad
--   offset 24  float32  gaze direction x, world, as it was used
--   offset 28  float32  gaze direction y
--   offset 32  float32  gaze direction z
--   offset 36  int64    age of that gaze, ns
--   offset 44  uint32   samples traced for this frame
--   offset 48  uint32   flags: bit 0 is set if the tracker's newest gaze was valid, bit 1 if the
--                       gaze above was one that is held, bit 2 if the frame missed its refresh;
--                       bits 16 to 31 are how far the head was tilted to the right, as an int16 in
--                       1/65536 of a turn; the others are 0
-- Encoding 'frames-2', of sessions that were recorded in schema 2 or 3, is the same in 44 bytes:
-- without the second time, and without bit 2.
CREATE TABLE frame_chunk (
  session INTEGER NOT NULL,
  trial INTEGER NOT NULL,
  attempt INTEGER NOT NULL,
  first_frame INTEGER NOT NULL CHECK (first_frame >= 0),
  frame_count INTEGER NOT NULL CHECK (frame_count >= 1),
  encoding TEXT NOT NULL CHECK (encoding IN ('frames-2', 'frames-3')),
  data BLOB NOT NULL,
  data_sha256 TEXT NOT NULL
    CHECK (length(data_sha256) = 64 AND data_sha256 NOT GLOB '*[^0-9a-f]*'),
  PRIMARY KEY (session, trial, attempt, first_frame),
  FOREIGN KEY (session, trial, attempt) REFERENCES attempt (session, trial, attempt) --4
  FOREIGN KEY (session, trial) REFERENCES planned_trial (session, trial) --5
) STRICT;

-- Consecutive gaze samples that arrived during an attempt, all of them, in the order of their
-- arrival; first_sample counts from the attempt's start. Where a session's gaze is corrected, so
-- are these. data and data_sha256 are as in frame_chunk.
--
-- Encoding 'gaze-1' is sample_count records of 24 bytes without gaps, all little-endian:
--   offset  0  int64    time when the eye was there, session clock, ns
--   offset  8  float32  gaze direction x, in the head's axes; straight ahead if it is not valid
--   offset 12  float32  gaze direction y
--   offset 16  float32  gaze direction z
--   offset 20  uint32   flags: bit 0 is set if the sample is valid; bits 1 and 2 are what the eye
--                       did meanwhile, by a velocity threshold: 0 unknown, 1 a fixation, 2 a
--                       saccade, 3 a blink; bit 3 is set if the tracker did not say when the eye was
--                       there, so that the time is that at which it was asked; the others are 0
CREATE TABLE gaze_chunk (
  session INTEGER NOT NULL,
  trial INTEGER NOT NULL,
  attempt INTEGER NOT NULL,
  first_sample INTEGER NOT NULL CHECK (first_sample >= 0),
  sample_count INTEGER NOT NULL CHECK (sample_count >= 1),
  encoding TEXT NOT NULL CHECK (encoding = 'gaze-1'),
  data BLOB NOT NULL,
  data_sha256 TEXT NOT NULL
    CHECK (length(data_sha256) = 64 AND data_sha256 NOT GLOB '*[^0-9a-f]*'),
  PRIMARY KEY (session, trial, attempt, first_sample),
  FOREIGN KEY (session, trial, attempt) REFERENCES attempt (session, trial, attempt) --4
  FOREIGN KEY (session, trial) REFERENCES planned_trial (session, trial) --5
) STRICT;

-- What an attempt's film was after a frame, for checking a replay; frame counts from the attempt's
-- start. row_sha256 is of the session's uuid, trial, attempt, frame and film_sha256 as a JSON array, as
-- at event; in version 4 without the uuid.
CREATE TABLE film_hash (
  session INTEGER NOT NULL,
  trial INTEGER NOT NULL,
  attempt INTEGER NOT NULL,
  frame INTEGER NOT NULL CHECK (frame >= 0),
  film_sha256 TEXT NOT NULL
    CHECK (length(film_sha256) = 64 AND film_sha256 NOT GLOB '*[^0-9a-f]*'),
  row_sha256 TEXT NOT NULL
    CHECK (length(row_sha256) = 64 AND row_sha256 NOT GLOB '*[^0-9a-f]*'),
  PRIMARY KEY (session, trial, attempt, frame),
  FOREIGN KEY (session, trial, attempt) REFERENCES attempt (session, trial, attempt) --4
  FOREIGN KEY (session, trial) REFERENCES planned_trial (session, trial) --5
) STRICT;

-- Sessions that study forget took out, of which nothing else is left: the SHA-256 of the session's uuid,
-- how many events it had, the hash of the last of them, and study_created_utc. So a head that was written
-- down before can be checked.
CREATE TABLE forgotten ( --5
  uuid_sha256 TEXT PRIMARY KEY --5
    CHECK (length(uuid_sha256) = 64 AND uuid_sha256 NOT GLOB '*[^0-9a-f]*'), --5
  events INTEGER NOT NULL CHECK (events >= 0), --5
  last_hash TEXT NOT NULL --5
    CHECK (length(last_hash) = 64 AND last_hash NOT GLOB '*[^0-9a-f]*'), --5
  study_created_utc TEXT NOT NULL --5
) STRICT; --5

-- One row per planned test trial with its last attempt's values, as far as the protocol has them;
-- attempts is 0 if it was never begun.
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
  CASE typeof(rating.value) WHEN 'real' THEN rating.value END AS artifacts
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
  AND rating.attempt = last.attempt AND rating.question = 'artifacts'
WHERE planned_trial.kind = 'test';

-- One table changes after its rows are made, in version 4 two, in these ways only.
CREATE TRIGGER session_changes_state_only
BEFORE UPDATE OF id, uuid, participant, kind, seed, design_row, started_utc, program_version,
  compiler, build_type, processor, cores, operating_system, devices, migrated_from ON session --4
  compiler, build_type, processor, cores, operating_system, devices, migrated_from, --5
  study_created_utc, site ON session --5
BEGIN SELECT raise(ABORT, 'only a session''s state changes'); END;
CREATE TRIGGER session_ends_once BEFORE UPDATE ON session
WHEN OLD.state IN ('completed', 'withdrawn', 'excluded', 'refused')
  AND NOT (OLD.state IN ('withdrawn', 'excluded') AND NEW.state = 'paused') --5
BEGIN SELECT raise(ABORT, 'the session is over'); END;
CREATE TRIGGER session_stays BEFORE DELETE ON session
BEGIN SELECT raise(ABORT, 'sessions are never removed'); END;

CREATE TRIGGER attempt_keeps_its_object --4
BEFORE UPDATE OF session, trial, attempt, object ON attempt --4
BEGIN SELECT raise(ABORT, 'only an attempt''s first frame and outcome change'); END; --4
CREATE TRIGGER attempt_starts_once BEFORE UPDATE OF first_frame_ns ON attempt --4
WHEN OLD.first_frame_ns IS NOT NULL --4
BEGIN SELECT raise(ABORT, 'the attempt has its first frame'); END; --4
CREATE TRIGGER attempt_ends_once BEFORE UPDATE ON attempt WHEN OLD.outcome <> 'open' --4
BEGIN SELECT raise(ABORT, 'the attempt is over'); END; --4
CREATE TRIGGER attempt_stays BEFORE DELETE ON attempt --4
BEGIN SELECT raise(ABORT, 'attempts are never removed'); END; --4

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
CREATE TRIGGER study_mark_is_fixed BEFORE UPDATE ON study_mark
BEGIN SELECT raise(ABORT, 'study_mark is only added to'); END;
CREATE TRIGGER study_mark_stays BEFORE DELETE ON study_mark
BEGIN SELECT raise(ABORT, 'study_mark is only added to'); END;
CREATE TRIGGER study_rating_is_fixed BEFORE UPDATE ON study_rating
BEGIN SELECT raise(ABORT, 'study_rating is only added to'); END;
CREATE TRIGGER study_rating_stays BEFORE DELETE ON study_rating
BEGIN SELECT raise(ABORT, 'study_rating is only added to'); END;
CREATE TRIGGER session_scene_is_fixed BEFORE UPDATE ON session_scene
BEGIN SELECT raise(ABORT, 'session_scene is only added to'); END;
CREATE TRIGGER session_scene_stays BEFORE DELETE ON session_scene
BEGIN SELECT raise(ABORT, 'session_scene is only added to'); END;
CREATE TRIGGER planned_trial_is_fixed BEFORE UPDATE ON planned_trial
BEGIN SELECT raise(ABORT, 'planned_trial is only added to'); END;
CREATE TRIGGER planned_trial_stays BEFORE DELETE ON planned_trial
BEGIN SELECT raise(ABORT, 'planned_trial is only added to'); END;
CREATE TRIGGER planned_step_is_fixed BEFORE UPDATE ON planned_step
BEGIN SELECT raise(ABORT, 'planned_step is only added to'); END;
CREATE TRIGGER planned_step_stays BEFORE DELETE ON planned_step
BEGIN SELECT raise(ABORT, 'planned_step is only added to'); END;
CREATE TRIGGER event_is_fixed BEFORE UPDATE ON event
BEGIN SELECT raise(ABORT, 'event is only added to'); END;
CREATE TRIGGER event_stays BEFORE DELETE ON event
BEGIN SELECT raise(ABORT, 'event is only added to'); END;
CREATE TRIGGER gaze_run_is_fixed BEFORE UPDATE ON gaze_run --4
BEGIN SELECT raise(ABORT, 'gaze_run is only added to'); END; --4
CREATE TRIGGER gaze_run_stays BEFORE DELETE ON gaze_run --4
BEGIN SELECT raise(ABORT, 'gaze_run is only added to'); END; --4
CREATE TRIGGER gaze_target_is_fixed BEFORE UPDATE ON gaze_target --4
BEGIN SELECT raise(ABORT, 'gaze_target is only added to'); END; --4
CREATE TRIGGER gaze_target_stays BEFORE DELETE ON gaze_target --4
BEGIN SELECT raise(ABORT, 'gaze_target is only added to'); END; --4
CREATE TRIGGER questionnaire_answer_is_fixed BEFORE UPDATE ON questionnaire_answer --4
BEGIN SELECT raise(ABORT, 'questionnaire_answer is only added to'); END; --4
CREATE TRIGGER questionnaire_answer_stays BEFORE DELETE ON questionnaire_answer --4
BEGIN SELECT raise(ABORT, 'questionnaire_answer is only added to'); END; --4
CREATE TRIGGER reaction_is_fixed BEFORE UPDATE ON reaction --4
BEGIN SELECT raise(ABORT, 'reaction is only added to'); END; --4
CREATE TRIGGER reaction_stays BEFORE DELETE ON reaction --4
BEGIN SELECT raise(ABORT, 'reaction is only added to'); END; --4
CREATE TRIGGER mark_is_fixed BEFORE UPDATE ON mark --4
BEGIN SELECT raise(ABORT, 'mark is only added to'); END; --4
CREATE TRIGGER mark_stays BEFORE DELETE ON mark --4
BEGIN SELECT raise(ABORT, 'mark is only added to'); END; --4
CREATE TRIGGER rating_is_fixed BEFORE UPDATE ON rating --4
BEGIN SELECT raise(ABORT, 'rating is only added to'); END; --4
CREATE TRIGGER rating_stays BEFORE DELETE ON rating --4
BEGIN SELECT raise(ABORT, 'rating is only added to'); END; --4
CREATE TRIGGER frame_chunk_is_fixed BEFORE UPDATE ON frame_chunk
BEGIN SELECT raise(ABORT, 'frame_chunk is only added to'); END;
CREATE TRIGGER frame_chunk_stays BEFORE DELETE ON frame_chunk
BEGIN SELECT raise(ABORT, 'frame_chunk is only added to'); END;
CREATE TRIGGER gaze_chunk_is_fixed BEFORE UPDATE ON gaze_chunk
BEGIN SELECT raise(ABORT, 'gaze_chunk is only added to'); END;
CREATE TRIGGER gaze_chunk_stays BEFORE DELETE ON gaze_chunk
BEGIN SELECT raise(ABORT, 'gaze_chunk is only added to'); END;
CREATE TRIGGER film_hash_is_fixed BEFORE UPDATE ON film_hash
BEGIN SELECT raise(ABORT, 'film_hash is only added to'); END;
CREATE TRIGGER film_hash_stays BEFORE DELETE ON film_hash
BEGIN SELECT raise(ABORT, 'film_hash is only added to'); END;
CREATE TRIGGER forgotten_is_fixed BEFORE UPDATE ON forgotten --5
BEGIN SELECT raise(ABORT, 'forgotten is only added to'); END; --5
CREATE TRIGGER forgotten_stays BEFORE DELETE ON forgotten --5
BEGIN SELECT raise(ABORT, 'forgotten is only added to'); END; --5
