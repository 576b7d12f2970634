#include "renderer/window/live/preview_controls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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
    LetterMeaning{']', PreviewAction::more_of_the_first, "more of the hybrid at the gaze"},
    LetterMeaning{'[', PreviewAction::less_of_the_first, "less of it"},
    LetterMeaning{'h', PreviewAction::fill_unsampled, "fill unsampled pixels"},
    LetterMeaning{'x', PreviewAction::cut_fireflies, "cut white specks (biased)"},
    LetterMeaning{'+', PreviewAction::brighter, "brighter"},
    LetterMeaning{'-', PreviewAction::darker, "darker"},
    LetterMeaning{'k', PreviewAction::next_curve, "filmic tone curve, or plain"},
    LetterMeaning{'z', PreviewAction::fit_view, "fit to view: the picked, or all"},
    LetterMeaning{'0', PreviewAction::first_field_of_view, "the first field of view"},
    LetterMeaning{'1', PreviewAction::true_angles, "true angles"},
    LetterMeaning{'v', PreviewAction::show_view, "view: camera, angles, exposure"},
    LetterMeaning{'o', PreviewAction::print_view, "print the view as options"},
    LetterMeaning{'g', PreviewAction::show_gaze, "gaze point"},
    LetterMeaning{'a', PreviewAction::show_rings, "acuity rings"},
    LetterMeaning{'d', PreviewAction::show_density, "sample density"},
    LetterMeaning{'t', PreviewAction::show_frame_times, "frame times"},
    LetterMeaning{'l', PreviewAction::show_latency, "latency"},
    LetterMeaning{'c', PreviewAction::check_gaze, "check the tracker: five dots"},
    LetterMeaning{'p', PreviewAction::take_picture, "picture of the film, as a file"},
    LetterMeaning{'w', PreviewAction::show_warnings, "warnings of the scene"},
    LetterMeaning{'q', PreviewAction::close, "quit, as Escape"},
    LetterMeaning{'?', PreviewAction::show_help, "this help, as F1"},
};

/// Keys other than letters.
constexpr std::array other_help = {
    std::string_view("Arrows, left drag, gamepad: look around"),
    std::string_view("Click: look there, pick it, and say what it is"),
    std::string_view("Middle or Alt+left drag: around what is picked"),
    std::string_view("Shift+arrows, Page Up, Page Down: move"),
    std::string_view("Right button held: fly by W A S D E Q"),
    std::string_view("Wheel: field of view; with Ctrl: speed of moving"),
    std::string_view("Home: back to the first place; F11: full screen"),
};

constexpr double exposure_step_stops = 0.5;
constexpr double share_step = 0.1;

}  // namespace

std::optional<PreviewAction> action_of(const CharacterTyped& typed) {
  const auto found = std::ranges::find(letters, typed.character, &LetterMeaning::letter);
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
    case GLFW_KEY_HOME:
      return PreviewAction::first_view;
    case GLFW_KEY_F11:
      return PreviewAction::toggle_full_screen;
    default:
      return std::nullopt;
  }
}

std::vector<std::string> help_lines() {
  constexpr std::size_t rows = (letters.size() + 1) / 2;
  std::vector<std::string> lines(other_help.begin(), other_help.end());
  for (std::size_t row = 0; row < rows; ++row) {
    const auto words = [](const LetterMeaning& one) {
      return fmt::format("{}  {}", static_cast<char>(one.letter), one.help);
    };
    const std::size_t second = row + rows;
    lines.push_back(second < letters.size()
                        ? fmt::format("{:<38}{}", words(letters[row]), words(letters[second]))
                        : words(letters[row]));
  }
  return lines;
}

std::string method_text(const PreviewChoices& choices) {
  const std::string& method = choices.methods[choices.method];
  return method == "hybrid" ? fmt::format("hybrid:{:.2f}*fv+{:.2f}*od", choices.hybrid_share,
                                          1.0 - choices.hybrid_share)
                            : method;
}

float largest_radiance(const PreviewChoices& choices) {
  constexpr double whites = 4.0;
  return choices.cuts_fireflies
             ? static_cast<float>(whites * std::exp2(-choices.look.exposure_stops))
             : std::numeric_limits<float>::infinity();
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
      return choices.cuts_fireflies;
    case PreviewAction::darker:
      choices.look.exposure_stops -= exposure_step_stops;
      return choices.cuts_fireflies;
    case PreviewAction::next_curve:
      choices.look.curve =
          choices.look.curve == ToneCurve::plain ? ToneCurve::filmic : ToneCurve::plain;
      break;
    case PreviewAction::cut_fireflies:
      toggle(choices.cuts_fireflies);
      return true;
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
    case PreviewAction::show_view:
      toggle(choices.shows_view);
      break;
    case PreviewAction::show_warnings:
      toggle(choices.shows_warnings);
      break;
    case PreviewAction::show_help:
      toggle(choices.shows_help);
      break;
    case PreviewAction::fit_view:
    case PreviewAction::first_view:
    case PreviewAction::first_field_of_view:
    case PreviewAction::true_angles:
    case PreviewAction::print_view:
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
