// Screens of every kind, with as much in them as studies put there.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "renderer/window/screens/screen.h"

namespace foveola::test {

struct SampleScreen {
  std::string name;
  ScreenPage screen;
};

/// As many lines of English words as a page promises to have room for.
inline std::string full_page_of_words() {
  const std::string words =
      "This study is about previews of pictures that a computer paints. You will look at scenes, "
      "press keys and answer questions. Taking part is voluntary: you may stop at any time and "
      "need "
      "not say why, and what was recorded of you can then be deleted. Your answers, the times at "
      "which you press keys and where you look are kept under a code, never under your name. Some "
      "people feel unwell while wearing a headset: then say so, and take it off at once. All of "
      "this takes three quarters of an hour, with as many breaks as you like between the scenes.";
  return words.substr(0, max_screen_lines * screen_line_characters);
}

inline ScreenField artifacts_scale() {
  return {.kind = ScreenField::Kind::scale,
          .question = "How disturbing are the artifacts in the areas around your object?",
          .labels = {"1\nvery disturbing", "2\ndisturbing", "3\nslightly disturbing",
                     "4\nnoticeable but not disturbing", "5\nnot discernible at all"},
          .chosen = 3,
          .has_focus = true};
}

inline ScreenField twenty_one_points() {
  ScreenField field{.kind = ScreenField::Kind::scale,
                    .question = "How mentally demanding was the task?",
                    .has_focus = true};
  for (int i = 0; i <= 20; ++i) {
    field.labels.push_back(std::to_string(i));
  }
  field.labels.front() += "\nvery low";
  field.labels.back() += "\nvery high";
  return field;
}

inline std::vector<SampleScreen> sample_screens() {
  using Kind = ScreenField::Kind;
  const std::string next = "[Enter] next    [\u2191] back";
  std::vector<SampleScreen> samples = {
      {"notice",
       {.title = "Are you ready?",
        .paragraphs = {"The next picture begins as noise. Press Space as soon as you can tell "
                       "whether your object was moved."},
        .keys = "[Enter] start",
        .progress = 0.4}},
      {"full_page",
       {.title = "Before we begin",
        .paragraphs = {full_page_of_words()},
        .keys = "[Enter] next",
        .progress = 0.0}},
      {"scale",
       {.title = "About you (3 of 6)",
        .fields = {artifacts_scale()},
        .keys = "[\u2190] [\u2192] or a digit: choose    " + next,
        .progress = 0.1}},
      {"many_points",
       {.title = "The task (1 of 6)", .fields = {twenty_one_points()}, .keys = next}},
      {"choice",
       {.title = "About you (2 of 6)",
        .fields = {{.kind = Kind::choice,
                    .question = "What is your gender?",
                    .labels = {"1  female", "2  male",
                               "3  another one than these, or several of "
                               "them, or none of them at all",
                               "4  I would rather not say"},
                    .chosen = 2,
                    .has_focus = true}},
        .keys = "[\u2191] [\u2193] or a digit: choose    [Enter] next    [\u2190] back",
        .progress = 1.0}},
      {"fault",
       {.title = "About you (1 of 6)",
        .fields = {{.kind = Kind::line,
                    .question = "How old are you, in years?",
                    .typed = "17",
                    .fault = "Please give a number from 18 to 99.",
                    .has_focus = true}},
        .keys = "[Enter] next"}},
      {"text",
       {.title = "At the end (4 of 4)",
        .fields = {{.kind = Kind::text,
                    .question = "Is there anything else that you would like to tell us?",
                    .typed = full_page_of_words(),
                    .has_focus = true}},
        .keys = next}},
      {"letters",
       {.title = "Γειά σου, привет, Grüß Gott",
        .paragraphs = {"Příliš žluťoučký kůň úpěl ďábelské ódy. Zażółć gęślą jaźń. Tiếng Việt.",
                       "Ξεσκεπάζω την ψυχοφθόρα βδελυγμία.",
                       "Съешь же ещё этих мягких французских булок, да выпей чаю."},
        .keys = "[Enter] Weiter – „gut“"}},
      {"several_fields",
       {.title = "Several questions",
        .fields = {{.kind = Kind::line, .question = "First", .typed = "done"},
                   {.kind = Kind::scale, .question = "Second", .labels = {"1", "2", "3"}},
                   artifacts_scale(),
                   {.kind = Kind::text, .question = "Fourth"},
                   {.kind = Kind::choice,
                    .question = "Fifth",
                    .labels = {"one", "two", "three", "four", "five", "six"}}},
        .keys = next}},
      {"signal", {.title = "NOW", .keys = "[Space]", .is_signal = true}},
      {"band_notice", {.title = "Taken: 1 of 2", .covers_picture = false}},
      {"band_scale",
       {.fields = {artifacts_scale()},
        .keys = "[\u2190] [\u2192] or a digit: choose    [Enter] next",
        .covers_picture = false}},
  };
  return samples;
}

}  // namespace foveola::test
