// Operates the window for a simulated participant, who sees its pixels and answers by keys.
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

struct ShownPixels {
  RgbImage image;     ///< one eye's view, as Stimulus::image
  Viewport viewport;  ///< the viewport that they were shown through
};

struct SeenFrame {
  const PromptState& prompt;
  SessionContext context;
  /// The objects of the scene that the session is in; null if it is in none.
  const std::vector<OfferedObject>* offered;
  Nanoseconds shown{0};
  Nanoseconds session_time{0};        ///< current time of the session's clock
  std::optional<ShownPixels> pixels;  ///< the pixels of a trial's frame, if wants_to_look()
};

/// Head, eye and keys follow the steady clock. Keys reach the session as the window's own do, with
/// the times of their presses. The participant's times are relative to an attempt, which begins
/// where a trial is prepared or a validation begins, and has a new number each time. Looks run in a
/// thread of their own, one at a time, since frames must not wait for them.
class SimulatedOperator final : private ParticipantActions {
 public:
  /// Everything referred to must outlive the operator.
  struct Parts {
    Participant& participant;
    const Protocol& protocol;
    const Plan& plan;
    SessionSeed seed;
    const Clock& clock;  ///< steady
    /// The window's events. Keys, pointer and gamepad of a person at the machine are not passed on.
    WindowEvents& window;
  };

  explicit SimulatedOperator(const Parts& parts);

  /// The events for the session, in place of the window's.
  WindowEvents& events() { return events_; }

  AzimuthElevation heading(Nanoseconds time) { return parts_.participant.head(time - zero_); }
  /// Unit length, in the head's axes.
  Vec3 gaze_in_head(Nanoseconds time);

  /// Returns whether the pixels of the trial frame shown now are needed.
  bool wants_to_look() const;

  /// Call for every frame. may_answer: whether its effect still awaits an answer.
  void follow(SeenFrame frame, bool may_answer);

 private:
  void answer_frame(SeenFrame& frame);

  // Actions of the participant.
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

  /// Types the answer to the form's question, then the key that continues.
  void fill_in(const std::vector<Answer>& answers);
  void turn_to(const std::string& scene, const OfferedObject& object);
  /// Begins a look at the frame if its pixels are there.
  void look();
  /// Takes the result of a finished look.
  void finish_look();

  Nanoseconds now() const { return parts_.clock.now(); }
  bool is_settled() const;
  void press(PersonKey key) { events_.push(make_press(key, now())); }
  void press(FormKey key) { events_.push(make_press(FormInput(key), now())); }
  /// Presses the mark's key once it is due.
  void press_mark_when_due();
  void pass_on_window_events();

  Parts parts_;
  SimulatedConduct conduct_;
  SeenFrame* frame_ = nullptr;  ///< the current frame, during follow()
  WindowEvents events_;
  Nanoseconds zero_;       ///< the clock's time of attempt time 0
  Nanoseconds turned_{0};  ///< time of the last turn to an object
  std::string object_;     ///< the object of the last turn
  std::optional<Nanoseconds> last_glance_;
  /// The result of see(), while a look lasts.
  std::future<std::optional<Nanoseconds>> thought_;
  std::optional<Nanoseconds> due_;  ///< time of the mark's key press
  bool has_reacted_ = false;        ///< whether it has reacted to the current stimulus
  std::optional<Vec3> target_;      ///< in the head's axes
  std::optional<std::vector<Answer>> ratings_;
  bool withdraws_ = false;
};

}  // namespace foveola::study
