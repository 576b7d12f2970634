#include "study/protocol/built_in_texts.h"

#include <array>

namespace foveola::study {
namespace {

constexpr std::array built_in{
    BuiltInText{"welcome_title", "Welcome"},
    BuiltInText{
        "welcome",
        "Everything here is done with the keyboard; each screen says with which keys. "
        "You may pause at any time with Escape, and stop for good without giving a reason."},
    // Consent is the study's own matter: no built-in words could say what it is to.
    BuiltInText{"consent_title", "Consent"},
    BuiltInText{"consent", ""},
    BuiltInText{"consent_key", "I agree: press Y"},
    BuiltInText{"refuse_key", "I do not agree: press N"},
    BuiltInText{"continue_key", "Continue: press Enter"},
    BuiltInText{"back_key", "Back: press Backspace"},
    BuiltInText{"question_progress", "Question {question} of {questions}"},
    BuiltInText{"optional", "You may leave this out."},
    BuiltInText{"confirm_answers", "Are these your answers? Press Enter again to hand them in."},
    BuiltInText{"fault_missing", "Please answer this question."},
    BuiltInText{"fault_not_a_number", "Please type a number."},
    BuiltInText{"fault_not_whole", "Please give a whole number."},
    BuiltInText{"fault_out_of_range", "Please give a number from {minimum} to {maximum}."},
    BuiltInText{"fault_no_option", "Please choose one of the options."},
    BuiltInText{"validation_title", "Where you look"},
    BuiltInText{"validation",
                "Dots will appear one after the other. Look at the middle of each until it goes. "
                "Keep your head still."},
    BuiltInText{"validation_again", "That was not precise enough yet. Let us try once more."},
    BuiltInText{"reaction_title", "How fast you press"},
    BuiltInText{"reaction",
                "The screen will change {presses} times, each time after another wait. Press Space "
                "as soon as it does."},
    BuiltInText{"reaction_wait", "Wait ..."},
    BuiltInText{"reaction_now", "NOW"},
    BuiltInText{"reaction_early", "Too early: wait until the screen changes."},
    BuiltInText{"practice_title", "Practice"},
    BuiltInText{"practice", "The next part is only to get used to it. It does not count."},
    BuiltInText{"scene_title", "Scene {scene} of {scenes}"},
    BuiltInText{
        "choose_object",
        "Imagine that you have just changed one of the objects in this scene. Choose which: "
        "Tab or the arrows go from one to the next, Enter chooses."},
    BuiltInText{"ready_title", "Are you ready?"},
    BuiltInText{"ready",
                "Turn to your object. When you press Space, the picture starts anew and becomes "
                "clearer with time. Take every time at the same quality."},
    BuiltInText{"trial_progress", "Part {trial} of {trials}"},
    BuiltInText{"mark_instruction", "{mark}. {instruction} Press Space."},
    BuiltInText{"mark_taken", "Taken"},
    BuiltInText{"retime_key", "If a time went wrong: press R to do this part again"},
    BuiltInText{"retime_confirm", "Do this part again? Press R once more, or Backspace to go on."},
    BuiltInText{"rating_title", "Look around"},
    BuiltInText{"rating", "Look at the other areas of the picture, then answer."},
    BuiltInText{"pause_title", "Pause"},
    BuiltInText{"pause", "Rest as long as you like. Press Space to go on."},
    BuiltInText{"break_title", "The next scene"},
    BuiltInText{"break", "Rest your eyes if you like. Press Space to go on."},
    BuiltInText{"goodbye_title", "Thank you"},
    BuiltInText{"goodbye", "That was all. You may take the headset off."},
    BuiltInText{"stopped", "The session has ended. Thank you for your time."},
};

}  // namespace

std::span<const BuiltInText> built_in_texts() { return built_in; }

}  // namespace foveola::study
