// State of the runtime between calls.
#pragma once

#include <bit>
#include <deque>
#include <list>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/openxr/runtime/calls.h"
#include "tests/openxr/runtime/script.h"

namespace foveola::test::openxr {

struct Action {
  XrActionType type = XR_ACTION_TYPE_BOOLEAN_INPUT;
};

/// A binding that an application suggests for an action.
struct Suggestion {
  const Action* action = nullptr;
  std::string source;  ///< such as /user/hand/left/input/select/click
};

/// Of an action's pose, or else a reference space.
struct Space {
  XrReferenceSpaceType reference = XR_REFERENCE_SPACE_TYPE_VIEW;
  const Action* action = nullptr;
};

struct Swapchain {
  XrSwapchainCreateInfo info{};
  std::vector<GLuint> textures;
  std::uint32_t next_image = 0;
  std::optional<std::uint32_t> acquired;
  bool is_waited_for = false;
  std::optional<std::uint32_t> released;  ///< the latest
};

struct Frame {
  std::int64_t number = -1;  ///< -1 before the first focus
  double time_s = -1.0;      ///< the script's
  XrTime display_time = 0;
  XrTime sample_time = 0;  ///< of the eyes: when xrWaitFrame returned
};

struct Session {
  int number = 1;
  GLXContext gl = nullptr;

  XrSessionState state = XR_SESSION_STATE_UNKNOWN;
  XrSessionState max_state = XR_SESSION_STATE_FOCUSED;
  bool is_running = false;
  bool was_focused = false;
  bool is_loss_pending = false;
  std::size_t events_played = 0;

  std::int64_t frames_since_focus = 0;
  XrTime last_wake_up = 0;
  std::vector<Frame> frames;  ///< all that were waited for
  bool is_waited = false;     ///< the last of them, and not begun
  bool is_begun = false;
  std::set<XrTime> times_of_views;  ///< for which views were located since the last xrEndFrame

  double local_yaw_deg = 0.0;  ///< of LOCAL in the room
  std::list<Space> spaces;
  std::list<Swapchain> swapchains;
  bool are_actions_attached = false;
  bool are_actions_active = false;  ///< at the last xrSyncActions
  double synchronised_s = -1.0;     ///< the script's time then
};

struct Instance {
  std::set<std::string> extensions;
  std::vector<std::string> paths;                              ///< XrPath n is the n-th, from 1
  std::list<Action> actions;                                   ///< of the only action set
  std::map<std::string, std::vector<Suggestion>> suggestions;  ///< by interaction profile
  std::deque<XrEventDataBuffer> events;
  bool are_graphics_requirements_known = false;
};

struct Runtime {
  std::mutex mutex;
  std::filesystem::path folder;  ///< of the script, the log and the pictures
  int sessions = 0;              ///< so far with this folder
  Script script;
  std::optional<Instance> instance;
  std::optional<Session> session;
};

/// The only one: OpenXR's functions have no argument by which a runtime could know itself.
Runtime& runtime();

/// Handles are addresses.
template <typename Handle, typename Object>
Handle handle_of(Object& object) {
  return std::bit_cast<Handle>(&object);
}
template <typename Object, typename Handle>
Object& object_of(Handle handle) {
  return *std::bit_cast<Object*>(handle);
}

const std::string& path_text(XrPath path);
bool is_enabled(const char* extension);

/// Adds a line to the log, for the test to read.
void write_log(const nlohmann::json& line);

/// An event, as the application will poll it.
template <typename Event>
void queue_event(const Event& event) {
  XrEventDataBuffer buffer{};
  static_assert(sizeof(Event) <= sizeof(buffer));
  auto* const bytes = reinterpret_cast<const unsigned char*>(&event);
  std::copy(bytes, bytes + sizeof(event), reinterpret_cast<unsigned char*>(&buffer));
  runtime().instance->events.push_back(buffer);
}

// session.cpp

/// Plays the script's events up to this time, each once.
void play_events(Session& session, double time_s);
/// Moves a session that starts one state up towards its highest.
void rise_by_one(Session& session);

// spaces.cpp

/// The system's monotonic clock, but not its numbers, so that an application that takes the one for
/// the other is found out.
XrTime now();

/// Refuses a time that is so far from the latest frame that it must be another clock's.
void require_time(const Session& session, XrTime time);

/// The eyes' views, the left one first.
std::vector<XrView> views_at(const Session& session, const Space& space, XrTime time);

// swapchains.cpp

/// Refuses a rectangle that is not inside of a finished image.
void check_image(const XrSwapchainSubImage& image);
/// Writes a portable pixmap.
void save_image(const XrSwapchainSubImage& image, const std::filesystem::path& file);

// actions.cpp

constexpr const char* gaze_source = "/user/eyes_ext/input/gaze_ext/pose";

/// The connected sources that the application has suggested for the action. None if the session was
/// not focused at the last xrSyncActions.
std::vector<std::string> active_sources(const Session& session, const Action& action);

}  // namespace foveola::test::openxr
