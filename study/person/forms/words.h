// What participants read, from the protocol's words and the built-in ones: forms and plain screens.
//
// No screen says which method is shown.
#pragma once

#include <string>
#include <vector>

#include "renderer/window/screens/screen.h"
#include "study/person/forms/form.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

// --- Forms ---

/// Ends with the question whether one agrees.
Form consent_form(const Texts& texts);
/// The answers of who agrees.
std::vector<Answer> consent_answers();

Form questionnaire_form(const Questionnaire& questionnaire, const Texts& texts);

/// The form in a band below the picture.
Form rating_form(const std::vector<Question>& ratings, const Texts& texts);

// --- Pages of a title, a paragraph and a line of keys ---

enum class Notice {
  welcome,
  loading,           ///< something takes a moment
  validation,        ///< before the first look at the targets
  validation_again,  ///< before another look at the targets
  refused,           ///< the gaze did not pass the protocol's gate
  practice,          ///< before the practice trials
  first_trial,       ///< after the practice trials
  next_scene,
  pause,
  withdrawn,
  interrupted,
  goodbye,
};

ScreenPage notice_screen(Notice notice, const Texts& texts);

// --- The reaction test ---

/// Before the first press.
ScreenPage reaction_screen(int presses, const Texts& texts);
ScreenPage reaction_wait_screen(const Texts& texts);
/// Bright, as its change is what is reacted to.
ScreenPage reaction_now_screen(const Texts& texts);
/// After a press that came too early; then it waits anew.
ScreenPage reaction_early_screen(const Texts& texts);

// --- Bands below the picture ---

/// An object of the scene, as the view shows it.
struct NamedObject {
  std::string name;
  bool is_in_view = true;
};

/// object: the one that Enter would choose.
ScreenPage choosing_screen(const NamedObject& object, const Texts& texts);

/// Which of a session's trials it is, from 1; those of the practice are counted by themselves.
struct TrialCount {
  std::size_t trial = 1;
  std::size_t trials = 1;
};

/// Why a trial is timed again.
enum class TimedAgain {
  no,
  asked_for,
  object_out_of_view,
  gaze_elsewhere,
};

/// What is to be known before a trial.
struct ReadyPage {
  NamedObject object;  ///< the chosen one
  TrialCount count;
  TimedAgain again = TimedAgain::no;
};

/// What is to be marked, before a trial.
ScreenPage ready_screen(const std::vector<MarkEntry>& marks, const ReadyPage& page,
                        const Texts& texts);

/// A trial that follows the gaze waits for one.
ScreenPage no_gaze_screen(const Texts& texts);

/// For a moment: the first `taken` of `marks` are kept.
ScreenPage mark_taken_screen(std::size_t taken, std::size_t marks, const Texts& texts);

/// Before the rating.
ScreenPage look_around_screen(const Texts& texts);

/// Asks whether to time the trial again; a list of choices belongs to it.
ScreenPage retiming_screen(const Texts& texts);
/// Asks whether to stop taking part; a list of choices belongs to it, and it is no band.
ScreenPage stopping_screen(const Texts& texts);

}  // namespace foveola::study
