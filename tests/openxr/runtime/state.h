// What the runtime remembers between calls.
#pragma once

#include <condition_variable>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/openxr/runtime/handles.h"
#include "tests/openxr/runtime/log.h"
#include "tests/openxr/runtime/script.h"

namespace foveola::test::openxr {

struct Action;

struct ActionSet {
  std::string name;
  std::string localized_name;
  std::vector<std::shared_ptr<Action>> actions;
  bool is_attached = false;
};

struct Action {
  std::string name;
  std::string localized_name;
  XrActionType type = XR_ACTION_TYPE_BOOLEAN_INPUT;
  std::vector<std::string> subactions;  ///< top level user paths
  std::weak_ptr<ActionSet> set;
};

/// What an application suggests that an action is fed from.
struct Suggestion {
  std::shared_ptr<Action> action;
  std::string source;  ///< a path with its component, such as /user/hand/left/input/select/click
};

/// Of a reference space or of an action's pose.
struct Space {
  XrReferenceSpaceType reference = XR_REFERENCE_SPACE_TYPE_VIEW;
  std::shared_ptr<Action> action;  ///< null for a reference space
  std::string subaction;
  Pose offset;
};

struct Swapchain {
  std::uint64_t number = 0;
  XrSwapchainCreateInfo info{};
  std::vector<GLuint> textures;
  std::uint32_t next_image = 0;
  std::deque<std::uint32_t> acquired;  ///< the oldest first
  bool is_oldest_waited_for = false;
  std::optional<std::uint32_t> last_released;
};

struct Frame {
  std::int64_t number = -1;  ///< -1 before the first focus
  double time_s = -1.0;      ///< the script's
  XrTime display_time = 0;
  XrTime sample_time = 0;  ///< when the eyes were sampled: xrWaitFrame's return
  bool should_render = false;
};

/// What the application knows of the inputs since its last xrSyncActions.
struct Synchronised {
  double time_s = -1.0;
  bool is_focused = false;
  std::vector<std::pair<std::shared_ptr<ActionSet>, std::string>> sets;  ///< with their subactions
};

/// The application's OpenGL.
struct GlBinding {
  Display* display = nullptr;
  GLXDrawable drawable = 0;
  GLXContext context = nullptr;
};

enum class AfterStopping { restart, exit };

struct Session {
  XrSession handle = XR_NULL_HANDLE;
  int number = 1;
  GlBinding gl;

  XrSessionState state = XR_SESSION_STATE_UNKNOWN;
  XrSessionState highest_state = XR_SESSION_STATE_FOCUSED;  ///< to which the runtime lets it go
  AfterStopping after_stopping = AfterStopping::exit;
  bool is_running = false;
  bool was_focused = false;
  bool is_loss_pending = false;
  bool is_lost = false;
  std::size_t events_played = 0;

  std::int64_t frames_since_focus = 0;
  XrTime last_wake_up = 0;
  std::vector<Frame> frames;  ///< all that were waited for
  std::optional<Frame> waited;
  std::optional<Frame> begun;
  std::set<XrTime> times_of_views;  ///< for which views were located since the last xrEndFrame

  /// From when on LOCAL is where in the room.
  std::vector<std::pair<XrTime, Pose>> local_origins;
  std::optional<std::vector<std::shared_ptr<ActionSet>>> attached;  ///< once, or not yet
  Synchronised synchronised;
  Synchronised synchronised_before;
};

struct Instance {
  XrInstance handle = XR_NULL_HANDLE;
  std::set<std::string> extensions;
  std::vector<std::string> paths;                              ///< XrPath n is the n-th, from 1
  std::map<std::string, std::vector<Suggestion>> suggestions;  ///< by interaction profile
  std::deque<XrEventDataBuffer> events;
  bool are_graphics_requirements_known = false;
};

struct Runtime {
  std::mutex mutex;
  std::condition_variable_any frame_begun;
  std::filesystem::path script_file;
  Script script;
  Log log;
  std::optional<Instance> instance;
  std::optional<Session> session;
  std::uint64_t instances_made = 0;
  std::uint64_t sessions_made = 0;
  int sessions_of_script = 0;  ///< so far
  Handles<XrActionSet, ActionSet> action_sets{"action set"};
  Handles<XrAction, Action> actions{"action"};
  Handles<XrSpace, Space> spaces{"space"};
  Handles<XrSwapchain, Swapchain> swapchains{"swapchain"};
};

/// The only one: OpenXR's functions have no argument by which a runtime could know itself.
Runtime& runtime();

/// Reads the script and opens the log that the environment names.
void read_environment();

Instance& instance_of(XrInstance handle);
Session& session_of(XrSession handle);
/// Refuses a session that does not run.
Session& running_session_of(XrSession handle);
/// Of what belongs to a session and has a handle of its own.
Session& current_session();

/// Refuses paths that are not known. XR_NULL_PATH is none.
const std::string& text_of(XrPath path);
XrPath path_of(const std::string& text);
bool is_enabled(const char* extension);

/// An event, as the application will poll it.
template <typename Event>
void queue_event(const Event& event) {
  XrEventDataBuffer buffer{};
  static_assert(sizeof(Event) <= sizeof(buffer));
  auto* const bytes = reinterpret_cast<const unsigned char*>(&event);
  std::copy(bytes, bytes + sizeof(event), reinterpret_cast<unsigned char*>(&buffer));
  runtime().instance->events.push_back(buffer);
}

}  // namespace foveola::test::openxr
