// Script of a test's headset and its wearer: a JSON object in which every key may be left out. {}
// is a plain headset that nobody moves. Each new instance reads it from script.json in the folder
// that FOVEOLA_OPENXR_FOLDER names.
//
// Times are seconds since the session was first focused. Frame n, the first of which is 0, is of
// the time n / refresh_hz, so that a slow machine sees the same in the same frames as a fast one.
// Before the first focus only the first keys hold. Lists are in the order of their times.
//
// Angles are degrees, lengths m. A positive yaw turns to the left, a positive pitch up, and a
// positive roll tilts to the left.
//
// The headset:
//   starts_with        name of a file: until it exists, all is as before the first focus
//   system_name        its name
//   refresh_hz         frames per second: 90
//   real_time          false: xrWaitFrame never sleeps
//   extensions         names of those that are offered: all that the runtime knows
//   interaction_profiles  connected devices: khr/simple_controller and microsoft/xbox_controller,
//                      each after /interaction_profiles/
//   eyes               two objects, the left eye's and the right eye's:
//     recommended_px     [width, height]: [640, 720]
//     fov_deg            {left, right, up, down}, to the left and down negative
//     offset_m           [x, y, z] from the middle between the eyes
//     cant_deg           yaw of the eye's view in the head
//     mask               {vertices: [[x, y], ...], indices: [...]}: hidden triangles in the plane
//                        1 m ahead of the eye
//
// The wearer:
//   head               [{time, yaw_deg, pitch_deg, roll_deg}, ...] in the room, which is LOCAL at
//                      first; linear between these times
//   gaze               [{time, yaw_deg, pitch_deg}, ...] in VIEW; linear between these times
//   gaze_gaps          [{from, to, kind}, ...]: "blink", valid without TRACKED bits, and held; or
//                      "lost", without bits, and the action is not active
//   gaze_sample_time   [{time, policy, delay_ms}, ...], each from its time on: "true" or "zero". An
//                      eye is sampled once a frame, when xrWaitFrame returns, and seen delay_ms
//                      before that; its true time says so.
//   inputs             [{time, path, pressed}, ...], with a path such as
//                      /user/hand/right/input/select/click; or {time, path, xy}
//
// What happens:
//   events             [{time, event, session, yaw_deg}, ...], each in the process's session of
//                      that number with this file: 1. By event:
//     recentre           LOCAL turns by the yaw
//     focus_lost         -> VISIBLE
//     hidden             -> SYNCHRONIZED
//     focus_gained       -> FOCUSED
//     taken_off          -> VISIBLE, and the user is no longer present
//     put_on             -> FOCUSED, and the user is present
//     session_loss       -> LOSS_PENDING, and XR_SESSION_LOSS_PENDING from then on
//     exit               -> STOPPING, and once the application has ended the session, EXITING
//   failures           [{function, result, time, times}, ...]: from that time on, or from the
//                      start, the call has this result, that many times, or for ever
//   save_pictures      true: each frame's images are saved in the folder, as FRAME-VIEW.ppm
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/openxr/runtime/poses.h"

namespace foveola::test::openxr {

struct ScriptedEye {
  std::uint32_t width_px = 640;
  std::uint32_t height_px = 720;
  XrFovf fov{};
  glm::dvec3 offset_m{0.0};
  double cant_deg = 0.0;
  std::vector<XrVector2f> mask_vertices;
  std::vector<std::uint32_t> mask_indices;
};

struct TurnKey {
  double time_s = 0.0;
  Turn turn;
};

struct GazeGap {
  double from_s = 0.0;  ///< until before to_s
  double to_s = 0.0;
  bool is_blink = false;
};

struct SampleTimeStep {
  double time_s = 0.0;
  bool is_true = true;
  double delay_s = 0.0;
};

struct InputStep {
  double time_s = 0.0;
  std::string path;
  XrVector2f value{0.0F, 0.0F};  ///< of a button only x: 0 or 1
};

struct ScriptedEvent {
  double time_s = 0.0;
  std::string name;
  int session = 1;
  double yaw_deg = 0.0;
};

struct ScriptedFailure {
  std::string function;
  XrResult result = XR_ERROR_RUNTIME_FAILURE;
  double time_s = -1.0;
  int times = 0;
};

struct Script {
  std::filesystem::path starts_with;  ///< empty: the script starts with the first focus
  std::string system_name;
  double refresh_hz = 90.0;
  bool is_real_time = true;
  std::vector<std::string> extensions;
  std::vector<std::string> interaction_profiles;
  std::array<ScriptedEye, 2> eyes;
  std::vector<TurnKey> head;
  std::vector<TurnKey> gaze;
  std::vector<GazeGap> gaze_gaps;
  std::vector<SampleTimeStep> gaze_sample_times;
  std::vector<InputStep> inputs;
  std::vector<ScriptedEvent> events;
  std::vector<ScriptedFailure> failures;
  bool saves_pictures = false;

  Pose head_at(double time_s) const;
  /// In VIEW. Held in a gap.
  Pose gaze_at(double time_s) const;
  std::optional<GazeGap> gaze_gap_at(double time_s) const;
  SampleTimeStep sample_time_at(double time_s) const;
  /// (0, 0) before its first step.
  XrVector2f input_at(const std::string& path, double time_s) const;
};

/// The extensions that the runtime knows.
std::vector<std::string> known_extensions();

/// Throws std::runtime_error for a key or a word without a meaning, since a mistyped one would be a
/// test of nothing.
Script read_script(const std::filesystem::path& file);

/// The header's name of a result, such as XR_ERROR_TIME_INVALID.
std::string result_name(XrResult result);

}  // namespace foveola::test::openxr
