// The interface of a simulated session's participant.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/base/clock.h"
#include "renderer/image/image.h"
#include "renderer/view/viewport.h"
#include "study/participant/observer/evidence.h"
#include "study/protocol/protocol.h"
#include "study/session/session.h"
#include "study/stage/offered_object.h"

namespace foveola::study {

/// The stimulus of one glance at the display. It does not reveal the method of the image.
struct Stimulus {
  const RgbImage& image;     ///< The presented pixels: sRGB-encoded, in [0, 1].
  const Viewport& viewport;  ///< The viewport that they were shown through.
  Vec3 gaze{0.0F};           ///< Direction of the participant's eye; unit length, world.
  Nanoseconds presented{0};  ///< Time since the attempt began.
};

/// The participant's current task.
enum class Task {
  mark_outline,   ///< Mark when the chosen object's outline can be recognised.
  mark_material,  ///< Mark when its material looks finished.
  look_around,    ///< Look around, and rate the artifacts afterwards.
};

/// An attempt at a trial, or one look at all targets of a validation.
struct Attempt {
  std::uint32_t conduct = 0;  ///< Unique number, the seed of all its random draws.
  int trials_before = 0;  ///< Number of trials before it in the session, whatever their outcome.
};

/// Times are relative to the beginning of an attempt. An attempt depends on nothing before it, so
/// that it can be repeated exactly after a crash.
class Participant {
 public:
  virtual ~Participant() = default;

  /// Returns the answers to a form's questions, within their ranges; optional questions may lack
  /// one. A form's answers are always the same.
  virtual std::vector<Answer> answer(const std::string& form,
                                     const std::vector<Question>& questions) = 0;

  /// Returns the time from a stimulus to the key press; each attempt has its own number.
  virtual Nanoseconds react(std::uint32_t attempt) = 0;

  /// Returns the index of the chosen object of `scene`; `offered` is not empty.
  virtual std::size_t choose_object(const std::string& scene,
                                    const std::vector<OfferedObject>& offered) = 0;

  /// Starts another attempt at time 0, with head and eye straight ahead.
  virtual void begin_attempt(const Attempt& attempt) = 0;

  /// Turns to the next tasks' object in `scene`.
  virtual void turn_to(const std::string& scene, const OfferedObject& object, Nanoseconds now) = 0;

  /// Moves the eye to a target that appears, and keeps it there; the head does not move. `target`:
  /// unit length, world.
  virtual void look_at(const Vec3& target, Nanoseconds now) = 0;

  virtual void begin(Task task, Nanoseconds now) = 0;

  /// Return the directions of the head and, in world axes, of the eye. Times may go back by a
  /// tracker's latency. Before the participant's last begin(), turn or target, the pose is that at
  /// its start.
  virtual AzimuthElevation head(Nanoseconds time) = 0;
  virtual Vec3 gaze(Nanoseconds time) = 0;

  /// Shows the participant a stimulus. Returns the time of the key press, not earlier than the
  /// stimulus, once the task's mark is made. Meanwhile other threads may call head() and gaze()
  /// only.
  virtual std::optional<Nanoseconds> see(const Stimulus& stimulus) = 0;
  /// The part of see() after the evidence is known. Predicted glances, which have no pixels, use it
  /// alone.
  virtual std::optional<Nanoseconds> consider(const Evidence& evidence, Nanoseconds now) = 0;

  /// Whether the participant, after a mark or before a rating, noticed a premature press and wants
  /// the trial to be retimed.
  virtual bool wants_retime() const = 0;

  /// Whether the participant, asked between trials, wants to end the session here, after
  /// `trials_before` trials.
  virtual bool wants_to_withdraw(int trials_before) const = 0;

  /// Returns the answers to the rating questions, about the images seen while looking around.
  virtual std::vector<Answer> rate(const std::vector<Question>& ratings) = 0;
};

}  // namespace foveola::study
