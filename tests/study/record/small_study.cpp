#include "small_study.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"

namespace fs = std::filesystem;

namespace foveola::study {
Protocol small_protocol() {
  Protocol protocol;
  protocol.name = "small";
  protocol.title = "A small study";
  protocol.scenes = {{.name = "box"}, {.name = "hall"}};
  protocol.methods = {"od", "fv", "mask:file=a.png"};
  protocol.method_files = {{.method = "mask:file=a.png",
                            .file = "a.png",
                            .sha256 = std::string(64, 'e'),
                            .weights = nullptr}};
  protocol.display.profile = DisplayProfile{.name = "goggles", .toml = "kind = \"headset\"\n"};
  protocol.tracker.profile = TrackerProfile{.name = "camera", .toml = "rate_hz = 120\n"};
  protocol.marks = {{.id = "outline", .simulated = "outline"},
                    {.id = "material", .simulated = "material"}};
  protocol.ratings = {{.id = "artifacts", .minimum = 1.0, .maximum = 5.0}};
  protocol.questionnaires = {
      {.id = "background",
       .questions = {{.id = "age", .kind = QuestionKind::number, .maximum = 99.0},
                     {.id = "cg_experience"}}}};
  protocol.phases = {{.kind = PhaseEntry::Kind::questionnaire, .questionnaire = "background"},
                     {.kind = PhaseEntry::Kind::trials}};
  protocol.path = "small.toml";
  protocol.text = R"(name = "small"
title = "A small study"
scenes = ["box", "hall"]
methods = ["od", "fv", "mask:file=a.png"]

[[rating]]
id = "artifacts"
text = "Artifacts?"

[[questionnaire]]
id = "background"
title = "You"

[[questionnaire.question]]
id = "age"
text = "Age?"
kind = "number"
minimum = 1
maximum = 99

[[questionnaire.question]]
id = "cg_experience"
text = "Experience?"
)";
  protocol.sha256 = sha256(protocol.text);
  return protocol;
}

Protocol other_protocol() {
  Protocol protocol = small_protocol();
  protocol.text += "# changed\n";
  protocol.sha256 = sha256(protocol.text);
  protocol.path = "other.toml";
  return protocol;
}

Protocol protocol_with_another_file() {
  Protocol protocol = small_protocol();
  protocol.method_files[0].sha256 = std::string(64, 'f');
  return protocol;
}

Protocol protocol_with_another_tracker() {
  Protocol protocol = small_protocol();
  protocol.tracker.profile->toml = "rate_hz = 60\n";
  return protocol;
}

Protocol thorough_protocol() {
  Protocol protocol = small_protocol();
  protocol.tracker.validation = ValidationSettings{.attempts = 2};
  protocol.reaction = ReactionSettings{.presses = 2};
  protocol.questionnaires.push_back(
      {.id = "debrief",
       .questions = {{.id = "sickness"}, {.id = "comments", .kind = QuestionKind::text}}});
  using Kind = PhaseEntry::Kind;
  protocol.phases = {
      {.kind = Kind::consent},  {.kind = Kind::validation},
      {.kind = Kind::reaction}, {.kind = Kind::questionnaire, .questionnaire = "background"},
      {.kind = Kind::trials},   {.kind = Kind::questionnaire, .questionnaire = "debrief"}};
  return protocol;
}

GazeRun bad_run() {
  const GazeFigures figures{
      .accuracy_deg = 4.0, .precision_rms_deg = 0.5, .precision_sd_deg = 0.25};
  return {.quality = {.targets = {{.direction = {0.0F, 0.0F, -1.0F},
                                   .data_loss = 0.5,
                                   .seen = SeenTarget{.mean_gaze = {0.0F, 1.0F, -1.0F},
                                                      .samples = 70,
                                                      .figures = figures}},
                                  {.direction = {1.0F, 0.0F, -1.0F}}},
                      .data_loss = 0.75,
                      .figures = figures}};
}

GazeRun good_run() {
  const GazeFigures figures{
      .accuracy_deg = 0.5, .precision_rms_deg = 0.25, .precision_sd_deg = 0.125};
  return {.quality = {.targets = {{.direction = {0.0F, 0.0F, -1.0F},
                                   .data_loss = 0.0,
                                   .seen = SeenTarget{.samples = 120, .figures = figures}}},
                      .data_loss = 0.0,
                      .figures = figures},
          .correction = GazeCorrection{.azimuth = {-1.5, 1.25, 0.0}, .elevation = {0.5, 0.0, 1.0}},
          .passed = true};
}

Plan small_plan() {
  return {{.scene = "hall", .method = "fv", .scene_position = 0, .method_position = 0},
          {.scene = "hall", .method = "od", .scene_position = 0, .method_position = 1},
          {.scene = "box", .method = "od", .scene_position = 1, .method_position = 0},
          {.scene = "box", .method = "fv", .scene_position = 1, .method_position = 1}};
}

Plan thorough_plan() {
  Plan plan = small_plan();
  plan.insert(plan.begin() + 1, {.scene = "hall", .method = "fv", .kind = TrialKind::catch_trial});
  plan.insert(plan.begin(), {.scene = "box", .method = "od", .kind = TrialKind::practice});
  return plan;
}

SessionFacts facts_of(const std::string& participant) {
  return {
      .participant = participant,
      .kind = SessionKind::simulated,
      .seed = 18'446'744'073'709'551'615U,
      .design_row = 7,
      .build = {.version = "0.1.0", .compiler = "GNU 12.2.0", .build_type = "Release"},
      .machine = {.processor = "A processor", .cores = 2, .system = "Linux 6.1"},
      .scenes = {
          {.name = "box", .file_name = "box.glb", .sha256 = std::string(64, 'c'), .shown_as = "{}"},
          {.name = "hall",
           .file_name = "hall.glb",
           .sha256 = std::string(64, 'd'),
           .shown_as = R"({"exposure_stops":1.5})"}}};
}

PlayedSession::PlayedSession(StudyStore& store, const SessionFacts& facts, const Plan& plan,
                             const Protocol& protocol)
    : store_(store),
      procedure_(procedure_of(protocol, plan)),
      id_(store.begin_session(facts, plan)) {}

void PlayedSession::happen(Nanoseconds time, const Event& event) {
  const std::optional<Transition> transition = step(procedure_, state_, event);
  ASSERT_TRUE(transition) << name_of(event) << " in " << name_of(state_.phase);
  store_.record(
      id_, EventEntry{.time = time, .event = event, .before = state_, .after = transition->state});
  state_ = transition->state;
}

void PlayedSession::note(const std::string& text, Nanoseconds time) {
  happen(time, NoteWritten{text});
}

void PlayedSession::begin() {
  happen(ms(0), SessionStarted{});
  happen(ms(10), QuestionnaireAnswered{.questionnaire = "background",
                                       .answers = {{.question = "age", .value = 31.0},
                                                   {.question = "cg_experience", .value = 4.0}}});
}

void PlayedSession::begin_thoroughly() {
  happen(ms(0), SessionStarted{});
  happen(ms(1), ConsentGiven{});
  happen(ms(2), GazeValidated{.runs = {bad_run()}});
  happen(ms(3), GazeValidated{.runs = {bad_run(), good_run()}, .passed = true});
  happen(ms(4), ReactionPressed{.shown = ms(6), .time = ms(4)});
  happen(ms(7), ReactionPressed{.shown = ms(6), .time = ms(7)});
  happen(ms(9), ReactionPressed{.shown = ms(8), .time = ms(9)});
  happen(ms(10), QuestionnaireAnswered{.questionnaire = "background",
                                       .answers = {{.question = "age", .value = 31.0},
                                                   {.question = "cg_experience", .value = 4.0}}});
}

void PlayedSession::choose_and_start(Nanoseconds time, const std::string& object) {
  if (state_.phase == Phase::choosing_object) {
    happen(time, ObjectChosen{object});
  }
  happen(time, TrialStarted{});
}

void PlayedSession::run_trial(Nanoseconds first_frame, Nanoseconds outline, Nanoseconds material,
                              int rating, const std::vector<SessionEntry>& measured) {
  choose_and_start(first_frame - ms(1));
  happen(first_frame, FirstFramePresented{first_frame});
  happen(first_frame + outline, Marked{first_frame + outline});
  happen(first_frame + material, Marked{first_frame + material});
  for (const SessionEntry& entry : measured) {
    store_.record(id_, entry);
  }
  happen(first_frame + material + ms(1), rated(rating));
}

Rated rated(int artifacts) {
  return {{{.question = "artifacts", .value = static_cast<double>(artifacts)}}};
}

void run_thorough_session(StudyStore& store, const std::string& participant, const Event& last) {
  PlayedSession session(store, facts_of(participant), thorough_plan(), thorough_protocol());
  session.begin_thoroughly();
  session.run_trial(ms(1000), ms(100), ms(200), 5);
  session.happen(ms(1500), NoteWritten{.text = "glasses"});
  session.choose_and_start(ms(2000));
  session.happen(ms(2001), FirstFramePresented{ms(2001)});
  session.happen(ms(2100), TimedOut{ms(2100)});
  store.record(session.id(), FrameChunk{.attempt = {.trial = 1, .attempt = 1},
                                        .first = 0,
                                        .frames = plausible_frames(50)});
  store.record(
      session.id(),
      GazeChunk{.attempt = {.trial = 1, .attempt = 1}, .first = 0, .samples = plausible_gaze(80)});
  session.happen(ms(2200), RetimeRequested{});
  session.choose_and_start(ms(3000));
  session.happen(ms(3001), FirstFramePresented{ms(3001)});
  session.happen(ms(3100), PauseRequested{});
  session.happen(ms(3200), Resumed{});
  session.run_trial(ms(4000), ms(300), ms(400), 4);
  session.choose_and_start(ms(5000));
  session.happen(ms(5100), Interrupted{});
  session.happen(ms(5200), Resumed{});
  for (int trial = 2; trial < 5; ++trial) {
    session.run_trial(ms(5000 + 1000 * trial), ms(500), ms(600), 3);
  }
  session.run_trial(ms(10'000), ms(500), ms(600), 3,
                    {FilmEntry{.attempt = {.trial = 5, .attempt = 1},
                               .hash = {.frame = 12, .sha256 = std::string(64, '2')}}});
  session.happen(ms(20'000), last);
}

void write_thorough_session(const std::filesystem::path& path, const std::string& participant,
                            const Event& last) {
  StudyStore store(path, thorough_protocol());
  run_thorough_session(store, participant, last);
}

PlayedSession begun_session(StudyStore& store, const std::string& participant) {
  PlayedSession session(store, facts_of(participant), small_plan());
  session.begin();
  return session;
}

void run_whole_session(StudyStore& store, const std::string& participant) {
  PlayedSession session(store, facts_of(participant), small_plan(), thorough_protocol());
  session.begin_thoroughly();
  for (std::size_t trial = 0; trial < small_plan().size(); ++trial) {
    const AttemptKey attempt = {.trial = trial, .attempt = 1};
    session.run_trial(
        ms(1000 + 10'000 * static_cast<int>(trial)), ms(2000), ms(3000), 2,
        {FrameChunk{.attempt = attempt, .first = 0, .frames = plausible_frames(60)},
         FrameChunk{.attempt = attempt, .first = 60, .frames = plausible_frames(40)},
         GazeChunk{.attempt = attempt, .first = 0, .samples = plausible_gaze(100)},
         FilmEntry{.attempt = attempt, .hash = {.frame = 99, .sha256 = std::string(64, '1')}}});
  }
  session.happen(ms(60'000),
                 QuestionnaireAnswered{.questionnaire = "debrief",
                                       .answers = {{.question = "comments", .value = "none"}}});
}

std::vector<FrameRow> plausible_frames(int count) {
  std::vector<FrameRow> frames;
  for (int i = 0; i < count; ++i) {
    frames.push_back({.time = ms(14 * i),
                      .presented = ms(14 * i + 9),
                      .head_azimuth_rad = 0.01F * static_cast<float>(i),
                      .gaze = {0.0F, 0.6F, -0.8F},
                      .gaze_valid = i % 7 != 0,
                      .is_late = i % 50 == 49,
                      .gaze_age = ms(i % 9),
                      .samples = static_cast<std::uint32_t>(600 + i)});
  }
  return frames;
}

std::vector<GazeSample> plausible_gaze(int count) {
  std::vector<GazeSample> samples;
  for (int i = 0; i < count; ++i) {
    samples.push_back({.time = ms(8 * i), .valid = i % 11 != 0, .mark = GazeMark::fixation});
  }
  return samples;
}

std::string query(const fs::path& path, const std::string& sql) {
  SQLite::Database database(path, SQLite::OPEN_READONLY);
  return database.execAndGet(sql).getString();
}

std::vector<std::string> query_column(const fs::path& path, const std::string& sql) {
  SQLite::Database database(path, SQLite::OPEN_READONLY);
  SQLite::Statement rows(database, sql);
  std::vector<std::string> values;
  while (rows.executeStep()) {
    values.push_back(rows.getColumn(0).getString());
  }
  return values;
}

void tamper(const fs::path& path, const std::string& sql) {
  SQLite::Database database(path, SQLite::OPEN_READWRITE);
  database.exec("PRAGMA synchronous = OFF");  // the disk need not have it between two triggers
  std::map<std::string, std::string> guards;
  {
    SQLite::Statement rows(database, "SELECT name, sql FROM sqlite_schema WHERE type = 'trigger'");
    while (rows.executeStep()) {
      guards[rows.getColumn(0).getString()] = rows.getColumn(1).getString();
    }
  }
  for (const auto& [name, guard] : guards) {
    database.exec("DROP TRIGGER " + name);
  }
  database.exec(sql);
  for (const auto& [name, guard] : guards) {
    database.exec(guard);
  }
}

std::string refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was refused";
  return {};
}

}  // namespace foveola::study
