// The live preview's panels of text over the picture, temporary messages, and chosen overlays on
// the film.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/base/clock.h"
#include "renderer/gaze/calibration.h"
#include "renderer/gaze/gaze_quality.h"
#include "renderer/gaze/profiles.h"
#include "renderer/preview/live_frames.h"
#include "renderer/preview/preview.h"
#include "renderer/window/drawing/view_overlays.h"
#include "renderer/window/live/preview_controls.h"
#include "renderer/window/screens/panel_layout.h"

namespace foveola {

/// Duration of a message, chosen by judgement.
enum class MessageStay {
  briefly,      ///< 4 s: the effect of a key
  long_enough,  ///< 15 s: news that the user did not ask for
  until_key     ///< until the next key: results that the user waits for, perhaps looking away
};

class PreviewMessages {
 public:
  void tell(Nanoseconds now, std::string text, MessageStay stay = MessageStay::briefly);

  /// Removes the messages that wait for a key, after one was pressed.
  void answer_key();

  /// The messages still shown at `now`, the oldest first; at most the newest four.
  std::vector<std::string> lines(Nanoseconds now) const;

 private:
  struct Message {
    std::string text;
    std::optional<Nanoseconds> end;  ///< empty: until the next key
  };
  std::vector<Message> messages_;
};

/// Summary of the last second's frames.
std::vector<std::string> frame_time_lines(std::span<const LiveFrame> frames,
                                          const std::string& method);

/// The measured quality of a gaze check.
std::string gaze_quality_line(const GazeQuality& quality);

/// The correction as formulas of the azimuth a and the elevation e, in degrees.
std::string gaze_correction_line(const GazeCorrection& correction);

/// Latency from the eye's movement to the light of the last second's frames, stage by stage;
/// assumed stages are marked.
std::vector<std::string> latency_lines(std::span<const LiveFrame> frames,
                                       const TrackerProfile& tracker,
                                       const DisplayProfile& display);

/// The scale below a density map's colours, and its meaning for the last second's frames.
std::vector<std::string> density_lines(std::span<const LiveFrame> frames);

/// The current view.
struct ShownNow {
  std::string view;                          ///< WindowView::in_words
  std::optional<double> horizontal_fov_deg;  ///< nullopt if it cannot be chosen
  DVec3 camera{0.0};                         ///< in the file's coordinates
  AzimuthElevation head;                     ///< world
  double speed_m_per_s = 0.0;                ///< of moving the camera
  double exposure_stops = 0.0;
  ToneCurve curve = ToneCurve::plain;
  float largest_radiance = 0.0F;  ///< upper bound of samples; infinite: none
};
std::vector<std::string> view_lines(const ShownNow& shown);

/// The options of render and preview for the same view: --camera, --head and --fov.
std::string view_options(const ShownNow& shown);

/// The content of panels.
struct PanelContents {
  std::vector<std::string> notes;         ///< for the user to read now
  std::span<const std::string> warnings;  ///< on the scene
  std::span<const LiveFrame> frames;
  const TrackerProfile& tracker;
  const DisplayProfile& display;
  ShownNow shown;
};

/// The chosen panels, the most important first: they get room before others.
std::vector<TextPanel> preview_panels(const PreviewChoices& choices, const PanelContents& contents);

/// For the preview's last frame.
ViewOverlays preview_overlays(const PreviewChoices& choices, const Preview& preview);

}  // namespace foveola
