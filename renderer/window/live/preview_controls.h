// The keys of the live preview: what each does, and what follows from it.
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

/// What a key means, if anything. Letters go by the keyboard's layout, other keys by their place.
std::optional<PreviewAction> action_of(const CharacterTyped& typed);
std::optional<PreviewAction> action_of(const KeyMoved& key);

/// What every key and the mouse do: two letters a line.
std::vector<std::string> help_lines();

/// What the user has chosen so far.
struct PreviewChoices {
  std::vector<std::string> methods;  ///< at least one, to go through
  std::size_t method = 0;            ///< index of the present method
  /// The share of samples that follow the first part of the method "hybrid", fv; the rest is od's.
  double hybrid_share = 0.9;
  bool gaze_is_frozen = false;
  ViewLook look;
  /// Whether samples are cut so that few bright ones leave no specks: see largest_radiance.
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

/// What is rendered: "hybrid" stands for a mixture with the chosen shares.
std::string method_text(const PreviewChoices& choices);

/// What samples are cut at: four times what is white at the present exposure, or infinity.
float largest_radiance(const PreviewChoices& choices);

/// Follows an action. Returns whether what was rendered so far no longer holds.
bool follow(PreviewAction action, PreviewChoices& choices);

/// The keys that turn the head, as they are held: each of -1, 0 and 1.
class TurnKeys {
 public:
  /// Whether `key` is one of them.
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
