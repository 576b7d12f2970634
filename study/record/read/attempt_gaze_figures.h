// Where a participant's gaze was in one timing of a trial: on the chosen object, elsewhere or not
// known; and where gaze and object were at each mark.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "renderer/gaze/eye_tracker.h"
#include "renderer/view/viewport.h"
#include "study/record/read/recorded_gaze.h"
#include "study/record/setup/shown_scene.h"
#include "study/record/write/session_recorder.h"

namespace foveola::study {

/// The gaze is on an object if it is not further from the object's middle than the object's angular
/// radius and this. Trackers are accurate to about a degree (0.6 to 0.8 degrees: Pupil; 1.5 degrees
/// pass the validation of Foveola's protocols), and while the head turns, the direction that a
/// frame used is a little older than the head's.
inline constexpr double gaze_margin_deg = 2.0;

/// How the time of an attempt divides, in seconds: from its first presented frame to its last mark,
/// or to the end of the wait for that. Each frame stands for the time until the next was presented.
struct GazeTimes {
  double all_s = 0.0;
  double without_gaze_s = 0.0;        ///< no valid gaze, or none that is recent
  std::optional<double> on_object_s;  ///< empty if it is not known where the object was
  std::optional<double> elsewhere_s;  ///< a valid gaze that was not on the object; likewise
};

/// Fixations that lie in that time, or the parts of them that do.
struct FixationFigures {
  std::size_t count = 0;
  std::optional<double> mean_duration_s;  ///< empty without any
  /// Those whose mean direction is on the object; empty if it is not known where that was.
  std::optional<std::size_t> on_object;
};

/// Gaze and object in the frame that was on the display at a mark. Angles are true ones, in
/// degrees; each is empty if it is not known.
struct GazeAtMark {
  std::string mark;
  std::optional<double> gaze_from_object_deg;    ///< from the object's middle; of a valid gaze
  std::optional<double> object_from_middle_deg;  ///< from straight ahead of the head
  std::optional<bool> object_in_view;            ///< whether the object's middle was shown
};

struct AttemptGazeFigures {
  std::optional<GazeTimes> times;            ///< empty without frames before the last mark
  std::optional<FixationFigures> fixations;  ///< empty without times, or without marked samples
  std::vector<GazeAtMark> marks;             ///< of marks that came, in the order of time
};

/// What is known of an attempt. All times are of the session's clock.
struct WatchedAttempt {
  std::vector<FrameRow> frames;     ///< in the order of their presentation
  std::vector<GazeSample> samples;  ///< in the order of their arrival, as GazeMarker marks them
  std::vector<MarkedMoment> marks;  ///< in the order of time
  std::optional<SeenObject> object;
  std::optional<FieldOfView> view;  ///< of the display, a headset's of its left eye
};

/// Whether a gaze, which need not have unit length, is on an object; zero is on none.
bool is_gaze_on(const SeenObject& object, const Vec3& gaze);

/// Whether it is known where the eye was in a frame. A tracker that fell silent has no invalid
/// sample: its last valid one only becomes older. What is older than a blink lasts says nothing.
bool has_gaze(const FrameRow& frame);

/// The last of `frames`, which are in the order of their presentation, that was on the display at
/// `time`; null if none was yet.
const FrameRow* frame_on_display(const std::vector<FrameRow>& frames, Nanoseconds time);

/// Throws Error if there can be no such view.
AttemptGazeFigures attempt_gaze_figures(const WatchedAttempt& attempt);

}  // namespace foveola::study
