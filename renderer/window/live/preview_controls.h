// The keys of the live preview and their effects.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/window/drawing/view_renderer.h"
#include "renderer/window/window_event.h"

namespace foveola {

enum class PreviewAction {
  next_method,
  restart,
  freeze_gaze,
  more_of_the_first,
  less_of_the_first,
  fill_unsampled,
  brighter,
  darker,
  show_gaze,
  show_rings,
  show_density,
  show_frame_times,
  show_latency,
  show_view,
  show_warnings,
  show_help,
  cut_fireflies,
  next_curve,
  fit_view,
  first_view,
  first_field_of_view,
  true_angles,
  print_view,
  check_gaze,
  take_picture,
  toggle_full_screen,
  close
};

/// The action of a key, if any. Letters follow the keyboard's layout, other keys their place.
std::optional<PreviewAction> action_of(const CharacterTyped& typed);
std::optional<PreviewAction> action_of(const KeyMoved& key);

/// Help on every key and the mouse, two letters per line.
std::vector<std::string> help_lines();

/// The user's choices.
struct PreviewChoices {
  std::vector<std::string> methods;  ///< to cycle through, at least one
  std::size_t method = 0;            ///< index of the current method
  /// Share of samples of the first part, fv, of the method "hybrid"; the rest is od's.
  double hybrid_share = 0.9;
  bool gaze_is_frozen = false;
  ViewLook look;
  /// Whether samples are clamped to remove bright specks: see largest_radiance.
  bool cuts_fireflies = false;
  bool shows_gaze = false;
  bool shows_rings = false;
  bool shows_density = false;
  bool shows_frame_times = false;
  bool shows_latency = false;
  bool shows_view = false;
  bool shows_warnings = false;
  bool shows_help = false;
};

/// The method to render: "hybrid" becomes a mixture with the chosen shares.
std::string method_text(const PreviewChoices& choices);

/// Upper bound of samples: four times white at the current exposure, or infinity.
float largest_radiance(const PreviewChoices& choices);

/// Applies an action. Returns whether the film must be restarted.
bool follow(PreviewAction action, PreviewChoices& choices);

/// The held keys that turn the head: each of -1, 0 and 1.
class TurnKeys {
 public:
  /// Returns whether `key` is one of them.
  bool follow(const KeyMoved& key);
  int right() const { return right_ - left_; }
  int up() const { return up_ - down_; }

 private:
  int left_ = 0;
  int right_ = 0;
  int up_ = 0;
  int down_ = 0;
};

}  // namespace foveola
