// Builds forms and plain screens from the protocol's texts and the built-in ones.
//
// No screen names the method that is shown.
#pragma once

#include <string>
#include <vector>

#include "renderer/window/screens/screen.h"
#include "study/person/forms/form.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

// --- Forms ---

/// Ends with the question whether the participant agrees.
Form consent_form(const Texts& texts);
/// Returns the answers of a participant who agrees.
std::vector<Answer> consent_answers();

Form questionnaire_form(const Questionnaire& questionnaire, const Texts& texts);

/// Returns the form in a band below the picture.
Form rating_form(const std::vector<Question>& ratings, const Texts& texts);

// --- Pages of a title, a paragraph and a line of keys ---

enum class Notice {
  welcome,
  loading,           ///< while something is loaded
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

/// The page before the first press.
ScreenPage reaction_screen(int presses, const Texts& texts);
ScreenPage reaction_wait_screen(const Texts& texts);
/// The bright stimulus: its onset is reacted to.
ScreenPage reaction_now_screen(const Texts& texts);
/// The page after a premature press; a new wait follows.
ScreenPage reaction_early_screen(const Texts& texts);

// --- Bands below the picture ---

/// An object of the scene, and whether the view shows it.
struct NamedObject {
  std::string name;
  bool is_in_view = true;
};

/// object: the one that Enter would choose.
ScreenPage choosing_screen(const NamedObject& object, const Texts& texts);

/// Number of a trial within its session, from 1; practice trials are counted separately.
struct TrialCount {
  std::size_t trial = 1;
  std::size_t trials = 1;
};

/// Reason why a trial is retimed.
enum class TimedAgain {
  no,
  asked_for,
  object_out_of_view,
  gaze_elsewhere,
};

/// Facts shown before a trial.
struct ReadyPage {
  NamedObject object;  ///< the chosen one
  TrialCount count;
  TimedAgain again = TimedAgain::no;
};

/// The marks to be made, before a trial.
ScreenPage ready_screen(const std::vector<MarkEntry>& marks, const ReadyPage& page,
                        const Texts& texts);

/// The page while a trial that follows the gaze waits for gaze.
ScreenPage no_gaze_screen(const Texts& texts);

/// The message that the first `taken` of `marks` are recorded.
ScreenPage mark_taken_screen(std::size_t taken, std::size_t marks, const Texts& texts);

/// The page before the rating.
ScreenPage look_around_screen(const Texts& texts);

/// Asks whether to retime the trial; shown with a list of choices.
ScreenPage retiming_screen(const Texts& texts);
/// Asks whether to stop taking part; shown with a list of choices, over the whole screen.
ScreenPage stopping_screen(const Texts& texts);

}  // namespace foveola::study
