// The live preview's panels of text over the picture, what it tells its user for a while, and what
// its user has chosen to see over the film.
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

/// How long a message stays, chosen by judgement.
enum class MessageStay {
  briefly,      ///< 4 s: what a key did
  long_enough,  ///< 15 s: what the user did not ask for
  until_key     ///< until the next key: what the user waits for, and may not look at just then
};

class PreviewMessages {
 public:
  void tell(Nanoseconds now, std::string text, MessageStay stay = MessageStay::briefly);

  /// A key was pressed: what waits for one goes.
  void answer_key();

  /// Those that still stay at `now`, the oldest first; at most the newest four.
  std::vector<std::string> lines(Nanoseconds now) const;

 private:
  struct Message {
    std::string text;
    std::optional<Nanoseconds> end;  ///< empty: the next key
  };
  std::vector<Message> messages_;
};

/// Summary of the last second's frames.
std::vector<std::string> frame_time_lines(std::span<const LiveFrame> frames,
                                          const std::string& method);

/// How well the tracker saw the eye look at targets.
std::string gaze_quality_line(const GazeQuality& quality);

/// The correction as formulas of the azimuth a and the elevation e, in degrees.
std::string gaze_correction_line(const GazeCorrection& correction);

/// Latency from the eye's movement to the light of the last second's frames, stage by stage;
/// assumed stages are marked.
std::vector<std::string> latency_lines(std::span<const LiveFrame> frames,
                                       const TrackerProfile& tracker,
                                       const DisplayProfile& display);

/// The scale below the colours of a density map, and what it means by the last second's frames.
std::vector<std::string> density_lines(std::span<const LiveFrame> frames);

/// What is shown, and how.
struct ShownNow {
  std::string view;                          ///< WindowView::in_words
  std::optional<double> horizontal_fov_deg;  ///< empty where it cannot be chosen
  DVec3 camera{0.0};                         ///< in the file's coordinates
  AzimuthElevation head;                     ///< world
  double speed_m_per_s = 0.0;                ///< of moving the camera
  double exposure_stops = 0.0;
  ToneCurve curve = ToneCurve::plain;
  float largest_radiance = 0.0F;  ///< that samples are cut at; infinite: they are not
};
std::vector<std::string> view_lines(const ShownNow& shown);

/// The options of render and preview that show the same: --camera, --head and --fov.
std::string view_options(const ShownNow& shown);

/// What panels tell of.
struct PanelContents {
  std::vector<std::string> notes;         ///< what the user should read now
  std::span<const std::string> warnings;  ///< on the scene
  std::span<const LiveFrame> frames;
  const TrackerProfile& tracker;
  const DisplayProfile& display;
  ShownNow shown;
};

/// Those that were chosen, the most important ones first: they have room before others.
std::vector<TextPanel> preview_panels(const PreviewChoices& choices, const PanelContents& contents);

/// As of the preview's last frame.
ViewOverlays preview_overlays(const PreviewChoices& choices, const Preview& preview);

}  // namespace foveola
