#include "tests/end_to_end/run/seated_participant.h"

#include <chrono>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "study/record/maintain/maintenance.h"
#include "tests/end_to_end/tracker_profile.h"
#include "tests/waiting.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

/// Small, so that Mesa and few cores keep up.
const char* const top_keys = R"(
name = "keys"
title = "A session by keys"
scenes = ["hall"]
scene_order = "fixed"
method_order = "fixed"
)";

const char* const film_table = R"(
[film]
width = 128
height = 64
max_depth = 2
)";

const char* const lamp = R"(
[[object]]
name = "Lamp"
position = [0.0, 1.9, -0.5]
radius_deg = 8.0
)";

constexpr int default_refresh_rate_hz = 60;

/// The refresh rate is to be filled in.
constexpr const char* small_display = R"(
title = "A small monitor"
kind = "monitor"
width_px = 1280
height_px = 1024
refresh_rate_hz = {}
width_m = 0.34
height_m = 0.272
viewing_distance_m = 0.6
scan_out = {{ duration_ms = 16.7, provenance = "assumed" }}
)";

constexpr std::chrono::milliseconds keystroke{40};  ///< as long as a finger's, about

double monotonic_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The picture of the page of this number, if it is there: "007-marking.png".
std::string picture_of_page(const fs::path& folder, int number) {
  const std::string begin = std::to_string(1000 + number).substr(1) + "-";
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (name.starts_with(begin)) {
      return name;
    }
  }
  return {};
}

}  // namespace

SeatedParticipant::SeatedParticipant() {
  folder().write("share/scenes/hall.toml", std::string(hall_descriptor) + lamp);
  set_refresh_rate(default_refresh_rate_hz);
  folder().write("share/data/trackers/pointer.toml", tracker_profile("pointer", 125));
}

void SeatedParticipant::set_refresh_rate(int hz) const {
  folder().write("share/data/displays/desktop.toml", fmt::format(small_display, hz));
}

void SeatedParticipant::write_protocol(const std::string& keys, const std::string& tables) const {
  folder().write("share/protocols/keys.toml", top_keys + keys + film_table + tables);
}

void SeatedParticipant::begin(const std::vector<std::string>& options) {
  screens_ = folder() / ("screens-" + std::to_string(++runs_));
  pages_ = 0;
  program_ = std::make_unique<RunningProgram>(
      joined(joined(command(), {"--screens", screens_.string()}), options), hall_.environment());
  const std::string line = program_->wait_for("Session time 0 is ");
  zero_s_ = std::stod(line.substr(line.find(" is ") + 4));
  point_at(320, 240);
}

std::function<int()> SeatedParticipant::at_terminal() const {
  std::vector<std::string> program = command();
  program.insert(program.begin(), FOVEOLA_PROGRAM);
  return [program, environment = hall_.environment()]() -> int { become(program, environment); };
}

std::vector<std::string> SeatedParticipant::command() const {
  // Other tests run beside it.
  return {"study", "run",      "keys",  "--db",     database().string(), "--participant",
          code_,   "--window", window_, "--seed=7", "--threads=1"};
}

std::string SeatedParticipant::wait_for_page() {
  ++pages_;
  std::string picture;
  try {
    wait_until("page " + std::to_string(pages_), [&] {
      picture = picture_of_page(screens_, pages_);
      return !picture.empty();
    });
  } catch (const std::runtime_error& in_vain) {
    throw std::runtime_error(std::string(in_vain.what()) + "; it said:\n" + program_->said());
  }
  return picture.substr(4, picture.size() - 8);
}

fs::path SeatedParticipant::picture() const { return screens_ / picture_of_page(screens_, pages_); }

void SeatedParticipant::replace_scene(const std::string& glb) const {
  fs::rename(folder().write("new.glb", glb), folder() / "real/hall.glb");
}

void SeatedParticipant::wait_for_signal() {
  constexpr std::chrono::milliseconds reaction{300};
  wait_until("the signal", [&] { return user_->brightness_at("Foveola", 2, 2) > 0.5; });
  std::this_thread::sleep_for(reaction);
}

void SeatedParticipant::take_display_away() {
  user_.reset();
  server_.kill();
}

KeyPress SeatedParticipant::type(const std::string& key) {
  KeyPress press{.asked_s = monotonic_s() - zero_s_};
  press.stamped_s = 1e-3 * user_->hold_and_ask_time(key) - zero_s_;
  press.taken_s = monotonic_s() - zero_s_;
  std::this_thread::sleep_for(keystroke);
  user_->let_go(key);
  std::this_thread::sleep_for(keystroke);
  return press;
}

void SeatedParticipant::type_all(const std::vector<std::string>& keys) {
  for (const std::string& key : keys) {
    type(key);
  }
}

void SeatedParticipant::point_at(int x, int y) { user_->point_at("Foveola", x, y); }

void SeatedParticipant::answer_page(const std::string& key) {
  wait_for_page();
  type(key);
}

void SeatedParticipant::begin_trials() {
  answer_page("Return");
  answer_page("Return");
}

void SeatedParticipant::quit() {
  program_->type_line("quit");
  EXPECT_EQ(program_->wait_for_end(), 0);
}

void SeatedParticipant::expect_no_fault() const {
  const study::Verification verified = study::verify_study(database());
  EXPECT_TRUE(verified.faults.empty()) << verified.faults.front().what;
}

ProgramResult SeatedParticipant::run_besides(const std::string& participant,
                                             const std::vector<std::string>& options) const {
  return hall_.run(
      joined({"study", "run", "keys", "--db", database().string(), "--participant", participant},
             options));
}

ProgramResult SeatedParticipant::replay() const {
  return hall_.run({"study", "replay", database().string(), "--participant", code_});
}

ProgramResult SeatedParticipant::status() const {
  return hall_.run({"study", "status", database().string()});
}

}  // namespace foveola::test
