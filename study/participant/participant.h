// Whoever takes part in a session: what is asked of a participant, and all that one ever gets to
// see.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/base/clock.h"
#include "renderer/image/image.h"
#include "renderer/view/viewport.h"
#include "study/protocol/protocol.h"
#include "study/session/session.h"

namespace foveola::study {

/// An object that may be chosen, as it is seen from the viewpoint.
struct OfferedObject {
  std::string name;
  Vec3 direction{0.0F, 0.0F, -1.0F};  ///< unit length, world
  double radius_deg = 4.0;            ///< angular radius that covers it
};

/// One glance at the display. Nothing in it tells how the image was made.
struct Stimulus {
  const RgbImage& image;     ///< the presented pixels: sRGB-encoded, in [0, 1]
  const Viewport& viewport;  ///< the view that they were shown through
  Vec3 gaze{0.0F};           ///< unit length, world: where the participant's own eye pointed
  Nanoseconds presented{0};  ///< of the attempt
};

/// What a participant is to do from now on.
enum class Task {
  mark_outline,   ///< mark when the chosen object's outline can be made out
  mark_material,  ///< mark when its material looks as it will
  look_around,    ///< and afterwards rate the artifacts
};

/// An attempt at a trial, or a look at all targets.
struct Attempt {
  std::uint32_t conduct = 0;  ///< a number for each; all that is left to chance follows from it
  int trials_before = 0;      ///< in the session, whatever came of them
};

/// Times are those of an attempt: of an attempt at a trial, or of one look at all targets. What
/// happens in it depends on nothing that was before, so that it can be had again after a crash.
class Participant {
 public:
  virtual ~Participant() = default;

  /// The answers to a form's questions, within their ranges; none to a question that may be left
  /// out. The same to the same form.
  virtual std::vector<Answer> answer(const std::string& form,
                                     const std::vector<Question>& questions) = 0;

  /// How long after something appears the key is pressed; attempt: a number for each.
  virtual Nanoseconds react(std::uint32_t attempt) = 0;

  /// One of the objects of `scene`: its index. offered is not empty.
  virtual std::size_t choose_object(const std::string& scene,
                                    const std::vector<OfferedObject>& offered) = 0;

  /// From now on, time 0, it is another attempt: head and eye are straight ahead.
  virtual void begin_attempt(const Attempt& attempt) = 0;

  /// Turns to the object of `scene` that the next tasks are about.
  virtual void turn_to(const std::string& scene, const OfferedObject& object, Nanoseconds now) = 0;

  /// Moves the eye to a target that appears, and keeps it there; the head stays as it is. target:
  /// of unit length, world.
  virtual void look_at(const Vec3& target, Nanoseconds now) = 0;

  virtual void begin(Task task, Nanoseconds now) = 0;

  /// Where the head points and, in world axes, the eye. Times may go back by a tracker's latency,
  /// but not before the participant's last begin(), turn or target: there the pose is that of the
  /// start.
  virtual AzimuthElevation head(Nanoseconds time) = 0;
  virtual Vec3 gaze(Nanoseconds time) = 0;

  /// Shows the participant what is on the display. Returns the time of the key press, not earlier
  /// than the stimulus, once the mark that the task asks for is made. Another thread may meanwhile
  /// ask for head() and gaze(), and for nothing else.
  virtual std::optional<Nanoseconds> see(const Stimulus& stimulus) = 0;

  /// After a mark, or before a rating: whether the timing of this attempt's trial failed, since
  /// the key was pressed too early. The session is then to be asked to time it again.
  virtual bool wants_retime() const = 0;

  /// Whether the participant, asked between trials, wants to end the session here. trials_before:
  /// as of an attempt.
  virtual bool wants_to_withdraw(int trials_before) const = 0;

  /// The answers to the ratings of what was seen while looking around.
  virtual std::vector<Answer> rate(const std::vector<Question>& ratings) = 0;
};

}  // namespace foveola::study
