#include "renderer/window/preview_controls.h"

#include <algorithm>
#include <array>
#include <string_view>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

namespace foveola {
namespace {

struct LetterMeaning {
  char32_t letter;
  PreviewAction action;
  std::string_view help;
};

constexpr std::array letters = {
    LetterMeaning{'m', PreviewAction::next_method, "next method"},
    LetterMeaning{'r', PreviewAction::restart, "restart"},
    LetterMeaning{'f', PreviewAction::freeze_gaze, "freeze the gaze, or let it go"},
    LetterMeaning{']', PreviewAction::more_of_the_first,
                  "more of the hybrid's samples at the gaze"},
    LetterMeaning{'[', PreviewAction::less_of_the_first, "fewer"},
    LetterMeaning{'h', PreviewAction::fill_unsampled, "fill unsampled pixels"},
    LetterMeaning{'+', PreviewAction::brighter, "brighter"},
    LetterMeaning{'-', PreviewAction::darker, "darker"},
    LetterMeaning{'g', PreviewAction::show_gaze, "gaze point"},
    LetterMeaning{'a', PreviewAction::show_rings, "acuity rings"},
    LetterMeaning{'d', PreviewAction::show_density, "sample density"},
    LetterMeaning{'t', PreviewAction::show_frame_times, "frame times"},
    LetterMeaning{'l', PreviewAction::show_latency, "latency"},
    LetterMeaning{'c', PreviewAction::check_gaze, "check the tracker: five targets to look at"},
    LetterMeaning{'p', PreviewAction::take_picture, "picture of the window, as a file"},
    LetterMeaning{'q', PreviewAction::close, "quit, as Escape"},
    LetterMeaning{'?', PreviewAction::show_help, "this help, as F1"},
};

constexpr double exposure_step_stops = 0.5;
constexpr double share_step = 0.1;

}  // namespace

std::optional<PreviewAction> action_of(const CharacterTyped& typed) {
  const auto found = std::find_if(letters.begin(), letters.end(), [&](const LetterMeaning& one) {
    return one.letter == typed.character;
  });
  return found != letters.end() ? std::optional(found->action) : std::nullopt;
}

std::optional<PreviewAction> action_of(const KeyMoved& key) {
  if (!key.is_down) {
    return std::nullopt;
  }
  switch (key.key) {
    case GLFW_KEY_ESCAPE:
      return PreviewAction::close;
    case GLFW_KEY_F1:
      return PreviewAction::show_help;
    case GLFW_KEY_F11:
      return PreviewAction::toggle_full_screen;
    default:
      return std::nullopt;
  }
}

std::vector<std::string> help_lines() {
  std::vector<std::string> lines;
  for (const LetterMeaning& one : letters) {
    lines.push_back(fmt::format("{:<7}{}", static_cast<char>(one.letter), one.help));
  }
  lines.emplace_back("F11    full screen");
  lines.emplace_back("Arrows, left mouse button, gamepad: look around");
  return lines;
}

std::string method_text(const PreviewChoices& choices) {
  const std::string& method = choices.methods[choices.method];
  return method == "hybrid" ? fmt::format("hybrid:{:.2f}*fv+{:.2f}*od", choices.hybrid_share,
                                          1.0 - choices.hybrid_share)
                            : method;
}

bool follow(PreviewAction action, PreviewChoices& choices) {
  const auto toggle = [](bool& choice) { choice = !choice; };
  const bool is_hybrid = choices.methods[choices.method] == "hybrid";
  switch (action) {
    case PreviewAction::next_method:
      choices.method = (choices.method + 1) % choices.methods.size();
      return true;
    case PreviewAction::restart:
      return true;
    case PreviewAction::more_of_the_first:
      choices.hybrid_share = std::min(choices.hybrid_share + share_step, 0.9);
      return is_hybrid;
    case PreviewAction::less_of_the_first:
      choices.hybrid_share = std::max(choices.hybrid_share - share_step, 0.1);
      return is_hybrid;
    case PreviewAction::freeze_gaze:
      toggle(choices.gaze_is_frozen);
      break;
    case PreviewAction::fill_unsampled:
      toggle(choices.look.fill_unsampled);
      break;
    case PreviewAction::brighter:
      choices.look.exposure_stops += exposure_step_stops;
      break;
    case PreviewAction::darker:
      choices.look.exposure_stops -= exposure_step_stops;
      break;
    case PreviewAction::show_gaze:
      toggle(choices.shows_gaze);
      break;
    case PreviewAction::show_rings:
      toggle(choices.shows_rings);
      break;
    case PreviewAction::show_density:
      toggle(choices.shows_density);
      break;
    case PreviewAction::show_frame_times:
      toggle(choices.shows_frame_times);
      break;
    case PreviewAction::show_latency:
      toggle(choices.shows_latency);
      break;
    case PreviewAction::show_help:
      toggle(choices.shows_help);
      break;
    case PreviewAction::check_gaze:
    case PreviewAction::take_picture:
    case PreviewAction::toggle_full_screen:
    case PreviewAction::close:
      break;
  }
  return false;
}

bool TurnKeys::follow(const KeyMoved& key) {
  const int held = key.is_down ? 1 : 0;
  switch (key.key) {
    case GLFW_KEY_LEFT:
      left_ = held;
      return true;
    case GLFW_KEY_RIGHT:
      right_ = held;
      return true;
    case GLFW_KEY_UP:
      up_ = held;
      return true;
    case GLFW_KEY_DOWN:
      down_ = held;
      return true;
    default:
      return false;
  }
}

}  // namespace foveola
