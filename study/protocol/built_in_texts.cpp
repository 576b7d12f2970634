#include "study/protocol/built_in_texts.h"

#include <array>

namespace foveola::study {
namespace {

constexpr std::array built_in{
    // Texts of every form.
    BuiltInText{"form_title", "{title} ({question} of {questions})"},
    BuiltInText{"form_optional", "(You may leave this out.)"},
    BuiltInText{
        "form_confirm",
        "That was the last question. Once you hand in your answers, they stay as they are."},
    BuiltInText{"form_left_out", "You left out {count} of the questions."},
    BuiltInText{"form_scale_keys", "[←] [→] or a digit: choose    [Enter] next"},
    BuiltInText{"form_choice_keys", "[↑] [↓] or a digit: choose    [Enter] next"},
    BuiltInText{"form_typing_keys", "[Enter] next"},
    BuiltInText{"form_reading_keys", "[Enter] next"},
    BuiltInText{"form_confirm_keys", "[Enter] hand in"},
    BuiltInText{"form_back_up", "[↑] back"},
    BuiltInText{"form_back_left", "[←] back"},
    BuiltInText{"fault_missing", "Please answer this question."},
    BuiltInText{"fault_not_a_number", "Please type a number."},
    BuiltInText{"fault_ambiguous", "Please type {decimal} or {whole}: {typed} may be either."},
    BuiltInText{"fault_not_whole", "Please give a whole number."},
    BuiltInText{"fault_out_of_range", "Please give a number from {minimum} to {maximum}."},
    BuiltInText{"fault_no_option", "Please choose one of the options."},

    // Before the trials.
    BuiltInText{"welcome_title", "Welcome"},
    BuiltInText{
        "welcome",
        "Everything here is done with the keyboard; each screen says with which keys.\n\n"
        "You may pause at any time with Escape, and stop for good without giving a reason."},
    BuiltInText{"welcome_keys", "[Enter] begin"},
    BuiltInText{"loading_title", "One moment"},
    BuiltInText{"loading", "The next scene is being prepared."},
    BuiltInText{"loading_keys", ""},
    // Consent has no built-in text: only the study knows its content.
    BuiltInText{"consent_title", "Consent"},
    BuiltInText{"consent", ""},
    BuiltInText{"consent_confirm", "Do you agree to take part?"},
    BuiltInText{"consent_yes", "I agree"},
    BuiltInText{"consent_no", "I do not agree"},
    BuiltInText{"validation_title", "Where you look"},
    BuiltInText{"validation",
                "Dots will appear one after the other. Look at the middle of each until it goes, "
                "and keep your head still."},
    BuiltInText{"validation_keys", "[Enter] begin"},
    BuiltInText{"validation_again_title", "Once more"},
    BuiltInText{"validation_again",
                "The eye tracker did not see well enough where you looked. Let us try again: look "
                "at the middle of each dot until it goes, and keep your head still."},
    BuiltInText{"validation_again_keys", "[Enter] begin"},
    BuiltInText{"refused_title", "We have to stop here"},
    BuiltInText{
        "refused",
        "The eye tracker does not see your eyes well enough for this study. You did nothing "
        "wrong. Thank you for coming!"},
    BuiltInText{"refused_keys", ""},
    BuiltInText{"reaction_title", "How fast you press"},
    BuiltInText{"reaction",
                "The screen will turn bright {presses} times, each time after another wait. Press "
                "Space as soon as it does."},
    BuiltInText{"reaction_keys", "[Enter] begin"},
    BuiltInText{"reaction_wait", "Wait …"},
    BuiltInText{"reaction_early", "Too early: wait until the screen turns bright."},
    BuiltInText{"reaction_now", "NOW"},
    BuiltInText{"reaction_now_keys", "[Space]"},

    // The trials.
    BuiltInText{"practice_title", "Practice"},
    BuiltInText{"practice", "The next part is only to get used to it. It does not count."},
    BuiltInText{"practice_keys", "[Enter] go on"},
    BuiltInText{"first_trial_title", "That was the practice"},
    BuiltInText{"first_trial", "From now on it counts. Ask now if anything is unclear."},
    BuiltInText{"first_trial_keys", "[Enter] go on"},
    BuiltInText{"next_scene_title", "The next scene"},
    BuiltInText{"next_scene", "Rest your eyes if you like."},
    BuiltInText{"next_scene_keys", "[Enter] go on"},
    BuiltInText{"choosing_title", "Choose an object"},
    BuiltInText{"choosing", "Imagine that you have just changed one of the objects in this scene."},
    BuiltInText{"choosing_object", "Ahead: {object}"},
    BuiltInText{"choosing_keys",
                "[Tab] another one    [Enter] choose it    arrow keys: look around"},
    BuiltInText{"ready_title", "Are you ready? ({trial} of {trials})"},
    BuiltInText{"ready", "Press Space, at a similar quality every time:"},
    BuiltInText{"ready_object", "Your object: {object}"},
    BuiltInText{"ready_unseen", "Your object, {object}, is out of view: turn along the arrow."},
    BuiltInText{"ready_again", "The same once more, from the beginning."},
    BuiltInText{"ready_again_out_of_view",
                "Once more: your object was out of view when you pressed."},
    BuiltInText{"ready_again_elsewhere", "Once more: look at your object until the last press."},
    BuiltInText{"ready_mark", "{mark}. {instruction}"},
    BuiltInText{"ready_keys", "[Space] start"},
    BuiltInText{"no_gaze_title", "Where do you look?"},
    BuiltInText{
        "no_gaze",
        "It is not seen yet where you look; the picture comes as soon as it is. Look at the "
        "middle of the screen. If the mouse stands for your eyes, move its pointer there."},
    BuiltInText{"no_gaze_keys", "[Escape] pause"},
    BuiltInText{"mark_taken", "Taken: {mark} of {marks}"},
    BuiltInText{"look_around_title", "Look around"},
    BuiltInText{"look_around", "Now look at the other areas of the picture."},
    BuiltInText{"look_around_keys", "[Enter] answer    [Backspace] a time went wrong: once more"},
    BuiltInText{"rating_confirm", "Your answer: {answers}"},
    BuiltInText{"rating_keys", "[Enter] yes, that is it"},
    BuiltInText{"retiming_title", "Do this part once more?"},
    BuiltInText{"retiming", "It starts again as noise, and you press Space at each moment anew."},
    BuiltInText{"retiming_continue", "No, continue"},
    BuiltInText{"retiming_again", "Once more"},

    // At any time, and at the end.
    BuiltInText{"pause_title", "Pause"},
    BuiltInText{"pause", "Rest as long as you like."},
    BuiltInText{"pause_keys", "[Enter] go on    [Backspace] stop taking part"},
    BuiltInText{"stopping_title", "Stop taking part?"},
    BuiltInText{"stopping",
                "You need not say why. If what was recorded of you shall be deleted, tell the "
                "experimenter."},
    BuiltInText{"stopping_continue", "Continue"},
    BuiltInText{"stopping_stop", "Stop taking part"},
    BuiltInText{"withdrawn_title", "The session has ended"},
    BuiltInText{"withdrawn", "Thank you for your time!"},
    BuiltInText{"withdrawn_keys", ""},
    BuiltInText{"interrupted_title", "One moment"},
    BuiltInText{"interrupted", "The experimenter will be with you."},
    BuiltInText{"interrupted_keys", ""},
    BuiltInText{"goodbye_title", "Thank you!"},
    BuiltInText{"goodbye", "That was everything. You may tell the experimenter now."},
    BuiltInText{"goodbye_keys", ""},
};

constexpr std::array in_headset{
    BuiltInText{"form_scale_keys", "[←] [→] or [mark]: choose    [go on] next"},
    BuiltInText{"form_choice_keys", "[↑] [↓] or [mark]: choose    [go on] next"},
    BuiltInText{"form_typing_keys", "numbers: [←] [→] or [mark]    [go on] next"},
    BuiltInText{"form_reading_keys", "[go on] next"},
    BuiltInText{"form_confirm_keys", "[go on] hand in"},
    BuiltInText{
        "welcome",
        "Each page says which buttons of a controller or a gamepad do what.\n\n"
        "[mark] is the trigger, or A of a gamepad. [go on] is A or X, or B of a gamepad; without "
        "letters, the pad or the menu button.\n\n"
        "You may pause at any time, and stop for good without giving a reason: tell the "
        "experimenter."},
    BuiltInText{"welcome_keys", "[go on] begin"},
    BuiltInText{"validation_keys", "[go on] begin"},
    BuiltInText{"validation_again_keys", "[go on] begin"},
    BuiltInText{"reaction",
                "The view will turn bright {presses} times, each time after another wait. Press "
                "[mark] as soon as it does."},
    BuiltInText{"reaction_early", "Too early: wait until the view turns bright."},
    BuiltInText{"reaction_keys", "[go on] begin"},
    BuiltInText{"reaction_now_keys", "[mark]"},
    BuiltInText{"practice_keys", "[go on]"},
    BuiltInText{"first_trial_keys", "[go on]"},
    BuiltInText{"next_scene_keys", "[go on]"},
    BuiltInText{"choosing_keys",
                "[mark] another one    [go on] choose it    turn your head: look around"},
    BuiltInText{"ready", "Press [mark], at a similar quality every time:"},
    BuiltInText{"ready_keys", "[mark] start"},
    BuiltInText{"no_gaze",
                "It is not seen yet where you look; the picture comes as soon as it is. Look "
                "straight ahead; if it does not come, tell the experimenter."},
    BuiltInText{"no_gaze_keys", ""},
    BuiltInText{"look_around_keys", "[go on] answer    A time went wrong: tell the experimenter."},
    BuiltInText{"rating_keys", "[go on] yes, that is it"},
    BuiltInText{"retiming", "It starts again as noise, and you press [mark] at each moment anew."},
    BuiltInText{"pause_keys", "[go on]"},
};

constexpr std::array<std::string_view, 3> retired = {"consent_keys", "retiming_keys",
                                                     "stopping_keys"};

}  // namespace

std::span<const BuiltInText> built_in_texts() { return built_in; }

std::span<const BuiltInText> built_in_texts_in_headset() { return in_headset; }

std::span<const std::string_view> retired_text_ids() { return retired; }

}  // namespace foveola::study
