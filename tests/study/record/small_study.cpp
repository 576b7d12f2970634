#include "small_study.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include "renderer/base/error.h"

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
  protocol.path = "small.toml";
  protocol.text = "name = \"small\"\n";
  protocol.sha256 = std::string(64, 'a');
  return protocol;
}

Protocol other_protocol() {
  Protocol protocol = small_protocol();
  protocol.text += "# changed\n";
  protocol.sha256 = std::string(64, 'b');
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

SessionFacts facts_of(const std::string& participant) {
  return {
      .participant = participant,
      .kind = SessionKind::simulated,
      .seed = 18'446'744'073'709'551'615U,
      .build = {.version = "0.1.0", .compiler = "GNU 12.2.0", .build_type = "Release"},
      .machine = {.processor = "A processor", .cores = 2, .system = "Linux 6.1"},
      .scenes = {
          {.name = "box", .file_name = "box.glb", .sha256 = std::string(64, 'c'), .shown_as = "{}"},
          {.name = "hall",
           .file_name = "hall.glb",
           .sha256 = std::string(64, 'd'),
           .shown_as = R"({"exposure_stops":1.5})"}}};
}

RecordedSession::RecordedSession(StudyStore& store, const SessionFacts& facts, const Plan& plan)
    : store_(store), plan_(plan), id_(store.begin_session(facts, plan)) {}

void RecordedSession::happen(Nanoseconds time, const Event& event) {
  const std::optional<Transition> transition = step(plan_, state_, event);
  ASSERT_TRUE(transition) << name_of(event) << " in " << name_of(state_.phase);
  store_.record_event(id_, time, event, state_, transition->state);
  state_ = transition->state;
}

void RecordedSession::begin() {
  happen(ms(0), SessionStarted{});
  happen(ms(10), BackgroundAnswered{{{.question = "age", .value = 31},
                                     {.question = "cg_experience", .value = 4}}});
}

void RecordedSession::begin_validated() {
  happen(ms(0), SessionStarted{.validations = 2});
  happen(ms(1), GazeValidated{.runs = {bad_run()}});
  happen(ms(2), GazeValidated{.runs = {bad_run(), good_run()}, .passed = true});
  happen(ms(3), BackgroundAnswered{});
}

void RecordedSession::run_trial(Nanoseconds first_frame, Nanoseconds outline, Nanoseconds material,
                                int rating) {
  happen(first_frame - ms(1), ObjectChosen{"vase"});
  happen(first_frame, FirstFramePresented{first_frame});
  happen(first_frame + outline, OutlineMarked{first_frame + outline});
  happen(first_frame + material, MaterialMarked{first_frame + material});
  happen(first_frame + material + ms(1), ArtifactsRated{rating});
}

std::string query(const fs::path& path, const std::string& sql) {
  SQLite::Database database(path, SQLite::OPEN_READONLY);
  return database.execAndGet(sql).getString();
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
