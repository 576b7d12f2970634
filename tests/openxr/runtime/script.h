// What a headset, its wearer and its runtime do in a test: a file in JSON, of which every key may
// be left out. {} is a plain headset that nobody moves. FOVEOLA_OPENXR_SCRIPT in the environment
// names it; it is read again for each instance.
//
// Times are seconds since the session was first focused, and go on by 1 / refresh_hz with each
// frame that xrWaitFrame hands out: frame n, the first of which is 0, is of the time
// n / refresh_hz. So they tell frames, in other words, and a slow machine sees the same happen in
// the same frames as a fast one. Before the first focus nothing of the script happens but what its
// first keys say. Whatever has a time has to come in the order of times.
//
// A test can start these times itself:
//   starts_with        name of a file: until it exists, all is as before the first focus
//
// Angles are degrees, lengths m. A positive yaw turns to the left, a positive pitch up, and a
// positive roll tilts to the left. Intervals are {from, to}; without an end they have none.
//
// The headset:
//   system_name        what it is called
//   refresh_hz         frames per second: 90
//   real_time          false: xrWaitFrame never sleeps
//   extensions         names of those that are offered: all that the runtime knows
//   eye_tracking       false: the extension is there, but this headset has no eye tracker
//   interaction_profiles  what is connected: khr/simple_controller and microsoft/xbox_controller,
//                      each behind /interaction_profiles/; oculus/touch_controller is known too.
//                      Of those that a hand could hold, the first one for which the application
//                      has suggested bindings.
//   eyes               two objects, the left eye's and the right eye's:
//     recommended_px     [width, height]: [640, 720]
//     max_px             [width, height]: [1280, 1440]
//     fov_deg            {left, right, up, down}, to the left and down negative
//     offset_m           [x, y, z] from the middle between the eyes
//     cant_deg           yaw of the eye's view in the head
//     mask               {vertices: [[x, y], ...], indices: [...]}: triangles that are hidden, in
//                        the plane 1 m ahead of the eye; without it there is no mask
//   max_swapchain_px   [width, height] of the largest image: [4096, 4096]
//   swapchain_formats  the preferred one first: GL_SRGB8_ALPHA8, GL_RGBA8, GL_RGBA16F,
//                      GL_DEPTH_COMPONENT24
//   eye_height_m       how far STAGE's floor is below the head's origin: 1.6
//
// The wearer:
//   head               [{time, yaw_deg, pitch_deg, roll_deg, position_m}, ...] in the room, which
//                      is LOCAL at first; between these times, evenly
//   head_gaps          [{from, to}, ...] when it is not tracked: valid without TRACKED bits
//   gaze               [{time, yaw_deg, pitch_deg}, ...] in VIEW; between these times, evenly
//   gaze_gaps          [{from, to, kind}, ...]: "blink", valid without TRACKED bits, and held;
//                      "invalid", no bits at all; "lost", the action is not active either
//   gaze_sample_time   [{time, policy, delay_ms}, ...], each from its time on: "true", "zero",
//                      "future" (1 s ahead) or "stuck". An eye is sampled once a frame, when
//                      xrWaitFrame returns. What is seen of it is delay_ms older, and its true
//                      time says so.
//   inputs             [{time, path, pressed}, ...], with a path such as
//                      /user/hand/right/input/select/click; or {time, path, value} with a number,
//                      or {time, path, xy} with two
//
// What happens:
//   events             [{time, event, session, ...}, ...], each in the session of that number of
//                      the process's sessions with this file: 1. By event:
//     recentre           yaw_deg, position_m: the new LOCAL in the one before; after_s: how long
//                        after the event it changes
//     focus_lost         -> VISIBLE
//     hidden             -> SYNCHRONIZED
//     focus_gained       -> FOCUSED; shown, the same
//     taken_off          -> VISIBLE, and the user is no longer present
//     put_on             -> FOCUSED, and the user is present
//     session_loss       -> LOSS_PENDING, and XR_SESSION_LOSS_PENDING from then on
//     instance_loss      the event, and then as session_loss
//     session_lost       XR_ERROR_SESSION_LOST from then on
//     exit               -> STOPPING, and once the application has ended the session, EXITING
//     restart            -> STOPPING, and then READY again
//   no_render          [{from, to}, ...] when should_render is false
//   failures           [{function, result, time, times}, ...]: from that time on, or from the
//                      start, the call is answered so, that many times, or for ever
//   save_frames        [n, ...] of the frames whose images are saved, as FRAME-VIEW.ppm in the
//                      folder that FOVEOLA_OPENXR_PICTURES names
#pragma once

#include <array>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tests/openxr/runtime/poses.h"

namespace foveola::test::openxr {

struct SizePx {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
};

struct FovDeg {
  double left = 0.0;
  double right = 0.0;
  double up = 0.0;
  double down = 0.0;
};

struct ScriptedEye {
  SizePx recommended_px{640, 720};
  SizePx max_px{1280, 1440};
  FovDeg fov_deg;
  glm::dvec3 offset_m{0.0};
  double cant_deg = 0.0;
  std::vector<XrVector2f> mask_vertices;
  std::vector<std::uint32_t> mask_indices;
};

struct HeadKey {
  double time_s = 0.0;
  Turn turn;
  glm::dvec3 position_m{0.0};
};

struct GazeKey {
  double time_s = 0.0;
  double yaw_deg = 0.0;
  double pitch_deg = 0.0;
};

/// From its first time on, and no longer at its last.
struct Interval {
  double from_s = 0.0;
  double to_s = 0.0;

  bool holds(double time_s) const { return time_s >= from_s && time_s < to_s; }
};

enum class GazeGap { blink, invalid, lost };
struct GazeGapInterval {
  Interval when;
  GazeGap kind = GazeGap::blink;
};

enum class SampleTime { truthful, zero, future, stuck };
struct SampleTimeStep {
  double time_s = 0.0;
  SampleTime policy = SampleTime::truthful;
  double delay_ms = 0.0;
};

struct InputStep {
  double time_s = 0.0;
  std::string path;
  XrVector2f value{0.0F, 0.0F};  ///< of which a button has only x: 0 or 1
};

enum class EventKind {
  recentre,
  focus_lost,
  focus_gained,
  hidden,
  shown,
  taken_off,
  put_on,
  session_loss,
  instance_loss,
  session_lost,
  exit,
  restart
};
struct ScriptedEvent {
  double time_s = 0.0;
  EventKind kind = EventKind::recentre;
  std::string name;
  int session = 1;
  Pose pose;             ///< of recentre
  double after_s = 0.0;  ///< of recentre
};

struct ScriptedFailure {
  std::string function;
  XrResult result = XR_ERROR_RUNTIME_FAILURE;
  std::optional<double> time_s;
  int times = std::numeric_limits<int>::max();
};

struct Script {
  std::filesystem::path starts_with;  ///< empty: the script starts with the first focus
  std::string system_name = "Test headset";
  double refresh_hz = 90.0;
  bool is_real_time = true;
  std::vector<std::string> extensions;
  std::vector<std::string> interaction_profiles;
  bool has_eye_tracker = true;
  std::array<ScriptedEye, 2> eyes;
  SizePx max_swapchain_px{4096, 4096};
  std::vector<std::int64_t> swapchain_formats;
  double eye_height_m = 1.6;
  std::vector<HeadKey> head;
  std::vector<Interval> head_gaps;
  std::vector<GazeKey> gaze;
  std::vector<GazeGapInterval> gaze_gaps;
  std::vector<SampleTimeStep> gaze_sample_times;
  std::vector<InputStep> inputs;
  std::vector<ScriptedEvent> events;
  std::vector<Interval> no_render;
  std::vector<ScriptedFailure> failures;
  std::vector<std::int64_t> save_frames;
};

/// Throws std::runtime_error with where it is wrong. Without a file (an empty path), {}.
Script read_script(const std::filesystem::path& file);

// What it says of a time.
Pose head_at(const Script& script, double time_s);
bool is_head_tracked(const Script& script, double time_s);
/// In VIEW. Held in a gap.
Pose gaze_at(const Script& script, double time_s);
std::optional<GazeGap> gaze_gap_at(const Script& script, double time_s);
SampleTimeStep sample_time_at(const Script& script, double time_s);
/// The last step of that input until then, or null.
const InputStep* input_at(const Script& script, const std::string& path, double time_s);
bool is_in_any(const std::vector<Interval>& intervals, double time_s);

}  // namespace foveola::test::openxr
