// Who sits before the window in a person's place: a simulated participant, who sees what the window
// shows, is asked what its pages ask, and answers by keys.
#pragma once

#include <cstdint>
#include <future>
#include <optional>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/window/window_event.h"
#include "study/participant/conduct.h"
#include "study/participant/participant.h"
#include "study/person/forms/form_input.h"
#include "study/person/prompts/person_keys.h"
#include "study/person/prompts/prompt_state.h"

namespace foveola::study {

/// The pixels of a frame.
struct ShownPixels {
  RgbImage image;     ///< one eye's view, as Stimulus::image
  Viewport viewport;  ///< the viewport that they were shown through
};

/// A frame that has been shown.
struct SeenFrame {
  const PromptState& prompt;
  SessionContext context;
  /// The objects of the scene that the session is in; null if it is in none.
  const std::vector<OfferedObject>* offered;
  Nanoseconds shown{0};
  Nanoseconds session_time{0};        ///< the present, by the session's clock
  std::optional<ShownPixels> pixels;  ///< the pixels of a trial's frame, if they were wanted
};

/// Head, eye and keys follow the steady clock. The keys reach the session as the window's own do,
/// with the time at which they go down; the participant's times are those of an attempt, which
/// begins where a trial is prepared or a validation begins, and has another number each time. Looks
/// take a thread of their own, since frames must not wait for them; while one goes on, there is no
/// other.
class SimulatedOperator final : private ParticipantActions {
 public:
  /// All that is referred to must outlive the operator.
  struct Parts {
    Participant& participant;
    const Protocol& protocol;
    const Plan& plan;
    SessionSeed seed;
    const Clock& clock;  ///< steady
    /// The window's. Keys, pointer and gamepad of whoever is at the machine are not passed on.
    WindowEvents& window;
  };

  explicit SimulatedOperator(const Parts& parts);

  /// What the session takes in place of the window's events.
  WindowEvents& events() { return events_; }

  AzimuthElevation heading(Nanoseconds time) { return parts_.participant.head(time - zero_); }
  /// Unit length, in the head's axes.
  Vec3 gaze_in_head(Nanoseconds time);

  /// Whether a trial's frame that is shown now should be looked at.
  bool wants_to_look() const;

  /// Has to be called for every frame; may_answer: whether what it asks for is still asked.
  void follow(SeenFrame frame, bool may_answer);

 private:
  void act(SeenFrame& frame);

  // What the participant does.
  Participant& participant() override {
    if (thought_.valid()) {
      thought_.wait();
    }
    return parts_.participant;
  }
  void consent() override { fill_in(consent_answers()); }
  void hand_in(const Questionnaire& /*form*/, const std::vector<Answer>& answers) override {
    fill_in(answers);
  }
  void validate_gaze(const Attempt& attempt) override;
  void react(std::uint32_t conduct) override;
  void withdraw() override;
  void begin_attempt(const Attempt& attempt) override;
  void choose_object() override;
  void start_trial() override;
  void ask_for_retime() override;
  void begin_task(Task task) override;
  void look_for_mark() override;
  void look_around() override;
  void rate() override;
  void resume() override { press(withdraws_ ? PersonKey::back : PersonKey::confirm); }
  void leave() override { press(PersonKey::confirm); }

  /// Types the answer to the question that the form shows, and the key that goes on.
  void fill_in(const std::vector<Answer>& answers);
  void turn_to(const std::string& scene, const OfferedObject& object);
  /// Begins a look at the frame, if its pixels were wanted.
  void look();
  /// Knows what came of a look that is over.
  void take_thought();

  Nanoseconds now() const { return parts_.clock.now(); }
  bool is_settled() const;
  void press(PersonKey key) { events_.push(press_of(key, now())); }
  void press(FormKey key) { events_.push(press_of(FormInput(key), now())); }
  /// Presses the mark's key once it is time to.
  void press_mark_when_due();
  void pass_on_window_events();

  Parts parts_;
  SimulatedConduct conduct_;
  SeenFrame* frame_ = nullptr;  ///< the frame that is acted upon, meanwhile
  WindowEvents events_;
  Nanoseconds zero_;       ///< the clock's time at which the attempt's is 0
  Nanoseconds turned_{0};  ///< when it last turned to an object
  std::string object_;     ///< the object that it last turned to
  std::optional<Nanoseconds> last_glance_;
  /// What see() returns, while a look goes on.
  std::future<std::optional<Nanoseconds>> thought_;
  std::optional<Nanoseconds> due_;  ///< when the mark's key goes down
  bool has_reacted_ = false;        ///< whether it has reacted to what has appeared
  std::optional<Vec3> target_;      ///< in the head's axes
  std::optional<std::vector<Answer>> ratings_;
  bool withdraws_ = false;
};

}  // namespace foveola::study
